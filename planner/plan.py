"""The next footprint of any character, whatever plans it: one kernel, four modes.

A planner object prepares Plans, arrays over characters; the crowd asks `next_footprint` for one footprint after the other,
real ones and, with higher step numbers, tentative ones. Nothing is remembered between them but how many stops a walker has
reached, which the crowd keeps.
"""

from math import atan2, cos, hypot, sin
from typing import NamedTuple

import numpy as np

from planner.stepping import placing, random, timing
from planner.wander import free_way, walk_step, wander_step
from worlds import queries
from worlds.compiled.jit import jit_borrowing

WANDER, ROUTE, STAND, WALK = 0, 1, 2, 3
STAND_TIME = 0.5
"""A standing character plans again after this time [s]."""
START_OVERLAP = 0.6
"""Shift of weight before the first step from standing, in pendulum times sqrt(h / g)."""
THERE, CONTENT = 0.5, 0.25
"""A walker is at its last stop within this share of its preferred step, and more for every step that others hindered."""
ABEAM = 0.7
"""Whom others hinder has passed a stop on the way once the cosine between its direction and the leg to it is below this."""
PATIENT = 8
"""Up to so many steps that others hindered make one more impatient, and more content."""


class Plans(NamedTuple):
    """What C characters are up to."""

    mode: np.ndarray  # (C,) WANDER, ROUTE, STAND or WALK
    route_begin: np.ndarray  # (C,) number of the step to the route's first footprint
    route_length: np.ndarray  # (C,)
    route: np.ndarray  # (C, R, 4) side, x, y, heading (unwrapped)
    start: np.ndarray  # (C, 2) where a walker sets out
    stops: np.ndarray  # (C, P, 2) places to walk to, one after the other
    again: np.ndarray  # (C,) bool: from the last stop on to the first
    near: np.ndarray  # (C,) a stop on the way is reached within this distance [m]


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
    way: float  # [rad] where it goes on to: it cannot turn at once
    longest: float  # step time of a walk, in pendulum times
    wait: float  # [s] until the next plan, where it stands


def plans_of(mode: int, characters: int, routes: int = 0, stops: int = 0) -> Plans:
    """Plans in which all characters do the same, with room for routes and stops of that length."""
    c = characters
    return Plans(
        np.full(c, mode, np.int64),
        np.zeros(c, np.int64),
        np.zeros(c, np.int64),
        np.zeros((c, routes, 4)),
        np.zeros((c, 2)),
        np.zeros((c, stops, 2)),
        np.zeros(c, np.bool_),
        np.zeros(c),
    )


@jit_borrowing
def put(b, w, side, x, y, heading, way, longest):
    """Footprint of foot `side` whose sole's middle is at x, y: on a rock or the terrain; see Placed."""
    rock = queries.rock_under(w, x, y, placing.EDGE)
    z, nx, ny, nz = placing.lay_sole(b, w, x, y, heading, rock)
    return Placed(side, x, y, z, heading, nx, ny, nz, rock, False, way, longest, 0.0)


@jit_borrowing
def middle_of(b, side, x, y, heading):
    """Middle of the walker whose foot `side` stands at x, y."""
    across = 0.5 * b.step_width if side == 1 else -0.5 * b.step_width
    return x - across * sin(heading), y + across * cos(heading)


@jit_borrowing
def beside(b, side, x, y, heading):
    """Where foot `side` of a walker stands whose middle is at x, y."""
    across = -0.5 * b.step_width if side == 1 else 0.5 * b.step_width
    return x - across * sin(heading), y + across * cos(heading)


@jit_borrowing
def stay(side, position, heading, normal, rock, wait):
    """The foot stands where it is for another `wait` [s]."""
    return Placed(
        side, position[0], position[1], position[2], heading, normal[0], normal[1], normal[2], rock, True, heading,
        timing.LONGEST_STEP, wait,
    )  # fmt: skip


@jit_borrowing
def hurried(f, longest):
    """The same footprint, in another longest step time."""
    return Placed(f.side, f.x, f.y, f.z, f.heading, f.nx, f.ny, f.nz, f.rock, f.stands, f.way, longest, f.wait)


@jit_borrowing
def scripted(b, w, script, k, track):
    """Footprint of row k of a planner.script.script.Script, after a track that ends in the last two footprints."""
    n = len(track.side)
    if script.wait[k] > 0:
        rock = queries.rock_under(w, track.position[n - 2, 0], track.position[n - 2, 1], placing.EDGE)
        return stay(script.side[k], track.position[n - 2], track.heading[n - 2], track.normal[n - 2], rock, script.wait[k])
    heading = script.heading[k]
    return put(b, w, script.side[k], script.place[k, 0], script.place[k, 1], heading, heading, timing.LONGEST_STEP)


@jit_borrowing
def stop_of(plans, c, reached):
    """Which stop character c walks to after it has reached so many."""
    stops = plans.stops.shape[1]
    return reached % stops if plans.again[c] else min(reached, stops - 1)


@jit_borrowing
def is_last_stop(plans, c, reached):
    """Whether the stop that character c walks to is its last."""
    return not plans.again[c] and reached >= plans.stops.shape[1] - 1


@jit_borrowing
def is_there(b, w, plans, c, reached, hindered, x, y):
    """Whether character c, whose middle is at x, y, has come to the stop that it walks to, or past it on its way."""
    stop = stop_of(plans, c, reached)
    far = hypot(plans.stops[c, stop, 0] - x, plans.stops[c, stop, 1] - y)
    if is_last_stop(plans, c, reached):
        return far < (THERE + CONTENT * min(hindered, PATIENT)) * b.preferred_step
    return far < plans.near[c] or _is_past(b, w, plans, c, reached, x, y, ABEAM if hindered > 0 else 0.0)


@jit_borrowing
def _is_past(b, w, plans, c, reached, x, y, abeam):
    """Whether the stop lies behind, or more to the side than `abeam` (a cosine), and the way to the next one is free.

    Whom others have pushed past a stop, or kept off it, does not make for it across their way: that would block a gap.
    """
    stop, from_x, from_y = stop_of(plans, c, reached), plans.start[c, 0], plans.start[c, 1]
    if reached > 0:
        before = stop_of(plans, c, reached - 1)
        from_x, from_y = plans.stops[c, before, 0], plans.stops[c, before, 1]
    stop_x, stop_y = plans.stops[c, stop, 0], plans.stops[c, stop, 1]
    leg_x, leg_y, to_x, to_y = stop_x - from_x, stop_y - from_y, stop_x - x, stop_y - y
    if to_x * leg_x + to_y * leg_y >= abeam * hypot(to_x, to_y) * hypot(leg_x, leg_y):
        return False
    then = stop_of(plans, c, reached + 1)
    dx, dy = plans.stops[c, then, 0] - x, plans.stops[c, then, 1] - y
    far = hypot(dx, dy)
    return free_way(w, x, y, atan2(dy, dx), min(b.body_radius, queries.clearance(w, x, y) - 0.01), far) >= far


@jit_borrowing
def avoids(plans, c):
    """Whether character c goes around others: those on a route have no choice of places."""
    return plans.mode[c] == WANDER or plans.mode[c] == WALK


@jit_borrowing
def next_footprint(b, w, plans, c, seed, step, reached, hindered, side, position, heading, normal, rock):
    """Footprint number `step` of character c after the last two, given as rows 0 and 1: side (2,), position (2, 3), ...

    `reached` is how many stops a walker has reached, `hindered` how many of its latest steps others kept from getting on.
    """
    number = step - plans.route_begin[c]
    walking = avoids(plans, c) or (plans.mode[c] == ROUTE and number < plans.route_length[c])
    if step <= 2 or not walking or number < 0:
        wait = 0.3 + 0.5 * random.uniform(seed, c, step, random.WAIT) if step <= 2 else STAND_TIME
        return stay(side[0], position[0], heading[0], normal[0], rock[0], wait)
    if plans.mode[c] == ROUTE:
        f = plans.route[c, number]
        return put(b, w, int(f[0]), f[1], f[2], f[3], f[3], timing.LONGEST_STEP)
    x, y = middle_of(b, side[1], position[1, 0], position[1, 1], heading[1])
    if plans.mode[c] == WALK:
        there = is_there(b, w, plans, c, reached, hindered, x, y)
        if there and is_last_stop(plans, c, reached):
            return stay(side[0], position[0], heading[0], normal[0], rock[0], STAND_TIME)
        stop = stop_of(plans, c, reached + there)
        x, y, ahead, way = walk_step(b, w, x, y, heading[1], plans.stops[c, stop], seed, c)
    else:
        x, y, ahead, way = wander_step(b, w, x, y, heading[1], seed, c, step)
    x, y = beside(b, 1 - side[1], x, y, ahead)
    return put(b, w, 1 - side[1], x, y, ahead, way, timing.LONGEST_STEP)
