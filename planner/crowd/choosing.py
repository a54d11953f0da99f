"""Of the steps that are free, the one that costs least.

A direction has ONE speed: as fast as the spacing to those ahead in it allows (Tordeux, Chraibi & Seyfried 2016, collision-free
speed model), at most the wished one; the step in that direction is as long as that speed tells, and shorter where soles, bodies
or walls are in its way. What a step costs is told term by term (planner.crowd.terms), and what each term weighs by one table
(planner.round.weights).
"""

from math import hypot, inf
from typing import Any, NamedTuple

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from planner.crowd import candidates, terms
from planner.crowd.candidates import CANDIDATE, DIRECTIONS, QUICK, Candidate, bearing_of, candidate, candidate_in
from planner.crowd.neighbour import NEIGHBOUR, close_by, see
from planner.crowd.sides import AGAINST, meets, on_the_right, wrong_side
from planner.crowd.walker import CROWDED, LONGER, Walker, longer
from planner.round.round import Round
from worlds.compiled.jit import jit_borrowing, stack_array

LEAST = 0.08
"""No step is shorter than this share of the preferred one."""
SHORTER_BY = 0.88
"""Share of its length that a step keeps when it is not free."""
CLAIMS = 0.4
"""Where spacing allows no step, one claims the place of a step of this share of the longest, so that others make room."""
SIDLES = 0.5
"""Who stays where it is steps aside at this share of its full speed."""
HASTE = 1.1
"""The wish is taken as it is up to this share of the speed that spacing allows."""
STAND, WISH = len(DIRECTIONS), len(DIRECTIONS) + 1
"""Numbers of standing and of the wish, behind those of the directions."""
STANDING = Candidate(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""No step: its time is 0."""


class Scratch(NamedTuple):
    """Room to work in: of each direction, of standing, of the wish."""

    others: Any  # (K,) records of NEIGHBOUR: those near
    close: Any  # those of them to whom spacing may matter
    dense: np.ndarray  # (D, 3) of those whose density counts: x, y [m], the share of the ground that each covers (_dense)
    most: float  # speed that those who come against one leave [m/s]
    cost: np.ndarray  # (WISH + 1,) what it costs, or no more than that
    weighed: np.ndarray  # (WISH + 1,) bool: that is what it costs
    length: np.ndarray  # (STAND,) of the step in each direction [m]; negative: claimed, but not taken
    step: Any  # (WISH + 1,) records of CANDIDATE


_neighbours, _numbers_of_neighbours = stack_array(CROWDED, dtype=NEIGHBOUR), stack_array(CROWDED, 3)
_costs, _truths = stack_array(WISH + 1), stack_array(WISH + 1, dtype=np.bool_)
_lengths, _steps = stack_array(STAND), stack_array(WISH + 1, dtype=CANDIDATE)


class Own(NamedTuple):
    """What a step costs whoever is near, and its velocity."""

    vx: float  # [m/s]
    vy: float
    going: float  # progress lost, and turn
    side: float


@jit_borrowing
def _own_cost(round: Round, walker: Walker, right: float, step: Candidate, goes: bool) -> Own:
    """Of a step, or of standing. right: of those who come against me (planner.crowd.sides)."""
    weights = round.weights[round.kind[walker.c]]
    vx, vy = ((step.x - walker.x) / step.time, (step.y - walker.y) / step.time) if goes else (0.0, 0.0)
    going = weights.progress * terms.progress_lost(walker, vx, vy) + weights.turn * terms.turned(walker, step)
    return Own(vx, vy, going, weights.side * wrong_side(walker, right, vx, vy))


@jit_borrowing
def least_cost(round: Round, walker: Walker, right: float, step: Candidate, goes: bool) -> float:
    """What a step costs at least: others add to that (weights are not negative), also as numbers are rounded."""
    own = _own_cost(round, walker, right, step, goes)
    return own.going + own.side + (0.0 if goes else round.weights[round.kind[walker.c]].stand)


@jit_borrowing
def cost_of(round: Round, walker: Walker, others: Any, right: float, step: Candidate, goes: bool) -> float:
    """What a step costs; one that does not `go` stands. right: of those who come against me (planner.crowd.sides)."""
    biped, weights = round.bipeds[round.kind[walker.c]], round.weights[round.kind[walker.c]]
    swing, stride = pendulum_time(biped.timing.hip_height), biped.gait.preferred_step
    own = _own_cost(round, walker, right, step, goes)
    vx, vy = own.vx, own.vy
    touch = near = yields = rest_x = rest_y = 0.0
    if goes:
        rest_x = 0.5 * (walker.foot_x + step.foot_x) - walker.rest_x
        rest_y = 0.5 * (walker.foot_y + step.foot_y) - walker.rest_y
    for i in range(len(others)):
        other = others[i]
        touch = max(touch, terms.danger(walker, other, vx, vy, weights.horizon, swing))
        near += terms.nearness(walker, other, vx, vy, step.time, weights.distance * stride)
        yields = max(yields, terms.in_the_way(walker, other, rest_x, rest_y))
    cost = own.going + (weights.touch * touch + weights.near * near)
    cost += own.side + weights.rank * yields
    return cost if goes else cost + weights.stand


@jit_borrowing
def _claim(round: Round, walker: Walker, others: Any, x: float, y: float) -> None:
    """Sets my claim: to rest at x, y, as I would if nobody were there; with my rank, or with that of whom I am in the way of.

    Less one, so that a whole queue backs off, and nobody is pushed back by those whom it pushes (priority inheritance; Okumura,
    Machida, Defago & Tamura 2022). Who has long been where it is claims a step along its course: the cheapest is to stand.
    """
    intents, c, rank, biped = round.intents, walker.c, float(walker.hindered), round.bipeds[round.kind[walker.c]]
    if walker.time - intents.since[c] > LONGER * pendulum_time(biped.timing.hip_height):
        to = bearing_of(biped, walker, DIRECTIONS[0])
        x, y = candidates.rest_after(walker, candidate(biped, walker, to, CLAIMS * to.longest))
    for i in range(len(others)):
        if others[i].rank - 1 > rank and terms.in_the_way(walker, others[i], 0.0, 0.0) > 0:
            rank = others[i].rank - 1
    intents.claim[c, 0], intents.claim[c, 1], intents.rank[c] = x, y, rank


@jit_borrowing
def _dense(round: Round, walker: Walker, others: Any, dense: np.ndarray) -> int:
    """Fills in who may make it dense ahead: where, and what share of open ground each covers; returns how many. Not those who
    come against one: lanes part."""
    kind, count = round.kind[walker.c], 0
    far = round.weights[kind].ahead * round.bipeds[kind].gait.preferred_step
    part = candidates.part_open(round, walker, far)
    for i in range(len(others)):
        cover = terms.covered(others[i], far) / part if others[i].along > AGAINST else 0.0
        if cover > 0:
            dense[count, 0], dense[count, 1], dense[count, 2] = others[i].x, others[i].y, cover
            count += 1
    return count


@jit_borrowing
def _past_those(round: Round, walker: Walker, others: Any) -> float:
    """The most speed [m/s] that those who come against one leave it until it is past them, though lanes part."""
    weights, stride = round.weights[round.kind[walker.c]], round.bipeds[round.kind[walker.c]].gait.preferred_step
    return walker.full * (1 - weights.meet * meets(walker, others, weights.ahead * stride))


@jit_borrowing
def _speed_in(round: Round, walker: Walker, scratch: Scratch, dx: float, dy: float) -> float:
    """The speed [m/s] in the direction of a unit vector: the wished one, or what the spacing to those ahead in it allows, and
    how dense it is there."""
    biped, weights = round.bipeds[round.kind[walker.c]], round.weights[round.kind[walker.c]]
    swing, dense, cover = pendulum_time(biped.timing.hip_height), scratch.dense, 0.0
    speed, gap = walker.full, weights.gap * swing
    if walker.calm:
        stays = walker.wish_x == 0 and walker.wish_y == 0
        speed = SIDLES * walker.full if stays else max(walker.wish_x * dx + walker.wish_y * dy, 0.0)
    for i in range(len(scratch.close)):
        speed = min(speed, terms.speed_behind(walker, scratch.close[i], dx, dy, QUICK * swing, gap, speed))
    for i in range(len(dense)):
        if dense[i, 0] * dx + dense[i, 1] * dy > 0:
            cover += dense[i, 2]
    return min(speed, scratch.most, terms.pace_at(cover) * walker.full)


@jit_borrowing
def _lay(round: Round, walker: Walker, right: float, wished: Candidate, scratch: Scratch) -> None:
    """Fills in the steps, and what each direction, standing and the wish cost at least."""
    others, cost, length = scratch.close, scratch.cost, scratch.length
    biped = round.bipeds[round.kind[walker.c]]
    most, least = QUICK * pendulum_time(biped.timing.hip_height), LEAST * biped.gait.preferred_step
    for k in range(STAND):
        to = bearing_of(biped, walker, DIRECTIONS[k])
        speed = _speed_in(round, walker, scratch, to.ahead_x, to.ahead_y)
        enough = min(speed * most, to.longest)
        length[k] = min(enough, max(terms.room_in(walker, others, to, enough), least))
        step = candidate(biped, walker, to, length[k])
        goes = min(speed * step.time, length[k]) if length[k] >= least else 0.0
        if goes < max(length[k], least):
            length[k] = goes if goes >= least else -CLAIMS * to.longest
            step = candidate(biped, walker, to, abs(length[k]))
        _put(round, walker, right, k, step, scratch)
    for k in (STAND, WISH):
        _put(round, walker, right, k, wished, scratch)
    dx, dy = wished.x - walker.x, wished.y - walker.y
    far = hypot(dx, dy)
    if not (
        wished.time > 0 and (far <= least or far <= HASTE * _speed_in(round, walker, scratch, dx / far, dy / far) * wished.time)
    ):
        cost[WISH] = inf


@jit_borrowing
def _put(round: Round, walker: Walker, right: float, k: int, candidate: Candidate, scratch: Scratch) -> None:
    """Makes a candidate the one of direction k, or what one would stand instead of, or the wish."""
    candidates.keep(scratch.step[k], candidate)
    scratch.cost[k], scratch.weighed[k] = least_cost(round, walker, right, candidate, k != STAND), False


@jit_borrowing
def _cheapest(round: Round, walker: Walker, right: float, scratch: Scratch) -> int:
    """Which option costs least, the first of those that do: weighed are only those that may (branch and bound)."""
    cost, weighed, step = scratch.cost, scratch.weighed, scratch.step
    k = int(np.argmin(cost))
    while not weighed[k] and cost[k] < inf:
        cost[k] = cost_of(round, walker, scratch.others, right, candidate_in(step[k]), k != STAND)
        weighed[k] = True
        k = int(np.argmin(cost))
    return k


@jit_borrowing
def _shorten(round: Round, walker: Walker, right: float, near: np.ndarray, k: int, scratch: Scratch) -> None:
    """Makes the step of direction k, which may not be taken, as long as may be.

    Each shorter one would have been the cheapest before its turn came: so it costs as much as the dearest of those that were
    tried on the way. In directions that are never free, which most are where one is left to stand, none of them is weighed.
    """
    biped, cost, length = round.bipeds[round.kind[walker.c]], scratch.cost, scratch.length
    to, dearest, tried = bearing_of(biped, walker, DIRECTIONS[k]), cost[k], length[k]
    cost[k] = inf
    while length[k] * SHORTER_BY >= LEAST * biped.gait.preferred_step:
        length[k] *= SHORTER_BY
        shorter = candidate(biped, walker, to, length[k])
        if candidates.may_be_taken(round, walker, near, shorter):
            _put(round, walker, right, k, shorter, scratch)
            while tried > length[k]:
                tried *= SHORTER_BY
                step = candidate(biped, walker, to, tried)
                dearest = max(dearest, cost_of(round, walker, scratch.others, right, step, True))
            cost[k], scratch.weighed[k] = dearest, True
            return


@jit_borrowing
def choose(round: Round, walker: Walker, wished: Candidate, left: float, near: np.ndarray) -> Candidate:
    """The cheapest step that is free; its time is 0 where that is to stand, which one may also wish for.

    left: of where I should pass (Passage).
    """
    c, others, close, dense = walker.c, _neighbours()[: len(near)], _neighbours(), _numbers_of_neighbours()
    cost, length = _costs(), _lengths()
    biped, aim = round.bipeds[round.kind[c]], (round.intents.aim[c, 0], round.intents.aim[c, 1])
    least, claimed = LEAST * biped.gait.preferred_step, False
    see(round.reservations, walker, aim, float(walker.hindered), longer(round, c), near, others)
    close, dense = close[: close_by(round, walker, others, close)], dense[: _dense(round, walker, others, dense)]
    scratch = Scratch(others, close, dense, _past_those(round, walker, others), cost, _truths(), length, _steps())
    right = max(on_the_right(walker, others, aim, round.reservations.reach), left)
    _lay(round, walker, right, wished, scratch)
    while True:
        k = _cheapest(round, walker, right, scratch)
        if k == STAND:
            if not claimed:
                _claim(round, walker, others, walker.rest_x, walker.rest_y)
            return STANDING
        if claimed and k < STAND and length[k] < 0:
            cost[k] = inf
            continue
        step = candidate_in(scratch.step[k])
        if not candidates.crosses(biped, walker, step) and candidates.is_open(round, walker, step):
            if not claimed:
                claimed = True
                _claim(round, walker, others, *candidates.rest_after(walker, step))
            if (k == WISH or length[k] > 0) and candidates.is_free(round, walker, near, step):
                return step
        if k < STAND and claimed:
            _shorten(round, walker, right, near, k, scratch)
            continue
        cost[k] = inf
        if k < STAND and length[k] * SHORTER_BY >= least:
            length[k] *= SHORTER_BY
            to = bearing_of(biped, walker, DIRECTIONS[k])
            _put(round, walker, right, k, candidate(biped, walker, to, length[k]), scratch)
