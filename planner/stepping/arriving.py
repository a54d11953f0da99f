"""Walking to a place over open land, and coming to rest there."""

from math import atan2, cos, hypot, sin
from typing import NamedTuple

import numpy as np

from motion.arithmetic.angles import unwrapped
from motion.characters.dimensions import Dimensions
from planner.round.reservations import COMMITTED, line_distance, neighbours
from planner.round.round import PATIENT, Me, Round, Wish, biped_of, standing
from planner.stepping import random
from planner.stepping.beside import Place, are_together
from planner.stepping.field import course_down
from planner.stepping.finding import surely
from planner.stepping.steering import LOOK_STEPS, Onward, free_way, lengthened, room_at, step_toward, step_within
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit, jit_borrowing

STAND_TIME = 0.5
"""A standing character plans again after this time [s]."""
FORESIGHT, GLANCE = 3.0, 0.4
"""One looks so many preferred steps down a way, in glances of so many."""
AT_HAND = 0.2
"""Down a field one looks so many preferred steps ahead: it knows of what lies beyond."""
SIGHT = 6.0
"""A stop that is nearer than so many preferred steps, and to be seen, is walked to straight."""
THERE, CONTENT = 0.5, 0.25
"""A walker is at the place where it stays within this share of its preferred step, and more for every step that others hindered
while one of them is in its way there."""
CROWDED, WIDEST = 32, 4.0
"""Among more than so many one's place is taken; others reach no further to it than so many of one's own half widths."""


@jit_borrowing
def walk_on(
    biped: Dimensions, world: WorldArrays, middle: Place, heading: float, stop: Place, seed: int, who: tuple[int, int]
) -> Onward:
    """A step of the walker whose middle is there on its way to a stop, not beyond it; who: character and step."""
    (x, y), (character, step) = middle, who
    dx, dy = stop[0] - x, stop[1] - y
    far = hypot(dx, dy)
    right_first = random.uniform(seed, character, 0, random.SIDE) < 0.5
    look = min(biped.gait.preferred_step * LOOK_STEPS, far)
    on = step_toward(biped, world, middle, heading, unwrapped(atan2(dy, dx), heading), look, right_first)
    share = random.near_one(seed, character, step, biped.gait.variation)
    return lengthened(on, middle, min(far / max(hypot(on.x - x, on.y - y), 1e-9), share))


@jit_borrowing
def drawn(draw: Place, course: float) -> float:
    """A course [rad], turned toward those with whom one walks."""
    return course if draw[0] == 0 and draw[1] == 0 else atan2(sin(course) + draw[1], cos(course) + draw[0])


class Outlook(NamedTuple):
    """Where a way leads."""

    course: float  # to the furthest place of it that one sees [rad]
    ahead_x: float  # unit vector to where it leads in FORESIGHT
    ahead_y: float


@jit_borrowing
def look_down(
    biped: Dimensions, world: WorldArrays, middle: Place, field: np.ndarray, cell: float, stop: Place
) -> Outlook:  # fmt: skip
    """The way down the field of a stop. One makes for the furthest place of it that one sees, as people do (Kneidl, Borrmann &
    Hartmann 2012): cells are coarse, and beside a door all of their slopes lead into one file through its middle."""
    (x, y), seen = middle, True
    step, margin = GLANCE * biped.gait.preferred_step, room_at(biped, world, x, y)
    down = course = course_down(field, cell, x, y, atan2(stop[1] - y, stop[0] - x))
    for _ in range(int(FORESIGHT / GLANCE)):
        x, y = x + step * cos(down), y + step * sin(down)
        far, there = hypot(x - middle[0], y - middle[1]), atan2(y - middle[1], x - middle[0])
        seen = seen and free_way(biped, world, middle[0], middle[1], there, margin, far) >= far
        if seen:
            course = there
        down = course_down(field, cell, x, y, atan2(stop[1] - y, stop[0] - x))
    far = max(hypot(x - middle[0], y - middle[1]), 1e-9)
    return Outlook(course, (x - middle[0]) / far, (y - middle[1]) / far)


@jit_borrowing
def walk_down(round: Round, me: Me, middle: Place, course: float, draw: Place) -> Onward:
    """A step down a way (Outlook), close by walls: it leads through doors; draw: toward those with whom one walks."""
    biped, foot, (x, y) = biped_of(round, me), me.feet.newer, middle
    right_first = random.uniform(round.seed, me.c, 0, random.SIDE) < 0.5
    margin, look = room_at(biped, round.world, x, y), AT_HAND * biped.gait.preferred_step
    wanted = unwrapped(drawn(draw, course), foot.heading)
    return step_within(biped, round.world, middle, foot.heading, wanted, look, right_first, margin)


@jit_borrowing
def sees(round: Round, me: Me, middle: Place, stop: Place) -> bool:
    """Whether the straight way to a stop is near and free, so that no field is needed."""
    biped, dx, dy = biped_of(round, me), stop[0] - middle[0], stop[1] - middle[1]
    far, (x, y) = hypot(dx, dy), middle
    margin = room_at(biped, round.world, x, y)
    return far < SIGHT * biped.gait.preferred_step and free_way(biped, round.world, x, y, atan2(dy, dx), margin, far) >= far


@jit_borrowing
def is_content(round: Round, me: Me, middle: Place, goal: Place) -> bool:
    """Whether the walker has come to the place where it stays, or as near to it as others let it."""
    stride, far = biped_of(round, me).gait.preferred_step, hypot(goal[0] - middle[0], goal[1] - middle[1])
    if far < THERE * stride:
        return True
    return far < (THERE + CONTENT * min(me.hindered, PATIENT)) * stride and _is_taken(round, me, middle, far, goal)


@jit
def _is_taken(round: Round, me: Me, middle: Place, far: float, goal: Place) -> bool:
    """Whether another rests on a place, `far` away [m], or on the straight way to it."""
    held, c, near = round.reservations, me.c, np.empty(CROWDED, np.int64)
    dx, dy = goal[0] - middle[0], goal[1] - middle[1]
    count = neighbours(held, c, min(far + WIDEST * held.half[c, 1], held.reach), near)
    for i in range(count):
        x, y = held.path[near[i], COMMITTED - 1, 0] - middle[0], held.path[near[i], COMMITTED - 1, 1] - middle[1]
        apart = held.half[c, 1] + held.half[near[i], 1]
        if x * dx + y * dy > 0 and line_distance(x, y, x - dx, y - dy) < apart:
            return True
    return count < 0


@jit_borrowing
def arrive(round: Round, me: Me, middle: Place) -> Wish:
    """At the last stop: the foot behind comes beside the other one, and then it stands."""
    biped, older, newer = biped_of(round, me), me.feet.older, me.feet.newer
    if older.side != newer.side and not are_together(biped, older, newer):
        return surely(round, me, middle, newer.heading, newer.heading, False)
    still = standing(me, STAND_TIME)
    return Wish(still.step, still.course, still.longest, True, True)
