"""Laying a timed track's feet into the problem of its COM curve: who stands when, where it presses, where the leg begins.

Segments are the phases of support, or the paper's steps; see motion.com.problem for what a sample holds.
"""

from typing import NamedTuple

import numpy as np

from motion.com import problem as problems
from motion.track import foot, heading, phases
from worlds.compiled.jit import jit, jit_inline

FULL_REACH = 0.995
"""Share of max_length from which on reach counts: the penalty gives a little, the leg shall not."""
LOOK_BACK = 6
"""Footprints before the newest among which a standing one is looked for."""


class Stance(NamedTuple):
    """What laying asks of the feet: computed once for all samples."""

    axis: np.ndarray  # (n, 3) of each footprint's sole, heel to toe
    ahead: np.ndarray  # (m * (S + 1) + 1, 2) the body's direction at each segment's beginning and samples, and the last end


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
    ahead = np.empty((len(times), 2))
    for i in range(len(times)):
        ahead[i, 0], ahead[i, 1] = np.cos(yaw[i]), np.sin(yaw[i])
    return Stance(axis, ahead)


@jit
def lay_samples(b, track, problem, support, by_step):
    """Fills the samples of a problem whose `time` is set.

    A segment of one phase has the phase's support (m, 2) all along; the paper's segments span a step and are sampled by time.
    """
    samples = problem.support_point.shape[0]
    stance = _stance(b, track, problem.time, samples)
    for i in range(len(problem.time) - 1):
        begin, end, k = problem.time[i], problem.time[i + 1], i * (samples + 1)
        left, right = support[i, 0], support[i, 1]
        first = max(np.searchsorted(track.contact_time, begin, side="right") - LOOK_BACK, 0) if by_step else 0
        for j in range(samples):
            t = begin + (j + 0.5) / samples * (end - begin)
            if by_step:
                left, right = phases.support_at(track.side, track.contact_time, track.stance_time, first, t)
            _lay_sample(b, track, stance, problem, i, j, left, right, t, k + 1 + j)
            if j == 0:
                _lay_end(b, track, stance, problem, i, 0, left, right, begin, k)
        _lay_end(b, track, stance, problem, i, 1, left, right, end, k + samples + 1)


@jit_inline
def _lay_sample(b, track, stance, problem, i, j, left, right, t, k):
    for leg in range(2):
        n = left if leg == 0 else right
        problem.standing[j, leg, i] = n >= 0
        if n >= 0:
            u = _share(track, n, t)
            roll = track.roll[n, 0] + u * (track.roll[n, 1] - track.roll[n, 0])
            _put(problem.support_point, j, leg, i, _on_sole(track, stance, n, (roll - 0.5) * b.foot_length, 0.0))
            _put(problem.leg_origin, j, leg, i, _origin(b, track, stance, n, leg, k, u))
            problem.nominal_length[j, leg, i] = track.nominal_length[n]


@jit_inline
def _lay_end(b, track, stance, problem, i, end, left, right, t, k):
    """The legs at an end of a segment are those of its nearest sample."""
    for leg in range(2):
        n = left if leg == 0 else right
        problem.end_standing[end, leg, i] = n >= 0
        if n >= 0:
            _put(problem.end_origin, end, leg, i, _origin(b, track, stance, n, leg, k, _share(track, n, t)))


@jit_inline
def _put(array, j, leg, i, point):
    array[j, leg, 0, i], array[j, leg, 1, i], array[j, leg, 2, i] = point


@jit_inline
def _share(track, n, t):
    return min(max((t - track.contact_time[n]) / track.stance_time[n], 0.0), 1.0)


@jit_inline
def _on_sole(track, stance, n, forward, up):
    """motion.track.foot.along_sole for footprint n."""
    return (
        track.position[n, 0] + forward * stance.axis[n, 0] + up * track.normal[n, 0],
        track.position[n, 1] + forward * stance.axis[n, 1] + up * track.normal[n, 1],
        track.position[n, 2] + forward * stance.axis[n, 2] + up * track.normal[n, 2],
    )


@jit_inline
def _origin(b, track, stance, n, leg, k, u):
    """Ankle of the foot on footprint n at share u of its stance (motion.track.foot.stance_ankle), minus the hip's offset."""
    hip = foot.hip_toward(b, leg, stance.ahead[k, 0], stance.ahead[k, 1])
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
