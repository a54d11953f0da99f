"""Crossers one behind the other: each goes along its own route, and waits for ground that another holds.

A route is taken to the letter, so who cannot go on stands. It does not begin what it could not stand still in: between two
stances in which one can wait lies a block of one step on land, or of all the leaps in a row from rock to rock. A block is begun
when every sole of it, and the way of the body, are clear of what the others hold, and of where one goes who is within a block.

They go in turn: nobody comes to rest in the way that one before it has still to go. So the first of those who are not across
yet finds its way free, whatever the others do: nobody waits forever, where they begin out of each other's ways
(planner.river.queue.berths). At first they go in the order of their numbers; where a change of the world finds them on their
ways, whoever has the least to go is the first. Ashore on the other side each walks on by itself, around the others.
"""

from math import hypot, inf
from typing import Any, NamedTuple

from motion.track.footprints import Foot, step_in
from planner.river.queue.routes import Routes, empty_routes
from planner.round.kernel import Compiled
from planner.round.reservations import COMMITTED, TENTATIVE, Reservations, foot_is_free, lag, least_distance, line_distance
from planner.round.round import UNHURRIED, Me, Round, Wish, biped_of, standing
from planner.round.soles import sole_of
from planner.stepping.arriving import STAND_TIME, arrive, is_content, walk_on
from planner.stepping.beside import Place, middle_beside, sole_heading
from planner.stepping.finding import surely
from planner.stepping.timing import step_timing
from worlds.compiled.jit import jit_borrowing

WAIT = 0.15
"""Who waits looks again after twice this time [s]: each foot stands on once."""
SOLES = 0.01
"""Room kept between soles [m]."""
NEAR = 2.0
"""Who walks has come by a place of its route within so many preferred steps of it."""
CLEAR = 0.02
"""Room kept beside the ways of those who go first, beyond that between bodies [m]."""


class Going(NamedTuple):
    """A body on its way from one rest to the next."""

    x: float  # where it rests [m]
    y: float
    time: float  # contact of the newest footprint [s]


@jit_borrowing
def _is_on(record: Any, foot: Foot) -> bool:
    return record.side == foot.side and record.x == foot.x and record.y == foot.y


@jit_borrowing
def _footprint_of(plans: Routes, me: Me) -> int:
    """Which footprint of its route the newer foot stands on, the older on the one before; -1 where a foot has stood on."""
    c, last = me.c, plans.length[me.c] - 1
    for i in range(min(plans.at[c] + TENTATIVE + 1, last), max(plans.at[c], 1) - 1, -1):
        if _is_on(plans.steps[c, i], me.feet.newer) and _is_on(plans.steps[c, i - 1], me.feet.older):
            return i
    return -1


@jit_borrowing
def _comes_by(held: Reservations, c: int, j: int, here: Going, x: float, y: float, begin: float, end: float) -> bool:
    """Whether c's body keeps off j's from `here` to a rest at x, y; where they are too near already, it may part them."""
    apart = held.room[c] + held.room[j]
    least = least_distance(held, j, here.x, here.y, begin, x, y, end)
    if least >= apart:
        return True
    now = least_distance(held, j, here.x, here.y, begin, here.x, here.y, end)
    return least >= now and now < apart


@jit_borrowing
def _rest(plans: Routes, c: int, k: int) -> Place:
    """Where c rests between footprint k of its route and the one before."""
    before, step = plans.steps[c, k - 1], plans.steps[c, k]
    return 0.5 * (before.x + step.x), 0.5 * (before.y + step.y)


@jit_borrowing
def _is_bound(plans: Routes, j: int) -> bool:
    """Whether j is within a block, where it cannot wait."""
    newest = plans.at[j] + 1
    return not plans.waits[j] and not plans.walks[j] and newest < plans.length[j] and not plans.stops[j, newest]


@jit_borrowing
def _goes_to(held: Reservations, c: int, j: int, x: float, y: float) -> bool:
    """Whether j means to go to where c would rest at x, y."""
    apart, least = held.room[c] + held.room[j], inf
    for k in range(COMMITTED, COMMITTED + TENTATIVE):
        least = min(least, hypot(held.path[j, k, 0] - x, held.path[j, k, 1] - y))
    return least < apart


@jit_borrowing
def _is_in_the_way(round: Round, c: int, j: int, x: float, y: float) -> bool:
    """Whether c, at rest at x, y, is in the way that j has still to go over to the other side."""
    plans, held = round.plans, round.reservations
    apart, least = held.room[c] + held.room[j] + CLEAR, inf
    rest = _rest(plans, j, plans.at[j])
    for k in range(plans.at[j] + 1, plans.ashore[j] + 1):
        then = _rest(plans, j, k)
        least = min(least, line_distance(rest[0] - x, rest[1] - y, then[0] - x, then[1] - y))
        rest = then
    return least < apart


@jit_borrowing
def _is_clear_of(round: Round, me: Me, at: int, j: int) -> bool:
    """Whether the block behind footprint `at` keeps off what character j holds and means to do."""
    plans, held, biped, c = round.plans, round.reservations, biped_of(round, me), me.c
    older, newer, late, bound = me.feet.older, me.feet.newer, lag(biped), _is_bound(round.plans, j)
    here = Going(0.5 * (older.x + newer.x), 0.5 * (older.y + newer.y), newer.contact_time)
    for k in range(at + 1, plans.length[c]):
        before, step = plans.steps[c, k - 1], plans.steps[c, k]
        length, turn = hypot(step.x - before.x, step.y - before.y), abs(step.heading - before.heading)
        lands = here.time + step_timing(biped, length, 0.0, turn, step.side == before.side)[0]
        heading = sole_heading(biped, step.side, step.heading)
        if not foot_is_free(held, j, sole_of(held.sole, c, step.x, step.y, heading), SOLES, lands):
            return False
        x, y = _rest(plans, c, k)
        if not _comes_by(held, c, j, here, x, y, here.time + late, lands + late):
            return False
        here = Going(x, y, lands)
        if bound and _goes_to(held, c, j, x, y):
            return False
        if plans.stops[c, k]:
            break
    return True


@jit_borrowing
def _leaves_way(round: Round, me: Me, at: int, j: int) -> bool:
    """Whether the block behind footprint `at` ends off the way of j, unless it is in it already."""
    plans, rest, c, k = round.plans, COMMITTED - 1, me.c, at + 1
    while k + 1 < plans.length[c] and not plans.stops[c, k]:
        k += 1
    x, y = _rest(plans, c, k)
    if not _is_in_the_way(round, c, j, x, y):
        return True
    path = round.reservations.path
    return _is_in_the_way(round, c, j, path[c, rest, 0], path[c, rest, 1])


@jit_borrowing
def _is_clear(round: Round, me: Me, at: int) -> bool:
    """Whether the block behind footprint `at` keeps off everyone near, and off the ways of those who go first.

    Those further away than others are looked for may plan at the same time: what they change lies as far away.
    """
    held, rest = round.reservations, COMMITTED - 1
    x, y = held.path[me.c, rest, 0], held.path[me.c, rest, 1]
    for j in range(len(held.due)):
        near = hypot(held.path[j, rest, 0] - x, held.path[j, rest, 1] - y) < held.reach
        if round.plans.turn[j] < round.plans.turn[me.c] and not _leaves_way(round, me, at, j):
            return False
        if j != me.c and near and not _is_clear_of(round, me, at, j):
            return False
    return True


@jit_borrowing
def _walk(round: Round, me: Me) -> Wish:
    """Ashore, among others: on to where it is to come to rest, by the places of its route, around whoever is in the way."""
    plans, c, biped, last = round.plans, me.c, biped_of(round, me), round.plans.length[me.c] - 1
    middle, stride = middle_beside(biped, me.feet.newer), biped.gait.preferred_step
    ends = plans.aside if plans.parked[c] else plans.ends
    at, end = plans.at[c], (ends[c, 0], ends[c, 1])
    while at < last - 1 and hypot(plans.steps[c, at].x - middle[0], plans.steps[c, at].y - middle[1]) < NEAR * stride:
        at += 1
    if is_content(round, me, middle, end):
        at = last
    if me.real:
        plans.at[c] = at
    if at == last:
        return arrive(round, me, middle)
    ahead = (plans.steps[c, at].x, plans.steps[c, at].y) if at < last - 1 else end
    on = walk_on(biped, round.world, middle, me.feet.newer.heading, ahead, round.seed, (c, me.number))
    return surely(round, me, (on.x, on.y), on.heading, on.course, True)


def _next_step(round: Round, me: Me) -> Wish:
    """The route's next step where its block is clear; else, and at the end, standing."""
    plans, c = round.plans, me.c
    if plans.walks[c]:
        return _walk(round, me)
    at = _footprint_of(plans, me)
    if at < 0:
        return standing(me, WAIT if plans.waits[c] else STAND_TIME)
    if me.real:
        plans.at[c] = at
        if at >= plans.ashore[c] and len(plans.at) > 1:
            plans.walks[c], plans.waits[c] = True, False
            return _walk(round, me)
        plans.waits[c] = at + 1 < plans.length[c] and plans.stops[c, at] and not _is_clear(round, me, at)
    if plans.waits[c]:
        return standing(me, WAIT)
    if at + 1 >= plans.length[c]:
        return standing(me, STAND_TIME)
    step = step_in(plans.steps[c, at + 1])
    return Wish(step, step.heading, UNHURRIED, False, False)


PLANNING = Compiled(_next_step, empty_routes(1, 2))
