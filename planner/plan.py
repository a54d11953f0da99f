"""The next footprint of any character, whatever plans it: one kernel, three modes.

A planner object prepares Plans, arrays over characters; the crowd asks `next_footprint` for one footprint after the other,
real ones and, with higher step numbers, tentative ones. Nothing else is remembered between them.
"""

from math import cos, sin
from typing import NamedTuple

import numpy as np

from motion.jit import jit
from planner import placing, random
from planner.wander import wander_step
from worlds import queries

WANDER, ROUTE, STAND = 0, 1, 2
STAND_TIME = 0.5
"""A standing character plans again after this time [s]."""
START_OVERLAP = 0.6
"""Shift of weight before the first step from standing, in pendulum times sqrt(h / g)."""


class Plans(NamedTuple):
    """What C characters are up to."""

    mode: np.ndarray  # (C,) WANDER, ROUTE or STAND
    route_begin: np.ndarray  # (C,) number of the step to the route's first footprint
    route_length: np.ndarray  # (C,)
    route: np.ndarray  # (C, R, 4) side, x, y, heading (unwrapped)


class Placed(NamedTuple):
    """A footprint, planned; world frame, SI units."""

    side: int
    x: float
    y: float
    z: float
    heading: float
    nx: float
    ny: float
    nz: float
    rock: int  # -1 on land
    stands: bool  # the foot stays where it is
    wait: float  # [s] until the next plan, where it stands


def plans_of(mode: int, characters: int, routes: int = 0) -> Plans:
    """Plans in which all characters do the same, with room for routes of that length."""
    zero = np.zeros(characters, np.int64)
    return Plans(np.full(characters, mode, np.int64), zero.copy(), zero, np.zeros((characters, routes, 4)))


@jit
def _put(b, w, side, x, y, heading):
    rock = queries.rock_under(w, x, y, placing.EDGE)
    z, nx, ny, nz = placing.lay_sole(b, w, x, y, heading, rock)
    return Placed(side, x, y, z, heading, nx, ny, nz, rock, False, 0.0)


@jit
def middle_of(b, side, x, y, heading):
    """Middle of the walker whose foot `side` stands at x, y."""
    across = 0.5 * b.step_width if side == 1 else -0.5 * b.step_width
    return x - across * sin(heading), y + across * cos(heading)


@jit
def _stay(w, side, position, heading, normal, rock, wait):
    return Placed(side, position[0], position[1], position[2], heading, normal[0], normal[1], normal[2], rock, True, wait)


@jit
def scripted(b, w, script, k, track):
    """Footprint of row k of a planner.script.Script, after a track that ends in the last two footprints."""
    n = len(track.side)
    if script.wait[k] > 0:
        rock = queries.rock_under(w, track.position[n - 2, 0], track.position[n - 2, 1], placing.EDGE)
        return _stay(w, script.side[k], track.position[n - 2], track.heading[n - 2], track.normal[n - 2], rock, script.wait[k])
    return _put(b, w, script.side[k], script.place[k, 0], script.place[k, 1], script.heading[k])


@jit
def next_footprint(b, w, plans, c, seed, step, side, position, heading, normal, rock):
    """Footprint number `step` of character c after the last two, given as rows 0 and 1: side (2,), position (2, 3), ..."""
    number = step - plans.route_begin[c]
    walking = plans.mode[c] == WANDER or (plans.mode[c] == ROUTE and number < plans.route_length[c])
    if step <= 2 or not walking or number < 0:
        wait = 0.3 + 0.5 * random.uniform(seed, c, step, random.WAIT) if step <= 2 else STAND_TIME
        return _stay(w, side[0], position[0], heading[0], normal[0], rock[0], wait)
    if plans.mode[c] == ROUTE:
        f = plans.route[c, number]
        return _put(b, w, int(f[0]), f[1], f[2], f[3])
    x, y = middle_of(b, side[1], position[1, 0], position[1, 1], heading[1])
    x, y, ahead = wander_step(b, w, x, y, heading[1], seed, c, step)
    foot = 1 - side[1]
    across = -0.5 * b.step_width if foot == 1 else 0.5 * b.step_width
    return _put(b, w, foot, x - across * sin(ahead), y + across * cos(ahead), ahead)
