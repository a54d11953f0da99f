"""Gauss-Newton on block-tridiagonal normal equations: the default solver.

E sums norms |r|, whose exact gradient is J^T r / |r|. Weighting the squared residual by 1 / max(|r|, eps) gives that
gradient and a positive definite Hessian 1/|r| J^T J (iteratively reweighted least squares). It minimises Huber's smoothed
norm exactly; eps shrinks from a smooth problem (squared norm) to a sharp one, each stage warm-started by the last. A
control point couples only with its neighbours, so the normal equations are block tridiagonal with 6x6 blocks (half
bandwidth 12), factored by block Cholesky in time linear in the segments.

With h_k the cubic and b_k the linear weights of the four knots (p0, T v0, p1, T v1) of a segment in com and acceleration,
a sample's model (motion.cost) sees omega_k = b_k / T^2 - phi h_k, so it adds omega_k omega_l M + h_k h_l C to the 3x3
block of knots k and l, C the comfort's matrix: ten symmetric blocks, 120 multiply-adds per sample.
"""

from typing import NamedTuple

import numpy as np

from motion import cost, spline
from motion import problem as problems
from motion.jit import jit, jit_borrowing, jit_inline


class Effort(NamedTuple):
    """How hard to try: the more, the nearer to the optimum."""

    stages: int  # eps goes from eps_first to eps_last in this many equal ratios
    eps_first: float  # [m/s^2] large: squared norm, fast and smooth
    eps_last: float  # [m/s^2] small: the norm itself
    iterations: int  # at most, per stage
    tolerance: float  # a stage ends when the predicted decrease is below this share of E


TIGHT = Effort(9, 3.0, 3e-4, 60, 1e-7)
SCENE = Effort(2, 0.1, 3e-3, 12, 1e-3)
LIVE = Effort(1, 3e-3, 3e-3, 8, 5e-4)
HARDER = Effort(4, 1.0, 3e-3, 10, 1e-3)

DAMPING = 1e-6
"""Share of the diagonal that is added to it: keeps directions that nothing holds from running away."""
_BACK = 0.3
"""Share of a step that is tried next where the whole step has raised E."""


class Workspace(NamedTuple):
    """Normal equations of m segments: H = tridiagonal(lower, diagonal, lower^T), gradient, and the step."""

    diagonal: np.ndarray  # (m + 1, 6, 6) lower triangles
    lower: np.ndarray  # (m, 6, 6): row i + 1, column i
    gradient: np.ndarray  # (m + 1, 6)
    factor_diagonal: np.ndarray  # (m + 1, 6, 6) Cholesky factor, its diagonal inverted
    factor_lower: np.ndarray  # (m, 6, 6) transposed: [i, column, row], so that loops over rows are contiguous
    step: np.ndarray  # (m + 1, 6)
    weights: np.ndarray  # (S, 8) of the four knots in com and acceleration at the samples, for T = 1
    blocks: np.ndarray  # (10, 6) one segment's blocks of knots k >= l in the order 00 10 11 20 21 22 30 ..., lower triangles
    slopes: np.ndarray  # (4, 3) one segment's gradient


@jit
def workspace(m, samples):
    """Arrays for m segments of `samples` samples."""
    weights = np.empty((samples, 8))
    for j in range(samples):
        s = (j + 0.5) / samples
        h, b = spline.position_weights(s, 1.0), spline.acceleration_weights(s, 1.0)
        for k in range(4):
            weights[j, k], weights[j, 4 + k] = h[k], b[k]
    return Workspace(
        np.zeros((m + 1, 6, 6)),
        np.zeros((m, 6, 6)),
        np.zeros((m + 1, 6)),
        np.zeros((m + 1, 6, 6)),
        np.zeros((m, 6, 6)),
        np.zeros((m + 1, 6)),
        weights,
        np.zeros((10, 6)),
        np.zeros((4, 3)),
    )


@jit_inline
def _knots(control, i, duration, axis):
    """p0, T v0, p1, T v1 of segment i along an axis."""
    return (
        control[i, axis],
        duration * control[i, 3 + axis],
        control[i + 1, axis],
        duration * control[i + 1, 3 + axis],
    )


@jit_inline
def _mix(weights, j, first, u):
    """Sum of the four knots u by their weights at sample j."""
    return weights[j, first] * u[0] + weights[j, first + 1] * u[1] + weights[j, first + 2] * u[2] + weights[j, first + 3] * u[3]


@jit_inline
def _add_block(blocks, row, a, m, b, c):
    """blocks[row] += a m + b c, for lower triangles m and c."""
    blocks[row, 0] += a * m[0] + b * c[0]
    blocks[row, 1] += a * m[1] + b * c[1]
    blocks[row, 2] += a * m[2] + b * c[2]
    blocks[row, 3] += a * m[3] + b * c[3]
    blocks[row, 4] += a * m[4] + b * c[4]
    blocks[row, 5] += a * m[5] + b * c[5]


@jit_inline
def _add_slope(slopes, k, a, g, b, f):
    slopes[k, 0] += a * g[0] + b * f[0]
    slopes[k, 1] += a * g[1] + b * f[1]
    slopes[k, 2] += a * g[2] + b * f[2]


@jit_inline
def _add_sample(work, j, bend, scale, phi, g, m, f, c):
    """Spreads a sample's model, (g, m) of physics in dw - phi dc and (f, c) of comfort in dc, over the segment's knots."""
    weights, blocks = work.weights, work.blocks
    h0, h1, h2, h3 = weights[j, 0], weights[j, 1], weights[j, 2], weights[j, 3]
    o0, o1 = bend * weights[j, 4] - phi * h0, bend * weights[j, 5] - phi * h1
    o2, o3 = bend * weights[j, 6] - phi * h2, bend * weights[j, 7] - phi * h3
    a0, a1, a2, a3 = scale * o0, scale * o1, scale * o2, scale * o3
    b0, b1, b2, b3 = scale * h0, scale * h1, scale * h2, scale * h3
    _add_block(blocks, 0, a0 * o0, m, b0 * h0, c)
    _add_block(blocks, 1, a1 * o0, m, b1 * h0, c)
    _add_block(blocks, 2, a1 * o1, m, b1 * h1, c)
    _add_block(blocks, 3, a2 * o0, m, b2 * h0, c)
    _add_block(blocks, 4, a2 * o1, m, b2 * h1, c)
    _add_block(blocks, 5, a2 * o2, m, b2 * h2, c)
    _add_block(blocks, 6, a3 * o0, m, b3 * h0, c)
    _add_block(blocks, 7, a3 * o1, m, b3 * h1, c)
    _add_block(blocks, 8, a3 * o2, m, b3 * h2, c)
    _add_block(blocks, 9, a3 * o3, m, b3 * h3, c)
    _add_slope(work.slopes, 0, a0, g, b0, f)
    _add_slope(work.slopes, 1, a1, g, b1, f)
    _add_slope(work.slopes, 2, a2, g, b2, f)
    _add_slope(work.slopes, 3, a3, g, b3, f)


@jit_inline
def _put(target, i, row, column, blocks, n, factor):
    """target[i, row : row + 3, column : column + 3] += factor times block n, whole."""
    x, y, z = factor * blocks[n, 0], factor * blocks[n, 1], factor * blocks[n, 2]
    u, v, w = factor * blocks[n, 3], factor * blocks[n, 4], factor * blocks[n, 5]
    target[i, row, column] += x
    target[i, row, column + 1] += y
    target[i, row, column + 2] += u
    target[i, row + 1, column] += y
    target[i, row + 1, column + 1] += z
    target[i, row + 1, column + 2] += v
    target[i, row + 2, column] += u
    target[i, row + 2, column + 1] += v
    target[i, row + 2, column + 2] += w


@jit_inline
def _put_segment(work, i, duration):
    """Adds segment i's blocks to the equations of its two control points; a tangent is 1 / T of its knot."""
    blocks, square = work.blocks, duration * duration
    _put(work.diagonal, i, 0, 0, blocks, 0, 1.0)
    _put(work.diagonal, i, 3, 0, blocks, 1, duration)
    _put(work.diagonal, i, 3, 3, blocks, 2, square)
    _put(work.lower, i, 0, 0, blocks, 3, 1.0)
    _put(work.lower, i, 0, 3, blocks, 4, duration)
    _put(work.diagonal, i + 1, 0, 0, blocks, 5, 1.0)
    _put(work.lower, i, 3, 0, blocks, 6, duration)
    _put(work.lower, i, 3, 3, blocks, 7, square)
    _put(work.diagonal, i + 1, 3, 0, blocks, 8, duration)
    _put(work.diagonal, i + 1, 3, 3, blocks, 9, square)
    for axis in range(3):
        work.gradient[i, axis] += work.slopes[0, axis]
        work.gradient[i, 3 + axis] += duration * work.slopes[1, axis]
        work.gradient[i + 1, axis] += work.slopes[2, axis]
        work.gradient[i + 1, 3 + axis] += duration * work.slopes[3, axis]


@jit_borrowing
def assemble(problem, control, eps, work):
    """Fills work's Hessian (lower triangles) and gradient; returns the smoothed E."""
    work.diagonal[:] = 0.0
    work.lower[:] = 0.0
    work.gradient[:] = 0.0
    samples = problem.support_point.shape[1]
    e = _add_anchor(problem, control, work)
    for i in range(len(problem.time) - 1):
        duration = problem.time[i + 1] - problem.time[i]
        scale, bend = duration / samples, 1 / (duration * duration)
        x, y, z = _knots(control, i, duration, 0), _knots(control, i, duration, 1), _knots(control, i, duration, 2)
        work.blocks[:] = 0.0
        work.slopes[:] = 0.0
        for j in range(samples):
            com = (_mix(work.weights, j, 0, x), _mix(work.weights, j, 0, y), _mix(work.weights, j, 0, z))
            w0, w1 = bend * _mix(work.weights, j, 4, x), bend * _mix(work.weights, j, 4, y)
            w = (w0, w1, bend * _mix(work.weights, j, 4, z) + cost.GRAVITY)
            r, phi, g, m = problems.physics_of_sample(problem, i, j, com, w, eps)
            e0, f0, c0 = problems.comfort_of_leg(problem, i, j, 0, com)
            e1, f1, c1 = problems.comfort_of_leg(problem, i, j, 1, com)
            e += scale * (cost.smooth_norm(r, eps) + e0 + e1)
            f = (f0[0] + f1[0], f0[1] + f1[1], f0[2] + f1[2])
            c = (c0[0] + c1[0], c0[1] + c1[1], c0[2] + c1[2], c0[3] + c1[3], c0[4] + c1[4], c0[5] + c1[5])
            _add_sample(work, j, bend, scale, phi, g, m, f, c)
        _put_segment(work, i, duration)
        if problems.reach_counts(problem):
            e += _add_reach(problem, control, i, work)
    return e


@jit_borrowing
def _add_anchor(problem, control, work):
    last = len(control) - 1
    for k in range(6):
        work.diagonal[last, k, k] += problem.anchor_stiffness[k // 3]
        work.gradient[last, k] += problem.anchor_stiffness[k // 3] * (control[last, k] - problem.anchor[k])
    return problems.anchor_cost(problem, control)


@jit_borrowing
def _add_reach(problem, control, i, work):
    e = 0.0
    for end in range(2):
        if not problem.fixed[i + end]:
            e += cost.add_reach(
                control[i + end], problem.end_origin[i, end], problem.end_standing[i, end], problem.max_length,
                problem.comfort_weight, work.diagonal[i + end], work.gradient[i + end],
            )  # fmt: skip
    return e


@jit_inline
def _eliminate(work, i):
    """Takes control point i - 1 out of the equations of i: F = B L^-T (transposed), D -= F F^T, step -= F step before."""
    fd, ft, x = work.factor_diagonal, work.factor_lower, work.step
    p = i - 1
    for c in range(6):
        for k in range(c):
            for r in range(6):
                ft[p, c, r] -= fd[p, c, k] * ft[p, k, r]
        for r in range(6):
            ft[p, c, r] *= fd[p, c, c]
    for k in range(6):
        for r in range(6):
            x[i, r] -= ft[p, k, r] * x[p, k]
        for c in range(6):
            for r in range(6):
                fd[i, c, r] -= ft[p, k, c] * ft[p, k, r]


@jit_inline
def _factor(work, i):
    """Cholesky of block i in place, its diagonal inverted, and the forward substitution of its right side."""
    fd, x = work.factor_diagonal, work.step
    for c in range(6):
        for k in range(c):
            for r in range(c, 6):
                fd[i, r, c] -= fd[i, r, k] * fd[i, c, k]
            x[i, c] -= fd[i, c, k] * x[i, k]
        inverse = 1 / np.sqrt(max(fd[i, c, c], 1e-30))
        fd[i, c, c] = inverse
        for r in range(c + 1, 6):
            fd[i, r, c] *= inverse
        x[i, c] *= inverse


@jit_inline
def _load(problem, work, i):
    """Block row i of the damped equations; a fixed control point is alone with itself and does not move."""
    fd, ft, x, d = work.factor_diagonal, work.factor_lower, work.step, work.diagonal
    free = 0.0 if problem.fixed[i] else 1.0
    for r in range(6):
        x[i, r] = -free * work.gradient[i, r]
        for c in range(6):
            fd[i, r, c] = free * d[i, r, c]
        fd[i, r, r] += free * DAMPING * d[i, r, r] + (1 - free) + 1e-12
    if i > 0:
        coupled = 0.0 if problem.fixed[i - 1] else free
        for c in range(6):
            for r in range(6):
                ft[i - 1, c, r] = coupled * work.lower[i - 1, r, c]


@jit_borrowing
def solve(problem, work):
    """step = -(H + DAMPING diag H)^-1 gradient, zero at fixed control points; returns the predicted decrease of E."""
    fd, ft, x = work.factor_diagonal, work.factor_lower, work.step
    m = len(problem.time) - 1
    for i in range(m + 1):
        _load(problem, work, i)
        if i > 0:
            _eliminate(work, i)
        _factor(work, i)
    decrease = 0.0
    for i in range(m, -1, -1):
        if i < m:
            for k in range(6):
                for r in range(6):
                    x[i, k] -= ft[i, k, r] * x[i + 1, r]
        for c in range(5, -1, -1):
            for k in range(c + 1, 6):
                x[i, c] -= fd[i, k, c] * x[i, k]
            x[i, c] *= fd[i, c, c]
        for r in range(6):
            decrease -= 0.5 * work.gradient[i, r] * x[i, r]
    return decrease


@jit_borrowing
def _stage(problem, control, eps, iterations, tolerance, work, kept):
    """Full steps on the smoothed E, checked by the next assembly; returns (true E, iterations used)."""
    before, share = np.inf, 1.0
    for iteration in range(iterations):
        e = assemble(problem, control, eps, work)
        if not e <= before:
            share *= _BACK
        else:
            if not solve(problem, work) > tolerance * e:
                return problems.total_cost(problem, control), iteration + 1
            _copy(control, kept)
            before, share = e, 1.0
        _move(control, kept, share, work.step)
    e, true = problems.total_costs(problem, control, eps)
    if not e <= before:
        _copy(kept, control)
        true = problems.total_cost(problem, control)
    return true, iterations


@jit_inline
def _copy(source, goal):
    for i in range(len(source)):
        for k in range(6):
            goal[i, k] = source[i, k]


@jit_inline
def _move(control, kept, share, step):
    for i in range(len(control)):
        for k in range(6):
            control[i, k] = kept[i, k] + share * step[i, k]


@jit
def minimise(problem, control, effort):
    """Moves control (m + 1, 6) in place to a minimum of E; returns (E, iterations)."""
    work = workspace(len(problem.time) - 1, problem.support_point.shape[1])
    kept = np.empty_like(control)
    ratio = (effort.eps_last / effort.eps_first) ** (1.0 / max(effort.stages - 1, 1))
    eps = effort.eps_first
    e, used = 0.0, 0
    for _ in range(effort.stages):
        e, more = _stage(problem, control, eps, effort.iterations, effort.tolerance, work, kept)
        used += more
        eps *= ratio
    return e, used
