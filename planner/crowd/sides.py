"""The one rule for the side: each keeps those who come against it on its left.

So streams part into lanes. Where anyone comes, one makes for the right half of the narrowest place ahead, before it is full.
"""

from math import atan2, cos, pi, sin
from typing import Any

import numpy as np

from motion.characters.dimensions import Dimensions
from planner.crowd.walker import Walker
from planner.round.round import Round
from planner.stepping.beside import Place
from planner.stepping.steering import free_way
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit_borrowing

AGAINST = -0.5
"""The cosine between two wishes from which on they are against each other."""
WIDE, MOST = 2.0, 2.5
"""How far to the right those who come against one count, in widths of two bodies, and how many at most."""
NARROW, AHEAD, SLANTS = 5.0, 7, 2
"""Places narrower than this, in widths of two bodies, are passed on the right; looked for so many steps ahead, straight across
the course and at so many slants of 30 degrees to either side."""


@jit_borrowing
def keep_right(round: Round, c: int, near: np.ndarray, middle: Place, course: float) -> float:
    """The course [rad] of character c, whose middle is there, to the right half of the narrowest place ahead.

    It is the course that was given where nobody comes against it.
    """
    held, biped, (x, y) = round.reservations, round.bipeds[round.kind[c]], middle
    ux, uy, comes = cos(course), sin(course), False
    for j in near:
        comes |= held.aim[j, 0] * ux + held.aim[j, 1] * uy < AGAINST
    if not comes:
        return course
    margin = min(biped.body.radius, queries.clearance(round.world, x, y)) - 0.01
    return course + _to_the_right(biped, round.world, middle, course, margin, held.half[c, 1])


@jit_borrowing
def _to_the_right(
    biped: Dimensions, world: WorldArrays, middle: Place, course: float, margin: float, half: float
) -> float:  # fmt: skip
    """The turn [rad] from the course to the right half of the narrowest place ahead, `half` a body off its middle; 0 where
    the course leads there.

    How wide a place is, is measured through points of the course, also aslant: it may lead through a gap at an angle.
    """
    least, turn, stride = 4 * NARROW * half, 0.0, biped.gait.preferred_step
    for i in range(AHEAD):
        px, py = middle[0] + i * stride * cos(course), middle[1] + i * stride * sin(course)
        if queries.clearance(world, px, py) < margin:
            break
        for k in range(-SLANTS, SLANTS + 1):
            across = pi / 6 * k - 0.5 * pi
            right = free_way(biped, world, px, py, course + across, margin, 4 * NARROW * half)
            left = free_way(biped, world, px, py, course + across + pi, margin, 4 * NARROW * half)
            if right + left < least:
                least, aside = right + left, max(0.5 * (right - left) + half, 0.0)
                turn = atan2(aside * sin(across), max(i, 1) * stride + aside * cos(across))
    return turn


@jit_borrowing
def on_the_right(walker: Walker, others: Any, sight: float) -> float:
    """How many come against me whom I would leave on the right, not on the left; those further away count less, at most MOST.

    None beyond `sight` [m].
    """
    ux, uy, total = cos(walker.course), sin(walker.course), 0.0
    for i in range(len(others)):
        other = others[i]
        if other.along < AGAINST:
            ahead, left = other.x * ux + other.y * uy, ux * other.y - uy * other.x
            room = walker.wide + other.wide
            if 0 < ahead < sight and -WIDE * room < left < room:
                total += (1 - ahead / sight) * min((room - left) / room, 1.0)
    return min(total, MOST)


@jit_borrowing
def wrong_side(walker: Walker, right: float, vx: float, vy: float) -> float:
    """What a velocity costs one who has so many `right` of it who should be left (on_the_right): steps to the right mend it.

    Where there is more than one, one is in their lane: it costs to go on in it, and pays to go back.
    """
    ux, uy = cos(walker.course), sin(walker.course)
    ahead, rightward = (vx * ux + vy * uy) / walker.full, (vx * uy - vy * ux) / walker.full
    return max(right - 1, 0.0) * ahead - right * rightward
