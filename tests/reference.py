"""Slow twins of the kernels, written straight from the paper: plain numpy and scipy, no numba."""

import numpy as np
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


def total_cost(problem, control):
    """E of a motion.com.problem.Problem, sample by sample."""
    segments, samples = len(problem.time) - 1, len(problem.standing)
    e = 0.5 * float(np.repeat(problem.anchor_stiffness, 3) @ (control[-1] - problem.anchor) ** 2)
    for i in range(segments):
        duration = problem.time[i + 1] - problem.time[i]
        for j in range(samples):
            t = problem.time[i] + (j + 0.5) / samples * duration
            com, _, acceleration = hermite(problem.time, control, t)
            on = problem.standing[j, :, i]
            part = physics_cost(com, acceleration, list(problem.support_point[j, :, :, i][on]))
            legs = problem.leg_origin[j, :, :, i][on], problem.nominal_length[j, :, i][on]
            part += comfort_cost(com, *legs, problem.max_length[0], problem.comfort_weight)
            e += part * duration / samples
        for end in (0, 1):
            if problem.fixed[i + end]:
                continue
            legs = problem.end_origin[end, :, :, i][problem.end_standing[end, :, i]]
            e += reach_cost(control[i + end, :3], legs, problem.max_length[0], problem.comfort_weight)
    return e


def normal_equations(problem, control, eps):
    """Gauss-Newton (h (m + 1, 6, m + 1, 6), g (m + 1, 6)) of E: J^T M J + C, sample by sample with dense Jacobians."""
    segments, samples = len(problem.time) - 1, len(problem.standing)
    h, g = np.zeros((segments + 1, 6, segments + 1, 6)), np.zeros((segments + 1, 6))
    for i in range(segments):
        duration = problem.time[i + 1] - problem.time[i]
        for j in range(samples):
            t = problem.time[i] + (j + 0.5) / samples * duration
            com, _, acceleration = hermite(problem.time, control, t)
            unit = np.eye(12).reshape(12, 2, 6)
            basis = [hermite(problem.time[i : i + 2], u, t) for u in unit]
            dc, da = np.array([b[0] for b in basis]).T, np.array([b[2] for b in basis]).T
            points = [tuple(p) for p in problem.support_point[j, :, :, i]]
            on = problem.standing[j, :, i]
            _, phi, force, lower = cost.physics_model(tuple(com), tuple(acceleration - GRAVITY), *points, *on, eps)
            both = da - phi * dc
            part = both.T @ whole(lower) @ both
            slope = both.T @ np.array(force)
            for leg in range(2):
                origin = tuple(problem.leg_origin[j, leg, :, i])
                lengths = problem.nominal_length[j, leg, i], problem.max_length[leg]
                _, force, lower = cost.comfort_model(tuple(com), origin, on[leg], *lengths, problem.comfort_weight)
                part += dc.T @ whole(lower) @ dc
                slope += dc.T @ np.array(force)
            h[i : i + 2, :, i : i + 2] += part.reshape(2, 6, 2, 6) * duration / samples
            g[i : i + 2] += slope.reshape(2, 6) * duration / samples
    return h, g


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
