"""Going around others: of the steps that conflict with nobody's reservations, the one that costs least.

What a step costs is told term by term (planner.crowd.terms), and what each term weighs by one table (planner.round.weights).
Soles and bodies in time are the hard guarantee: a step is free whose sole keeps off all that the others hold, and whose body
comes to rest, and on its way is, where it touches nobody (for bodies that are too close already: where it comes no closer).
Standing is always free.
"""

from math import atan2, cos, hypot, inf, sin
from typing import Any, NamedTuple

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from motion.track.footprints import Foot, step_onto
from planner.crowd import terms
from planner.crowd.bodies import gap_between
from planner.crowd.candidates import CANDIDATES, QUICK, Candidate, candidate, candidate_to, crosses
from planner.crowd.neighbour import NEIGHBOUR, see
from planner.crowd.sides import AGAINST, keep_right, on_the_right, wrong_side
from planner.crowd.walker import Walker, calmed, walker_of
from planner.round import reservations
from planner.round.round import Me, Round, Wish, biped_of, standing
from planner.round.soles import sole_of
from planner.stepping.beside import Place, middle_beside, middle_of
from planner.stepping.footing import FINE, needs_care, why_not_step
from planner.stepping.steering import free_way
from worlds import queries
from worlds.compiled.jit import jit, jit_borrowing

FOOT_MARGIN = 0.01
"""Room kept between soles [m]."""
CROWDED = 48
"""Where more others than this are in reach, one looks for those who are nearer."""
CLOSEST = 0.37
"""Nobody nearer than this share of the reach is overlooked: a step and two bodies."""
YIELD_TIME = 0.2
"""Who stands because others are in the way plans again after this time [s]."""
GETS_ON = 0.4
"""A step gets on that covers this share of the wished one."""
SHORT = 0.8
"""A wish that is shorter than this share of a usual step is that of one who is calm (Walker)."""
GRAZE = 0.02
"""Bodies that are too close already may come so much closer [m] on their way to where they are not."""
LOOKS = 4
"""Moments of a step at which bodies are looked at."""


class Scratch(NamedTuple):
    """Room to work in."""

    others: Any  # (K,) records of NEIGHBOUR: those near
    cost: np.ndarray  # (CANDIDATES + 1,)


@jit_borrowing
def is_open(round: Round, walker: Walker, step: Candidate) -> bool:
    """Whether a step keeps off trees, walls and water."""
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
        return why_not_step(biped, world, foot, step.foot_x, step.foot_y, step.heading) == FINE
    return True


@jit_borrowing
def _gap_to(held: reservations.Reservations, walker: Walker, j: int, time: float, at: Place, face: Place) -> float:
    """The gap between j's body at a time [s] and mine at a place [m], facing in the direction of that unit vector."""
    jx, jy = reservations.place_on_path(held, j, time, reservations.COMMITTED - 1)
    mine, (x, y) = (walker.deep, walker.wide), at
    its, looks = (held.half[j, 0], held.half[j, 1]), (held.face[j, 0], held.face[j, 1])
    return gap_between(mine, face, its, looks, jx - x, jy - y)


@jit_borrowing
def is_free(round: Round, walker: Walker, near: np.ndarray, step: Candidate) -> bool:
    """Whether a step keeps off all that the others hold; where bodies are too close already, it may part them."""
    held = round.reservations
    rest_x, rest_y = 0.5 * (walker.foot_x + step.foot_x), 0.5 * (walker.foot_y + step.foot_y)
    sole = sole_of(held.sole, walker.c, step.foot_x, step.foot_y, step.heading)
    facing, face = 0.5 * (walker.heading + step.heading), (walker.face_x, walker.face_y)
    turned = (cos(facing), sin(facing))
    far = walker.wide + hypot(rest_x - walker.rest_x, rest_y - walker.rest_y) + walker.full * step.time
    for j in near:
        if not reservations.foot_is_free(held, j, sole, FOOT_MARGIN, walker.time + step.time):
            return False
        last = held.path[j, reservations.COMMITTED - 1]
        reach = far + max(held.half[j, 0], held.half[j, 1])
        if abs(last[0] - rest_x) > reach or abs(last[1] - rest_y) > reach:
            continue
        now = min(_gap_to(held, walker, j, inf, (walker.rest_x, walker.rest_y), face), 0.0)
        if _gap_to(held, walker, j, inf, (rest_x, rest_y), turned) < now:
            return False
        for k in range(1, LOOKS + 1):
            s = k / LOOKS
            x, y = walker.rest_x + s * (rest_x - walker.rest_x), walker.rest_y + s * (rest_y - walker.rest_y)
            if _gap_to(held, walker, j, walker.there + s * step.time, (x, y), face) < (now - GRAZE if now < 0 else 0.0):
                return False
    return True


@jit_borrowing
def cost_of(round: Round, walker: Walker, others: Any, right: float, step: Candidate, goes: bool) -> float:
    """What a step costs; one that does not `go` stands. right: of those who come against me (planner.crowd.sides)."""
    biped, weights = round.bipeds[round.kind[walker.c]], round.weights[round.kind[walker.c]]
    swing, stride = pendulum_time(biped.timing.hip_height), biped.gait.preferred_step
    vx, vy = ((step.x - walker.x) / step.time, (step.y - walker.y) / step.time) if goes else (0.0, 0.0)
    headway = touch = near = yields = rest_x = rest_y = 0.0
    if goes:
        rest_x, rest_y = (
            0.5 * (walker.foot_x + step.foot_x) - walker.rest_x,
            0.5 * (walker.foot_y + step.foot_y) - walker.rest_y,
        )
    for i in range(len(others)):
        other = others[i]
        if other.along > AGAINST:
            headway = max(headway, terms.headway_lacking(walker, other, vx, vy, step.time, weights.gap * swing))
        touch = max(touch, terms.danger(walker, other, vx, vy, weights.horizon, swing))
        near += terms.nearness(walker, other, vx, vy, step.time, weights.distance * stride)
        yields = max(yields, terms.in_the_way(walker, other, rest_x, rest_y))
    cost = weights.progress * terms.progress_lost(walker, vx, vy) + weights.turn * terms.turned(walker, step)
    cost += weights.headway * headway + weights.touch * touch + weights.near * near
    cost += weights.side * wrong_side(walker, right, vx, vy) + weights.rank * yields
    return cost if goes else cost + weights.stand


@jit_borrowing
def _claim(round: Round, walker: Walker, others: Any, x: float, y: float) -> None:
    """Sets my claim: to rest at x, y, as I would if nobody were there; with my rank, or with that of whom I am in the way of.

    Less one, so that a whole queue backs off, and nobody is pushed back by those whom it pushes (priority inheritance; Okumura,
    Machida, Defago & Tamura 2022).
    """
    intents, c, rank = round.intents, walker.c, float(walker.hindered)
    for i in range(len(others)):
        if others[i].rank - 1 > rank and terms.in_the_way(walker, others[i], 0.0, 0.0) > 0:
            rank = others[i].rank - 1
    intents.claim[c, 0], intents.claim[c, 1], intents.rank[c] = x, y, rank


@jit_borrowing
def choose(round: Round, walker: Walker, wished: Candidate, near: np.ndarray, scratch: Scratch) -> int:
    """The cheapest candidate that is free; 0 is the wish, CANDIDATES is standing."""
    others, cost, biped = scratch.others, scratch.cost, round.bipeds[round.kind[walker.c]]
    weights = round.weights[round.kind[walker.c]]
    see(round.reservations, walker, float(walker.hindered), near, others)
    right = on_the_right(walker, others, round.reservations.reach) if weights.side > 0 else 0.0
    for k in range(CANDIDATES + 1):
        step = candidate(biped, walker, k) if 0 < k < CANDIDATES else wished
        cost[k] = cost_of(round, walker, others, right, step, k < CANDIDATES)
    claimed = False
    while True:
        k = int(np.argmin(cost))
        if k == CANDIDATES:
            if not claimed:
                _claim(round, walker, others, walker.rest_x, walker.rest_y)
            return k
        step = candidate(biped, walker, k) if k > 0 else wished
        if not crosses(biped, walker, step) and is_open(round, walker, step):
            if not claimed:
                claimed = True
                _claim(round, walker, others, 0.5 * (walker.foot_x + step.foot_x), 0.5 * (walker.foot_y + step.foot_y))
            if is_free(round, walker, near, step):
                return k
        cost[k] = inf


@jit_borrowing
def _look_around(held: reservations.Reservations, c: int, near: np.ndarray) -> int:
    """Fills `near` with those in reach, or in a throng with those who are near; returns how many, -1: still too many."""
    reach = held.reach
    count = reservations.neighbours(held, c, reach, near)
    while count < 0 and reach > CLOSEST * held.reach:
        reach = max(0.75 * reach, CLOSEST * held.reach)
        count = reservations.neighbours(held, c, reach, near)
    return count


@jit_borrowing
def _hindered_after(walker: Walker, taken: Candidate) -> int:
    """Steps that did not get on, after this one."""
    gone = (taken.x - walker.x) * cos(walker.course) + (taken.y - walker.y) * sin(walker.course)
    if gone > GETS_ON * walker.full * taken.time:
        return max(walker.hindered - 1, 0)
    return walker.hindered + 1


@jit_borrowing
def intend(round: Round, me: Me, wish: Wish) -> None:
    """Sets my intents as if nobody were near: the wish's course is my aim."""
    intents, c = round.intents, me.c
    moves = 0.0 if wish.step.stands > 0 else 1.0
    intents.aim[c, 0], intents.aim[c, 1] = moves * cos(wish.course), moves * sin(wish.course)
    intents.hindered[c], intents.rank[c] = 0, 0.0
    intents.claim[c, 0] = 0.5 * (me.feet.older.x + me.feet.newer.x)
    intents.claim[c, 1] = 0.5 * (me.feet.older.y + me.feet.newer.y)


@jit
def give_way(round: Round, me: Me, wish: Wish) -> Wish:
    """The wish, or what is free of others instead of it. Sets my intents: aim, and how many steps others hindered."""
    intents, c, step, hindered = round.intents, me.c, wish.step, me.hindered
    intend(round, me, wish)
    if step.stands > 0:
        return wish
    near = np.empty(CROWDED, np.int64)
    count = _look_around(round.reservations, c, near)
    if count == 0:
        return wish
    biped, course, k = biped_of(round, me), wish.course, CANDIDATES
    if wish.goes and count > 0:
        course = keep_right(round, c, near[:count], middle_beside(biped, me.feet.newer), course)
    walker = walker_of(round, me, course)
    x, y = middle_of(biped, step.side, (step.x, step.y), step.heading)
    wished = candidate_to(biped, walker, (x, y), step.heading)
    length, turn = hypot(x - walker.x, y - walker.y), abs(wished.heading - walker.heading) / biped.reach.max_turn
    if length < SHORT * biped.gait.preferred_step * max(1 - 0.5 * turn, 0.3):
        walker = calmed(walker, (x - walker.x) / wished.time, (y - walker.y) / wished.time)
    if count > 0:
        scratch = Scratch(np.empty(count, NEIGHBOUR), np.empty(CANDIDATES + 1))
        k = choose(round, walker, wished, near[:count], scratch)
    if k == CANDIDATES:
        intents.hindered[c] = hindered + 1
        return standing(me, YIELD_TIME)
    if k == 0:
        intents.hindered[c] = max(hindered - 1, 0)
        return Wish(step, wish.course, QUICK, True, wish.goes)
    taken = candidate(biped, walker, k)
    intents.hindered[c] = _hindered_after(walker, taken)
    onto = step_onto(walker.side, taken.foot_x, taken.foot_y, taken.heading)
    return Wish(onto, wish.course, QUICK, True, wish.goes)
