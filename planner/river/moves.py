"""What it costs to step from one spot to another, in seconds: its time, and what its effort is worth."""

from math import atan2, hypot, sin
from typing import NamedTuple

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT
from planner.stepping.timing import step_timing
from worlds.compiled.jit import jit

SHARPEST = 2.2
"""Largest angle between two steps in a row, in units of the character's max_turn: headings turn by half of it."""
LONG, LONG_TURN = 1.3, 1.3
"""The same after a step that is longer than this share of the preferred one: who leaps does not turn much."""
LEAP_EFFORT, HOP_EFFORT, TURN_EFFORT, CLIMB_EFFORT, CROSSING_EFFORT = 0.6, 0.4, 0.3, 0.8, 1.5
"""Seconds that effort is worth: a leap; a hop on one side; a radian of turn; a climb of the hip's height; a foot crossed by
a preferred step."""


class Spots(NamedTuple):
    """K spots, and behind them the start and the goal."""

    place: np.ndarray  # (K + 2, 3) [m]
    rock: np.ndarray  # (K,) -1 on a bank
    cell: np.ndarray  # (K + 2, 2) row and column of the land that one walks to it and from it by; -1: on no land


@jit
def slowest_pace(biped: Dimensions) -> float:
    """Seconds per metre of walking on land."""
    stride = biped.gait.preferred_step
    return step_timing(biped, stride, 0.0, 0.0, False)[0] / stride


@jit
def step_cost(biped: Dimensions, length: float, rise: float, turn: float, crossed: float, hop: bool) -> float:
    """Cost of a step or of a hop on the same side [s]: its time, and what its effort is worth."""
    effort = (LEAP_EFFORT if length > biped.reach.max_step else 0.0) + (HOP_EFFORT if hop else 0.0)
    effort += TURN_EFFORT * turn + CLIMB_EFFORT * max(rise, 0.0) / biped.timing.hip_height
    effort += CROSSING_EFFORT * crossed / biped.gait.preferred_step
    return step_timing(biped, length, rise, 0.5 * turn, hop)[0] + effort


@jit
def fastest(biped: Dimensions) -> float:
    """Largest distance per cost [m/s] of any step or walk."""
    best = 1 / slowest_pace(biped)
    for k in range(1, 101):
        length = biped.reach.max_leap * k / 100
        for rise in (0.0, -biped.reach.max_drop):
            for hop in (False, True):
                best = max(best, length / step_cost(biped, length, rise, 0.0, 0.0, hop))
    return best


@jit
def can_step(biped: Dimensions, spots: Spots, i: int, j: int) -> bool:
    """Whether the character's reach allows a step from spot i to spot j, whatever the direction."""
    place, reach = spots.place, biped.reach
    length = hypot(place[j, 0] - place[i, 0], place[j, 1] - place[i, 1])
    rise = place[j, 2] - place[i, 2]
    if spots.rock[i] < 0 and spots.rock[j] < 0 and length < 0.5 * reach.max_step:
        return False
    return biped.foot.width <= length <= reach.max_leap and -reach.max_drop <= rise <= reach.max_rise


@jit
def directed_cost(biped: Dimensions, place: np.ndarray, before: int, i: int, j: int, foot: int, hop: bool) -> float:
    """Cost of a step from spot i, where `foot` stands, to j, coming from `before` (-1: none); place (K, 3).

    The other foot steps, or with `hop` the same one, no farther than a walking step. inf if it would turn too sharply or
    cross the legs too far.
    """
    stride = biped.gait.preferred_step
    dx, dy = place[j, 0] - place[i, 0], place[j, 1] - place[i, 1]
    length = hypot(dx, dy)
    ahead = atan2(dy, dx)
    came = atan2(place[i, 1] - place[before, 1], place[i, 0] - place[before, 0]) if before >= 0 else ahead
    turned = wrapped(ahead - came)
    sharpest = LONG_TURN if length > LONG * stride else SHARPEST
    if abs(turned) > (3.0 if length < 0.6 * stride else sharpest * biped.reach.max_turn):
        return np.inf
    across = length * sin(turned)
    crossed = 0.0 if hop else max(across if foot == LEFT else -across, 0.0)
    if crossed > 0.45 * stride or (hop and length > biped.reach.max_step):
        return np.inf
    return step_cost(biped, length, place[j, 2] - place[i, 2], abs(turned), crossed, hop)
