"""How one who is driven answers: the step that its reins ask for, or what can be done instead of it.

One that cannot be done is done as far as it can (planner.stepping.seeking): by a shorter step, a longer one over a ditch,
another place near it, a rock; else the walker stands. From a run one slows down by steps, so nothing slides.
"""

from math import atan2, cos, hypot, isfinite, sin

import numpy as np

from motion.arithmetic.angles import unwrapped
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, Foot, Step
from planner.crowd.candidates import Candidate, candidate_to, is_free
from planner.crowd.walker import walker_of
from planner.modes.reins import CREEP, RUN, STAND, WALK, Reins
from planner.round import reservations
from planner.round.round import UNHURRIED, Me, Round, Wish, biped_of, standing
from planner.stepping import timing
from planner.stepping.beside import are_together, middle_beside, middle_of
from planner.stepping.seeking import Wanted, seek
from planner.stepping.steering import free_way
from worlds import queries
from worlds.compiled.jit import jit, jit_borrowing

HALT = 0.15
"""Who stands looks for another wish after this time [s]."""
CREEPS, CROUCH, DAWDLE = 0.45, 0.93, 3.4
"""One creeps by so many preferred steps, on so much of its leg, and no longer than so many pendulum times a step."""
RUNS, LEAST_RUN = 1.12, 0.93
"""A running step is so many hip heights long, and no longer than so many lengths from which one leaps."""
GAIN, DROP = 0.3, 0.55
"""A running step is longer than the one before by so many preferred steps at most, and no shorter than this share of it."""
LEAPS, RUNNING_LEAP, MOST_LEAP = 1.3, 1.5, 0.97
"""A leap from a stand or walk, and from a run, in the lengths from which one leaps; at most this share of the longest leap."""
SIDESTEP, BACK = 0.5, 0.6
"""Farthest aside with the foot on that side, and farthest back, in preferred steps. The other foot follows."""
BENDS, LEANS = 0.5, 0.3
"""Share of the largest turn that a run allows; who is to go further aside than this [rad] slows down first, straight on."""
INWARD = 0.35
"""Turning on the spot, a foot turns in by this share of the largest turn: the toes would cross."""
ON_THE_SPOT = 1.2
"""Who still has to turn by more than this [rad] turns on the spot."""
ALIGNED = 0.03
"""Who faces the direction but for this [rad] has turned."""
NEAR_ENOUGH = 0.8
"""A place is taken within this share of the step from the wanted one."""
NOWHERE = 1e-9
"""A step that is to bring the middle no farther [m] stays where it is."""
LEAST_STEP = 0.15
"""No step gets less far on its way, in preferred steps: the walker stands instead."""
MOST_NEAR = 64
"""More others than that in reach, and one stands."""


@jit_borrowing
def _length(biped: Dimensions, pace: int) -> float:
    """The length of a step at a pace [m]."""
    if pace == CREEP:
        return CREEPS * biped.gait.preferred_step
    if pace == WALK:
        return biped.gait.preferred_step
    return min(RUNS * biped.timing.hip_height, LEAST_RUN * biped.reach.leap_length) if pace == RUN else 0.0


@jit_borrowing
def _last_length(biped: Dimensions, me: Me, reins: Reins) -> float:
    """How far the last step brought the middle [m]; 0 where one stands: with the feet apart, that cannot be told from them."""
    if reins.last[me.c] == 0:
        return 0.0
    (x, y), (u, v) = middle_beside(biped, me.feet.newer), middle_beside(biped, me.feet.older)
    return hypot(x - u, y - v)


@jit_borrowing
def _turn(biped: Dimensions, foot: Foot, wished: float, spot: bool) -> float:
    """The turn [rad] of one step out of a wished one."""
    left = biped.reach.max_turn * (INWARD if spot and foot.side == LEFT else 1.0)
    right = biped.reach.max_turn * (INWARD if spot and foot.side != LEFT else 1.0)
    return min(max(wished, -right), left)


@jit_borrowing
def _displaced(biped: Dimensions, foot: Foot, length: float, heading: float, aside: float) -> tuple[float, float]:
    """(dx, dy) of the middle [m] by a step: legs do not cross, so aside goes the foot of that side, twice as far."""
    stride, own = biped.gait.preferred_step, -1.0 if foot.side == LEFT else 1.0
    ahead, across = length * cos(aside), length * sin(aside)
    if abs(sin(aside)) > 0.3:
        across = own * min(2 * abs(across), SIDESTEP * stride) if across * own > 0 else 0.0
    ahead = max(ahead, -BACK * stride)
    c, s = cos(heading), sin(heading)
    return ahead * c - across * s, ahead * s + across * c


@jit_borrowing
def _wanted(biped: Dimensions, me: Me, reins: Reins) -> Wanted:
    """The step that the reins ask for, whatever the ground."""
    foot, c, stride = me.feet.newer, me.c, biped.gait.preferred_step
    pace, aside, last = reins.pace[c], reins.aside[c], _last_length(biped, me, reins)
    wished, slow = unwrapped(reins.direction[c] - aside, foot.heading) - foot.heading, last < 1.05 * stride
    if pace == STAND or not (slow or abs(aside) < LEANS):
        wished = 0.0
    if reins.leap[c]:
        return _leap(biped, foot, wished, last > 0.9 * _length(biped, RUN))
    length = min(_length(biped, pace), max(1.05 * stride, last + GAIN * stride))
    turn = _turn(biped, foot, wished, length == 0 or abs(wished) > ON_THE_SPOT)
    length *= max(1 - 0.5 * abs(turn) / biped.reach.max_turn, 0.3) * max(1 - abs(wished - turn) / ON_THE_SPOT, 0.0)
    if not slow:  # out of a run, or a leap, nobody turns sharply, nor goes aside at once
        turn, aside = min(max(turn, -BENDS * biped.reach.max_turn), BENDS * biped.reach.max_turn), 0.0
        length = max(length, DROP * last)
    heading = foot.heading + turn
    dx, dy = _displaced(biped, foot, length, heading, aside)
    if max(length, last) > stride:
        dx, dy = _narrowed(biped, foot, (dx, dy), heading, (last, length))
    farthest = min(max(biped.reach.max_step, 1.15 * length), biped.reach.leap_length)
    return Wanted(dx, dy, heading, cos(aside) > 0.5, farthest, NEAR_ENOUGH * max(hypot(dx, dy), 0.4 * stride))


@jit_borrowing
def _narrowed(
    biped: Dimensions, foot: Foot, way: tuple[float, float], heading: float, lengths: tuple[float, float]
) -> tuple[float, float]:  # fmt: skip
    """The way (dx, dy) [m] of a middle that is reckoned half a walker's width beside each foot, where runners tread narrower.

    lengths: of the step to where `foot` stands, and of the next [m]. Both feet lie farther inward by half of what lacks.
    """
    was, own = 0.5 * biped.gait.step_width, 1.0 if foot.side == LEFT else -1.0
    here = own * (was - 0.5 * timing.width_at(biped, timing.pace_of(biped, lengths[0])))
    there = own * (was - 0.5 * timing.width_at(biped, timing.pace_of(biped, lengths[1])))
    dx = way[0] - here * sin(foot.heading) - there * sin(heading)
    return dx, way[1] + here * cos(foot.heading) + there * cos(heading)


@jit_borrowing
def _leap(biped: Dimensions, foot: Foot, wished: float, runs: bool) -> Wanted:
    """A leap, straight on but for a small turn."""
    reach = biped.reach
    length = min((RUNNING_LEAP if runs else LEAPS) * reach.leap_length, MOST_LEAP * reach.max_leap)
    heading = foot.heading + min(max(wished, -0.3 * reach.max_turn), 0.3 * reach.max_turn)
    return Wanted(length * cos(heading), length * sin(heading), heading, True, reach.max_leap, NEAR_ENOUGH * length)


@jit_borrowing
def _stand(me: Me) -> Wish:
    """To stand for a moment; others see that one goes nowhere."""
    still = standing(me, HALT)
    return Wish(still.step, still.course, still.longest, True, False)


@jit_borrowing
def _set_down(round: Round, me: Me, wanted: Wanted, pace: int) -> Wish:
    """The wanted step, or what is nearest to it; standing where there is none."""
    biped, foot = biped_of(round, me), me.feet.newer
    found = seek(biped, round.world, me.feet, wanted)
    if not isfinite(found.cost):
        return _stand(me)
    x, y = middle_of(biped, 1 - foot.side, (found.x, found.y), found.heading)
    mx, my = middle_beside(biped, foot)
    far = hypot(wanted.dx, wanted.dy)
    if far > NOWHERE and (x - mx) * wanted.dx + (y - my) * wanted.dy < LEAST_STEP * biped.gait.preferred_step * far:
        return _stand(me)
    crouch, longest = (CROUCH, DAWDLE) if pace == CREEP else (1.0, UNHURRIED)
    step = Step(1 - foot.side, found.x, found.y, found.heading, np.nan, np.nan, 0.0, crouch, 0.0)
    course = atan2(y - my, x - mx) if far > NOWHERE else found.heading
    wish = Wish(step, course, longest, True, False)
    return wish if _on_dry_land(round, biped, (mx, my), (x, y)) else _to_the_letter(round, me, wish, (x, y))


@jit_borrowing
def _on_dry_land(round: Round, biped: Dimensions, begin: tuple[float, float], end: tuple[float, float]) -> bool:
    """Whether a step goes where one may go around others: there is room on either side."""
    far, margin = hypot(end[0] - begin[0], end[1] - begin[1]), biped.body.radius
    course = atan2(end[1] - begin[1], end[0] - begin[0])
    return free_way(biped, round.world, begin[0], begin[1], course, margin, far) >= far and (
        queries.clearance(round.world, end[0], end[1]) >= margin
    )


@jit
def _to_the_letter(round: Round, me: Me, wish: Wish, middle: tuple[float, float]) -> Wish:
    """A step on rocks, banks and leaps: as it is, or, where others are in its way, not at all."""
    near = np.empty(MOST_NEAR, np.int64)
    count = reservations.neighbours(round.reservations, me.c, round.reservations.reach, near) if me.real else 0
    step, walker = wish.step, walker_of(round, me, wish.course)
    timed = candidate_to(biped_of(round, me), walker, middle, step.heading)
    there = Candidate(middle[0], middle[1], step.heading, step.x, step.y, timed.time)
    if count < 0 or (count > 0 and not is_free(round, walker, near[:count], there)):
        return _stand(me)
    if me.real:
        intents, c = round.intents, me.c
        intents.aim[c, 0], intents.aim[c, 1], intents.hindered[c] = cos(wish.course), sin(wish.course), 0
        intents.stood[c] = 0
        intents.rank[c], intents.claim[c, 0], intents.claim[c, 1] = 0.0, middle[0], middle[1]
    return Wish(step, wish.course, wish.longest, False, False)


@jit_borrowing
def _at_rest(round: Round, me: Me, reins: Reins, wanted: Wanted) -> Wish:
    """Who goes nowhere: it turns if it is told to, brings its feet together, and stands."""
    biped, foot, older = biped_of(round, me), me.feet.newer, me.feet.older
    turns = abs(wanted.heading - foot.heading) > ALIGNED or abs(foot.heading - older.heading) > ALIGNED
    if older.side != foot.side and (turns or not are_together(biped, foot, older)):
        return _set_down(round, me, wanted, reins.pace[me.c])
    return _stand(me)


@jit_borrowing
def _answer(round: Round, me: Me, reins: Reins) -> Wish:
    """The step that the reins ask for, or what can be done instead of it."""
    biped = biped_of(round, me)
    wanted = _wanted(biped, me, reins)
    if hypot(wanted.dx, wanted.dy) <= NOWHERE:
        return _at_rest(round, me, reins, wanted)
    wish = _set_down(round, me, wanted, reins.pace[me.c])
    if not wish.step.stands > 0:
        return wish
    still = Wanted(0.0, 0.0, wanted.heading, False, wanted.farthest, 0.4 * biped.gait.preferred_step)
    return _at_rest(round, me, reins, still)


def next_step(round: Round, me: Me) -> Wish:
    """The answer; a leap is forgotten once a real step has been planned for it."""
    wish, reins, step = _answer(round, me, round.plans), round.plans, me.feet.newer
    if me.real:
        reins.leap[me.c], reins.last[me.c] = False, 0.0
        if not wish.step.stands > 0:
            reins.last[me.c] = max(hypot(wish.step.x - step.x, wish.step.y - step.y), NOWHERE)
    return wish
