"""A footprint as an action: three numbers from -1 to 1, how far ahead, how far aside, how far turned."""

from math import cos, sin
from typing import Any

import numpy as np

from motion.track.footprints import LEFT, Foot, Step, step_onto
from planner.stepping.beside import beside, middle_beside
from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def acted(biped: Any, foot: Foot, action: np.ndarray, ahead: float, reach: float) -> Step:
    """The step with the other foot that an action asks for, from the walker's middle beside `foot`, mirrored for the right one.

    It goes `ahead` [m] and so much less or more as `reach` [m] says, of a human; others in proportion to their legs.
    """
    side, unit = 1 - foot.side, biped.leg.nominal_length / 0.9
    mirror = 1.0 if side == LEFT else -1.0
    on, aside = unit * (ahead + reach * action[0]), mirror * unit * reach * action[1]
    c, s, (x, y) = cos(foot.heading), sin(foot.heading), middle_beside(biped, foot)
    heading = foot.heading + mirror * biped.reach.max_turn * action[2]
    fx, fy = beside(biped, side, (x + on * c - aside * s, y + on * s + aside * c), heading)
    return step_onto(side, fx, fy, heading)
