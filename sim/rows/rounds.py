"""One round of the paper's loop (section 4.2): footprint n is placed and timed, tentative footprints behind it, step n - 1 is
optimised in its window and committed. All who are due in a tick decide, then all show what they have decided.
"""

from math import cos, sin
from typing import NamedTuple

import numpy as np
from numba import prange

from motion.characters.biped import BIPED
from motion.com import newton, window
from planner import plan
from planner.crowd import avoiding, reservations
from sim.rows import row as rows
from sim.rows import steps
from sim.rows.crowd import REAL, SHARE, TENTATIVE, WORKERS, empty_crowd, fetch_row, horizon, track_of
from worlds.compiled.jit import jit, jit_borrowing, jit_parallel
from worlds.compiled.parts import Part, call, fetch, handle, take
from worlds.world import World

WINDOW_TAIL = 0.0
"""Share of a step that the window goes on after the last tentative contact: more steadies its end, and costs time."""

lend, opened = handle(
    (
        empty_crowd(np.zeros(1)),
        np.zeros(1, BIPED).view(np.recarray),
        World("sample", (1.0, 1.0)).arrays,
        plan.plans_of(plan.STAND, 1),
        reservations.empty_reservations(np.ones(1, BIPED).view(np.recarray), np.zeros(1, np.int64), (1.0, 1.0)),
        0,
        newton.LIVE,
    )
)
"""What a round works on: crowd, bipeds, world, plans, reservations, seed, effort."""


@jit_borrowing
def _wish(crowd, b, w, plans, c, seed, n, step):
    """What the planner wants as footprint number `step`, at row n."""
    two = slice(n - 2, n)
    return plan.next_footprint(
        b, w, plans, c, seed, step, crowd.reached[c], crowd.hindered[c], crowd.side[c, two], crowd.position[c, two],
        crowd.heading[c, two], crowd.normal[c, two], crowd.rock[c, two],
    )  # fmt: skip


@jit_borrowing
def _make_way(crowd, b, w, r, c, seed, n, goes, wish):
    """The wish, or what is free of others instead of it."""
    goes_on = 0.0 if wish.stands else 1.0
    crowd.aim[c, 0], crowd.aim[c, 1] = goes_on * cos(wish.way), goes_on * sin(wish.way)
    two = slice(n - 2, n)
    overlap = crowd.contact_time[c, n - 2] + crowd.stance_time[c, n - 2] - crowd.contact_time[c, n - 1]
    placed, crowd.hindered[c] = avoiding.make_way(
        b, w, r, c, wish, crowd.side[c, two], crowd.position[c, two], crowd.heading[c, two], crowd.normal[c, two],
        crowd.rock[c, two], crowd.contact_time[c, n - 1], overlap, crowd.hindered[c], seed, crowd.number[c], goes,
        crowd.claim[c],
    )  # fmt: skip
    return placed


@jit_borrowing
def _place(crowd, bipeds, w, plans, r, c, seed):
    """Footprint n and the tentative ones behind it; whoever has to stand means to go on standing."""
    b, n = bipeds[crowd.kind[c]], crowd.real[c]
    hindered = False
    for k in range(n, n + 1 + TENTATIVE):
        if hindered:
            placed = plan.stay(
                crowd.side[c, k - 2], crowd.position[c, k - 2], crowd.heading[c, k - 2], crowd.normal[c, k - 2],
                crowd.rock[c, k - 2], avoiding.YIELD_TIME,
            )  # fmt: skip
        else:
            wish = _wish(crowd, b, w, plans, c, seed, k, crowd.number[c] + k - n)
            placed = wish
            if k == n and plan.avoids(plans, c):
                placed = _make_way(crowd, b, w, r, c, seed, n, plans.mode[c] == plan.WALK, wish)
                hindered = placed.stands and not wish.stands
        steps.write(crowd, bipeds, c, k, placed)
        if k == n:
            crowd.standing[c] = placed.stands
    crowd.lift[c, n] = 0.0
    if not crowd.standing[c]:
        steps.lay_way(crowd, bipeds, w, c, n)


@jit_borrowing
def _reach_stop(crowd, b, w, plans, c, n):
    """Counts the stop that a walker has come to, unless it is the last one to stay at."""
    x, y = crowd.position[c, n - 1, 0], crowd.position[c, n - 1, 1]
    x, y = plan.middle_of(b, crowd.side[c, n - 1], x, y, crowd.heading[c, n - 1])
    reached = crowd.reached[c]
    if not plan.is_last_stop(plans, c, reached) and plan.is_there(b, w, plans, c, reached, crowd.hindered[c], x, y):
        crowd.reached[c] += 1


@jit_borrowing
def window_end(track):
    """Where the window ends [s]: shortly after the last tentative footprint has landed."""
    last = len(track.side) - 1
    return track.contact_time[last] + WINDOW_TAIL * track.step_time[last]


@Part
def optimise_step(address, c):
    """Solves character c's window over the real and tentative footprints and commits step n - 1 (paper, section 4.2)."""
    crowd, bipeds, _, _, _, _, effort = opened(address)
    n, committed = crowd.real[c] - 1, crowd.curve_count[c]
    track = track_of(crowd, c, n + TENTATIVE + 1)
    time, control, support = crowd.window_time[c], crowd.window_control[c], crowd.window_support[c]
    points, e, iterations = window.optimise_window(
        bipeds[crowd.kind[c]], track, crowd.curve_time[c, committed], window_end(track), crowd.control[c, committed],
        crowd.window_count[c], time, control, support, effort,
    )  # fmt: skip
    crowd.window_count[c] = points
    crowd.window_cost[c, 0], crowd.window_cost[c, 1] = e, iterations
    rows.commit(crowd, c, time[:points], control[:points], support[: points - 1], track.contact_time[n - 1])


@Part
def plan_step(address, c):
    """Character c's footprint n, its timing, and the tentative footprints behind it."""
    crowd, bipeds, w, plans, r, seed, _ = opened(address)
    if crowd.real[c] == REAL:
        rows.shift(crowd, c)
    n = crowd.real[c]
    crowd.number[c] += 1
    if plans.mode[c] == plan.WALK:
        _reach_stop(crowd, bipeds[crowd.kind[c]], w, plans, c, n)
    _place(crowd, bipeds, w, plans, r, c, seed)
    crowd.real[c] = n + 1


class Parts(NamedTuple):
    """The parts of one round of the paper's loop, by where they lie: kernels get them as an argument."""

    plan: int
    optimise: int


def compiled_parts() -> Parts:
    """The parts, compiled."""
    return Parts(plan_step.address, optimise_step.address)


@jit_borrowing
def publish(crowd, bipeds, r, c):
    """Lets the others see what character c holds and means to do."""
    n = crowd.real[c]
    r.due[c] = horizon(crowd, c)
    r.aim[c, 0], r.aim[c, 1] = crowd.aim[c, 0], crowd.aim[c, 1]
    for k in range(3):
        r.claim[c, k] = crowd.claim[c, k]
    late = reservations.lag(bipeds[crowd.kind[c]])
    for k in range(reservations.FEET):
        row = max(n - reservations.FEET + k, 0)
        r.foot[c, k, 0], r.foot[c, k, 1] = crowd.position[c, row, 0], crowd.position[c, row, 1]
        r.foot[c, k, 2] = np.inf if row >= n - 2 else crowd.contact_time[c, row] + crowd.stance_time[c, row]
    for k in range(reservations.COMMITTED + reservations.TENTATIVE):
        row = max(n - reservations.COMMITTED + k, 0)
        before = max(row - 1, 0)
        r.way[c, k, 0] = 0.5 * (crowd.position[c, before, 0] + crowd.position[c, row, 0])
        r.way[c, k, 1] = 0.5 * (crowd.position[c, before, 1] + crowd.position[c, row, 1])
        r.way[c, k, 2] = crowd.contact_time[c, row] + late


@jit_borrowing
def publish_all(crowd, bipeds, r, who):
    """Lets everyone see the characters `who` (K,)."""
    for c in who:
        publish(crowd, bipeds, r, c)


@jit
def due_now(r, until, placed):
    """The characters that must plan before `until` [s], in the order of their numbers."""
    due = np.empty(len(r.due), np.int64)
    count = 0
    for c in range(len(r.due)):
        if r.due[c] < until and placed[c] < REAL - 2:
            due[count] = c
            count += 1
    return due[:count].copy()


@jit_borrowing
def _fetch_round(crowd, c):
    """Asks for what a round of character c reads."""
    fetch_row(crowd, c)
    for n in range(crowd.window_count[c] + 1):
        fetch(crowd.window_control, (c, n, 0))
    fetch(crowd.window_time, (c, 0))
    fetch(crowd.window_time, (c, 8))


@jit_borrowing
def _advance_some(parts, address, turn, counter):
    """One round for share after share of a turn, until none is left."""
    crowd = opened(address)[0]
    begin = take(counter) * SHARE
    while begin < len(turn):
        for k in range(begin, min(begin + SHARE, len(turn))):
            if k + 1 < len(turn):
                _fetch_round(crowd, turn[k + 1])
            call(parts.plan, address, turn[k])
            call(parts.optimise, address, turn[k])
        begin = take(counter) * SHARE


@jit_parallel
def _advance_in_threads(parts, address, turn, counter):
    for _ in prange(WORKERS):
        _advance_some(parts, address, turn, counter)


@jit
def advance_all(parts, crowd, bipeds, w, plans, r, seed, effort, until, placed):
    """One round for every character whose committed curve ends before `until` [s]; placed (C,) counts the new footprints.

    Neighbours who are due in the same tick take turns, as often as needed: all of a turn decide against what was published
    before, then all publish, so the order of threads does not matter.
    """
    placed[:] = 0
    counter = np.zeros(1, np.int64)
    address = lend((crowd, bipeds, w, plans, r, seed, effort))
    due = due_now(r, until, placed)
    if len(due) > 0:
        reservations.sort_into_cells(r)
    while len(due) > 0:
        turn = reservations.without_neighbours(r, due)
        counter[0] = 0
        if len(turn) <= SHARE:
            _advance_some(parts, address, turn, counter)
        else:
            _advance_in_threads(parts, address, turn, counter)
        publish_all(crowd, bipeds, r, turn)
        for c in turn:
            placed[c] += 1
        due = due_now(r, until, placed)
