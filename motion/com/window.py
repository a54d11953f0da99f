"""From a timed track to the problem of its COM curve, and the live window on it (paper, sections 2.3 and 4.2).

When footprint n is placed, step n gets its timing and step n-1, which is about to be executed, is optimised together with
step n and the planner's tentative footprints beyond it; then step n-1 is committed and never changes again. The window's
first control point is the end of what is already committed.
"""

import numpy as np

from motion.com import laying, newton
from motion.com import problem as problems
from motion.track import spline
from worlds.compiled.jit import jit, jit_borrowing

LIVE_SAMPLES = 5
"""Samples per segment of the live window: the residual is nearly linear in a phase, five find it."""

HARD = 0.4
"""Mean cost [m/s^2] of a window above which it gets more effort: leaps, which are rare; walking stays below."""

ANCHOR_STIFFNESS = (10.0, 1.0)
"""Of the window's end, position [1/s/m] and velocity [s/m]: more steadies the end, and insists on a foreseen state."""
STRIDES = 4
"""Footprints after which a walk repeats: twice both feet."""
IRREGULAR = 1.5
"""Ratio of two strides' times from which on one says nothing about the other."""


@jit
def _warm_start(problem, control, old_time, old_control):
    """Control points within the previous window's time take its curve; returns the first beyond it."""
    scratch = np.empty(3)
    for i in range(1, len(problem.time)):
        if problem.time[i] > old_time[-1]:
            return i
        spline.evaluate(old_time, old_control, problem.time[i], control[i, :3], control[i, 3:], scratch)
    return len(problem.time)


@jit_borrowing
def _regular(track, last, old_time):
    """Whether the window's last stride repeats, about, the one two strides before: alternating feet, similar timing."""
    n = last - STRIDES
    if n < 2 or not old_time[0] <= track.contact_time[n] <= old_time[-1]:
        return False
    for k in range(STRIDES):
        i, j = last - k, n - (k % 2)
        if track.side[i] != track.side[j] or track.side[i] == track.side[i - 1]:
            return False
    pace = (track.contact_time[last] - track.contact_time[last - 2]) / (track.contact_time[n] - track.contact_time[n - 2])
    return 1 / IRREGULAR < pace < IRREGULAR and track.side[n] != track.side[n - 1]


@jit
def _repeat(track, last, t, old_time, old_control, out):
    """Fills out (6,) with the state at time t by that of the previous curve STRIDES footprints before.

    It keeps its place between the two feet in their mean heading, and the difference of its velocity from their mean.
    """
    n = last - STRIDES
    scratch = np.empty(3)
    spline.evaluate(old_time, old_control, t - track.contact_time[last] + track.contact_time[n], out[:3], out[3:], scratch)
    turn = 0.5 * (track.heading[last] + track.heading[last - 1] - track.heading[n] - track.heading[n - 1])
    c, s = np.cos(turn), np.sin(turn)
    before, after = track.contact_time[n] - track.contact_time[n - 2], track.contact_time[last] - track.contact_time[last - 2]
    for axis in range(3):
        out[axis] -= 0.5 * (track.position[n, axis] + track.position[n - 1, axis])
        out[3 + axis] -= (track.position[n, axis] - track.position[n - 2, axis]) / before
    for k in (0, 3):
        out[k], out[k + 1] = c * out[k] - s * out[k + 1], s * out[k] + c * out[k + 1]
    for axis in range(3):
        out[axis] += 0.5 * (track.position[last, axis] + track.position[last - 1, axis])
        out[3 + axis] += (track.position[last, axis] - track.position[last - 2, axis]) / after


@jit_borrowing
def begin_window(track, problem, control, start, old_time, old_control):
    """Fills control with start (6,) and the first guess of the rest; fixes the start, and the end where it is foreseeable."""
    for k in range(6):
        control[0, k] = start[k]
    problem.fixed[0] = True
    if len(old_time) < 2:
        problems.straight_guess(problem, control, 1)
        return
    first, m, last = _warm_start(problem, control, old_time, old_control), len(problem.time) - 1, len(track.side) - 1
    if first > m:
        return
    if _regular(track, last, old_time):
        for i in range(first, m + 1):
            _repeat(track, last, problem.time[i], old_time, old_control, control[i])
        for k in range(6):
            problem.anchor[k] = control[m, k]
        problem.anchor_stiffness[0], problem.anchor_stiffness[1] = ANCHOR_STIFFNESS
    else:
        problems.straight_guess(problem, control, first)


@jit
def optimise_track(b, track, begin, end, start, finish, samples, by_step, effort):
    """Optimises the whole motion from state start (6,) to finish (6,); returns (time, control, support, E, iterations)."""
    problem, support = laying.build_problem(b, track, begin, end, samples, by_step)
    control = np.zeros((len(problem.time), 6))
    control[0], control[-1] = start, finish
    problem.fixed[0] = problem.fixed[-1] = True
    problems.straight_guess(problem, control, 1)
    e, iterations = newton.minimise(problem, control, effort)
    return problem.time, control, support, e, iterations


@jit
def optimise_window(b, track, begin, end, start, count, time, control, support, effort):
    """Optimises [begin, end] from the committed state start (6,), in place; returns (control points, E, iterations).

    time (W,) and control (W, 6) hold the previous window's curve in their first `count` rows (0: none, a cold start), and this
    one's afterwards, support (W, 2) its footprints. W is at least the control points of the window.
    """
    problem, stand = lay_window(b, track, begin, end)
    found = np.zeros((len(problem.time), 6))
    begin_window(track, problem, found, start, time[:count], control[:count])
    e, iterations = _solve(problem, found, effort)
    for i in range(len(found)):
        time[i] = problem.time[i]
        for k in range(6):
            control[i, k] = found[i, k]
    for i in range(len(stand)):
        support[i, 0], support[i, 1] = stand[i, 0], stand[i, 1]
    return len(found), e, iterations


@jit
def _solve(problem, control, effort):
    e, iterations = newton.minimise(problem, control, effort)
    limit = HARD * (problem.time[-1] - problem.time[0])
    if e > limit:
        e, more = newton.minimise(problem, control, newton.HARDER)
        iterations += more
        if e > limit:
            e, more = _begin_anew(problem, control, e)
            iterations += more
    return e, iterations


@jit
def _begin_anew(problem, control, e):
    """The better of the curve found, of cost e, and one from a cold start: a bad last window must not spoil all that follow."""
    cold = control.copy()
    problems.straight_guess(problem, cold, 1)
    cold_e, iterations = newton.minimise(problem, cold, newton.HARDER)
    if cold_e < e:
        control[:] = cold
    return min(cold_e, e), iterations


@jit
def lay_window(b, track, begin, end):
    """Problem and support of the live window of the time [begin, end]."""
    return laying.build_problem(b, track, begin, end, LIVE_SAMPLES, False)
