"""Going around others: a step that conflicts with nobody's reservations, near the one wanted.

Each candidate (planner.crowd.candidates) costs

    |v - v_wanted| / |v_preferred| + TURN |heading - facing| + CAUTION (1 / ttc - 1 / FORESIGHT)

with ttc the predicted time to collision with anyone, who goes on as its tentative footprints say (the sampled form of
reciprocal velocity obstacles; van den Berg, Lin & Manocha 2008). The cheapest candidate that is clear of trees and of what
others hold is taken. Standing is always clear.

Where the wish runs into someone, one looks for a course around (course_around), and those who get on badly have the right of
way (right_of_way): the others expect them to come. They also grow impatient: they come nearer to others, staying in place costs
more, chance has a say, and short steps are quick ones.
"""

from math import atan2, cos, hypot, inf, sin
from typing import Any, NamedTuple

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.dimensions import Dimensions
from motion.track.footprints import Foot, step_onto
from planner.crowd.candidates import CANDIDATES, CLOSING, SMALL, Candidate, Walker, candidate, candidate_to, pace, walker_of
from planner.crowd.course_around import LEFTWARD, course_around, keep_right
from planner.crowd.foresight import danger, foresee
from planner.crowd.neighbour import NEIGHBOUR
from planner.crowd.right_of_way import hindered_after, inherited, of_higher_rank, queueing_speed, rank_of
from planner.round import reservations
from planner.round.round import PATIENT, Me, Round, Wish, biped_of, standing
from planner.stepping import random
from planner.stepping.beside import middle_beside, middle_of
from planner.stepping.footing import FINE, needs_care, why_not_step
from planner.stepping.steering import free_way
from worlds import queries
from worlds.compiled.jit import jit, jit_borrowing

TURN, ON_THE_SPOT = 0.5, 0.3
"""Cost of a radian off the facing: the wanted heading, or the wished one in steps shorter than this share of the preferred."""
STRAIGHT = 0.05
"""So much [rad] off the wished course is still the wished course."""
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


class Scratch(NamedTuple):
    """Room to work in."""

    others: Any  # (K,) records of NEIGHBOUR: those near
    higher: Any  # (K,) those of them who claim with a higher rank
    cost: np.ndarray  # (CANDIDATES + 1,)


@jit_borrowing
def is_free(round: Round, walker: Walker, near: np.ndarray, step: Candidate) -> bool:
    """Whether a step keeps off trees and off all that the others hold."""
    world, length = round.world, hypot(step.x - walker.x, step.y - walker.y)
    biped = round.bipeds[round.kind[walker.c]]
    if length > 0:
        course = atan2(step.y - walker.y, step.x - walker.x)
        if queries.clearance(world, step.x, step.y) < walker.margin:
            return False
        if free_way(biped, world, walker.x, walker.y, course, walker.margin - 0.01, length) < length:
            return False
    if needs_care(biped, world, walker.foot_x, walker.foot_y):
        foot = Foot(1 - walker.side, walker.foot_x, walker.foot_y, walker.heading, 0.0, 0.0)
        if why_not_step(biped, world, foot, step.foot_x, step.foot_y, step.heading) != FINE:
            return False
    return keeps_off(round, walker, near, step)


@jit_borrowing
def keeps_off(round: Round, walker: Walker, near: np.ndarray, step: Candidate) -> bool:
    """Whether a step keeps off all that the others hold; where bodies are too close already, it may part them."""
    held = round.reservations
    rest_x, rest_y = 0.5 * (walker.foot_x + step.foot_x), 0.5 * (walker.foot_y + step.foot_y)
    begin, end, radius = walker.there, walker.there + step.time, held.foot_radius[walker.c] + FOOT_MARGIN
    for j in near:
        if not reservations.foot_is_free(held, j, step.foot_x, step.foot_y, radius, walker.time + step.time):
            return False
        apart = held.room[walker.c] + held.room[j]
        least = reservations.least_distance(held, j, walker.rest_x, walker.rest_y, begin, rest_x, rest_y, end)
        if least < apart:
            now = reservations.least_distance(held, j, walker.rest_x, walker.rest_y, begin, walker.rest_x, walker.rest_y, end)
            if least < now or now >= apart:
                return False
    return True


@jit_borrowing
def _turned_to(biped: Dimensions, walker: Walker, course: float) -> float:
    """The heading of one who turns to a course [rad], as far as a step allows."""
    most = biped.reach.max_turn
    return walker.heading + min(max(wrapped(course - walker.heading), -most), most)


@jit_borrowing
def _costs(round: Round, walker: Walker, wished: Candidate, others: Any, cost: np.ndarray) -> None:
    """Fills cost (CANDIDATES + 1,): of the wish, of the candidates, and last of standing, as if only `others` were there."""
    biped, full = round.bipeds[round.kind[walker.c]], walker.full
    stride, wanted = biped.gait.preferred_step, course_around(round, walker, others)
    wx, wy = full * cos(wanted), full * sin(wanted)
    ahead, onward = _turned_to(biped, walker, wanted), _turned_to(biped, walker, walker.course)
    impatience = min(walker.hindered, PATIENT)
    for k in range(CANDIDATES + 1):
        step = candidate(biped, walker, wished, k)
        vx, vy = (step.x - walker.x) / step.time, (step.y - walker.y) / step.time
        if k == CANDIDATES:
            vx, vy = 0.0, 0.0
        gone = hypot(vx, vy) * step.time
        cost[k] = (
            hypot(vx - wx, vy - wy) / full
            + TURN * abs(step.heading - (ahead if gone >= ON_THE_SPOT * stride else onward))
            + LEFTWARD * max(step.heading - max(walker.heading, wished.heading), 0.0)
        )
        cost[k] += danger(others, vx, vy)
        cost[k] += IMPATIENCE * impatience * max(1 - gone / (SMALL * stride), 0.0)
        cost[k] += ASIDE * impatience * (vy * cos(wanted) - vx * sin(wanted)) / full
        cost[k] += CHANCE * impatience * random.uniform(round.seed, walker.c, walker.number, random.JAM + k)
    cost[CANDIDATES] += STAND
    if hypot(walker.x - walker.rest_x, walker.y - walker.rest_y) < 0.1 * stride:
        cost[CLOSING] += STAND


@jit_borrowing
def _claim(round: Round, walker: Walker, wished: Candidate, rank: float, scratch: Scratch) -> None:
    """Sets my claim: the velocity on the wished course, or out of the way of a higher claim; and with which rank."""
    claim, others, speed = round.intents.claim, scratch.others, queueing_speed(walker, scratch.others)
    c, mine = walker.c, inherited(others, rank)
    claim[c, 0], claim[c, 1], claim[c, 2] = speed * cos(walker.course), speed * sin(walker.course), mine
    if mine > rank:
        count = of_higher_rank(others, scratch.higher)
        _costs(round, walker, wished, scratch.higher[:count], scratch.cost)
        k = np.argmin(scratch.cost)
        if k < CANDIDATES:
            step = candidate(round.bipeds[round.kind[c]], walker, wished, int(k))
            claim[c, 0], claim[c, 1] = (step.x - walker.x) / step.time, (step.y - walker.y) / step.time


@jit_borrowing
def choose(round: Round, walker: Walker, wished: Candidate, straight: bool, near: np.ndarray, scratch: Scratch) -> int:
    """The best candidate that is free; 0 is the wish, CANDIDATES is standing.

    The wish is for those whose course is `straight`. Whoever goes somewhere and cannot have its wish sets its claim.
    """
    others, cost, biped = scratch.others, scratch.cost, round.bipeds[round.kind[walker.c]]
    rank = rank_of(round.reservations, walker, near)
    foresee(round.reservations, walker, near, rank, others)
    safe = danger(others, (wished.x - walker.x) / wished.time, (wished.y - walker.y) / wished.time) == 0
    if straight and safe and is_free(round, walker, near, wished):
        return 0
    if walker.goes:
        _claim(round, walker, wished, rank, scratch)
    _costs(round, walker, wished, others, cost)
    while True:
        k = int(np.argmin(cost))
        if k == CANDIDATES or is_free(round, walker, near, candidate(biped, walker, wished, k)):
            return k
        cost[k] = inf


@jit
def give_way(round: Round, me: Me, wish: Wish) -> Wish:
    """The wish, or what is free of others instead of it. Sets my intents: aim, claim, and how many steps others hindered."""
    intents, c, step = round.intents, me.c, wish.step
    moves = 0.0 if step.stands > 0 else 1.0
    intents.aim[c, 0], intents.aim[c, 1] = moves * cos(wish.course), moves * sin(wish.course)
    intents.claim[c] = 0.0
    hindered, intents.hindered[c] = me.hindered, 0
    if step.stands > 0:
        return wish
    near = np.empty(CROWDED, np.int64)
    count = reservations.neighbours(round.reservations, c, round.reservations.reach, near)
    if count == 0:
        return wish
    biped, course = biped_of(round, me), wish.course
    if wish.goes and count > 0:
        course = keep_right(round, c, near[:count], middle_beside(biped, me.feet.newer), course)
    walker = walker_of(round, me, course, wish.goes)
    x, y = middle_of(biped, step.side, (step.x, step.y), step.heading)
    wished, k = candidate_to(biped, walker, x, y, step.heading), CANDIDATES
    if count > 0:
        scratch = Scratch(np.empty(count, NEIGHBOUR), np.empty(count, NEIGHBOUR), np.empty(CANDIDATES + 1))
        k = choose(round, walker, wished, abs(course - wish.course) < STRAIGHT, near[:count], scratch)
    if k == CANDIDATES:
        intents.hindered[c] = hindered + 1
        return standing(me, YIELD_TIME)
    if k == 0:
        intents.hindered[c] = hindered_after(biped, walker, wished, wished) if wish.goes else max(hindered - 1, 0)
        return Wish(step, wish.course, pace(hindered), True, wish.goes)
    taken = candidate(biped, walker, wished, k)
    intents.hindered[c] = hindered_after(biped, walker, wished, taken)
    onto = step_onto(walker.side, taken.foot_x, taken.foot_y, taken.heading)
    return Wish(onto, course, pace(hindered), True, wish.goes)
