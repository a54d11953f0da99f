"""The next step in few words: going on as one went, where nothing better is known, or an action of three numbers."""

from math import cos, sin
from typing import Any

import numpy as np

from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, Feet, Foot, Step, step_onto
from planner.stepping.beside import beside, middle_beside
from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def going_on(biped: Dimensions, feet: Feet) -> Step:
    """The other foot goes as far as this one went, turned as it turned."""
    older, newer = feet.older, feet.newer
    (x, y), was = middle_beside(biped, newer), middle_beside(biped, older)
    turn, dx, dy = newer.heading - older.heading, x - was[0], y - was[1]
    c, s = cos(turn), sin(turn)
    middle = (x + c * dx - s * dy, y + s * dx + c * dy)
    fx, fy = beside(biped, older.side, middle, newer.heading + turn)
    return step_onto(older.side, fx, fy, newer.heading + turn)


@jit_borrowing
def acted(biped: Any, foot: Foot, action: np.ndarray, ahead: float, reach: float) -> Step:
    """The step with the other foot that an action (3,) asks for: how far ahead, aside and turned, each from -1 to 1.

    It begins at the walker's middle beside `foot`, and is mirrored for the right one. It goes `ahead` [m] and so
    much less or more as `reach` [m] says, of a human; others in proportion to their legs.
    """
    side, unit = 1 - foot.side, biped.leg.nominal_length / 0.9
    mirror = 1.0 if side == LEFT else -1.0
    on, aside = unit * (ahead + reach * action[0]), mirror * unit * reach * action[1]
    c, s, (x, y) = cos(foot.heading), sin(foot.heading), middle_beside(biped, foot)
    heading = foot.heading + mirror * biped.reach.max_turn * action[2]
    fx, fy = beside(biped, side, (x + on * c - aside * s, y + on * s + aside * c), heading)
    return step_onto(side, fx, fy, heading)
