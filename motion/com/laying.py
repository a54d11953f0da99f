"""Laying timed footprints into the problem of their COM curve: who stands when, where it presses, where the leg begins.

Segments are the phases of support, or the paper's steps; see motion.com.problem for what a sample holds.
"""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.functions import turn
from motion.arithmetic.gravity import GRAVITY
from motion.arithmetic.triples import Triple, minus
from motion.characters.dimensions import Dimensions
from motion.com import problem as problems
from motion.com.problem import Layout, Problem
from motion.track import foot, phases
from motion.track.footprints import Footprints
from motion.track.heading import body_headings
from motion.track.leg import FULL_REACH, landing_reach, leaving_reach, nominal_at
from motion.track.pelvis import pelvis_after, pelvis_turns
from motion.track.pieces import BRIEF, fineness, flies, flown, in_pieces
from worlds.compiled.beside.places import load_wide, store_some
from worlds.compiled.beside.wide import WIDE
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.lanes import Some
from worlds.compiled.tables import newest

STRENGTH = 3.2
"""Forces beyond so many body weights cost."""
LOOK_BACK = 6
"""Footprints before the newest among which a standing one is looked for."""


class Pelvis(NamedTuple):
    """The pelvis at the moments of m pieces: where they begin, at their S samples, where they end."""

    time: np.ndarray  # (S + 2, M) [s]
    yaw: np.ndarray  # (S + 2, M) the body's heading [rad]
    heading: np.ndarray  # (2, S + 2, M) cosine and sine of the pelvis's own
    roll: np.ndarray  # (2, S + 2, M) and of its list


class Run(NamedTuple):
    """Pieces all along which a leg stands on one footprint."""

    leg: int
    n: int  # the footprint
    axis: Triple  # of its sole, heel to toe
    first: int  # of the pieces
    many: int  # WIDE at most


@jit
def lay_samples(biped: Dimensions, footprints: Footprints, problem: Problem, support: np.ndarray, by_step: bool) -> None:
    """Fills the samples of a problem whose `time` is set.

    A segment of one phase has the phase's support (m, 2) all along; the paper's segments span a step and are sampled by time.
    """
    moments, m, wide = problem.support_point.shape[0] + 2, len(problem.time) - 1, len(problem.weight)
    pelvis = Pelvis(
        np.zeros((moments, wide)), np.zeros((moments, wide)), np.empty((2, moments, wide)), np.empty((2, moments, wide))
    )
    _lay_times(problem.time, pelvis.time)
    body_headings(biped, footprints, pelvis.time[:, :m], pelvis.yaw)
    _lay_pelvis(biped, footprints, pelvis_turns(biped, footprints, problem.time[0]), pelvis, m)
    if by_step:
        _lay_by_time(biped, footprints, problem, pelvis)
    else:
        _lay_by_phase(biped, footprints, problem, pelvis, support)


@jit_borrowing
def _lay_times(time: np.ndarray, times: np.ndarray) -> None:
    """The beginnings, samples and ends of segments between time (m + 1,)."""
    samples = len(times) - 2
    for i in range(len(time) - 1):
        times[0, i], times[samples + 1, i] = time[i], time[i + 1]
        for j in range(samples):
            times[1 + j, i] = time[i] + (j + 0.5) / samples * (time[i + 1] - time[i])


@jit_borrowing
def _lay_pelvis(biped: Dimensions, footprints: Footprints, turns: np.ndarray, pelvis: Pelvis, m: int) -> None:
    """Heading and list of the pelvis, WIDE pieces of one step at once. No piece spans a contact, or its pelvis is nearly so."""
    i, n, contact, middle = 0, -1, footprints.contact_time, len(pelvis.time) // 2
    while i < m:
        while n + 1 < len(contact) and contact[n + 1] <= pelvis.time[middle, i]:
            n += 1
        until = contact[n + 1] if n + 1 < len(contact) else np.inf
        count = 1
        while count < WIDE and i + count < m and pelvis.time[middle, i + count] < until:
            count += 1
        _lay_pelvis_of(biped, footprints, n, turns, pelvis, (i, count))
        i += count


@jit_borrowing
def _lay_pelvis_of(
    biped: Dimensions, footprints: Footprints, n: int, turns: np.ndarray, pelvis: Pelvis, run: tuple[int, int]
) -> None:
    """Of a run of pieces, from the first on so many, that follow the contact of footprint n."""
    i, count = run
    at, then = max(n, 0), min(max(n, 0) + 1, len(footprints.side) - 1)
    for k in range(len(pelvis.time)):
        by, roll = pelvis_after(
            biped, footprints, at, load_wide(pelvis.time, (k, i)), (turns[at, 0], turns[at, 1], turns[then, 0])
        )
        known = 1.0 if n >= 0 else 0.0
        (c, s), (d, z) = turn(load_wide(pelvis.yaw, (k, i)) + known * by), turn(known * roll)
        store_some(pelvis.heading, (0, k, i), c, count)
        store_some(pelvis.heading, (1, k, i), s, count)
        store_some(pelvis.roll, (0, k, i), d, count)
        store_some(pelvis.roll, (1, k, i), z, count)


@jit_borrowing
def _lay_by_phase(biped: Dimensions, footprints: Footprints, problem: Problem, pelvis: Pelvis, support: np.ndarray) -> None:
    """Legs that stand on one footprint all along a piece."""
    samples, m = problem.support_point.shape[0], len(problem.time) - 1
    for leg in range(2):
        i = 0
        while i < m:
            n, count = support[i, leg], 1
            while count < WIDE and i + count < m and support[i + count, leg] == n:
                count += 1
            if n >= 0:
                run = _run(footprints, leg, n, i, count)
                for j in range(samples):
                    _lay_sample(biped, footprints, problem, pelvis, run, j)
                _lay_end(biped, footprints, problem, pelvis, run, 0)
                _lay_end(biped, footprints, problem, pelvis, run, 1)
            i += count


@jit_borrowing
def _run(footprints: Footprints, leg: int, n: int, i: int, count: int) -> Run:
    return Run(leg, n, foot.sole_axis(footprints.heading[n], footprints.normal[n]), i, count)


@jit_borrowing
def _lay_by_time(biped: Dimensions, footprints: Footprints, problem: Problem, pelvis: Pelvis) -> None:
    """Legs as they stand at each sample; at the ends of a piece as at its nearest sample."""
    samples = problem.support_point.shape[0]
    for i in range(len(problem.time) - 1):
        first = max(newest(footprints.contact_time, problem.time[i]) + 1 - LOOK_BACK, 0)
        for j in range(samples):
            support = phases.support_at(footprints, first, pelvis.time[1 + j, i])
            for leg in range(2):
                n = support[leg]
                if n >= 0:
                    run = _run(footprints, leg, n, i, 1)
                    _lay_sample(biped, footprints, problem, pelvis, run, j)
                    if j == 0:
                        _lay_end(biped, footprints, problem, pelvis, run, 0)
                    if j == samples - 1:
                        _lay_end(biped, footprints, problem, pelvis, run, 1)


@jit_borrowing
def _lay_sample(biped: Dimensions, footprints: Footprints, problem: Problem, pelvis: Pelvis, run: Run, j: int) -> None:
    """Sample j of a run."""
    leg, i = run.leg, run.first
    for k in range(run.many):
        problem.standing[j, leg, i + k] = True
    u = foot.stance_share(footprints, run.n, load_wide(pelvis.time, (1 + j, i)))
    pressing = foot.pressing_at(biped, footprints, run.n, u)
    _put(problem.support_point, j, run, _standing_point(biped, footprints, run, u, pressing, 0.0))
    _put(problem.leg_origin, j, run, _origin(biped, footprints, pelvis, run, 1 + j, u))
    store_some(problem.nominal_length, (j, leg, i), nominal_at(biped, footprints, run.n, u), run.many)


@jit_borrowing
def _lay_end(biped: Dimensions, footprints: Footprints, problem: Problem, pelvis: Pelvis, run: Run, end: int) -> None:
    """An end of the pieces of a run."""
    for k in range(run.many):
        problem.end_standing[end, run.leg, run.first + k] = True
    moment = end * (len(pelvis.time) - 1)
    u = foot.stance_share(footprints, run.n, load_wide(pelvis.time, (moment, run.first)))
    _put(problem.end_origin, end, run, _origin(biped, footprints, pelvis, run, moment, u))


@jit_inline
def _put(array: np.ndarray, j: int, run: Run, point: Triple) -> None:
    store_some(array, (j, run.leg, 0, run.first), point[0], run.many)
    store_some(array, (j, run.leg, 1, run.first), point[1], run.many)
    store_some(array, (j, run.leg, 2, run.first), point[2], run.many)


@jit_inline
def _standing_point(biped: Dimensions, footprints: Footprints, run: Run, u: Some, forward: Some, up: Some) -> Triple:
    """motion.track.foot.standing_point."""
    if foot.pivot(biped.reach.max_turn, footprints, run.n) != 0.0:
        return foot.standing_point(biped, footprints, run.n, u, forward, up)
    return foot.on_sole(footprints.position[run.n], run.axis, footprints.normal[run.n], forward, up)


@jit_inline
def _origin(biped: Dimensions, footprints: Footprints, pelvis: Pelvis, run: Run, moment: int, u: Some) -> Triple:
    """Ankle of the foot at share u of its stance (motion.track.foot.stance_ankle), minus the hip's offset."""
    at, heading, roll = (moment, run.first), pelvis.heading, pelvis.roll
    hip = foot.hip_toward(
        biped, run.leg, (load_wide(heading[0], at), load_wide(heading[1], at)), (load_wide(roll[0], at), load_wide(roll[1], at))
    )
    forward, up = foot.ankle_of(biped, footprints, run.n, u)
    return minus(_standing_point(biped, footprints, run, u, forward, up), hip)


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
        cut = in_pieces(biped, footprints, time[: m + 1], support[:m], fineness(footprints, layout.steady, layout.rough))
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
