"""What others will do, as far as one can tell from what they have published, and when one would run into them."""

from math import cos, hypot, inf, sin, sqrt
from typing import Any

import numpy as np

from planner.crowd.candidates import Walker
from planner.crowd.neighbour import Neighbour
from planner.round.reservations import COMMITTED, TENTATIVE, Reservations, place_on_path
from planner.round.round import PATIENT
from worlds.compiled.jit import jit_borrowing

FORESIGHT = 2.0
"""Collisions later than this [s] do not matter."""
CAUTION = 1.0
"""Weight of an early collision [s]: more swerves earlier and wider."""
SPACE, CLOSE = 1.08, 0.15
"""Distance wanted between bodies, in what is kept; the impatient come nearer, down to that. It is less than there is by this
share of one's room: so among those who touch, coming nearer faster is worse, and backing off counts."""
LEAST_TIME = 0.1
"""Collisions sooner than this [s] cost no more, and velocities are not told from less."""
AGAINST = -0.5
"""The cosine between two wishes from which on they are against each other."""


@jit_borrowing
def time_to_collision(px: float, py: float, vx: float, vy: float, apart: float) -> float:
    """When someone at p who moves at v comes within `apart` of the origin [s]: inf never, 0 there and coming nearer."""
    half_b, c = px * vx + py * vy, px * px + py * py - apart * apart
    if half_b >= 0:
        return inf
    if c <= 0:
        return 0.0
    a = vx * vx + vy * vy
    d = half_b * half_b - a * c
    return c / (-half_b + sqrt(d)) if d >= 0 else inf


@jit_borrowing
def foresee(held: Reservations, walker: Walker, near: np.ndarray, rank: float, others: Any) -> None:
    """Fills others (K,) with those `near` (K,), as my last footprint lands; `rank` is mine (right_of_way)."""
    ahead = cos(walker.course), sin(walker.course)
    for i, j in enumerate(near):
        other = others[i]
        _where_it_goes(held, walker, j, other)
        other.aim_x, other.aim_y, other.rank = held.aim[j, 0], held.aim[j, 1], -inf
        other.speed = hypot(held.claim[j, 0], held.claim[j, 1])
        if gives_way(held, walker, rank, ahead, j, other):
            other.vx, other.vy = inf, inf
        elif other.speed > 0:
            if held.claim[j, 2] > rank:
                other.rank = held.claim[j, 2]
            along = other.aim_x * ahead[0] + other.aim_y * ahead[1]
            if hypot(other.vx, other.vy) < walker.full and (other.rank > -inf or along >= AGAINST):
                other.vx, other.vy = held.claim[j, 0], held.claim[j, 1]
        space = SPACE + (1 - SPACE) * min(walker.hindered, PATIENT) / PATIENT
        mine = held.room[walker.c]
        other.room = min(space * (mine + held.room[j]), max(hypot(other.x, other.y) - CLOSE * mine, 0.0))


@jit_borrowing
def gives_way(held: Reservations, walker: Walker, rank: float, ahead: tuple[float, float], j: int, other: Neighbour) -> bool:
    """Whether j, who does not come against my course, lets me go first.

    Those behind look out for those before them, as in a queue. Who have each other before them converge: the lower rank waits.
    """
    ux, uy = ahead
    if hypot(other.aim_x, other.aim_y) == 0 or other.aim_x * ux + other.aim_y * uy < AGAINST:
        return False
    if other.x * ux + other.y * uy <= 0:
        return True
    if is_leader(other):
        return False
    return held.claim[j, 2] < rank or (held.claim[j, 2] == rank and j > walker.c)


@jit_borrowing
def is_leader(other: Neighbour) -> bool:
    """Whether another has me behind it."""
    return other.x * other.aim_x + other.y * other.aim_y >= 0


@jit_borrowing
def _where_it_goes(held: Reservations, walker: Walker, j: int, other: Neighbour) -> None:
    """Place and velocity of j, as its tentative footprints say."""
    end = COMMITTED + TENTATIVE - 1
    x, y = place_on_path(held, j, walker.there, end)
    left = held.path[j, end, 2] - walker.there
    other.x, other.y = x - walker.rest_x, y - walker.rest_y
    other.vx = (held.path[j, end, 0] - x) / left if left > LEAST_TIME else 0.0
    other.vy = (held.path[j, end, 1] - y) / left if left > LEAST_TIME else 0.0


@jit_borrowing
def soonest(others: Any, vx: float, vy: float, horizon: float) -> float:
    """When a velocity leads to a collision with one who does not give way, at most `horizon` [s]."""
    for i in range(len(others)):
        other = others[i]
        if other.vx < inf:
            horizon = min(horizon, time_to_collision(other.x, other.y, other.vx - vx, other.vy - vy, other.room))
    return horizon


@jit_borrowing
def danger(others: Any, vx: float, vy: float) -> float:
    """Cost of the soonest predicted collision of a velocity."""
    return CAUTION * (1 / max(soonest(others, vx, vy, FORESIGHT), LEAST_TIME) - 1 / FORESIGHT)
