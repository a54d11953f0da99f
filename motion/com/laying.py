"""Laying timed footprints into the problem of their COM curve: who stands when, where it presses, where the leg begins.

Segments are the phases of support, or the paper's steps; see motion.com.problem for what a sample holds.
"""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.arithmetic.triples import Triple, minus
from motion.characters.dimensions import Dimensions
from motion.com import problem as problems
from motion.com.problem import Layout, Problem
from motion.track import foot, phases
from motion.track.footprints import LEFT, Footprints
from motion.track.heading import body_headings
from motion.track.leg import FULL_REACH, landing_reach, leaving_reach, nominal_at
from motion.track.pelvis import pelvis_between, pelvis_turns
from motion.track.pieces import BRIEF, flies, flown, in_pieces
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.tables import newest

STRENGTH = 3.2
"""Forces beyond so many body weights cost."""
LOOK_BACK = 6
"""Footprints before the newest among which a standing one is looked for."""


class Stance(NamedTuple):
    """What laying asks of the feet: computed once for all samples."""

    footprints: Footprints
    axis: np.ndarray  # (n, 3) of each footprint's sole, heel to toe
    pelvis: np.ndarray  # (m * (S + 1) + 1, 4) cosine, sine of its heading, of its list at all beginnings, samples, the end


class Moment(NamedTuple):
    """A time at which feet are laid."""

    t: float  # [s]
    heading: tuple[float, float]  # cosine and sine of the pelvis's heading
    roll: tuple[float, float]  # and of its list
    left: int  # footprint that carries the left leg, -1 for none
    right: int


@jit
def _stance(biped: Dimensions, footprints: Footprints, time: np.ndarray, samples: int) -> Stance:
    many = (len(time) - 1) * (samples + 1) + 1
    times, pelvis = np.empty(many), np.empty((many, 4))
    _lay_times(time, samples, times)
    body_headings(biped, footprints, times, pelvis[:, 0])
    stance = Stance(footprints, np.empty((len(footprints.side), 3)), pelvis)
    _lay_stance(biped, stance, pelvis_turns(biped, footprints), times)
    return stance


@jit_borrowing
def _lay_times(time: np.ndarray, samples: int, times: np.ndarray) -> None:
    """All beginnings, samples, and the end of segments between time (m + 1,)."""
    m, k = len(time) - 1, 0
    for i in range(m):
        times[k] = time[i]
        for j in range(samples):
            times[k + 1 + j] = time[i] + (j + 0.5) / samples * (time[i + 1] - time[i])
        k += samples + 1
    times[k] = time[m]


@jit_borrowing
def _lay_stance(biped: Dimensions, stance: Stance, turns: np.ndarray, times: np.ndarray) -> None:
    """The soles' axes, and the pelvis, where the body's heading lies, at the times."""
    footprints, axis, pelvis = stance.footprints, stance.axis, stance.pelvis
    for n in range(len(axis)):
        axis[n, 0], axis[n, 1], axis[n, 2] = foot.sole_axis(footprints.heading[n], footprints.normal[n])
    for i in range(len(times)):
        turn, roll = pelvis_between(biped, footprints, turns, times[i])
        yaw = pelvis[i, 0] + turn
        pelvis[i, 0], pelvis[i, 1] = np.cos(yaw), np.sin(yaw)
        pelvis[i, 2], pelvis[i, 3] = np.cos(roll), np.sin(roll)


@jit
def lay_samples(biped: Dimensions, footprints: Footprints, problem: Problem, support: np.ndarray, by_step: bool) -> None:
    """Fills the samples of a problem whose `time` is set.

    A segment of one phase has the phase's support (m, 2) all along; the paper's segments span a step and are sampled by time.
    """
    _lay_all(biped, _stance(biped, footprints, problem.time, problem.support_point.shape[0]), problem, support, by_step)


@jit_borrowing
def _lay_all(biped: Dimensions, stance: Stance, problem: Problem, support: np.ndarray, by_step: bool) -> None:
    footprints, samples = stance.footprints, problem.support_point.shape[0]
    for i in range(len(problem.time) - 1):
        begin, end, k = problem.time[i], problem.time[i + 1], i * (samples + 1)
        left, right = support[i, 0], support[i, 1]
        first = max(newest(footprints.contact_time, begin) + 1 - LOOK_BACK, 0) if by_step else 0
        for j in range(samples):
            t = begin + (j + 0.5) / samples * (end - begin)
            if by_step:
                left, right = phases.support_at(footprints, first, t)
            _lay_sample(biped, stance, problem, i, j, _moment(stance, k + 1 + j, t, left, right))
            if j == 0:
                _lay_end(biped, stance, problem, i, 0, _moment(stance, k, begin, left, right))
        _lay_end(biped, stance, problem, i, 1, _moment(stance, k + samples + 1, end, left, right))


@jit_inline
def _moment(stance: Stance, k: int, t: float, left: int, right: int) -> Moment:
    pelvis = stance.pelvis
    return Moment(t, (pelvis[k, 0], pelvis[k, 1]), (pelvis[k, 2], pelvis[k, 3]), left, right)


@jit_inline
def _lay_sample(biped: Dimensions, stance: Stance, problem: Problem, i: int, j: int, moment: Moment) -> None:
    """Sample j of segment i."""
    footprints = stance.footprints
    for leg in range(2):
        n = moment.left if leg == LEFT else moment.right
        problem.standing[j, leg, i] = n >= 0
        if n >= 0:
            u = foot.stance_share(footprints, n, moment.t)
            pressing = foot.pressing_at(biped, footprints, n, u)
            _put(problem.support_point, j, leg, i, _standing_point(biped, stance, n, u, pressing, 0.0))
            _put(problem.leg_origin, j, leg, i, _origin(biped, stance, n, leg, moment, u))
            problem.nominal_length[j, leg, i] = nominal_at(biped, footprints, n, u)


@jit_inline
def _lay_end(biped: Dimensions, stance: Stance, problem: Problem, i: int, end: int, moment: Moment) -> None:
    """The legs at an end of segment i are those of its nearest sample."""
    for leg in range(2):
        n = moment.left if leg == LEFT else moment.right
        problem.end_standing[end, leg, i] = n >= 0
        if n >= 0:
            u = foot.stance_share(stance.footprints, n, moment.t)
            _put(problem.end_origin, end, leg, i, _origin(biped, stance, n, leg, moment, u))


@jit_inline
def _put(array: np.ndarray, j: int, leg: int, i: int, point: Triple) -> None:
    array[j, leg, 0, i], array[j, leg, 1, i], array[j, leg, 2, i] = point


@jit_inline
def _standing_point(biped: Dimensions, stance: Stance, n: int, u: float, forward: float, up: float) -> Triple:
    """motion.track.foot.standing_point."""
    if foot.turned_by(biped, stance.footprints, n, u) != 0.0:
        return foot.standing_point(biped, stance.footprints, n, u, forward, up)
    return foot.on_sole(stance.footprints.position[n], stance.axis[n], stance.footprints.normal[n], forward, up)


@jit_inline
def _origin(biped: Dimensions, stance: Stance, n: int, leg: int, moment: Moment, u: float) -> Triple:
    """Ankle of the foot on footprint n at share u of its stance (motion.track.foot.stance_ankle), minus the hip's offset."""
    hip = foot.hip_toward(biped, leg, moment.heading, moment.roll)
    forward, up = foot.ankle_of(biped, stance.footprints, n, u)
    return minus(_standing_point(biped, stance, n, u, forward, up), hip)


@jit
def build_problem(
    biped: Dimensions, footprints: Footprints, begin: float, end: float, layout: Layout
) -> tuple[Problem, np.ndarray]:
    """Problem and support (m, 2) of the time [begin, end] [s]."""
    time = np.empty(2 * len(footprints.side) + 2)
    support = np.empty((2 * len(footprints.side) + 2, 2), np.int64)
    m = phases.build_phases(footprints, begin, end, time, support)
    if layout.by_step:
        m = phases.merge_by_step(time, support, m)
    if layout.smooth:
        cut = in_pieces(biped, footprints, time[: m + 1], support[:m], layout.steady)
        time, support, m = cut.time, cut.support, len(cut.support)
    leg, smooth = biped.leg, layout.smooth
    problem = problems.empty_problem(
        m, layout.samples, leg.nominal_length, FULL_REACH * leg.max_length, leg.comfort_weight, smooth,
        STRENGTH * GRAVITY if smooth else np.inf, layout.jerk_weight,
    )  # fmt: skip
    if smooth:
        _lay_shares(problem, cut.share)
        _limit_ends(biped, footprints, problem, support[:m])
    _lay_segments(footprints, problem, time, support, layout.steady)
    lay_samples(biped, footprints, problem, support, layout.by_step)
    return problem, support[:m]


@jit_borrowing
def _lay_shares(problem: Problem, share: np.ndarray) -> None:
    for i in range(len(share)):
        problem.comfort_share[i] = share[i]


@jit_borrowing
def _lay_segments(footprints: Footprints, problem: Problem, time: np.ndarray, support: np.ndarray, steady: bool) -> None:
    """Their times, and how much each counts."""
    m = len(problem.time) - 1
    problem.time[m] = time[m]
    for i in range(m):
        problem.time[i] = time[i]
        if steady and flies(support, i):
            problem.weight[i] = BRIEF + (1 - BRIEF) * max(2 * flown(time, support, i, True) - 1, 0.0)
        n = max(newest(footprints.contact_time, 0.5 * (time[i] + time[i + 1])), 0)
        problem.gravity[i] *= footprints.gravity[n]
        problem.comfort_share[i] *= footprints.comfort[n]


@jit_borrowing
def _limit_ends(biped: Dimensions, footprints: Footprints, problem: Problem, support: np.ndarray) -> None:
    """What a leg may reach where it lands, and where it leaves."""
    for i in range(1, len(support)):
        for leg in range(2):
            left, landed = support[i - 1, leg], support[i, leg]
            if left == landed:
                continue
            if landed > 0:
                problem.end_reach[0, leg, i] = landing_reach(biped, footprints, landed)
            if 0 <= left < len(footprints.side) - 1:
                problem.end_reach[1, leg, i - 1] = leaving_reach(biped, footprints, left + 1)
