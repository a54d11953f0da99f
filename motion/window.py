"""From a timed track to the problem of its COM curve, and the live window on it (paper, sections 2.3 and 4.2).

When footprint n is placed, step n gets its timing and step n-1, which is about to be executed, is optimised together with
step n and the planner's tentative footprints beyond it; then step n-1 is committed and never changes again. The window's
first control point is the end of what is already committed.
"""

import numpy as np

from motion import foot, heading, newton, phases, spline
from motion import problem as problems
from motion.jit import jit

LIVE_SAMPLES = 5
"""Samples per segment of the live window: the residual is nearly linear in a phase, five find it."""

HARD = 0.4
"""Mean cost [m/s^2] of a window above which it gets more effort: leaps, which are rare; walking stays below."""
TOO_FAR = 1e-3
"""Reach penalty from which on the legs are too long: one leg by some 0.7 mm."""
FULL_REACH = 0.995
"""Share of max_length from which on reach counts: the penalty gives a little, the leg shall not."""

LOOK_BACK = 6
"""Footprints before the newest among which a standing one is looked for."""


@jit
def lay_samples(b, track, problem):
    """Fills the samples of a problem whose `time` is set; a sample asks the track who stands at its time.

    A segment of one phase has the phase's support all along; the paper's segments span a step and are sampled by time.
    """
    samples = problem.support_point.shape[1]
    for i in range(len(problem.time) - 1):
        duration = problem.time[i + 1] - problem.time[i]
        first = max(np.searchsorted(track.contact_time, problem.time[i], side="right") - LOOK_BACK, 0)
        for j in range(samples):
            t = problem.time[i] + (j + 0.5) / samples * duration
            support = phases.support_at(track.side, track.contact_time, track.stance_time, first, t)
            yaw = heading.body_heading(b, track, t)
            for leg in range(2):
                n = support[leg]
                problem.standing[i, j, leg] = n >= 0
                if n >= 0:
                    problem.nominal_length[i, j, leg] = track.nominal_length[n]
                    problem.support_point[i, j, leg] = foot.point_of_support(b, track, n, _share(track, n, t))
                    _lay_origin(b, track, n, leg, yaw, t, problem.leg_origin[i, j])
            if j == 0:
                _lay_end(b, track, support, problem.time[i], problem.end_origin[i, 0], problem.end_standing[i, 0])
            if j == samples - 1:
                _lay_end(b, track, support, problem.time[i + 1], problem.end_origin[i, 1], problem.end_standing[i, 1])


@jit
def _lay_end(b, track, support, t, origin, standing):
    """The legs at an end of a segment are those of its nearest sample."""
    yaw = heading.body_heading(b, track, t)
    for leg in range(2):
        standing[leg] = support[leg] >= 0
        if support[leg] >= 0:
            _lay_origin(b, track, support[leg], leg, yaw, t, origin)


@jit
def _share(track, n, t):
    return min(max((t - track.contact_time[n]) / track.stance_time[n], 0.0), 1.0)


@jit
def _lay_origin(b, track, n, leg, yaw, t, origin):
    hip = foot.hip_offset(b, leg, yaw)
    ankle = foot.stance_ankle(b, track, n, _share(track, n, t))
    for axis in range(3):
        origin[leg, axis] = ankle[axis] - hip[axis]


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
    lay_samples(b, track, problem)
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


@jit
def optimise_track(b, track, begin, end, start, finish, samples, by_step, effort):
    """Optimises the whole motion from state start (6,) to finish (6,); returns (time, control, support, E, iterations)."""
    problem, support = build_problem(b, track, begin, end, samples, by_step)
    control = np.zeros((len(problem.time), 6))
    control[0], control[-1] = start, finish
    problem.fixed[0] = problem.fixed[-1] = True
    problems.straight_guess(problem, control, 1)
    problem.max_length[:] = FULL_REACH * b.max_length
    e, iterations = newton.minimise(problem, control, effort)
    return problem.time, control, support, e, iterations


@jit
def optimise_window(b, track, begin, end, start, old_time, old_control, effort):
    """Optimises [begin, end] from the committed state start (6,); returns (time, control, support, E, iterations).

    Walking keeps within reach by itself, so reach counts only where the first solve left it: its stiffness costs iterations.

    old_time (k + 1,) and old_control (k + 1, 6) are the previous window's curve (k = 0: none, a cold start).
    """
    problem, support = build_problem(b, track, begin, end, LIVE_SAMPLES, False)
    control = np.zeros((len(problem.time), 6))
    control[0] = start
    problem.fixed[0] = True
    first = _warm_start(problem, control, old_time, old_control) if len(old_time) > 1 else 1
    if first < len(problem.time):
        problems.straight_guess(problem, control, first)
    problem.max_length[:] = np.inf
    e, iterations = newton.minimise(problem, control, effort)
    problem.max_length[:] = FULL_REACH * b.max_length
    if problems.total_cost(problem, control) > e + TOO_FAR or e > HARD * (problem.time[-1] - problem.time[0]):
        e, more = newton.minimise(problem, control, newton.HARDER)
        iterations += more
    return problem.time, control, support, e, iterations
