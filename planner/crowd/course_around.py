"""Which course to take where the wished one runs into someone.

It is the one that comes nearest to a place LOOK ahead on the wished course when one goes as far as it is free (Moussaid,
Helbing & Theraulaz 2011), and that has on its left those who come the other way: so streams part into lanes before they meet.
Nobody goes around those of its own course who are held up: one queues behind them.
"""

from math import atan2, cos, inf, pi, sin
from typing import Any

import numpy as np

from motion.characters.dimensions import Dimensions
from planner.crowd.candidates import Walker
from planner.crowd.foresight import AGAINST, time_to_collision
from planner.round.round import Round
from planner.stepping.beside import Place
from planner.stepping.steering import MARGIN, free_way
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit_borrowing

LEFTWARD = 0.3
"""Cost of a radian to the left: who meet head-on pass on the right."""
LOOK, FAN = 5.0, 6
"""How far one looks for a way around, in preferred steps, and for courses to either side, over a right angle."""
KEEP_RIGHT, WIDE = 1.0, 3.0
"""Weight of having those who come against one on the left; how far to the right they count, in distances between bodies."""
NARROW, NARROW_AHEAD, SLANTS = 5.0, 7, 2
"""Places narrower than this, in distances between bodies, are passed on the right; looked for so many steps ahead, straight
across the course and at so many slants of 30 degrees to either side."""
LEAST_WAY = 0.3
"""A course around is free of trees for this share of a preferred step: no lane leads into a wall."""
QUEUES = 0.5
"""The cosine between two wishes from which on one queues behind who is held up, instead of going around."""


@jit_borrowing
def keep_right(round: Round, c: int, near: np.ndarray, middle: Place, course: float) -> float:
    """The course [rad] of character c, whose middle is there, to the right half of the narrowest place ahead.

    It is the course that was given where nobody comes against it. So lanes are agreed on before the place is full.
    """
    held, biped, (x, y) = round.reservations, round.bipeds[round.kind[c]], middle
    ux, uy, comes = cos(course), sin(course), False
    for j in near:
        comes |= held.aim[j, 0] * ux + held.aim[j, 1] * uy < AGAINST
    if not comes:
        return course
    margin = min(biped.body.radius + MARGIN, queries.clearance(round.world, x, y)) - 0.01
    return course + _to_the_right(biped, round.world, middle, course, margin, held.room[c])


@jit_borrowing
def _to_the_right(
    biped: Dimensions, world: WorldArrays, middle: Place, course: float, margin: float, room: float
) -> float:  # fmt: skip
    """The turn [rad] from the course to the right half of the narrowest place ahead, `room` [m] off its middle.

    0 where the course leads there.

    How wide a place is, is measured through points of the course, also aslant: it may lead through a gap at an angle.
    """
    least, turn, stride = 2 * NARROW * room, 0.0, biped.gait.preferred_step
    for i in range(NARROW_AHEAD):
        px, py = middle[0] + i * stride * cos(course), middle[1] + i * stride * sin(course)
        if queries.clearance(world, px, py) < margin:
            break
        for k in range(-SLANTS, SLANTS + 1):
            across = pi / 6 * k - 0.5 * pi
            right = free_way(biped, world, px, py, course + across, margin, 2 * NARROW * room)
            left = free_way(biped, world, px, py, course + across + pi, margin, 2 * NARROW * room)
            if right + left < least:
                least, aside = right + left, max(0.5 * (right - left) + room, 0.0)
                turn = atan2(aside * sin(across), max(i, 1) * stride + aside * cos(across))
    return turn


@jit_borrowing
def wrong_side(others: Any, wished: float, course: float, sight: float) -> float:
    """How much a course leaves those who come against the wished one on the right, not the left: lanes form early."""
    wx, wy, ux, uy, total = cos(wished), sin(wished), cos(course), sin(course), 0.0
    for i in range(len(others)):
        other = others[i]
        along, left = other.x * ux + other.y * uy, ux * other.y - uy * other.x
        comes = other.aim_x * wx + other.aim_y * wy < AGAINST
        if comes and 0 < along < sight and -WIDE * other.room < left < other.room:
            total += (1 - along / sight) * min((other.room - left) / other.room, 1.0)
    return total


@jit_borrowing
def _free_of_others(walker: Walker, others: Any, course: float, look: float) -> float:
    """How far one can go on a course at full speed, at most `look` [m]; those held up on the wished course are no obstacles."""
    wx, wy, full, free = cos(walker.course), sin(walker.course), walker.full, look
    vx, vy = full * cos(course), full * sin(course)
    for i in range(len(others)):
        other = others[i]
        if other.vx < inf and not (other.speed > 0 and other.aim_x * wx + other.aim_y * wy > QUEUES):
            free = min(free, full * time_to_collision(other.x, other.y, other.vx - vx, other.vy - vy, other.room))
    return free


@jit_borrowing
def course_around(round: Round, walker: Walker, others: Any) -> float:
    """The best course: where it is free far, and near the wished one."""
    biped = round.bipeds[round.kind[walker.c]]
    wished, stride = walker.course, biped.gait.preferred_step
    look = LOOK * stride
    best, least = wished, inf
    for k in range(-FAN, FAN + 1):
        offset = 0.5 * pi * k / FAN
        free = free_way(biped, round.world, walker.x, walker.y, wished + offset, walker.margin - 0.01, look)
        if k != 0 and free < LEAST_WAY * stride:
            continue
        free = min(free, _free_of_others(walker, others, wished + offset, look))
        off = look * look + free * free - 2 * look * free * cos(offset) + LEFTWARD * look * look * max(offset, 0.0)
        wrong = wrong_side(others, wished, wished + offset, round.reservations.reach)
        off += KEEP_RIGHT * look * look * min(wrong, 1.0)
        if off < least:
            best, least = wished + offset, off
    return best
