"""Going around others: of the steps that conflict with nobody's reservations, the one that a model chooses."""

from collections.abc import Callable
from math import cos, hypot, sin

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.track.footprints import step_onto
from planner.crowd.candidates import QUICK, Candidate, candidate_to
from planner.crowd.choosing import STANDING
from planner.crowd.sides import keep_right, straight_on
from planner.crowd.walker import CROWDED, PRESSED, Walker, calmed, look_where, walker_of
from planner.round import reservations
from planner.round.round import Me, Round, Wish, biped_of, standing
from planner.stepping.beside import middle_beside, middle_of
from worlds.compiled.jit import jit_borrowing, stack_array

CLOSEST = 0.37
"""Nobody nearer than this share of the reach is overlooked: a step and two bodies."""
YIELD_TIME = 0.2
"""Who stands because others are in the way plans again after this time [s]."""
GETS_ON = 0.4
"""A step gets on that covers this share of the wished one."""
SHORT = 0.8
"""A wish that is shorter than this share of a usual step is that of one who is calm (Walker)."""

ALONG = 0.1
"""A step whose heading is so far off the course [rad] that it goes on to turns."""
_numbers = stack_array(CROWDED, dtype=np.int64)

Choice = Callable[[Round, Walker, Candidate, float, np.ndarray], Candidate]
"""A model of walking among others, as a kernel: of a round, one who walks, the step that it wishes for (its time is 0 where it
would stand), how far left it is of where it should pass, and those near it, a step that is free; STANDING where none is."""


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
    """Sets my intents as if nobody were near: my aim is where my way leads, else the wish's course."""
    intents, c = round.intents, me.c
    moves = 0.0 if wish.step.stands > 0 else 1.0
    intents.aim[c, 0], intents.aim[c, 1] = moves * cos(wish.course), moves * sin(wish.course)
    if moves > 0 and (intents.ahead[c, 0] != 0 or intents.ahead[c, 1] != 0):
        intents.aim[c, 0], intents.aim[c, 1] = intents.ahead[c, 0], intents.ahead[c, 1]
    intents.hindered[c], intents.rank[c] = 0, 0.0
    intents.claim[c, 0] = 0.5 * (me.feet.older.x + me.feet.newer.x)
    intents.claim[c, 1] = 0.5 * (me.feet.older.y + me.feet.newer.y)


@jit_borrowing
def _let_by(round: Round, me: Me, wish: Wish, near: np.ndarray, choose: Choice) -> Wish:
    """One who has arrived stands, as it wishes, or steps out of the way of those who wait to pass; then its way leads back."""
    held, waits, walker = round.reservations, False, walker_of(round, me, me.feet.newer.heading)
    for j in near:
        far = hypot(held.claim[j, 0] - walker.rest_x, held.claim[j, 1] - walker.rest_y)
        waits |= held.rank[j] > 0 and far < walker.wide + held.half[j, 1]
    if not waits:
        round.intents.hindered[me.c] = me.hindered  # who is content with a place near its stop stays so
        return wish
    walker = calmed(walker, 0.0, 0.0)
    taken = choose(round, walker, STANDING, 0.0, near)
    if taken.time == 0:
        return wish
    onto = step_onto(walker.side, taken.foot_x, taken.foot_y, taken.heading)
    return Wish(onto, wish.course, QUICK, True, False)


@jit_borrowing
def give_way(round: Round, me: Me, wish: Wish, choose: Choice) -> Wish:
    """The wish, or what a model chooses that is free of others. Sets my intents: aim, and how many steps others hindered."""
    intents, c, step, hindered = round.intents, me.c, wish.step, me.hindered
    intend(round, me, wish)
    look_where(round, me, step.stands == 0)
    if step.stands > 0 and not wish.goes:
        intents.stood[c] = 0
        return wish
    near = _numbers()
    count = _look_around(round.reservations, c, near)
    if count == 0:
        intents.stood[c] = 0
        return wish
    if step.stands > 0:
        return _let_by(round, me, wish, near[: max(count, 0)], choose)
    biped, taken, passage = biped_of(round, me), STANDING, straight_on(wish.course, 0.0)
    if wish.goes:
        passage = keep_right(round, c, middle_beside(biped, me.feet.newer), wish.course)
    walker = walker_of(round, me, passage.course)
    x, y = middle_of(biped, step.side, (step.x, step.y), step.heading)
    wished = candidate_to(biped, walker, (x, y), step.heading)
    length, turn = hypot(x - walker.x, y - walker.y), abs(wished.heading - walker.heading) / biped.reach.max_turn
    along = abs(wrapped(wish.course - step.heading)) < ALONG
    if along and length < SHORT * biped.gait.preferred_step * max(1 - 0.5 * turn, 0.3):
        walker = calmed(walker, (x - walker.x) / wished.time, (y - walker.y) / wished.time)
    if count > 0:
        taken = choose(round, walker, wished, passage.left, near[:count])
    if taken.time == 0:
        intents.hindered[c] = hindered + 1
        intents.stood[c] = min(intents.stood[c] + 1, PRESSED)
        return standing(me, YIELD_TIME)
    if taken.x == wished.x and taken.y == wished.y and taken.heading == wished.heading:
        intents.hindered[c], intents.stood[c] = max(hindered - 1, 0), 0
        return Wish(step, wish.course, QUICK, True, wish.goes)
    intents.hindered[c] = _hindered_after(walker, taken)
    intents.stood[c] = max(intents.stood[c] - 1, 0) if intents.hindered[c] > hindered else 0
    onto = step_onto(walker.side, taken.foot_x, taken.foot_y, taken.heading)
    return Wish(onto, wish.course, QUICK, True, wish.goes)
