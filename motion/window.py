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
            left, right = phases.support_at(track.side, track.contact_time, track.stance_time, first, t)
            yaw = heading.body_heading(b, track, t)
            for leg, standing_on in ((0, left), (1, right)):
                problem.standing[i, j, leg] = standing_on >= 0
                if standing_on >= 0:
                    _lay_leg(b, track, standing_on, leg, yaw, t, problem.support_point[i, j], problem.leg_origin[i, j])


@jit
def _lay_leg(b, track, n, leg, yaw, t, support_point, leg_origin):
    u = min(max((t - track.contact_time[n]) / track.stance_time[n], 0.0), 1.0)
    support_point[leg] = foot.point_of_support(b, track, n, u)
    hip = foot.hip_offset(b, leg, yaw)
    ankle = foot.stance_ankle(b, track, n, u)
    for axis in range(3):
        leg_origin[leg, axis] = ankle[axis] - hip[axis]


@jit
def build_problem(b, track, begin, end, samples, by_step):
    """Problem and support (m, 2) of the time [begin, end]; a segment per phase, or the paper's per step."""
    time = np.empty(2 * len(track.side) + 2)
    support = np.empty((2 * len(track.side) + 2, 2), np.int64)
    m = phases.build_phases(track.side, track.contact_time, track.stance_time, begin, end, time, support)
    if by_step:
        m = phases.merge_by_step(time, support, m)
    problem = problems.empty_problem(m, samples, b.nominal_length, b.comfort_weight)
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
def optimise_window(b, track, begin, end, start, old_time, old_control, effort):
    """Optimises [begin, end] from the committed state start (6,); returns (time, control, support, E, iterations).

    old_time (k + 1,) and old_control (k + 1, 6) are the previous window's curve (k = 0: none, a cold start).
    """
    problem, support = build_problem(b, track, begin, end, LIVE_SAMPLES, False)
    control = np.zeros((len(problem.time), 6))
    control[0] = start
    problem.fixed[0] = True
    first = _warm_start(problem, control, old_time, old_control) if len(old_time) > 1 else 1
    if first < len(problem.time):
        problems.straight_guess(problem, control, first)
    e, iterations = newton.minimise(problem, control, effort)
    return problem.time, control, support, e, iterations
