"""Laying timed footprints into the problem of their COM curve: who stands when, where it presses, where the leg begins.

Segments are the phases of support, or the paper's steps; see motion.com.problem for what a sample holds.
"""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY, pendulum_time
from motion.arithmetic.smooth import smoothstep
from motion.arithmetic.triples import Triple, minus
from motion.characters.dimensions import Dimensions
from motion.com import problem as problems
from motion.com.problem import Layout, Problem
from motion.track import foot, heading, phases
from motion.track.footprints import LEFT, Footprints, rise
from motion.track.pelvis import pelvis_between, pelvis_turns
from worlds.compiled.jit import jit, jit_borrowing, jit_inline

SINGLE = 3
"""Pieces of a single stance: its force can rise, hold or dip, and fall."""
SPRINGY = 0.25
"""Share of comfort that counts in a stance beside a flight: there the leg is a spring, and gives as physics asks."""
MIDDLE = 4.5
"""The same in the middle of a walker's single stance on land, where people's legs are straightest."""
ROCKY, STEEP, GIVES = 0.6, 0.12, 0.25
"""The same on rocks, where legs give so that the body keeps its pace. Where legs lift or lower the body in a step by STEEP of
their length or more, GIVES is the most everywhere."""
SWITCH = 0.005
"""Time [s] in which the force changes from one leg to another that takes over at once."""
FULL_FLIGHT, BRIEF = 0.12, 0.3
"""From this time [s] on a flight changes all that it does beside it; one half as long counts this share: as costs are norms, a
flight is ballistic or not, and with less weight it comes to be so more slowly as it grows."""
PIECE = 0.45
"""Length of a piece of a long double stance, in pendulum times."""
JERK_WEIGHT = 1e-7
"""Of |jerk|^2 [s^3/m]: less lets forces flutter, more rounds them off."""
STRENGTH = 3.3
"""Forces beyond so many body weights cost."""
LOOK_BACK = 6
"""Footprints before the newest among which a standing one is looked for."""


class Stance(NamedTuple):
    """What laying asks of the feet: computed once for all samples."""

    footprints: Footprints
    axis: np.ndarray  # (n, 3) of each footprint's sole, heel to toe
    pelvis: np.ndarray  # (m * (S + 1) + 1, 3) cosine and sine of its heading, and its list, at all beginnings, samples, the end


class Moment(NamedTuple):
    """A time at which feet are laid."""

    t: float  # [s]
    cosine: float  # of the pelvis's heading
    sine: float
    roll: float  # of the pelvis [rad]
    left: int  # footprint that carries the left leg, -1 for none
    right: int


@jit
def _stance(biped: Dimensions, footprints: Footprints, time: np.ndarray, samples: int) -> Stance:
    axis = np.empty((len(footprints.side), 3))
    for n in range(len(axis)):
        axis[n, 0], axis[n, 1], axis[n, 2] = foot.sole_axis(footprints.heading[n], footprints.normal[n])
    m, k = len(time) - 1, 0
    times = np.empty(m * (samples + 1) + 1)
    for i in range(m):
        times[k] = time[i]
        for j in range(samples):
            times[k + 1 + j] = time[i] + (j + 0.5) / samples * (time[i + 1] - time[i])
        k += samples + 1
    times[k] = time[m]
    yaw = np.empty(len(times))
    heading.body_headings(biped, footprints, times, yaw)
    pelvis, turns = np.empty((len(times), 3)), pelvis_turns(biped, footprints)
    for i in range(len(times)):
        turn, pelvis[i, 2] = pelvis_between(biped, footprints, turns, times[i])
        pelvis[i, 0], pelvis[i, 1] = np.cos(yaw[i] + turn), np.sin(yaw[i] + turn)
    return Stance(footprints, axis, pelvis)


@jit
def lay_samples(biped: Dimensions, footprints: Footprints, problem: Problem, support: np.ndarray, by_step: bool) -> None:
    """Fills the samples of a problem whose `time` is set.

    A segment of one phase has the phase's support (m, 2) all along; the paper's segments span a step and are sampled by time.
    """
    samples = problem.support_point.shape[0]
    stance = _stance(biped, footprints, problem.time, samples)
    for i in range(len(problem.time) - 1):
        begin, end, k = problem.time[i], problem.time[i + 1], i * (samples + 1)
        left, right = support[i, 0], support[i, 1]
        first = max(np.searchsorted(footprints.contact_time, begin, side="right") - LOOK_BACK, 0) if by_step else 0
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
    return Moment(t, stance.pelvis[k, 0], stance.pelvis[k, 1], stance.pelvis[k, 2], left, right)


@jit_inline
def _lay_sample(biped: Dimensions, stance: Stance, problem: Problem, i: int, j: int, moment: Moment) -> None:
    """Sample j of segment i."""
    footprints = stance.footprints
    for leg in range(2):
        n = moment.left if leg == LEFT else moment.right
        problem.standing[j, leg, i] = n >= 0
        if n >= 0:
            u = foot.stance_share(footprints, n, moment.t)
            _put(problem.support_point, j, leg, i, _on_sole(stance, n, foot.pressing_at(biped, footprints, n, u), 0.0))
            _put(problem.leg_origin, j, leg, i, _origin(biped, stance, n, leg, moment, u))
            problem.nominal_length[j, leg, i] = foot.nominal_at(biped, footprints, n, u)


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
def _on_sole(stance: Stance, n: int, forward: float, up: float) -> Triple:
    """motion.track.foot.along_sole for footprint n."""
    return foot.on_sole(stance.footprints.position[n], stance.axis[n], stance.footprints.normal[n], forward, up)


@jit_inline
def _origin(biped: Dimensions, stance: Stance, n: int, leg: int, moment: Moment, u: float) -> Triple:
    """Ankle of the foot on footprint n at share u of its stance (motion.track.foot.stance_ankle), minus the hip's offset."""
    hip = foot.hip_toward(biped, leg, moment.cosine, moment.sine, moment.roll)
    forward, up = foot.ankle_of(biped, stance.footprints, n, u)
    return minus(_on_sole(stance, n, forward, up), hip)


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
        time, support, share = _in_pieces(biped, footprints, time[: m + 1], support[:m], layout.steady)
        m = len(support)
    leg = biped.leg
    problem = problems.empty_problem(
        m, layout.samples, leg.nominal_length, foot.FULL_REACH * leg.max_length, leg.comfort_weight, layout.smooth
    )
    if layout.smooth:
        problem = problems.with_effort(problem, STRENGTH * GRAVITY, JERK_WEIGHT, problem.pull)
        problem.comfort_share[:m] = share
        _limit_ends(biped, footprints, problem, support[:m])
    problem.time[:] = time[: m + 1]
    for i in range(m):
        if layout.steady and _flies(support, i):
            problem.weight[i] = BRIEF + (1 - BRIEF) * max(2 * _flown(time, support, i, True) - 1, 0.0)
        n = max(np.searchsorted(footprints.contact_time, 0.5 * (time[i] + time[i + 1]), side="right") - 1, 0)
        problem.gravity[i] *= footprints.gravity[n]
        problem.comfort_share[i] *= footprints.comfort[n]
    lay_samples(biped, footprints, problem, support, layout.by_step)
    return problem, support[:m]


@jit_borrowing
def _limit_ends(biped: Dimensions, footprints: Footprints, problem: Problem, support: np.ndarray) -> None:
    """What legs may reach in the pieces that begin with a landing, and that end with a leaving."""
    for i in range(1, len(support)):
        for leg in range(2):
            left, landed = support[i - 1, leg], support[i, leg]
            if left == landed:
                continue
            if landed > 0:
                problem.end_reach[0, i] = min(problem.end_reach[0, i], foot.landing_reach(biped, footprints, landed))
            if 0 <= left < len(footprints.side) - 1:
                problem.end_reach[1, i - 1] = min(problem.end_reach[1, i - 1], foot.leaving_reach(biped, footprints, left + 1))


@jit_borrowing
def _flies(support: np.ndarray, i: int) -> bool:
    """Whether phase i is a flight."""
    return 0 <= i < len(support) and phases.phase_of(support[i, 0], support[i, 1]) == phases.FLIGHT


@jit_borrowing
def _steep(biped: Dimensions, footprints: Footprints, support: np.ndarray, i: int) -> float:
    """How steep the way is in phase i, 0 to 1."""
    n = max(support[i, 0], support[i, 1])
    if n < 0:
        return 0.0
    climb = abs(rise(footprints, n)) if n > 0 else 0.0
    if n + 1 < len(footprints.side):
        climb = max(climb, abs(rise(footprints, n + 1)))
    return smoothstep(climb / (STEEP * biped.leg.nominal_length))


@jit_borrowing
def _on_rock(footprints: Footprints, support: np.ndarray, i: int) -> bool:
    """Whether a foot stands on a rock in phase i."""
    left, right = support[i, 0], support[i, 1]
    return (left >= 0 and footprints.rock[left] >= 0) or (right >= 0 and footprints.rock[right] >= 0)


@jit_borrowing
def _switches(support: np.ndarray, i: int) -> bool:
    """Whether after phase i one foot takes over from another, with neither an overlap nor a flight between."""
    n = min(i + 1, len(support) - 1)
    before, after = phases.phase_of(support[i, 0], support[i, 1]), phases.phase_of(support[n, 0], support[n, 1])
    return before != after and max(before, after) < phases.DOUBLE_STANCE


@jit_borrowing
def _flown(time: np.ndarray, support: np.ndarray, i: int, steady: bool) -> float:
    """How much of a flight phase i is, 0 to 1; steady: a brief one is less of it, so that none begins with a jump."""
    whole = 1.0 if _flies(support, i) else 0.0
    return min((time[i + 1] - time[i]) / FULL_FLIGHT, 1.0) if steady and whole else whole


@jit
def _in_pieces(
    biped: Dimensions, footprints: Footprints, time: np.ndarray, support: np.ndarray, steady: bool
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Phases in equal pieces: a single stance in SINGLE, as its force rises and falls; others by their time, a flight in one.

    Returns the times, supports and shares of comfort of the pieces. Beside a flight there are more, and comfort counts less.
    Steady: their number does not depend on times; where one foot takes over at once, the force may change within SWITCH.
    """
    counts, unit = np.ones(len(support), np.int64), PIECE * pendulum_time(biped.leg.nominal_length)
    switch = np.zeros(len(support), np.bool_)
    for i in range(len(support)):
        pieces = int(round((time[i + 1] - time[i]) / unit))
        if steady and not _flies(support, i):
            counts[i] = SINGLE if min(support[i, 0], support[i, 1]) >= 0 else 2 * SINGLE
        elif _flies(support, i - 1) or _flies(support, i + 1):
            counts[i] = min(max(2 * pieces, SINGLE), 2 * SINGLE)
        elif phases.phase_of(support[i, 0], support[i, 1]) == phases.DOUBLE_STANCE:
            counts[i] = min(max(pieces, 1), SINGLE)
        elif not _flies(support, i):
            counts[i] = SINGLE
        switch[i] = steady and time[i + 1] - time[i] > 4 * SWITCH and _switches(support, i)
    total = counts.sum() + switch.sum()
    out, stand, share = np.empty(total + 1), np.empty((total, 2), np.int64), np.ones(total)
    n = 0
    for i in range(len(support)):
        single = counts[i] >= SINGLE and min(support[i, 0], support[i, 1]) < 0
        for k in range(counts[i] + switch[i]):
            out[n] = time[i] + k * (time[i + 1] - time[i]) / counts[i] if k < counts[i] else time[i + 1] - SWITCH
            stand[n, 0], stand[n, 1] = support[i, 0], support[i, 1]
            flown = max(_flown(time, support, i - 1, steady), _flown(time, support, i + 1, steady))
            if flown < 1 and _on_rock(footprints, support, i):
                share[n] = ROCKY
            elif flown < 1 and single and counts[i] <= SINGLE * k < 2 * counts[i]:
                share[n] = MIDDLE
            steep = _steep(biped, footprints, support, i)
            share[n] += steep * (min(share[n], GIVES) - share[n])
            if flown > 0:
                share[n] = SPRINGY + (share[n] - SPRINGY) * (1 - flown) if flown < 1 else SPRINGY
            n += 1
    out[n] = time[-1]
    return out, stand, share
