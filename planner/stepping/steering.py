"""Steering over land: how far one can go straight on, the nearest clear heading, and a step toward it.

The walker's middle goes in front of it. A heading too far away is reached by short steps that turn: the place where the
walker is is always clear, so it can always turn round, and is never trapped.
"""

from math import cos, pi, sin, sqrt
from typing import NamedTuple

from motion.characters.dimensions import Dimensions
from planner.stepping.footing import STALLED, level_way
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit, jit_borrowing

LOOK_STEPS = 3.0
"""Look-ahead in preferred steps."""
FAN = 15
"""Headings tried to either side, spread over half a turn."""
MARGIN = 0.08
"""Tolerance kept beyond the body's radius [m]."""

SECTIONS, LAST = 3, 0.6
"""Room is measured across the course in so many places, from where one is to this share of how far one looks."""
BESIDE = 0.02
"""Kept from walls as room is measured [m]: people per square metre are counted up to the walls."""


class Onward(NamedTuple):
    """Where a step brings the walker's middle."""

    x: float  # [m]
    y: float
    heading: float  # [rad]
    course: float  # where it goes on to, which the step may not reach [rad]


@jit_borrowing
def free_way(
    biped: Dimensions, world: WorldArrays, x: float, y: float, course: float, margin: float, far: float
) -> float:  # fmt: skip
    """Distance [m] that one can go straight on with at least `margin` around, over ground that it can walk, at most `far`."""
    return level_way(biped, world, x, y, course, _open_way(world, x, y, course, margin, far))


@jit_borrowing
def room_at(biped: Dimensions, world: WorldArrays, x: float, y: float) -> float:
    """The margin [m] for a way from a place: the body's radius, or what there is of it where it is narrow already."""
    return min(biped.body.radius, queries.clearance(world, x, y) - 0.01)


@jit_borrowing
def _open_way(world: WorldArrays, x: float, y: float, course: float, margin: float, far: float) -> float:
    """The same, whatever the ground."""
    c, s, done = cos(course), sin(course), 0.0
    while done < far:
        room = queries.clearance(world, x + done * c, y + done * s) - margin
        if room < 0:
            return done - 0.05 if done > 0.05 else 0.0
        done += max(room, 0.05)
    return far


@jit_borrowing
def open_ahead(
    biped: Dimensions, world: WorldArrays, x: float, y: float, course: float, room: float, far: float, least: float
) -> float:  # fmt: skip
    """The share that walls leave of half a disc `far` [m] deep ahead, in which what is near counts more
    (planner.crowd.terms.covered): of the widest of SECTIONS across it, and no less than `least`.

    So a long neck is as dense as it is between its walls, and who comes to the end of one counts the room behind it: people
    speed up where a throng ends. room: to the nearest wall [m].
    """
    if room > far:
        return 1.0
    part, margin = least, min(BESIDE, room - 0.01)
    for k in range(SECTIONS):
        at = k / (SECTIONS - 1) * LAST * far
        if free_way(biped, world, x, y, course, margin, at) < at:
            break
        px, py, across = x + at * cos(course), y + at * sin(course), sqrt(far * far - at * at)
        left = free_way(biped, world, px, py, course + 0.5 * pi, margin, across) / across
        right = free_way(biped, world, px, py, course - 0.5 * pi, margin, across) / across
        part = max(part, 0.25 * (left * (3 - left * left) + right * (3 - right * right)))
    return part


@jit_borrowing
def clear_course(
    biped: Dimensions, world: WorldArrays, x: float, y: float, wanted: float, margin: float, look: float, right_first: bool
) -> float:  # fmt: skip
    """The offset [rad] from the wanted course that is nearest to it with a way as long as `look`, else the freest."""
    best, best_free = 0.0, -1.0
    for k in range(FAN + 1):
        for turn in range(2 if k else 1):
            sign = 1.0 if (turn == 0) != right_first else -1.0
            offset = sign * k * pi / FAN
            free = free_way(biped, world, x, y, wanted + offset, margin, look)
            if free >= look:
                return offset
            if free > best_free:
                best, best_free = offset, free
    return best


@jit
def longest_way(biped: Dimensions, world: WorldArrays, x: float, y: float, far: float) -> float:
    """Distance [m] that one can go straight on from there in the freest direction, at most `far`."""
    longest, margin = 0.0, room_at(biped, world, x, y)
    for k in range(2 * FAN):
        longest = max(longest, free_way(biped, world, x, y, k * pi / FAN, margin, far))
    return longest


@jit_borrowing
def step_toward(
    biped: Dimensions, world: WorldArrays, middle: tuple[float, float], heading: float, wanted: float, look: float,
    right_first: bool,
) -> Onward:  # fmt: skip
    """A step toward the clear course that is nearest to the wanted one, shorter where it turns."""
    margin = min(biped.body.radius + MARGIN, queries.clearance(world, middle[0], middle[1]) - 0.01)
    return step_within(biped, world, middle, heading, wanted, look, right_first, margin)


@jit_borrowing
def step_within(
    biped: Dimensions, world: WorldArrays, middle: tuple[float, float], heading: float, wanted: float, look: float,
    right_first: bool, margin: float,
) -> Onward:  # fmt: skip
    """The same, with at least `margin` [m] around."""
    x, y = middle
    most, stride = biped.reach.max_turn, biped.gait.preferred_step
    course = wanted + clear_course(biped, world, x, y, wanted, margin, look, right_first)
    if look < stride and level_way(biped, world, x, y, course, stride) < STALLED * stride:
        course = wanted + clear_course(biped, world, x, y, wanted, margin, stride, right_first)
    turn = min(max(course - heading, -most), most)
    free = free_way(biped, world, x, y, heading + turn, margin, stride)
    length = min(stride * max(1 - 0.5 * abs(turn) / most, 0.3), free)
    return Onward(x + length * cos(heading + turn), y + length * sin(heading + turn), heading + turn, course)


@jit_borrowing
def lengthened(on: Onward, middle: tuple[float, float], share: float) -> Onward:
    """The same step, `share` times as long."""
    x, y = middle
    return Onward(x + share * (on.x - x), y + share * (on.y - y), on.heading, on.course)
