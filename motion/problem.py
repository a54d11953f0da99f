"""The optimisation problem: segments, their samples, and E (paper, section 2.4).

    E = sum over segments of T / S * sum over S samples of (e_physics + e_comfort),   samples at (j + 1/2) T / S

Everything of a sample that does not depend on the unknown control points (who stands, points of support, where the leg
begins) is laid down once; solvers then only move control points.
"""

from typing import NamedTuple

import numpy as np

from motion import cost, spline
from motion.jit import jit, jit_borrowing, jit_inline


class Problem(NamedTuple):
    """m segments with S samples each; world frame, SI units."""

    time: np.ndarray  # (m + 1,) of the control points [s]
    support_point: np.ndarray  # (m, S, 2, 3) point of support per foot [m]
    leg_origin: np.ndarray  # (m, S, 2, 3) ankle minus the hip's offset from the com [m]: leg length = |com - this|
    standing: np.ndarray  # (m, S, 2) bool
    end_origin: np.ndarray  # (m, 2, 2, 3) the same as leg_origin, at the beginning and the end of the segment
    end_standing: np.ndarray  # (m, 2, 2) bool
    fixed: np.ndarray  # (m + 1,) bool: control points that may not move
    nominal_length: np.ndarray  # (m, S, 2) of the standing legs [m]
    max_length: np.ndarray  # (2,) of the left and right leg [m]; infinite: reach does not count
    anchor: np.ndarray  # (6,) where the last control point is held by springs
    anchor_stiffness: np.ndarray  # (2,) of its position [1/s/m] and velocity [s/m]; 0: free
    comfort_weight: float  # [1/s^2/m]


@jit
def empty_problem(segments, samples, nominal_length, max_length, comfort_weight):
    """A problem of that size with nobody standing and nothing fixed, all legs of one nominal length."""
    return Problem(
        np.zeros(segments + 1),
        np.zeros((segments, samples, 2, 3)),
        np.zeros((segments, samples, 2, 3)),
        np.zeros((segments, samples, 2), np.bool_),
        np.zeros((segments, 2, 2, 3)),
        np.zeros((segments, 2, 2), np.bool_),
        np.zeros(segments + 1, np.bool_),
        np.full((segments, samples, 2), nominal_length),
        np.full(2, max_length),
        np.zeros(6),
        np.zeros(2),
        comfort_weight,
    )


@jit_inline
def sample_state(control, i, s, duration):
    """com and needed force w = a - g of segment i at fraction s, as two triples."""
    p = spline.position_weights(s, duration)
    b = spline.acceleration_weights(s, duration)
    u, v = control[i], control[i + 1]
    c = (
        p[0] * u[0] + p[1] * u[3] + p[2] * v[0] + p[3] * v[3],
        p[0] * u[1] + p[1] * u[4] + p[2] * v[1] + p[3] * v[4],
        p[0] * u[2] + p[1] * u[5] + p[2] * v[2] + p[3] * v[5],
    )
    w = (
        b[0] * u[0] + b[1] * u[3] + b[2] * v[0] + b[3] * v[3],
        b[0] * u[1] + b[1] * u[4] + b[2] * v[1] + b[3] * v[4],
        b[0] * u[2] + b[1] * u[5] + b[2] * v[2] + b[3] * v[5] + cost.GRAVITY,
    )
    return c, w


@jit_inline
def triple(array, i, j, leg):
    """array[i, j, leg] (3,) as three numbers."""
    return array[i, j, leg, 0], array[i, j, leg, 1], array[i, j, leg, 2]


@jit_inline
def physics_of_sample(problem, i, j, c, w, eps):
    """motion.cost.physics_model of sample j of segment i."""
    s0, s1 = triple(problem.support_point, i, j, 0), triple(problem.support_point, i, j, 1)
    return cost.physics_model(c, w, s0, s1, problem.standing[i, j, 0], problem.standing[i, j, 1], eps)


@jit_inline
def comfort_of_leg(problem, i, j, leg, c):
    """motion.cost.comfort_model of one leg in sample j of segment i."""
    q, on = triple(problem.leg_origin, i, j, leg), problem.standing[i, j, leg]
    return cost.comfort_model(c, q, on, problem.nominal_length[i, j, leg], problem.max_length[leg], problem.comfort_weight)


@jit_borrowing
def reach_of_segment(problem, control, i):
    """The reach penalties at both ends of segment i, where they can move."""
    e = 0.0
    for end in range(2):
        if not problem.fixed[i + end]:
            e += cost.reach_cost(
                control[i + end], problem.end_origin[i, end], problem.end_standing[i, end], problem.max_length,
                problem.comfort_weight,
            )  # fmt: skip
    return e


@jit_inline
def reach_counts(problem):
    """Whether legs can be too long: max_length is finite."""
    return min(problem.max_length[0], problem.max_length[1]) < np.inf


@jit_borrowing
def segment_costs(problem, control, i, eps):
    """Segment i's share of E: (as the solver smooths it, the true norm)."""
    samples = problem.support_point.shape[1]
    duration = problem.time[i + 1] - problem.time[i]
    smooth, true = 0.0, 0.0
    for j in range(samples):
        c, w = sample_state(control, i, (j + 0.5) / samples, duration)
        r = physics_of_sample(problem, i, j, c, w, eps)[0]
        comfort = comfort_of_leg(problem, i, j, 0, c)[0] + comfort_of_leg(problem, i, j, 1, c)[0]
        smooth += cost.smooth_norm(r, eps) + comfort
        true += r + comfort
    reach = reach_of_segment(problem, control, i) if reach_counts(problem) else 0.0
    return smooth * duration / samples + reach, true * duration / samples + reach


@jit_borrowing
def anchor_cost(problem, control):
    """Energy of the springs that hold the last control point."""
    e, last = 0.0, len(control) - 1
    for k in range(6):
        e += 0.5 * problem.anchor_stiffness[k // 3] * (control[last, k] - problem.anchor[k]) ** 2
    return e


@jit_borrowing
def total_costs(problem, control, eps):
    """E of control (m + 1, 6): (smoothed, true)."""
    smooth = true = anchor_cost(problem, control)
    for i in range(len(problem.time) - 1):
        a, b = segment_costs(problem, control, i, eps)
        smooth += a
        true += b
    return smooth, true


@jit_borrowing
def segment_cost(problem, control, i):
    """Segment i's share of E (the true norm, not smoothed)."""
    return segment_costs(problem, control, i, 1.0)[1]


@jit_borrowing
def total_cost(problem, control):
    """E of control (m + 1, 6)."""
    return total_costs(problem, control, 1.0)[1]


@jit
def straight_guess(problem, control, first):
    """Control points that are not fixed, from `first` on: above the mean of the feet under them, moving with them."""
    m = len(problem.time) - 1
    last_sample = problem.support_point.shape[1] - 1
    for i in range(first, m + 1):
        if problem.fixed[i]:
            continue
        sums = np.zeros(3)
        found = _add_origins(problem, max(i - 1, 0), last_sample, sums) + _add_origins(problem, min(i, m - 1), 0, sums)
        control[i, :3] = sums / max(found, 1)
        control[i, 2] += 0.97 * problem.nominal_length[min(i, m - 1), 0, 0]
    for i in range(first, m + 1):
        if not problem.fixed[i]:
            _guess_velocity(problem, control, i)


@jit
def _add_origins(problem, i, j, sums):
    found = 0
    for leg in range(2):
        if problem.standing[i, j, leg]:
            sums += problem.leg_origin[i, j, leg]
            found += 1
    return found


@jit_borrowing
def _guess_velocity(problem, control, i):
    """Slope through the neighbours; beside a flight (both feet off at the middle sample) the ballistic one."""
    m = len(problem.time) - 1
    before, after = max(i - 1, 0), min(i + 1, m)
    time = problem.time
    for axis in range(3):
        control[i, 3 + axis] = (control[after, axis] - control[before, axis]) / (time[after] - time[before])
    middle = problem.support_point.shape[1] // 2
    for segment, sign in ((i, 0.5), (i - 1, -0.5)):
        if 0 <= segment < m and not problem.standing[segment, middle].any():
            duration = time[segment + 1] - time[segment]
            for axis in range(3):
                control[i, 3 + axis] = (control[segment + 1, axis] - control[segment, axis]) / duration
            control[i, 5] += sign * cost.GRAVITY * duration
