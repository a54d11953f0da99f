"""What others will do, as far as one can tell from what they have published, and when one would run into them."""

from math import cos, hypot, inf, sin, sqrt

from planner.crowd import reservations
from planner.crowd.reservations import COMMITTED, TENTATIVE
from planner.plan import PATIENT
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
OTHER = 9
"""Numbers foreseen of another: x, y, velocity (inf: it gives way), room to keep, wished direction, the rank of its claim (-inf:
no more than one's own), and the speed that it claims."""


@jit_borrowing
def time_to_collision(px, py, vx, vy, apart):
    """When someone at p who moves at v comes within `apart` of the origin [s]: inf never, 0 there and coming nearer."""
    b, c = px * vx + py * vy, px * px + py * py - apart * apart
    if b >= 0:
        return inf
    if c <= 0:
        return 0.0
    a = vx * vx + vy * vy
    d = b * b - a * c
    return c / (-b + sqrt(d)) if d >= 0 else inf


@jit_borrowing
def foresee(r, me, near, rank, others):
    """Fills others (K, OTHER), places relative to me, as my last footprint lands; `rank` is mine (right_of_way)."""
    ux, uy = cos(me.way), sin(me.way)
    for i, j in enumerate(near):
        o = others[i]
        _where_it_goes(r, me, j, o)
        o[5], o[6], o[7], o[8] = r.aim[j, 0], r.aim[j, 1], -inf, hypot(r.claim[j, 0], r.claim[j, 1])
        if gives_way(r, me, rank, ux, uy, j, o):
            o[2], o[3] = inf, inf
        elif o[8] > 0:
            if r.claim[j, 2] > rank:
                o[7] = r.claim[j, 2]
            if hypot(o[2], o[3]) < me.full and (o[7] > -inf or o[5] * ux + o[6] * uy >= AGAINST):
                o[2], o[3] = r.claim[j, 0], r.claim[j, 1]
        space = SPACE + (1 - SPACE) * min(me.hindered, PATIENT) / PATIENT
        o[4] = min(space * (r.room[me.c] + r.room[j]), max(hypot(o[0], o[1]) - CLOSE * r.room[me.c], 0.0))


@jit_borrowing
def gives_way(r, me, rank, ux, uy, j, o):
    """Whether j, who does not come against my way (ux, uy), lets me go first.

    Those behind look out for those before them, as in a queue. Who have each other before them converge: the lower rank waits.
    """
    if hypot(o[5], o[6]) == 0 or o[5] * ux + o[6] * uy < AGAINST:
        return False
    if o[0] * ux + o[1] * uy <= 0:
        return True
    if is_leader(o):
        return False
    return r.claim[j, 2] < rank or (r.claim[j, 2] == rank and j > me.c)


@jit_borrowing
def is_leader(o):
    """Whether another has me behind it."""
    return o[0] * o[5] + o[1] * o[6] >= 0


@jit_borrowing
def _where_it_goes(r, me, j, o):
    """Place and velocity of j, as its tentative footprints say."""
    end = COMMITTED + TENTATIVE - 1
    x, y = reservations.place_on_way(r, j, me.there, end)
    left = r.way[j, end, 2] - me.there
    o[0], o[1] = x - me.rest_x, y - me.rest_y
    o[2] = (r.way[j, end, 0] - x) / left if left > LEAST_TIME else 0.0
    o[3] = (r.way[j, end, 1] - y) / left if left > LEAST_TIME else 0.0


@jit_borrowing
def soonest(others, vx, vy, horizon):
    """When a velocity leads to a collision with one who does not give way, at most `horizon` [s]."""
    for o in others:
        if o[2] < inf:
            horizon = min(horizon, time_to_collision(o[0], o[1], o[2] - vx, o[3] - vy, o[4]))
    return horizon


@jit_borrowing
def danger(others, vx, vy):
    """Cost of the soonest predicted collision of a velocity."""
    return CAUTION * (1 / max(soonest(others, vx, vy, FORESIGHT), LEAST_TIME) - 1 / FORESIGHT)
