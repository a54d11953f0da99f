"""The smooth way from 0 to 1 that all gradual things take, and what lies between two numbers."""

from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def smoothstep(x: float) -> float:
    """3 x^2 - 2 x^3: from 0 at 0, and before, to 1 at 1, and after, at rest at both."""
    x = min(max(x, 0.0), 1.0)
    return x * x * (3 - 2 * x)


@jit_borrowing
def fade(s: float, end: float) -> float:
    """From 1 at 0 to 0 at `end`, smooth at both."""
    return 1 - smoothstep(s / end)


@jit_borrowing
def positive(x: float, soft: float) -> float:
    """x from `soft` on, none up to -soft, and between them a parabola that is smooth at both."""
    if x <= -soft:
        return 0.0
    return x if x > soft else (x + soft) ** 2 / (4 * soft)


@jit_borrowing
def mix(begin: float, end: float, share: float) -> float:
    """Between two numbers: the first at share 0, the second at 1."""
    return begin + share * (end - begin)
