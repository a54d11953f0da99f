"""Angles [rad]."""

from math import pi

from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def wrapped(angle: float) -> float:
    """The same direction in [-pi, pi)."""
    return (angle + pi) % (2 * pi) - pi


@jit_borrowing
def unwrapped(angle: float, near: float) -> float:
    """The same direction within half a turn of `near`: so that headings of neighbours differ by the turn between them."""
    return near + (angle - near + pi) % (2 * pi) - pi
