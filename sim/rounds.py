"""One round of the paper's loop (section 4.2), and a scripted character's only one.

Live: footprint n is placed and timed, tentative footprints behind it, step n - 1 is optimised in its window and committed.
Scripted: all footprints are placed and timed, and the whole curve is optimised at once.
"""

from math import cos, hypot, sin

import numpy as np
from numba import prange

from motion import window
from motion.jit import jit, jit_borrowing, jit_parallel
from planner import avoiding, placing, plan, reservations, timing
from planner.script import MIDDLE, ROLL
from sim import rows
from sim.crowd import REAL, TENTATIVE, above_feet, horizon, track_of

WINDOW_TAIL = 0.0
"""Share of a step that the window goes on after the last tentative contact: more steadies its end, and costs time."""


@jit_borrowing
def _write(crowd, bipeds, c, n, f):
    """Puts planned footprint f (a planner.plan.Placed) at row n, times the one it leaves, and lays the way to it."""
    b = bipeds[crowd.kind[c]]
    crowd.side[c, n] = f.side
    crowd.position[c, n, 0], crowd.position[c, n, 1], crowd.position[c, n, 2] = f.x, f.y, f.z
    crowd.heading[c, n] = f.heading
    crowd.normal[c, n, 0], crowd.normal[c, n, 1], crowd.normal[c, n, 2] = f.nx, f.ny, f.nz
    crowd.rock[c, n] = f.rock
    crowd.stands[c, n] = f.stands
    crowd.facing[c, n] = 0.0
    _roll(crowd, c, n, f.stands)
    step, stance = _timing(crowd, b, c, n, f)
    _time(crowd, b, c, n, f.stands, step, stance)


@jit_borrowing
def _roll(crowd, c, n, stands):
    """Where the support begins on footprint n and ends on n - 1: heel to toe forward, toe to heel backward, else between."""
    ahead = 0.0 if stands else placing.forwardness(crowd.position[c, n - 1], crowd.position[c, n], crowd.heading[c, n])
    if not stands:
        left = placing.forwardness(crowd.position[c, n - 1], crowd.position[c, n], crowd.heading[c, n - 1])
        crowd.roll[c, n - 1, 1] = 0.5 + 0.5 * left
    crowd.roll[c, n, 0] = 0.5 - 0.5 * ahead
    crowd.roll[c, n, 1] = 0.5 + 0.5 * ahead


@jit_borrowing
def _length(crowd, c, n):
    """Horizontal length of the step to footprint n [m]."""
    p, q = crowd.position[c, n - 1], crowd.position[c, n]
    return ((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2) ** 0.5


@jit_borrowing
def _timing(crowd, b, c, n, f):
    """(step time, stance time) of footprint n - 1 from the step to footprint n (paper, section 4.1)."""
    if f.stands:
        return f.wait, f.wait + plan.START_OVERLAP * timing.pendulum_time(b)
    rise = crowd.position[c, n, 2] - crowd.position[c, n - 1, 2]
    turn = abs(crowd.heading[c, n] - crowd.heading[c, n - 1])
    step, stance = timing.step_timing(b, _length(crowd, c, n), rise, turn, f.side == crowd.side[c, n - 1])
    overlap = crowd.contact_time[c, n - 2] + crowd.stance_time[c, n - 2] - crowd.contact_time[c, n - 1]
    longer = max(timing.least_step_time(b, overlap) - step, 0.0)
    return step + longer, stance + longer


@jit_borrowing
def _time(crowd, b, c, n, stands, step, stance):
    """Sets the timing of footprint n - 1, the same as a first guess for n's own, and the leg that the pace asks for."""
    if stands:
        crowd.stance_time[c, n - 2] = crowd.contact_time[c, n - 1] + step - crowd.contact_time[c, n - 2]
        crowd.roll[c, n - 2, 1] = 0.5
    crowd.step_time[c, n - 1] = step
    crowd.stance_time[c, n - 1] = stance
    crowd.contact_time[c, n] = crowd.contact_time[c, n - 1] + step
    crowd.step_time[c, n] = step
    crowd.stance_time[c, n] = stance
    rise = crowd.position[c, n, 2] - crowd.position[c, n - 1, 2]
    crowd.nominal_length[c, n] = b.nominal_length if stands else timing.nominal_length(b, _length(crowd, c, n), step, rise)


@jit_borrowing
def _lay_way(crowd, bipeds, w, c, n):
    """Lift and hold of the swing that arrives at footprint n."""
    before = n - 1
    while before > 0 and crowd.side[c, before] != crowd.side[c, n]:
        before -= 1
    b = bipeds[crowd.kind[c]]
    placing.lay_swing(b, w, track_of(crowd, c, n + 1), before, n)


@jit_borrowing
def _wish(crowd, b, w, plans, c, seed, n, step):
    """What the planner wants as footprint number `step`, at row n."""
    two = slice(n - 2, n)
    return plan.next_footprint(
        b, w, plans, c, seed, step, crowd.reached[c], crowd.hindered[c], crowd.side[c, two], crowd.position[c, two],
        crowd.heading[c, two], crowd.normal[c, two], crowd.rock[c, two],
    )  # fmt: skip


@jit_borrowing
def _make_way(crowd, b, w, r, c, seed, n, wish):
    """The wish, or what is free of others instead of it."""
    last = crowd.position[c, n - 1]
    x, y = plan.middle_of(b, crowd.side[c, n - 1], last[0], last[1], crowd.heading[c, n - 1])
    to_x, to_y = plan.middle_of(b, wish.side, wish.x, wish.y, wish.heading)
    length = 0.0 if wish.stands else hypot(to_x - x, to_y - y)
    crowd.aim[c, 0], crowd.aim[c, 1] = length * cos(wish.heading), length * sin(wish.heading)
    two = slice(n - 2, n)
    overlap = crowd.contact_time[c, n - 2] + crowd.stance_time[c, n - 2] - crowd.contact_time[c, n - 1]
    placed, crowd.hindered[c] = avoiding.make_way(
        b, w, r, c, wish, crowd.side[c, two], crowd.position[c, two], crowd.heading[c, two], crowd.normal[c, two],
        crowd.rock[c, two], crowd.contact_time[c, n - 1], overlap, crowd.hindered[c], seed, crowd.number[c], crowd.claim[c],
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
                placed = _make_way(crowd, b, w, r, c, seed, n, wish)
                hindered = placed.stands and not wish.stands
        _write(crowd, bipeds, c, k, placed)
        if k == n:
            crowd.standing[c] = placed.stands
    crowd.lift[c, n] = 0.0
    if not crowd.standing[c]:
        _lay_way(crowd, bipeds, w, c, n)


@jit_borrowing
def _reach_stop(crowd, b, plans, c, n):
    """Counts the stop that a walker has come to, unless it is the last one to stay at."""
    x, y = crowd.position[c, n - 1, 0], crowd.position[c, n - 1, 1]
    x, y = plan.middle_of(b, crowd.side[c, n - 1], x, y, crowd.heading[c, n - 1])
    more = plans.again[c] or crowd.reached[c] < plans.stops.shape[1] - 1
    if more and plan.is_there(b, plans, c, crowd.reached[c], crowd.hindered[c], x, y):
        crowd.reached[c] += 1


@jit_borrowing
def window_end(track):
    """Where the window ends [s]: shortly after the last tentative footprint has landed."""
    last = len(track.side) - 1
    return track.contact_time[last] + WINDOW_TAIL * track.step_time[last]


@jit
def optimise_step(crowd, bipeds, c, effort):
    """Solves the window over the real and tentative footprints and commits step n - 1 (paper, section 4.2)."""
    n = crowd.real[c] - 1
    last = n + TENTATIVE
    track = track_of(crowd, c, last + 1)
    committed = crowd.curve_count[c]
    begin = crowd.curve_time[c, committed]
    kept = crowd.window_count[c]
    time, control, support, e, iterations = window.optimise_window(
        bipeds[crowd.kind[c]], track, begin, window_end(track),
        crowd.control[c, committed], crowd.window_time[c, :kept], crowd.window_control[c, :kept], effort,
    )  # fmt: skip
    crowd.window_cost[c, 0], crowd.window_cost[c, 1] = e, iterations
    crowd.window_count[c] = len(time)
    crowd.window_time[c, : len(time)] = time
    crowd.window_control[c, : len(time)] = control
    rows.commit(crowd, c, time, control, support, track.contact_time[n - 1])


@jit_borrowing
def plan_step(crowd, bipeds, w, plans, r, c, seed):
    """Character c's footprint n, its timing, and the tentative footprints behind it."""
    if crowd.real[c] == REAL:
        rows.shift(crowd, c)
    n = crowd.real[c]
    crowd.number[c] += 1
    if plans.mode[c] == plan.WALK:
        _reach_stop(crowd, bipeds[crowd.kind[c]], plans, c, n)
    _place(crowd, bipeds, w, plans, r, c, seed)
    crowd.real[c] = n + 1


@jit_borrowing
def _advance(crowd, bipeds, w, plans, r, c, seed, effort):
    """One round of the paper's loop: footprint n, its timing, tentative footprints, step n - 1 optimised, committed."""
    plan_step(crowd, bipeds, w, plans, r, c, seed)
    optimise_step(crowd, bipeds, c, effort)


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


@jit_parallel
def publish_all(crowd, bipeds, r):
    """Lets everyone see everyone: where a simulation begins, or goes on after it was restored."""
    for row in prange(len(crowd.kind)):
        publish(crowd, bipeds, r, np.int64(row))  # prange counts unsigned: kernels would be compiled a second time


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


@jit_parallel
def _take_turn(crowd, bipeds, w, plans, r, turn, seed, effort):
    """All of `turn` decide against what was published before, then all publish: the order of threads does not matter."""
    for k in prange(len(turn)):
        _advance(crowd, bipeds, w, plans, r, turn[k], seed, effort)
    for k in prange(len(turn)):
        publish(crowd, bipeds, r, turn[k])


@jit
def advance_all(crowd, bipeds, w, plans, r, seed, until, effort, placed):
    """Plans every character whose committed curve ends before `until` [s]; placed (C,) counts the new footprints.

    Neighbours who are due in the same tick take turns, as often as needed.
    """
    placed[:] = 0
    due = due_now(r, until, placed)
    if len(due) > 0:
        reservations.sort_into_cells(r)
    while len(due) > 0:
        turn = reservations.without_neighbours(r, due)
        _take_turn(crowd, bipeds, w, plans, r, turn, seed, effort)
        for c in turn:
            placed[c] += 1
        due = due_now(r, until, placed)


@jit
def perform(crowd, bipeds, w, c, script, samples, by_step, effort):
    """Lets character c, which stands, do all of a planner.script.Script, and then stand; returns (E, iterations)."""
    for k in range(len(script.side)):
        n = crowd.real[c]
        _write(crowd, bipeds, c, n, plan.scripted(bipeds[crowd.kind[c]], w, script, k, track_of(crowd, c, n)))
        _own_timing(crowd, bipeds, c, n, script, k)
        crowd.nominal_length[c, n] *= script.crouch[k]
        crowd.facing[c, n] = script.facing[k]
        crowd.real[c] = n + 1
    n = crowd.real[c]
    crowd.roll[c, n - 2 : n, 1] = 0.5
    if script.support != ROLL:
        crowd.roll[c, 2:n] = 0.5 if script.support == MIDDLE else 1.0
    end = crowd.contact_time[c, n - 1] + script.rest
    crowd.stance_time[c, n - 2 : n] = end + plan.STAND_TIME - crowd.contact_time[c, n - 2 : n]
    for k in range(2, n):
        _lay_way(crowd, bipeds, w, c, k)
    finish = np.empty(6)
    above_feet(bipeds[crowd.kind[c]], track_of(crowd, c, n), finish)
    time, control, support, e, iterations = window.optimise_track(
        bipeds[crowd.kind[c]], track_of(crowd, c, n), crowd.curve_time[c, 0], end, crowd.control[c, 0], finish, samples,
        by_step, effort,
    )  # fmt: skip
    rows.commit(crowd, c, time, control, support, end)
    return e, iterations


@jit_borrowing
def _own_timing(crowd, bipeds, c, n, script, k):
    """Timing given by the script replaces the automatic one (NaN: none)."""
    step, stance = crowd.step_time[c, n - 1], crowd.stance_time[c, n - 1]
    if not np.isnan(script.stance_time[k]):
        stance = script.stance_time[k]
    elif not np.isnan(script.step_time[k]):
        stance *= script.step_time[k] / step
    if not np.isnan(script.step_time[k]):
        step = script.step_time[k]
    _time(crowd, bipeds[crowd.kind[c]], c, n, script.wait[k] > 0, step, stance)
