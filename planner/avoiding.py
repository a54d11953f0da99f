"""Going around others: a step that conflicts with nobody's reservations, near the one wanted.

Candidates are steps with other turns and lengths, side steps, steps back, turns on the spot, and standing. Each costs

    |v - v_wanted| / |v_preferred| + TURN |heading - wanted heading| + CAUTION (1 / ttc - 1 / FORESIGHT)

with ttc the predicted time to collision with anyone, who goes on as its tentative footprints say (the sampled form of
reciprocal velocity obstacles; van den Berg, Lin & Manocha 2008). The cheapest candidate that is clear of trees and of what
others hold is taken. Standing is always clear.

Where the wish runs into someone, the wanted heading is the one that comes nearest to a place LOOK ahead on the wished way when
one goes as far as it is free (Moussaid, Helbing & Theraulaz 2011), and that has on its left those who come the other way: so
streams part into lanes before they meet. Whoever gets on badly grows impatient: it comes nearer to others, staying in place
costs more, and chance has a say, which loosens jams.
"""

from math import atan2, cos, hypot, inf, pi, sin, sqrt
from typing import NamedTuple

import numpy as np

from motion.jit import jit
from planner import plan, random, reservations, timing
from planner.reservations import COMMITTED, TENTATIVE
from planner.wander import MARGIN, free_way
from worlds import queries

FORESIGHT = 2.0
"""Collisions later than this [s] do not matter."""
CAUTION = 1.0
"""Weight of an early collision [s]: more swerves earlier and wider."""
TURN = 0.25
"""Cost of a radian off the wanted heading."""
LEFT, ASIDE = 0.3, 0.1
"""Cost of a radian to the left, and of going left for every step that did not get on: who meet head-on pass on the right."""
STAND = 0.15
"""Cost of standing with the feet apart, or of closing feet that are together."""
LOOK, FAN = 5.0, 6
"""How far one looks for a way around, in preferred steps, and for headings to either side, over a right angle."""
IMPATIENCE, CHANCE, PATIENT = 0.1, 0.15, 8
"""Cost of staying where one is and of chance for every step that did not get on, up to so many."""
GETS_ON = 0.4
"""A step gets on that covers this share of the wished one."""
SMALL = 0.4
"""Side steps and steps back, in preferred steps."""
SPACE = 1.08
"""Distance wanted between bodies, in what is kept; the impatient come nearer, down to that."""
KEEP_RIGHT, WIDE, AGAINST = 1.0, 3.0, -0.5
"""Weight of having those who come against one on the left; how far to the right they count, in distances between bodies; the
cosine between two wishes from which on they are against each other."""
EAGER = 0.3
"""Who stands for others is expected to go where it wishes at this share of the full speed, as soon as it can: one queues behind
those of the same way, and turns aside for those who come."""
FOOT_MARGIN = 0.01
"""Room kept between soles [m]."""
CROWDED = 64
"""More others than this in reach, and one stands."""
LEAST_TIME = 0.1
"""Collisions sooner than this [s] cost no more, and velocities are not told from less."""
YIELD_TIME = 0.3
"""Who stands because others are in the way plans again after this time [s]."""
TURNS, LENGTHS = 3, 4
CANDIDATES = (2 * TURNS + 2) * LENGTHS + 3
CLOSING = (2 * TURNS + 2) * (LENGTHS - 1) + TURNS + 1
"""The candidate that sets the foot beside the other."""


class Walker(NamedTuple):
    """Who plans: its last footprint, and when and where its body will be as that one lands."""

    c: int
    side: int  # of the foot to be placed
    foot_x: float  # the last footprint
    foot_y: float
    x: float  # middle, beside it
    y: float
    heading: float
    rest_x: float  # where the body rests: between the last two footprints
    rest_y: float
    time: float  # contact of the last footprint [s]
    there: float  # when the body comes to rest beside it [s]
    overlap: float  # of the last two stances [s]
    margin: float  # kept from trees [m]
    full: float  # speed when nothing hinders [m/s]
    hindered: int  # steps that did not get on


class Step(NamedTuple):
    """A step that may be taken."""

    x: float  # middle
    y: float
    heading: float
    foot_x: float
    foot_y: float
    time: float  # it takes [s]


@jit
def _walker(b, w, c, side, position, heading, contact_time, overlap, hindered):
    x, y = plan.middle_of(b, side[1], position[1, 0], position[1, 1], heading[1])
    rest_x, rest_y = 0.5 * (position[0, 0] + position[1, 0]), 0.5 * (position[0, 1] + position[1, 1])
    margin = min(b.body_radius + MARGIN, queries.clearance(w, x, y))
    full = b.preferred_step / timing.step_timing(b, b.preferred_step, 0.0, 0.0, False)[0]
    return Walker(
        c, 1 - side[1], position[1, 0], position[1, 1], x, y, heading[1], rest_x, rest_y, contact_time,
        contact_time + reservations.lag(b), overlap, margin, full, hindered,
    )  # fmt: skip


@jit
def _step(b, me, x, y, heading):
    """The step to a middle, timed as on level ground: rises only make it later."""
    fx, fy = plan.beside(b, me.side, x, y, heading)
    time, _ = timing.step_timing(b, hypot(fx - me.foot_x, fy - me.foot_y), 0.0, abs(heading - me.heading), False)
    return Step(x, y, heading, fx, fy, max(time, timing.least_step_time(b, me.overlap)))


@jit
def candidate(b, me, wish, k):
    """Candidate k: lengths times turns, the wish's own turn first (0 is the wish), then steps to the side and back."""
    turn = wish.heading - me.heading
    length = hypot(wish.x - me.x, wish.y - me.y)
    kinds = 2 * TURNS + 2
    if k < kinds * LENGTHS:
        if k % kinds:
            turn = (k % kinds - 1 - TURNS) * b.max_turn / TURNS
            length = b.preferred_step * max(1 - 0.5 * abs(turn) / b.max_turn, 0.3)
        length *= (1.0, 0.55, 0.25, 0.0)[k // kinds]
        heading = me.heading + turn
        return _step(b, me, me.x + length * cos(heading), me.y + length * sin(heading), heading)
    ahead, across = ((0.0, 1.0), (1.0, 1.0), (-1.0, 0.0), (0.0, 0.0))[k - kinds * LENGTHS]
    ahead, across = ahead * SMALL * b.preferred_step, across * SMALL * b.preferred_step * (1 - 2 * me.side)
    c, s = cos(me.heading), sin(me.heading)
    return _step(b, me, me.x + ahead * c - across * s, me.y + ahead * s + across * c, me.heading)


@jit
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


@jit
def foresee(r, me, near, others):
    """Fills others (K, 7): place relative to me and velocity as my last footprint lands, room to keep, wished direction."""
    end = COMMITTED + TENTATIVE - 1
    for i, j in enumerate(near):
        x, y = reservations.place_on_way(r, j, me.there, end)
        left = r.way[j, end, 2] - me.there
        others[i, 0], others[i, 1] = x - me.rest_x, y - me.rest_y
        others[i, 2] = (r.way[j, end, 0] - x) / left if left > LEAST_TIME else 0.0
        others[i, 3] = (r.way[j, end, 1] - y) / left if left > LEAST_TIME else 0.0
        aim = hypot(r.aim[j, 0], r.aim[j, 1])
        others[i, 5], others[i, 6] = (r.aim[j, 0] / aim, r.aim[j, 1] / aim) if aim > 0 else (0.0, 0.0)
        if aim > 0 and hypot(others[i, 2], others[i, 3]) < EAGER * me.full:
            others[i, 2], others[i, 3] = EAGER * me.full * others[i, 5], EAGER * me.full * others[i, 6]
        space = SPACE + (1 - SPACE) * me.hindered / PATIENT
        others[i, 4] = space * (r.room[me.c] + r.room[j])


@jit
def _soonest(others, vx, vy, horizon):
    """When a velocity leads to a collision, at most `horizon` [s]."""
    for o in others:
        horizon = min(horizon, time_to_collision(o[0], o[1], o[2] - vx, o[3] - vy, o[4]))
    return horizon


@jit
def _danger(others, vx, vy):
    """Cost of the soonest predicted collision of a velocity."""
    return CAUTION * (1 / max(_soonest(others, vx, vy, FORESIGHT), LEAST_TIME) - 1 / FORESIGHT)


@jit
def wrong_side(others, wished, way, sight):
    """How much going `way` [rad] leaves those who come against the wished one on the right, not the left: lanes form early."""
    wx, wy, ux, uy, total = cos(wished), sin(wished), cos(way), sin(way), 0.0
    for o in others:
        along, left = o[0] * ux + o[1] * uy, ux * o[1] - uy * o[0]
        if o[5] * wx + o[6] * wy < AGAINST and 0 < along < sight and -WIDE * o[4] < left < o[4]:
            total += (1 - along / sight) * min((o[4] - left) / o[4], 1.0)
    return total


@jit
def way_around(b, w, r, me, wish, others):
    """The best direction of travel: where it is free far, and near the wished one."""
    wished = atan2(wish.y - me.y, wish.x - me.x)
    look = LOOK * b.preferred_step
    best, least = wished, inf
    for k in range(-FAN, FAN + 1):
        offset = 0.5 * pi * k / FAN
        vx, vy = me.full * cos(wished + offset), me.full * sin(wished + offset)
        free = min(
            me.full * _soonest(others, vx, vy, look / me.full), free_way(w, me.x, me.y, wished + offset, me.margin - 0.01, look)
        )
        off = look * look + free * free - 2 * look * free * cos(offset) + LEFT * look * look * max(offset, 0.0)
        off += KEEP_RIGHT * look * look * min(wrong_side(others, wished, wished + offset, r.reach), 1.0)
        if off < least:
            best, least = wished + offset, off
    return best


@jit
def is_free(w, r, me, near, step):
    """Whether a step keeps off trees and off all that the others hold; where bodies are too close already, it may part them."""
    length = hypot(step.x - me.x, step.y - me.y)
    if length > 0:
        way = atan2(step.y - me.y, step.x - me.x)
        if queries.clearance(w, step.x, step.y) < me.margin or free_way(w, me.x, me.y, way, me.margin - 0.01, length) < length:
            return False
    rest_x, rest_y = 0.5 * (me.foot_x + step.foot_x), 0.5 * (me.foot_y + step.foot_y)
    for j in near:
        if not reservations.foot_is_free(
            r, j, step.foot_x, step.foot_y, r.foot_radius[me.c] + FOOT_MARGIN, me.time + step.time
        ):
            return False
        apart = r.room[me.c] + r.room[j]
        least = reservations.least_distance(r, j, me.rest_x, me.rest_y, me.there, rest_x, rest_y, me.there + step.time)
        if least < apart:
            now = reservations.least_distance(r, j, me.rest_x, me.rest_y, me.there, me.rest_x, me.rest_y, me.there + step.time)
            if least < now or now >= apart:
                return False
    return True


@jit
def _costs(b, me, wish, wanted, others, seed, step_number, cost):
    """Fills cost (CANDIDATES + 1,): of the wish, of the candidates, and last of standing, for a wanted direction of travel."""
    speed = hypot(wish.x - me.x, wish.y - me.y) / wish.time
    wx, wy = speed * cos(wanted), speed * sin(wanted)
    turned = (wanted - wish.heading + pi) % (2 * pi) - pi
    facing = wish.heading + (turned if speed > 0 else 0.0)
    for k in range(CANDIDATES + 1):
        step = candidate(b, me, wish, k)
        vx, vy = (step.x - me.x) / step.time, (step.y - me.y) / step.time
        if k == CANDIDATES:
            vx, vy = 0.0, 0.0
        cost[k] = (
            hypot(vx - wx, vy - wy) / me.full + TURN * abs(step.heading - facing) + LEFT * max(step.heading - me.heading, 0.0)
        )
        cost[k] += _danger(others, vx, vy)
        cost[k] += IMPATIENCE * me.hindered * max(1 - hypot(vx, vy) * step.time / (SMALL * b.preferred_step), 0.0)
        cost[k] += ASIDE * me.hindered * (vy * cos(wanted) - vx * sin(wanted)) / me.full
        cost[k] += CHANCE * me.hindered * random.uniform(seed, me.c, step_number, random.JAM + k)
    cost[CANDIDATES] += STAND
    if hypot(me.x - me.rest_x, me.y - me.rest_y) < 0.1 * b.preferred_step:
        cost[CLOSING] += STAND


@jit
def choose(b, w, r, me, wish, near, seed, step_number):
    """The best candidate that is free; 0 is the wish, CANDIDATES is standing."""
    others = np.empty((len(near), 7))
    foresee(r, me, near, others)
    if _danger(others, (wish.x - me.x) / wish.time, (wish.y - me.y) / wish.time) == 0 and is_free(w, r, me, near, wish):
        return 0
    cost = np.empty(CANDIDATES + 1)
    _costs(b, me, wish, way_around(b, w, r, me, wish, others), others, seed, step_number, cost)
    while True:
        k = np.argmin(cost)
        if k == CANDIDATES or is_free(w, r, me, near, candidate(b, me, wish, k)):
            return k
        cost[k] = inf


@jit
def make_way(b, w, r, c, wished, side, position, heading, normal, rock, contact_time, overlap, hindered, seed, step_number):
    """(footprint, hindered): what to place (a planner.plan.Placed) after the last two in rows 0 and 1, instead of the wished.

    `hindered` counts the steps that did not get on.
    """
    if wished.stands:
        return wished, 0
    near = np.empty(CROWDED, np.int64)
    count = reservations.neighbours(r, c, r.reach, near)
    if count == 0:
        return wished, 0
    me = _walker(b, w, c, side, position, heading, contact_time, overlap, hindered)
    x, y = plan.middle_of(b, wished.side, wished.x, wished.y, wished.heading)
    wish = _step(b, me, x, y, wished.heading)
    k = choose(b, w, r, me, wish, near[:count], seed, step_number) if count > 0 else CANDIDATES
    if k == 0:
        return wished, max(hindered - 1, 0)
    if k == CANDIDATES:
        return plan.stay(side[0], position[0], heading[0], normal[0], rock[0], YIELD_TIME), min(hindered + 1, PATIENT)
    step = candidate(b, me, wish, k)
    along = (step.x - me.x) * (wish.x - me.x) + (step.y - me.y) * (wish.y - me.y)
    got_on = along > GETS_ON * ((wish.x - me.x) ** 2 + (wish.y - me.y) ** 2)
    hindered = max(hindered - 1, 0) if got_on else min(hindered + 1, PATIENT)
    return plan.put(b, w, me.side, step.foot_x, step.foot_y, step.heading), hindered
