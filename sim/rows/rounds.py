"""One round of the paper's loop (section 4.2): footprint n is placed and timed, tentative footprints behind it, step n - 1 is
optimised in its window and committed. All who are due in a tick decide, then all show what they have decided.
"""

from math import cos, sin
from typing import Any, NamedTuple

import numpy as np
from numba import prange

from motion.com import newton
from motion.com.newton import Effort
from motion.com.window import optimise_window
from motion.track.curve import up_to
from motion.track.footprints import feet_before
from planner.crowd import choosing
from planner.crowd.avoiding import YIELD_TIME, give_way, intend
from planner.crowd.candidates import QUICK
from planner.round import reservations
from planner.round.kernel import A_ROUND, lend_me, lend_wish, open_me, open_round, open_wish, put_wish
from planner.round.refusals import NO_ANSWER, can_be, nothing_refused, refuse
from planner.round.reservations import Reservations
from planner.round.round import Me, Round, Wish, standing
from planner.stepping import random
from planner.stepping.finding import heels_apart
from planner.stepping.going_on import going_on
from planner.stepping.placing import lay_swing
from planner.stepping.taking import take_step
from planner.velocities import orca
from sim.rows.crowd import REAL, TENTATIVE, Crowd, commit, committed_of, empty_crowd, footprints_of, horizon, shift
from sim.rows.posing import SHARE, WORKERS, fetch_row
from sim.rows.pressing import press_apart
from worlds.compiled.jit import jit, jit_borrowing, jit_parallel
from worlds.compiled.parts import Part, call, call_three, fetch, handle, take
from worlds.compiled.tables import row

AT_FIRST, LONGER = 0.3, 0.5
"""Everyone stands so long [s] at the very beginning, and by chance up to so much longer."""


class Work(NamedTuple):
    """What a round works on."""

    crowd: Crowd
    round: Round  # its plans an address, which the planner alone opens
    round_at: int  # where it lies
    planner: int  # where its next_step lies
    soles: bool  # the headings of steps are those of soles, to the letter; else the walker's, and toes point outward
    others: int  # where going around others lies; 0 for one who is alone, who needs none of that
    refused: Any  # (C,) records of STEP: what it wished that no body can do (planner.round.refusals)
    effort: Effort = newton.LIVE


class Parts(NamedTuple):
    """The parts of a round, by where they lie."""

    plan: int
    optimise: int


_, open_work, _, WORK = handle(Work(empty_crowd(np.zeros(1)), A_ROUND, 0, 0, False, 0, nothing_refused(1)))


@jit_borrowing
def _wish(work: Work, me: Me) -> Wish:
    """What the planner wants, asked where it lies; at the very beginning everyone stands."""
    if me.number <= 2:
        return standing(me, AT_FIRST + LONGER * random.uniform(work.round.seed, me.c, me.number, random.WAIT))
    answer = lend_wish(NO_ANSWER)
    call_three(work.planner, work.round_at, lend_me(me), answer)
    wish = open_wish(answer)
    if can_be(wish, work.round.world.bounds):
        return wish
    refuse(work.refused[me.c], wish.step)
    return standing(me, YIELD_TIME)


def _by_steps(round_at: int, me_at: int, wish_at: int) -> None:
    """Puts what is free of others instead of a lent wish there: of all steps the one that costs least."""
    put_wish(wish_at, give_way(open_round(round_at), open_me(me_at), open_wish(wish_at), choosing.choose))


def _by_velocities(round_at: int, me_at: int, wish_at: int) -> None:
    """The same, by a velocity that avoids all for a while."""
    put_wish(wish_at, give_way(open_round(round_at), open_me(me_at), open_wish(wish_at), orca.choose))


go_around = {"steps": Part(_by_steps, 3), "orca": Part(_by_velocities, 3)}
"""By the names of models (planner.round.weights)."""


@jit_borrowing
def _wish_among_others(work: Work, me: Me) -> tuple[Wish, bool]:
    """A real step: the wish, or what is free of others instead of it; and whether it is another one than was wished."""
    if work.crowd.paused[me.c]:
        return standing(me, YIELD_TIME), True
    wish = _wish(work, me)
    if not wish.avoids:
        return wish, False
    if work.others == 0:
        intend(work.round, me, wish)
        return (wish if work.soles else heels_apart(work.round, me, wish)), False
    answer = lend_wish(wish)
    call_three(work.others, work.round_at, lend_me(me), answer)
    free = open_wish(answer)
    step, taken = wish.step, free.step
    other = taken.x != step.x or taken.y != step.y or taken.heading != step.heading
    return free, other or (taken.stands > 0 and not step.stands > 0)


@Part
def plan_step(address: int, c: int) -> None:
    """Character c's footprint n, its timing, and the tentative ones behind it; whom others hinder means to go on as it does."""
    work = open_work(address)
    crowd, round = work.crowd, work.round
    if crowd.real[c] == REAL:
        shift(crowd, c)
    crowd.number[c] += 1
    n, footprints, biped = crowd.real[c], row(crowd.footprints, c), round.bipeds[crowd.kind[c]]
    hindered = False
    for k in range(n, n + 1 + TENTATIVE):
        me = Me(c, crowd.number[c] + k - n, k == n, crowd.intents.hindered[c], feet_before(footprints, k))
        if k == n:
            wish, hindered = _wish_among_others(work, me)
            crowd.standing[c] = wish.step.stands > 0
        elif hindered and crowd.standing[c]:
            wish = standing(me, YIELD_TIME)
        elif hindered and me.feet.older.side != me.feet.newer.side:
            wish = Wish(going_on(biped, me.feet), me.feet.newer.heading, QUICK, False, False)
        else:
            wish = _wish(work, me)
        take_step(biped, round.world, footprints, k, wish, 0.0 if work.soles else biped.gait.toe_out)
    footprints.lift[n] = 0.0
    if not crowd.standing[c]:
        lay_swing(biped, round.world, footprints, n)
    crowd.real[c] = n + 1


@Part
def optimise_step(address: int, c: int) -> None:
    """Solves character c's window over the real and tentative footprints and commits step n - 1 (paper, section 4.2)."""
    work = open_work(address)
    crowd = work.crowd
    n = crowd.real[c] - 1
    footprints, window = footprints_of(crowd, c, n + TENTATIVE + 1), row(crowd.window, c)
    points, solved = optimise_window(
        work.round.bipeds[crowd.kind[c]], footprints, committed_of(crowd, c), window, crowd.points[c], work.effort,
    )  # fmt: skip
    crowd.points[c] = points
    if work.others != 0:
        solved = press_apart(crowd, work.round.bipeds, work.round.reservations, c, solved, work.effort)
    crowd.window_cost[c, 0], crowd.window_cost[c, 1] = solved.cost, solved.iterations
    commit(crowd, c, up_to(window, points - 1), footprints.contact_time[n - 1])


def compiled_parts() -> Parts:
    """The parts, compiled."""
    return Parts(plan_step.address, optimise_step.address)


@jit_borrowing
def publish(crowd: Crowd, round: Round, c: int) -> None:
    """Lets the others see what character c holds and means to do."""
    held, n, intents, f = round.reservations, crowd.real[c], crowd.intents, crowd.footprints
    held.due[c] = horizon(crowd, c)
    held.aim[c, 0], held.aim[c, 1] = intents.aim[c, 0], intents.aim[c, 1]
    held.rank[c], held.claim[c, 0], held.claim[c, 1] = intents.rank[c], intents.claim[c, 0], intents.claim[c, 1]
    held.since[c] = intents.since[c]
    facing = 0.5 * (f.heading[c, n - 2] + f.heading[c, n - 1])
    held.face[c, 0], held.face[c, 1] = cos(facing), sin(facing)
    late = reservations.lag(round.bipeds[crowd.kind[c]])
    for k in range(reservations.FEET):
        i = max(n - reservations.FEET + k, 0)
        held.foot[c, k, 0], held.foot[c, k, 1] = f.position[c, i, 0], f.position[c, i, 1]
        held.foot[c, k, 2], held.foot[c, k, 3] = cos(f.heading[c, i]), sin(f.heading[c, i])
        held.foot[c, k, 4] = np.inf if i >= n - 2 else f.contact_time[c, i] + f.stance_time[c, i]
    for k in range(reservations.COMMITTED + reservations.TENTATIVE):
        i = max(n - reservations.COMMITTED + k, 0)
        before = max(i - 1, 0)
        held.path[c, k, 0] = 0.5 * (f.position[c, before, 0] + f.position[c, i, 0])
        held.path[c, k, 1] = 0.5 * (f.position[c, before, 1] + f.position[c, i, 1])
        held.path[c, k, 2] = f.contact_time[c, i] + late


@jit
def publish_all(address: int, who: np.ndarray) -> None:
    """Lets everyone see the characters `who` (K,) of the Work at an address."""
    work = open_work(address)
    for c in who:
        publish(work.crowd, work.round, c)


@jit
def due_now(held: Reservations, until: float, placed: np.ndarray) -> np.ndarray:
    """The characters that must plan before `until` [s], in the order of their numbers."""
    due = np.empty(len(held.due), np.int64)
    count = 0
    for c in range(len(held.due)):
        if held.due[c] < until and placed[c] < REAL - 2:
            due[count] = c
            count += 1
    return due[:count].copy()


@jit_borrowing
def _fetch_round(crowd: Crowd, c: int) -> None:
    """Asks for what a round of character c reads."""
    fetch_row(crowd, c)
    for n in range(crowd.points[c] + 1):
        fetch(crowd.window.control, (c, n, 0))
    fetch(crowd.window.time, (c, 0))
    fetch(crowd.window.time, (c, 8))


@jit_borrowing
def _advance_some(parts: Parts, address: int, turn: np.ndarray, counter: np.ndarray) -> None:
    """One round for share after share of a turn, until none is left."""
    crowd, begin = open_work(address).crowd, take(counter) * SHARE
    while begin < len(turn):
        for k in range(begin, min(begin + SHARE, len(turn))):
            if k + 1 < len(turn):
                _fetch_round(crowd, turn[k + 1])
            call(parts.plan, address, turn[k])
            call(parts.optimise, address, turn[k])
        begin = take(counter) * SHARE


@jit_parallel
def _advance_in_threads(parts: Parts, address: int, turn: np.ndarray, counter: np.ndarray) -> None:
    for _ in prange(WORKERS):
        _advance_some(parts, address, turn, counter)


@jit
def advance_all(parts: Parts, address: int, until: float, placed: np.ndarray, threads: int) -> None:
    """One round of the Work at an address for every character whose committed curve ends before `until` [s].

    placed (C,) counts the new footprints; threads: how many there are.

    Neighbours who are due in the same tick take turns, as often as needed: all of a turn decide against what was published
    before, then all publish, so the order of threads does not matter.
    """
    placed[:] = 0
    work, counter = open_work(address), np.zeros(1, np.int64)
    held = work.round.reservations
    due = due_now(held, until, placed)
    if len(due) > 0:
        reservations.sort_into_cells(held)
    while len(due) > 0:
        turn = reservations.without_neighbours(held, due)
        counter[0] = 0
        if threads == 1 or len(turn) <= SHARE:  # a thread of numba's has to be woken, even where it is the only one
            _advance_some(parts, address, turn, counter)
        else:
            _advance_in_threads(parts, address, turn, counter)
        publish_all(address, turn)
        for c in turn:
            placed[c] += 1
        due = due_now(held, until, placed)
