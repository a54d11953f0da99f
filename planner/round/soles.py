"""Soles on the ground: capsules, as long and as wide as the foot, and how far two of them are apart."""

from math import cos, hypot, inf, sin
from typing import Any, NamedTuple

import numpy as np

from worlds.compiled.jit import jit_borrowing


def soles(bipeds: Any) -> np.ndarray:
    """(K, 2) half the middle line and the radius of soles of K kinds, (2,) of one [m]: capsules as long and wide as feet."""
    length, width = bipeds["foot"]["length"], bipeds["foot"]["width"]
    radius = 0.5 * np.minimum(length, width)
    return np.stack([0.5 * length - radius, radius], axis=-1)


class Sole(NamedTuple):
    """A sole on the ground: its middle, the unit vector of its heading, half its middle line and the radius around it [m]."""

    x: float
    y: float
    ahead_x: float
    ahead_y: float
    half: float
    radius: float


@jit_borrowing
def sole_of(sole: np.ndarray, c: int, x: float, y: float, heading: float) -> Sole:
    """The sole of character c at a place [m] with a heading [rad]; sole (C, 2): as `soles` tells them."""
    return Sole(x, y, cos(heading), sin(heading), sole[c, 0], sole[c, 1])


@jit_borrowing
def _to_line(px: float, py: float, ux: float, uy: float, half: float) -> float:
    """Distance of p from the line of half a length `half` about the origin in the direction u [m]."""
    along = min(max(px * ux + py * uy, -half), half)
    return hypot(px - along * ux, py - along * uy)


@jit_borrowing
def soles_apart(a: Sole, b: Sole) -> float:
    """How far two soles are apart [m]; negative: they overlap. Two lines in a plane are nearest at an end, or they cross."""
    dx, dy, cross = b.x - a.x, b.y - a.y, a.ahead_x * b.ahead_y - a.ahead_y * b.ahead_x
    if abs(cross) > 1e-9:
        on_a, on_b = (dx * b.ahead_y - dy * b.ahead_x) / cross, (dx * a.ahead_y - dy * a.ahead_x) / cross
        if abs(on_a) <= a.half and abs(on_b) <= b.half:
            return -a.radius - b.radius
    least = inf
    for k in range(2):
        s = 2 * k - 1
        mine = _to_line(s * a.half * a.ahead_x - dx, s * a.half * a.ahead_y - dy, b.ahead_x, b.ahead_y, b.half)
        its = _to_line(dx + s * b.half * b.ahead_x, dy + s * b.half * b.ahead_y, a.ahead_x, a.ahead_y, a.half)
        least = min(least, mine, its)
    return least - a.radius - b.radius
