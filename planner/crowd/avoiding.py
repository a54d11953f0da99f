"""Going around others: a step that conflicts with nobody's reservations, near the one wanted.

Each candidate (planner.crowd.candidates) costs

    |v - v_wanted| / |v_preferred| + TURN |heading - facing| + CAUTION (1 / ttc - 1 / FORESIGHT)

with ttc the predicted time to collision with anyone, who goes on as its tentative footprints say (the sampled form of
reciprocal velocity obstacles; van den Berg, Lin & Manocha 2008). The cheapest candidate that is clear of trees and of what
others hold is taken. Standing is always clear.

Where the wish runs into someone, one looks for a way around (planner.crowd.way_around), and those who get on badly have the
right of way (planner.crowd.right_of_way): the others expect them to come. They also grow impatient: they come nearer to others,
staying in place costs more, chance has a say, and short steps are quick ones.
"""

from math import atan2, cos, hypot, inf, pi, sin

import numpy as np

from planner import plan
from planner.crowd import reservations
from planner.crowd.candidates import CANDIDATES, CLOSING, SMALL, candidate, pace, step_to, walker
from planner.crowd.foresight import OTHER, danger, foresee
from planner.crowd.right_of_way import hindered_after, inherited, of_higher_rank, queueing_speed, rank_of
from planner.crowd.way_around import LEFT, keep_right, way_around
from planner.plan import PATIENT
from planner.stepping import random
from planner.wander import free_way
from worlds import queries
from worlds.compiled.jit import jit, jit_borrowing

TURN, ON_THE_SPOT = 0.5, 0.3
"""Cost of a radian off the facing: the wanted heading, or the wished one in steps shorter than this share of the preferred."""
STRAIGHT = 0.05
"""So much [rad] off the wished way is still the wished way."""
ASIDE = 0.1
"""Cost of going left, for every step that did not get on."""
STAND = 0.15
"""Cost of standing with the feet apart, or of closing feet that are together."""
IMPATIENCE, CHANCE = 0.1, 0.15
"""Cost of staying where one is and of chance for every step that did not get on, up to PATIENT."""
FOOT_MARGIN = 0.01
"""Room kept between soles [m]."""
CROWDED = 64
"""More others than this in reach, and one stands."""
YIELD_TIME = 0.2
"""Who stands because others are in the way plans again after this time [s]."""


@jit_borrowing
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


@jit_borrowing
def _turned_to(b, me, way):
    """The heading of one who turns to a way [rad], as far as a step allows."""
    turn = (way - me.heading + pi) % (2 * pi) - pi
    return me.heading + min(max(turn, -b.max_turn), b.max_turn)


@jit_borrowing
def _costs(b, w, r, me, wish, others, seed, step_number, cost):
    """Fills cost (CANDIDATES + 1,): of the wish, of the candidates, and last of standing, as if only `others` were there."""
    wanted = way_around(b, w, r, me, others)
    wx, wy = me.full * cos(wanted), me.full * sin(wanted)
    ahead, onward = _turned_to(b, me, wanted), _turned_to(b, me, me.way)
    impatience = min(me.hindered, PATIENT)
    for k in range(CANDIDATES + 1):
        step = candidate(b, me, wish, k)
        vx, vy = (step.x - me.x) / step.time, (step.y - me.y) / step.time
        if k == CANDIDATES:
            vx, vy = 0.0, 0.0
        cost[k] = (
            hypot(vx - wx, vy - wy) / me.full
            + TURN * abs(step.heading - (ahead if hypot(vx, vy) * step.time >= ON_THE_SPOT * b.preferred_step else onward))
            + LEFT * max(step.heading - max(me.heading, wish.heading), 0.0)
        )
        cost[k] += danger(others, vx, vy)
        cost[k] += IMPATIENCE * impatience * max(1 - hypot(vx, vy) * step.time / (SMALL * b.preferred_step), 0.0)
        cost[k] += ASIDE * impatience * (vy * cos(wanted) - vx * sin(wanted)) / me.full
        cost[k] += CHANCE * impatience * random.uniform(seed, me.c, step_number, random.JAM + k)
    cost[CANDIDATES] += STAND
    if hypot(me.x - me.rest_x, me.y - me.rest_y) < 0.1 * b.preferred_step:
        cost[CLOSING] += STAND


@jit_borrowing
def _claim(b, w, r, me, wish, rank, others, scratch, seed, step_number, claim):
    """Sets claim (3,): the velocity on the wished way, or out of the way of a higher claim; and with which rank."""
    higher, cost = scratch
    speed = queueing_speed(me, others)
    claim[0], claim[1], claim[2] = speed * cos(me.way), speed * sin(me.way), inherited(others, rank)
    if claim[2] > rank:
        count = of_higher_rank(others, higher)
        _costs(b, w, r, me, wish, higher[:count], seed, step_number, cost)
        k = np.argmin(cost)
        if k < CANDIDATES:
            step = candidate(b, me, wish, k)
            claim[0], claim[1] = (step.x - me.x) / step.time, (step.y - me.y) / step.time


@jit_borrowing
def choose(b, w, r, me, wish, straight, near, scratch, seed, step_number, claim):
    """The best candidate that is free; 0 is the wish, CANDIDATES is standing.

    The wish is for those whose way is `straight`. Whoever goes somewhere and cannot have its wish sets its claim.
    """
    others, higher, cost = scratch
    rank = rank_of(r, me, near, me.way)
    foresee(r, me, near, rank, others)
    safe = danger(others, (wish.x - me.x) / wish.time, (wish.y - me.y) / wish.time) == 0
    if straight and safe and is_free(w, r, me, near, wish):
        return 0
    if me.goes:
        _claim(b, w, r, me, wish, rank, others, (higher, cost), seed, step_number, claim)
    _costs(b, w, r, me, wish, others, seed, step_number, cost)
    while True:
        k = np.argmin(cost)
        if k == CANDIDATES or is_free(w, r, me, near, candidate(b, me, wish, k)):
            return k
        cost[k] = inf


@jit
def make_way(
    b, w, r, c, wished, side, position, heading, normal, rock, contact_time, overlap, hindered, seed, step_number, goes,
    claim,
):  # fmt: skip
    """(footprint, hindered): what to place (a planner.plan.Placed) after the last two in rows 0 and 1, instead of the wished.

    `hindered` counts the steps that did not get on. Sets claim (3,) of one who goes somewhere: see planner.crowd.right_of_way.
    """
    claim[:] = 0.0
    if wished.stands:
        return wished, 0
    near = np.empty(CROWDED, np.int64)
    count = reservations.neighbours(r, c, r.reach, near)
    if count == 0:
        return wished, 0
    way = wished.way
    if goes and count > 0:
        x, y = plan.middle_of(b, side[1], position[1, 0], position[1, 1], heading[1])
        way = keep_right(b, w, r, c, near[:count], x, y, way)
    me = walker(b, w, c, side, position, heading, contact_time, overlap, hindered, way, goes)
    x, y = plan.middle_of(b, wished.side, wished.x, wished.y, wished.heading)
    wish, k = step_to(b, me, x, y, wished.heading), CANDIDATES
    if count > 0:
        scratch = np.empty((count, OTHER)), np.empty((count, OTHER)), np.empty(CANDIDATES + 1)
        straight = abs(way - wished.way) < STRAIGHT
        k = choose(b, w, r, me, wish, straight, near[:count], scratch, seed, step_number, claim)
    if k == 0:
        return plan.hurried(wished, pace(hindered)), hindered_after(b, me, wish, wish) if goes else max(hindered - 1, 0)
    if k == CANDIDATES:
        return plan.stay(side[0], position[0], heading[0], normal[0], rock[0], YIELD_TIME), hindered + 1
    step = candidate(b, me, wish, k)
    placed = plan.put(b, w, me.side, step.foot_x, step.foot_y, step.heading, way, pace(hindered))
    return placed, hindered_after(b, me, wish, step)
