"""From a timed track to the problem of its COM curve, and the live window on it (paper, sections 2.3 and 4.2).

When footprint n is placed, step n gets its timing and step n-1, which is about to be executed, is optimised together with
step n and the planner's tentative footprints beyond it; then step n-1 is committed and never changes again. The window's
first control point is the end of what is already committed.
"""

from typing import NamedTuple

import numpy as np

from motion import foot, heading, newton, phases, spline
from motion import problem as problems
from motion.jit import jit, jit_borrowing, jit_inline

LIVE_SAMPLES = 5
"""Samples per segment of the live window: the residual is nearly linear in a phase, five find it."""

HARD = 0.4
"""Mean cost [m/s^2] of a window above which it gets more effort: leaps, which are rare; walking stays below."""
FULL_REACH = 0.995
"""Share of max_length from which on reach counts: the penalty gives a little, the leg shall not."""

ANCHOR_STIFFNESS = (10.0, 1.0)
"""Of the window's end, position [1/s/m] and velocity [s/m]: more steadies the end, and insists on a foreseen state."""
STRIDES = 4
"""Footprints after which a walk repeats: twice both feet."""
IRREGULAR = 1.5
"""Ratio of two strides' times from which on one says nothing about the other."""

LOOK_BACK = 6
"""Footprints before the newest among which a standing one is looked for."""


class Stance(NamedTuple):
    """What laying asks of the feet: computed once for all samples."""

    axis: np.ndarray  # (n, 3) of each footprint's sole, heel to toe
    yaw: np.ndarray  # (m * (S + 1) + 1,) body heading at each segment's beginning and samples, then at the last end


@jit
def _stance(b, track, time, samples):
    axis = np.empty((len(track.side), 3))
    for n in range(len(axis)):
        axis[n, 0], axis[n, 1], axis[n, 2] = foot.sole_axis(track.heading[n], track.normal[n])
    m, k = len(time) - 1, 0
    times = np.empty(m * (samples + 1) + 1)
    for i in range(m):
        times[k] = time[i]
        for j in range(samples):
            times[k + 1 + j] = time[i] + (j + 0.5) / samples * (time[i + 1] - time[i])
        k += samples + 1
    times[k] = time[m]
    yaw = np.empty(len(times))
    heading.body_headings(b, track, times, yaw)
    return Stance(axis, yaw)


@jit
def lay_samples(b, track, problem, support, by_step):
    """Fills the samples of a problem whose `time` is set.

    A segment of one phase has the phase's support (m, 2) all along; the paper's segments span a step and are sampled by time.
    """
    samples = problem.support_point.shape[1]
    stance = _stance(b, track, problem.time, samples)
    for i in range(len(problem.time) - 1):
        begin, end, k = problem.time[i], problem.time[i + 1], i * (samples + 1)
        left, right = support[i, 0], support[i, 1]
        first = max(np.searchsorted(track.contact_time, begin, side="right") - LOOK_BACK, 0) if by_step else 0
        for j in range(samples):
            t = begin + (j + 0.5) / samples * (end - begin)
            if by_step:
                left, right = phases.support_at(track.side, track.contact_time, track.stance_time, first, t)
            _lay_sample(b, track, stance, problem, i, j, left, right, t, stance.yaw[k + 1 + j])
            if j == 0:
                _lay_end(b, track, stance, problem, i, 0, left, right, begin, stance.yaw[k])
        _lay_end(b, track, stance, problem, i, 1, left, right, end, stance.yaw[k + samples + 1])


@jit_inline
def _lay_sample(b, track, stance, problem, i, j, left, right, t, yaw):
    for leg in range(2):
        n = left if leg == 0 else right
        problem.standing[i, j, leg] = n >= 0
        if n >= 0:
            u = _share(track, n, t)
            roll = track.roll[n, 0] + u * (track.roll[n, 1] - track.roll[n, 0])
            x, y, z = _on_sole(track, stance, n, (roll - 0.5) * b.foot_length, 0.0)
            at = problem.support_point
            at[i, j, leg, 0], at[i, j, leg, 1], at[i, j, leg, 2] = x, y, z
            x, y, z = _origin(b, track, stance, n, leg, yaw, u)
            at = problem.leg_origin
            at[i, j, leg, 0], at[i, j, leg, 1], at[i, j, leg, 2] = x, y, z
            problem.nominal_length[i, j, leg] = track.nominal_length[n]


@jit_inline
def _lay_end(b, track, stance, problem, i, end, left, right, t, yaw):
    """The legs at an end of a segment are those of its nearest sample."""
    for leg in range(2):
        n = left if leg == 0 else right
        problem.end_standing[i, end, leg] = n >= 0
        if n >= 0:
            x, y, z = _origin(b, track, stance, n, leg, yaw, _share(track, n, t))
            at = problem.end_origin
            at[i, end, leg, 0], at[i, end, leg, 1], at[i, end, leg, 2] = x, y, z


@jit_inline
def _share(track, n, t):
    return min(max((t - track.contact_time[n]) / track.stance_time[n], 0.0), 1.0)


@jit_inline
def _on_sole(track, stance, n, forward, up):
    """motion.foot.along_sole for footprint n."""
    return (
        track.position[n, 0] + forward * stance.axis[n, 0] + up * track.normal[n, 0],
        track.position[n, 1] + forward * stance.axis[n, 1] + up * track.normal[n, 1],
        track.position[n, 2] + forward * stance.axis[n, 2] + up * track.normal[n, 2],
    )


@jit_inline
def _origin(b, track, stance, n, leg, yaw, u):
    """Ankle of the foot on footprint n at share u of its stance (motion.foot.stance_ankle), minus the hip's offset."""
    hip = foot.hip_offset(b, leg, yaw)
    forward, up = foot.about_ball(b, b.ankle_forward, b.ankle_height, foot.heel_off_angle(b, track.roll[n, 1], u))
    ankle = _on_sole(track, stance, n, forward, up)
    return ankle[0] - hip[0], ankle[1] - hip[1], ankle[2] - hip[2]


@jit
def build_problem(b, track, begin, end, samples, by_step):
    """Problem and support (m, 2) of the time [begin, end]; a segment per phase, or the paper's per step."""
    time = np.empty(2 * len(track.side) + 2)
    support = np.empty((2 * len(track.side) + 2, 2), np.int64)
    m = phases.build_phases(track.side, track.contact_time, track.stance_time, begin, end, time, support)
    if by_step:
        m = phases.merge_by_step(time, support, m)
    problem = problems.empty_problem(m, samples, b.nominal_length, FULL_REACH * b.max_length, b.comfort_weight)
    problem.time[:] = time[: m + 1]
    lay_samples(b, track, problem, support, by_step)
    return problem, support[:m]


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
    problem, support = build_problem(b, track, begin, end, samples, by_step)
    control = np.zeros((len(problem.time), 6))
    control[0], control[-1] = start, finish
    problem.fixed[0] = problem.fixed[-1] = True
    problems.straight_guess(problem, control, 1)
    e, iterations = newton.minimise(problem, control, effort)
    return problem.time, control, support, e, iterations


@jit
def optimise_window(b, track, begin, end, start, old_time, old_control, effort):
    """Optimises [begin, end] from the committed state start (6,); returns (time, control, support, E, iterations).

    old_time (k + 1,) and old_control (k + 1, 6) are the previous window's curve (k = 0: none, a cold start).
    """
    problem, support = lay_window(b, track, begin, end)
    control = np.zeros((len(problem.time), 6))
    begin_window(track, problem, control, start, old_time, old_control)
    e, iterations = newton.minimise(problem, control, effort)
    if e > HARD * (problem.time[-1] - problem.time[0]):
        e, more = newton.minimise(problem, control, newton.HARDER)
        iterations += more
        if e > HARD * (problem.time[-1] - problem.time[0]):
            e, more = _begin_anew(problem, control, e)
            iterations += more
    return problem.time, control, support, e, iterations


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
    return build_problem(b, track, begin, end, LIVE_SAMPLES, False)
