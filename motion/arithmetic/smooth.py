"""The smooth way from 0 to 1 that all gradual things take, and what lies between two numbers."""

from worlds.compiled.jit import jit_inline
from worlds.compiled.lanes import Some, choose, larger, smaller


@jit_inline
def smoothstep(x: Some) -> Some:
    """3 x^2 - 2 x^3: from 0 at 0, and before, to 1 at 1, and after, at rest at both."""
    x = smaller(larger(x, 0.0), 1.0)
    return x * x * (3 - 2 * x)


@jit_inline
def fade(s: Some, end: Some) -> Some:
    """From 1 at 0 to 0 at `end`, smooth at both."""
    return 1 - smoothstep(s / end)


@jit_inline
def positive(x: Some, soft: Some) -> Some:
    """x from `soft` on, none up to -soft, and between them a parabola that is smooth at both."""
    beyond = x + soft
    return choose(x > soft, x, choose(x <= -soft, 0.0, beyond * beyond / (4 * soft)))


@jit_inline
def mix(begin: Some, end: Some, share: Some) -> Some:
    """Between two numbers: the first at share 0, the second at 1."""
    return begin + share * (end - begin)
