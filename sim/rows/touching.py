"""Who touches whom, and how far bodies that would lie in each other press.

How others move is known: what is committed, and what they expect to do with the feet that they have placed.
"""

from math import cos, hypot, sin
from typing import Any, NamedTuple

import numpy as np

from motion.arithmetic.triples import Triple
from motion.track.curve import place_at, up_to
from motion.track.heading import body_heading
from planner.crowd.bodies import press_between
from planner.round.reservations import Reservations, neighbours, strays
from sim.rows.crowd import TENTATIVE, Crowd, committed_of, footprints_of, horizon
from worlds.compiled.jit import jit_borrowing
from worlds.compiled.tables import row

NEAR = 0.55
"""Others are looked for within this share of the reach: two bodies and three steps."""
SWAYS = 1.1
"""Bodies that sway beside their ways do not reach further than so many times what is held for them."""
THROUGH = 0.5
"""Who would lie deeper in another than this share of half its depth goes through it, and is not pressed: a planner wants it so
that avoids nobody."""


class Box(NamedTuple):
    """Within which middles lie [m]."""

    left: float
    right: float
    low: float
    high: float


@jit_borrowing
def until_of(crowd: Crowd, c: int) -> float:
    """Until when it is known how c moves: its newest foot lands then [s]."""
    return crowd.footprints.contact_time[c, crowd.real[c] - 1]


@jit_borrowing
def place_of(crowd: Crowd, c: int, t: float) -> Triple:
    """Where the com of c is at a time [s], on the committed curve, or beyond it where c expects to be."""
    if t <= horizon(crowd, c) or crowd.points[c] < 2:
        return place_at(committed_of(crowd, c), t)
    return place_at(up_to(row(crowd.window, c), crowd.points[c] - 1), t)


@jit_borrowing
def _facing(crowd: Crowd, bipeds: Any, c: int, t: float) -> tuple[float, float]:
    """Where c's body faces then: a unit vector."""
    expected = TENTATIVE if crowd.points[c] > 1 else 0
    heading = body_heading(bipeds[crowd.kind[c]], footprints_of(crowd, c, crowd.real[c] + expected), t)
    return cos(heading), sin(heading)


@jit_borrowing
def _half(crowd: Crowd, bipeds: Any, held: Reservations, c: int) -> tuple[float, float]:
    """Half axes of c's body, without the room that it keeps [m]."""
    ahead, aside = strays(bipeds[crowd.kind[c]])
    return held.half[c, 0] - ahead, held.half[c, 1] - aside


@jit_borrowing
def _around(box: Box, x: float, y: float) -> Box:
    return Box(min(box.left, x), max(box.right, x), min(box.low, y), max(box.high, y))


@jit_borrowing
def _way_of(crowd: Crowd, c: int) -> Box:
    """Where the middle of c goes with the footprint that it has just placed."""
    (x, y, _), position, n = place_of(crowd, c, horizon(crowd, c)), crowd.footprints.position, crowd.real[c] - 1
    box = Box(x, x, y, y)
    for i in range(n - 1, n + 1):
        u, v = 0.5 * (position[c, i - 1, 0] + position[c, i, 0]), 0.5 * (position[c, i - 1, 1] + position[c, i, 1])
        box = _around(box, u, v)
    return box


@jit_borrowing
def _meets(held: Reservations, j: int, box: Box, reach: float) -> bool:
    """Whether the path that j has published comes as near as `reach` [m] to a box, along either axis."""
    path = held.path[j]
    its = _around(Box(path[0, 0], path[0, 0], path[0, 1], path[0, 1]), path[1, 0], path[1, 1])
    its = _around(its, path[2, 0], path[2, 1])
    beside, above = max(its.left - box.right, box.left - its.right), max(its.low - box.high, box.low - its.high)
    return beside < reach and above < reach


@jit_borrowing
def close(crowd: Crowd, held: Reservations, c: int, near: np.ndarray) -> int:
    """Fills `near` with those whom c may touch with the footprint that it has just placed; returns how many."""
    mine, kept, reach = max(held.half[c, 0], held.half[c, 1]), 0, NEAR * held.reach
    count = neighbours(held, c, reach, near)
    while count < 0:
        reach *= 0.75
        count = neighbours(held, c, reach, near)
    box = _way_of(crowd, c)
    for i in range(count):
        j = near[i]
        if _meets(held, j, box, SWAYS * (mine + max(held.half[j, 0], held.half[j, 1]))):
            near[kept] = j
            kept += 1
    return kept


@jit_borrowing
def press(crowd: Crowd, bipeds: Any, held: Reservations, c: int, t: float, near: np.ndarray) -> tuple[float, float]:
    """How far, and where to, others press c's body at a time [s]: x, y [m]."""
    mine, (x, y, _), right, up = _half(crowd, bipeds, held, c), place_of(crowd, c, t), 0.0, 0.0
    for j in near:
        if t > until_of(crowd, j):
            continue
        its, (u, v, _) = _half(crowd, bipeds, held, j), place_of(crowd, j, t)
        dx, dy = u - x, v - y
        if hypot(dx, dy) < max(mine[0], mine[1]) + max(its[0], its[1]):
            press = press_between(mine, _facing(crowd, bipeds, c, t), its, _facing(crowd, bipeds, j, t), dx, dy)
            if 0 < press.deep < THROUGH * mine[0]:
                right -= press.deep * press.x
                up -= press.deep * press.y
    return right, up
