"""Slow twins of the kernels, written straight from the paper: plain numpy and scipy, no numba."""

import numpy as np
from scipy.interpolate import BSpline
from scipy.optimize import nnls

from motion.com import cost

GRAVITY = np.array([0.0, 0.0, -9.81])


def hermite(time, control, t):
    """Position, velocity, acceleration of the spline at t from its polynomial coefficients. control (m + 1, 6)."""
    i = min(max(int(np.searchsorted(time, t, side="right")) - 1, 0), len(time) - 2)
    duration = time[i + 1] - time[i]
    s = (t - time[i]) / duration
    p0, m0, p1, m1 = control[i, :3], duration * control[i, 3:], control[i + 1, :3], duration * control[i + 1, 3:]
    cubic, square = 2 * p0 + m0 - 2 * p1 + m1, -3 * p0 - 2 * m0 + 3 * p1 - m1
    com = cubic * s**3 + square * s**2 + m0 * s + p0
    velocity = (3 * cubic * s**2 + 2 * square * s + m0) / duration
    return com, velocity, (6 * cubic * s + 2 * square) / duration**2


def physics_cost(com, acceleration, supports):
    """|F - w| with F the best non-negative combination of the legs' directions. supports: list of (3,)."""
    w = acceleration - GRAVITY
    if not supports:
        return float(np.linalg.norm(w))
    legs = np.array([(com - s) / np.linalg.norm(com - s) for s in supports]).T
    return float(nnls(legs, w)[1])


def comfort_cost(com, origins, nominal_lengths, max_length, weight):
    """weight * sum of (l - l_nominal)^2 + 100 (l - l_max)^2, the second where a leg is longer."""
    lengths = np.linalg.norm(com - np.reshape(origins, (-1, 3)), axis=1)
    return weight * np.sum((lengths - nominal_lengths) ** 2 + 100 * np.maximum(lengths - max_length, 0.0) ** 2)


def reach_cost(com, origins, max_length, weight):
    """20 s * weight * sum of (l - l_max)^2 where a leg is longer."""
    return 20 * weight * sum(max(np.linalg.norm(com - q) - max_length, 0.0) ** 2 for q in origins)


def jerk(time, control, i):
    """Third derivative of segment i of the spline. control (m + 1, 6)."""
    inside = time[i] + (time[i + 1] - time[i]) * np.array([0.25, 0.75])
    return np.diff([hermite(time, control, t)[2] for t in inside], axis=0)[0] / np.diff(inside)


def total_cost(problem, control):
    """E of a motion.com.problem.Problem, sample by sample."""
    segments, samples = len(problem.time) - 1, len(problem.standing)
    e = 0.5 * float(np.repeat(problem.anchor_stiffness, 3) @ (control[-1] - problem.anchor) ** 2)
    for segment, share, *place, stiffness in problem.pull:
        t = problem.time[int(segment)] + share * (problem.time[int(segment) + 1] - problem.time[int(segment)])
        e += 0.5 * stiffness * float(((hermite(problem.time, control, t)[0] - place) ** 2).sum())
    for i in range(segments):
        duration = problem.time[i + 1] - problem.time[i]
        for j in range(samples):
            t = problem.time[i] + (j + 0.5) / samples * duration
            com, _, acceleration = hermite(problem.time, control, t)
            on = problem.standing[j, :, i]
            needed = acceleration + (0, 0, problem.gravity[i] + GRAVITY[2])
            part = physics_cost(com, needed, list(problem.support_point[j, :, :, i][on]))
            legs = problem.leg_origin[j, :, :, i][on], problem.nominal_length[j, :, i][on]
            part += comfort_cost(com, *legs, problem.max_length[0], problem.comfort_weight * problem.comfort_share[i])
            over = max(np.linalg.norm(needed - GRAVITY) - problem.strength, 0.0)
            e += problem.weight[i] * (part + problem.strength_weight * over**2) * duration / samples
        e += problem.weight[i] * problem.jerk_weight * duration * float(np.sum(jerk(problem.time, control, i) ** 2))
        for end in (0, 1):
            if problem.fixed[i + end]:
                continue
            for leg in np.flatnonzero(problem.end_standing[end, :, i]):
                limit = problem.end_reach[end, leg, i] * problem.max_length[leg]
                e += reach_cost(control[i + end, :3], problem.end_origin[end, leg, :, i][None], limit, problem.comfort_weight)
    return e


def spline(problem, basis, coefficients):
    """The curve of these coefficients, by scipy."""
    return BSpline(problem.time[basis.knot], coefficients, 3)


def normal_equations(problem, basis, coefficients, eps):
    """Gauss-Newton (h (n, 3, n, 3), g (n, 3)) of E: J^T M J + C, sample by sample with dense Jacobians, by scipy's splines."""
    n, segments, samples = len(coefficients), len(problem.time) - 1, len(problem.standing)
    h, g, units = np.zeros((n, 3, n, 3)), np.zeros((n, 3)), np.eye(n)
    curve, each = spline(problem, basis, coefficients), spline(problem, basis, units)
    for i in range(segments):
        duration = problem.time[i + 1] - problem.time[i]
        for j in range(samples):
            t = problem.time[i] + (j + 0.5) / samples * duration
            com, w, share = curve(t), curve(t, 2) - GRAVITY, duration / samples
            points = [tuple(p) for p in problem.support_point[j, :, :, i]]
            on = problem.standing[j, :, i]
            _, phi, force, lower = cost.physics_model(tuple(com), tuple(w), *points, *on, eps)
            _spread(h, g, each(t, 2) - phi * each(t), share * whole(lower), share * np.array(force))
            for leg in range(2):
                origin = tuple(problem.leg_origin[j, leg, :, i])
                lengths = problem.nominal_length[j, leg, i], problem.max_length[leg]
                _, force, lower = cost.comfort_model(
                    tuple(com), origin, on[leg], *lengths, problem.comfort_weight * problem.comfort_share[i]
                )
                _spread(h, g, each(t), share * whole(lower), share * np.array(force))
            if np.linalg.norm(w) > problem.strength:
                _, _, force, lower = cost.strength_model(tuple(w), problem.strength, problem.strength_weight)
                _spread(h, g, each(t, 2), share * whole(lower), share * np.array(force))
        rate, weight = each(t, 3), 2 * problem.jerk_weight * duration
        _spread(h, g, rate, weight * np.eye(3), weight * curve(t, 3))
    return h, g


def _spread(h, g, weights, matrix, force):
    """Adds a model of what the coefficients weigh (n,) into."""
    h += np.einsum("i,ab,j->iajb", weights, matrix, weights)
    g += np.outer(weights, force)


def whole(lower):
    """The symmetric 3x3 matrix of a lower triangle (00, 10, 11, 20, 21, 22)."""
    m = np.zeros((3, 3))
    m[np.tril_indices(3)] = lower
    return m + np.tril(m, -1).T


def phases(side, contact, stance, begin, end, step=1e-3):
    """Support rows (left, right footprint or -1) at closely spaced times: [(t, left, right)]."""
    rows = []
    for t in np.arange(begin + step / 2, end, step):
        on = [-1, -1]
        for i, (s, c, a) in enumerate(zip(side, contact, stance, strict=True)):
            if c <= t < c + a:
                on[s] = i
        rows.append((t, *on))
    return rows


def footprint_triangles(position, heading, normal, outline):
    """Corners (N * 3 Q, 6), position and normal, of footprints: outline (Q, 3, 2) laid on the ground, 6 mm above it."""
    corners = []
    for p, h, n in zip(position, heading, normal, strict=True):
        forward = np.array([np.cos(h), np.sin(h), -(n[0] * np.cos(h) + n[1] * np.sin(h)) / n[2]])
        forward /= np.linalg.norm(forward)
        for x, y in outline.reshape(-1, 2):
            corners.append([*(p + x * forward + y * np.cross(n, forward) + 0.006 * n), *n])
    return np.array(corners)
