"""The optimisation problem: segments, their samples, and E (paper, section 2.4).

    E = sum over segments of T / S * sum over S samples of (e_physics + e_comfort),   samples at (j + 1/2) T / S

Everything of a sample that does not depend on the unknown control points (who stands, points of support, where the leg
begins) is laid down once; solvers move control points. Segments are the last axis of every array: WIDE are worked on at once.
"""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.com import cost, springs
from motion.com.cost import ComfortModel, PhysicsModel, Three, mix
from motion.track.curve import Weights, acceleration_weights, position_weights
from motion.track.footprints import LEFT, RIGHT
from worlds.compiled.across import bits_of, total
from worlds.compiled.beside.places import counted, counting, each_of, load_wide
from worlds.compiled.beside.wide import WIDE
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.lanes import Some

STRENGTH_WEIGHT = 0.12
"""Of what a force is beyond the strength of the legs, squared [s^2/m]."""


class Layout(NamedTuple):
    """How a curve is laid out."""

    samples: int  # of the costs in each segment
    by_step: bool  # a segment per step, as in the paper; else by phases of support
    smooth: bool  # several segments to a phase, and no jump of the acceleration between segments; else one
    steady: bool  # and so many, whatever the times, that the curve moves by no jump where timing is changed little by little
    jerk_weight: float  # of |jerk|^2 [s^3/m]: less lets forces flutter, more rounds them off
    rough: int = 0  # last steps whose single stances are one segment each: they will be solved again before they are walked


class Problem(NamedTuple):
    """m segments with S samples each; world frame, SI units. M = m + WIDE - 1: the rest is never read as a segment."""

    time: np.ndarray  # (m + 1,) of the control points [s]
    support_point: np.ndarray  # (S, 2, 3, M) point of support per foot [m]
    leg_origin: np.ndarray  # (S, 2, 3, M) ankle minus the hip's offset from the com [m]: leg length = |com - this|
    standing: np.ndarray  # (S, 2, M) bool
    end_origin: np.ndarray  # (2, 2, 3, M) the same as leg_origin, at the beginning and the end of the segment
    end_standing: np.ndarray  # (2, 2, M) bool
    end_reach: np.ndarray  # (2, 2, M) share of max_length that each leg may have there
    fixed: np.ndarray  # (m + 1,) bool: control points that may not move
    nominal_length: np.ndarray  # (S, 2, M) of the standing legs [m]
    max_length: np.ndarray  # (2,) of the left and right leg [m]; infinite: reach does not count
    anchor: np.ndarray  # (6,) where the last control point is held by springs
    anchor_stiffness: np.ndarray  # (2,) of its position [1/s/m] and velocity [s/m]; 0: free
    comfort_weight: float  # [1/s^2/m]
    comfort_share: np.ndarray  # (M,) of it that counts in each segment
    strength: float  # of the legs: a force beyond it costs [m/s^2]
    strength_weight: float  # [s^2/m]
    jerk_weight: float  # of |jerk|^2 [s^3/m]
    smooth: bool  # the acceleration may not jump between segments
    bend: np.ndarray  # (2, 3) acceleration where a smooth curve begins and ends, if those are fixed [m/s^2]
    weight: np.ndarray  # (M,) with which each segment's samples count
    gravity: np.ndarray  # (M,) that each segment reckons with, downward [m/s^2]
    pull: np.ndarray  # (P, springs.PULL) soft springs on the com


@jit
def empty_problem(
    segments: int,
    samples: int,
    nominal_length: float,
    max_length: float,
    comfort_weight: float,
    smooth: bool = False,
    strength: float = np.inf,
    jerk_weight: float = 0.0,
) -> Problem:
    """A problem of that size with nobody standing and nothing fixed, all legs of one nominal length."""
    wide = segments + WIDE - 1
    return Problem(
        np.zeros(segments + 1),
        np.zeros((samples, 2, 3, wide)),
        np.zeros((samples, 2, 3, wide)),
        np.zeros((samples, 2, wide), np.bool_),
        np.zeros((2, 2, 3, wide)),
        np.zeros((2, 2, wide), np.bool_),
        np.ones((2, 2, wide)),
        np.zeros(segments + 1, np.bool_),
        np.full((samples, 2, wide), nominal_length),
        np.full(2, max_length),
        np.zeros(6),
        np.zeros(2),
        comfort_weight,
        np.ones(wide),
        strength,
        STRENGTH_WEIGHT,
        jerk_weight,
        smooth,
        np.zeros((2, 3)),
        np.ones(wide),
        np.full(wide, GRAVITY),
        np.zeros((0, springs.PULL)),
    )


@jit
def with_effort(problem: Problem, strength: float, jerk_weight: float, pull: np.ndarray) -> Problem:
    """The same problem in which forces beyond `strength` [m/s^2], and jerk, cost, with springs (P, PULL) that pull the com."""
    p = problem
    return Problem(
        p.time, p.support_point, p.leg_origin, p.standing, p.end_origin, p.end_standing, p.end_reach, p.fixed,
        p.nominal_length, p.max_length, p.anchor, p.anchor_stiffness, p.comfort_weight, p.comfort_share, strength,
        p.strength_weight, jerk_weight, p.smooth, p.bend, p.weight, p.gravity, pull,
    )  # fmt: skip


class Segments(NamedTuple):
    """WIDE segments from one on; beyond the last lie copies of it that count for nothing."""

    duration: Some  # lanes [s]
    scale: Some  # lanes: time per sample [s]
    bend: Some  # lanes: 1 / T^2
    x: tuple  # of four lanes: the knots p0, T v0, p1, T v1 along each axis
    y: tuple
    z: tuple


@jit_inline
def _knots(control: np.ndarray, at: Some, duration: Some, axis: int) -> tuple[Some, Some, Some, Some]:
    place, speed = (axis,), (3 + axis,)
    return (
        each_of(control, at, place), duration * each_of(control, at, speed),
        each_of(control, at + 1, place), duration * each_of(control, at + 1, speed),
    )  # fmt: skip


@jit_inline
def segments_from(problem: Problem, control: np.ndarray, i: int) -> Segments:
    """The Segments from i on."""
    time, end = problem.time, len(problem.time) - 1
    at = counted(i, end)
    duration = each_of(time, at + 1, ()) - each_of(time, at, ())
    return Segments(
        duration,
        counting(i, end) * load_wide(problem.weight, (i,)) * duration / problem.support_point.shape[0],
        1 / (duration * duration),
        _knots(control, at, duration, 0),
        _knots(control, at, duration, 1),
        _knots(control, at, duration, 2),
    )


@jit_inline
def state_of_sample(segments: Segments, gravity: Some, h: Weights, bends: Weights) -> tuple[Three, Three]:
    """com and needed force w = a - g, by the knots' weights h in the com and `bends` in the acceleration, for T = 1."""
    x, y, z = segments.x, segments.y, segments.z
    com = (mix(h, x), mix(h, y), mix(h, z))
    bend = segments.bend
    return com, (bend * mix(bends, x), bend * mix(bends, y), bend * mix(bends, z) + gravity)


@jit_inline
def triple(array: np.ndarray, j: int, leg: int, i: int) -> Three:
    """array[j, leg, :, i] and the next ones as three lanes."""
    return load_wide(array, (j, leg, 0, i)), load_wide(array, (j, leg, 1, i)), load_wide(array, (j, leg, 2, i))


@jit_inline
def physics_of_sample(problem: Problem, i: int, j: int, com: Three, w: Three, eps: float) -> PhysicsModel:
    """motion.com.cost.physics_model of sample j of the segments from i on."""
    s0, s1 = triple(problem.support_point, j, 0, i), triple(problem.support_point, j, 1, i)
    on0, on1 = load_wide(problem.standing, (j, 0, i)), load_wide(problem.standing, (j, 1, i))
    return cost.physics_model(com, w, s0, s1, on0, on1, eps)


@jit_inline
def comfort_of_leg(problem: Problem, i: int, j: int, leg: int, com: Three) -> ComfortModel:
    """motion.com.cost.comfort_model of one leg in sample j of the segments from i on."""
    q, on = triple(problem.leg_origin, j, leg, i), load_wide(problem.standing, (j, leg, i))
    nominal = load_wide(problem.nominal_length, (j, leg, i))
    weight = problem.comfort_weight * load_wide(problem.comfort_share, (i,))
    return cost.comfort_model(com, q, on, nominal, problem.max_length[leg], weight)


@jit_inline
def overreaches(problem: Problem, segments: Segments, i: int) -> bool:
    """Whether a leg is longer than max_length at an end of the segments from i on: only then it costs."""
    x, y, z = segments.x, segments.y, segments.z
    return reaches_beyond(problem, i, 0, (x[0], y[0], z[0])) | reaches_beyond(problem, i, 1, (x[2], y[2], z[2]))


@jit_inline
def reaches_beyond(problem: Problem, i: int, end: int, com: Three) -> bool:
    """Whether a leg is longer than max_length at one end of any of the segments from i on, where their coms are given."""
    found = 0
    for leg in range(2):
        q, on = triple(problem.end_origin, end, leg, i), load_wide(problem.end_standing, (end, leg, i))
        x, y, z = com[0] - q[0], com[1] - q[1], com[2] - q[2]
        limit = problem.max_length[leg] * load_wide(problem.end_reach, (end, leg, i))
        found |= bits_of(on & (x * x + y * y + z * z > limit * limit))
    return found != 0


@jit_borrowing
def reach_cost(problem: Problem, control: np.ndarray, i: int) -> float:
    """The reach penalties at the ends of the segments from i on that can move."""
    e = 0.0
    for k in range(i, min(i + WIDE, len(problem.time) - 1)):
        for end in range(2):
            if not problem.fixed[k + end]:
                share = problem.end_reach[end, :, k]
                e += cost.reach_cost(
                    control[k + end], problem.end_origin[end, :, :, k], problem.end_standing[end, :, k],
                    (share[0] * problem.max_length[0], share[1] * problem.max_length[1]), problem.comfort_weight,
                )  # fmt: skip
    return e


@jit_inline
def _jerk_cost(problem: Problem, segments: Segments) -> Some:
    """jerk_weight |jerk|^2 of a segment as a cost of each sample."""
    x, y, z = (
        12 * (segments.x[0] - segments.x[2]) + 6 * (segments.x[1] + segments.x[3]),
        12 * (segments.y[0] - segments.y[2]) + 6 * (segments.y[1] + segments.y[3]),
        12 * (segments.z[0] - segments.z[2]) + 6 * (segments.z[1] + segments.z[3]),
    )
    third = segments.bend * segments.bend * segments.bend  # 1 / T^6
    return (problem.support_point.shape[0] * problem.jerk_weight) * third * (x * x + y * y + z * z)


@jit_borrowing
def costs_from(problem: Problem, control: np.ndarray, i: int, eps: float) -> tuple[float, float]:
    """The share in E of the WIDE segments from i on: (as the solver smooths it, the true norm)."""
    samples = problem.support_point.shape[0]
    segments, gravity = segments_from(problem, control, i), load_wide(problem.gravity, (i,))
    smooth, true = 0.0 * segments.scale, _jerk_cost(problem, segments)
    smooth += true
    for j in range(samples):
        s = (j + 0.5) / samples
        com, w = state_of_sample(segments, gravity, position_weights(s, 1.0), acceleration_weights(s, 1.0))
        r = physics_of_sample(problem, i, j, com, w, eps).size
        comfort = comfort_of_leg(problem, i, j, LEFT, com).cost + comfort_of_leg(problem, i, j, RIGHT, com).cost
        comfort += cost.strength_model(w, problem.strength, problem.strength_weight).size
        smooth += cost.smooth_norm(r, eps) + comfort
        true += r + comfort
    reach = reach_cost(problem, control, i) if overreaches(problem, segments, i) else 0.0
    return total(smooth * segments.scale) + reach, total(true * segments.scale) + reach


@jit_borrowing
def total_costs(problem: Problem, control: np.ndarray, eps: float) -> tuple[float, float]:
    """E of control (m + 1, 6): (smoothed, true)."""
    smooth = true = springs.anchor_cost(problem.anchor, problem.anchor_stiffness, control)
    if len(problem.pull):
        pulled = springs.pull_cost(problem.pull, problem.time, control)
        smooth, true = smooth + pulled, true + pulled
    for i in range(0, len(problem.time) - 1, WIDE):
        smooth_part, true_part = costs_from(problem, control, i, eps)
        smooth, true = smooth + smooth_part, true + true_part
    return smooth, true


@jit_borrowing
def total_cost(problem: Problem, control: np.ndarray) -> float:
    """E of control (m + 1, 6)."""
    return total_costs(problem, control, 1.0)[1]
