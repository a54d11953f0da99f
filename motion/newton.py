"""Gauss-Newton with Levenberg damping on block-tridiagonal normal equations: the default solver.

E sums norms |r|, whose exact gradient is J^T r / |r|. Weighting the squared residual by 1 / max(|r|, eps) gives that
gradient and a positive definite Hessian 1/|r| J^T J (iteratively reweighted least squares). It minimises Huber's smoothed
norm exactly; eps shrinks from a smooth problem (squared norm) to a sharp one, each stage warm-started by the last. A
control point couples only with its neighbours, so the normal equations are block tridiagonal with 6x6 blocks (half
bandwidth 12), factored by block Cholesky in time linear in the segments.
"""

from typing import NamedTuple

import numpy as np

from motion import cost, spline
from motion import problem as problems
from motion.jit import jit


class Effort(NamedTuple):
    """How hard to try: the more, the nearer to the optimum. Times are for a 12-step walk on one core."""

    stages: int  # eps goes from eps_first to eps_last in this many equal ratios
    eps_first: float  # [m/s^2] large: squared norm, fast and smooth
    eps_last: float  # [m/s^2] small: the norm itself
    iterations: int  # at most, per stage
    tolerance: float  # a stage ends when the predicted decrease is below this share of E


TIGHT = Effort(9, 3.0, 3e-4, 60, 1e-7)
SCENE = Effort(6, 3.0, 3e-3, 20, 1e-4)
LIVE = Effort(2, 0.05, 3e-3, 6, 1e-3)
HARDER = Effort(4, 1.0, 3e-3, 10, 1e-3)


class Workspace(NamedTuple):
    """Normal equations of m segments: H = tridiagonal(lower, diagonal, lower^T), gradient, and the step."""

    diagonal: np.ndarray  # (m + 1, 6, 6)
    lower: np.ndarray  # (m, 6, 6): row i + 1, column i
    factor_diagonal: np.ndarray  # (m + 1, 6, 6)
    factor_lower: np.ndarray  # (m, 6, 6)
    gradient: np.ndarray  # (m + 1, 6)
    step: np.ndarray  # (m + 1, 6)


@jit
def workspace(m):
    """Arrays for m segments."""
    return Workspace(
        np.zeros((m + 1, 6, 6)),
        np.zeros((m, 6, 6)),
        np.zeros((m + 1, 6, 6)),
        np.zeros((m, 6, 6)),
        np.zeros((m + 1, 6)),
        np.zeros((m + 1, 6)),
    )


@jit
def _expand(h, g, wp, wa, scale, work, i):
    """Spreads a sample's block in (c, a) over the control points i, i + 1: J = [wp_k I; wa_k I] for k = p0, v0, p1, v1."""
    for k in range(4):
        row, point = 3 * (k % 2), i + k // 2
        pk, ak = scale * wp[k], scale * wa[k]
        for x in range(3):
            work.gradient[point, row + x] += pk * g[x] + ak * g[3 + x]
        for n in range(k + 1):
            column = 3 * (n % 2)
            target = work.lower[i] if k // 2 != n // 2 else work.diagonal[point]
            cc, ca, ac, aa = pk * wp[n], pk * wa[n], ak * wp[n], ak * wa[n]
            for x in range(3):
                for y in range(3):
                    target[row + x, column + y] += cc * h[x, y] + ca * h[x, 3 + y] + ac * h[y, 3 + x] + aa * h[3 + x, 3 + y]


@jit
def assemble(problem, control, eps, work):
    """Fills work's Hessian (lower triangles) and gradient; returns the smoothed E."""
    work.diagonal[:] = 0.0
    work.lower[:] = 0.0
    work.gradient[:] = 0.0
    h = np.zeros((6, 6))
    g = np.zeros(6)
    samples = problem.support_point.shape[1]
    e = 0.0
    for i in range(len(problem.time) - 1):
        duration = problem.time[i + 1] - problem.time[i]
        scale = duration / samples
        for j in range(samples):
            s = (j + 0.5) / samples
            c0, c1, c2, w0, w1, w2 = problems.sample_state(control, i, s, duration)
            h[:] = 0.0
            g[:] = 0.0
            standing = problem.standing[i, j]
            e += scale * cost.add_physics(c0, c1, c2, w0, w1, w2, problem.support_point[i, j], standing, eps, h, g)
            e += scale * cost.add_comfort(
                c0, c1, c2, problem.leg_origin[i, j], standing, problem.nominal_length[i, j], problem.comfort_weight, h, g
            )
            wp = spline.position_weights(s, duration)
            wa = spline.acceleration_weights(s, duration)
            _expand(h, g, wp, wa, scale, work, i)
        for end in range(2):
            e += cost.add_reach(
                control[i + end], problem.end_origin[i, end], problem.end_standing[i, end], problem.max_length,
                problem.comfort_weight, work.diagonal[i + end], work.gradient[i + end],
            )  # fmt: skip
    return e


@jit
def smooth_cost(problem, control, eps):
    """The smoothed E that a stage minimises: physics by Huber's norm."""
    samples = problem.support_point.shape[1]
    e = 0.0
    for i in range(len(problem.time) - 1):
        duration = problem.time[i + 1] - problem.time[i]
        part = 0.0
        for j in range(samples):
            c0, c1, c2, w0, w1, w2 = problems.sample_state(control, i, (j + 0.5) / samples, duration)
            standing = problem.standing[i, j]
            r = cost.physics_cost(c0, c1, c2, w0, w1, w2, problem.support_point[i, j], standing)
            part += cost.smooth_norm(r, eps) + problems.comfort_of_sample(problem, i, j, c0, c1, c2)
        e += part * duration / samples + problems.reach_of_segment(problem, control, i)
    return e


@jit
def _cholesky(a):
    """In place, lower triangle of a (6, 6)."""
    for j in range(6):
        for k in range(j):
            for i in range(j, 6):
                a[i, j] -= a[i, k] * a[j, k]
        pivot = np.sqrt(max(a[j, j], 1e-30))
        for i in range(j, 6):
            a[i, j] /= pivot


@jit
def _forward(a, x):
    """x := A^-1 x for a lower triangular A."""
    for i in range(6):
        for k in range(i):
            x[i] -= a[i, k] * x[k]
        x[i] /= a[i, i]


@jit
def _backward(a, x):
    """x := A^-T x."""
    for i in range(5, -1, -1):
        for k in range(i + 1, 6):
            x[i] -= a[k, i] * x[k]
        x[i] /= a[i, i]


@jit
def solve_damped(problem, work, damping):
    """step = -(H + damping diag H)^-1 gradient, zero at fixed control points; returns the predicted decrease of E."""
    fd, fl, x = work.factor_diagonal, work.factor_lower, work.step
    m = len(problem.time) - 1
    for i in range(m + 1):
        for r in range(6):
            for c in range(r + 1):
                fd[i, r, c] = work.diagonal[i, r, c]
            fd[i, r, r] += damping * work.diagonal[i, r, r] + 1e-12
            x[i, r] = -work.gradient[i, r]
        if problem.fixed[i]:
            fd[i] = np.eye(6)
            x[i] = 0.0
        if i > 0:
            if problem.fixed[i] or problem.fixed[i - 1]:
                fl[i - 1] = 0.0
            else:
                fl[i - 1] = work.lower[i - 1]
            for r in range(6):
                _forward(fd[i - 1], fl[i - 1, r])
            for r in range(6):
                for k in range(6):
                    x[i, r] -= fl[i - 1, r, k] * x[i - 1, k]
                    for c in range(r + 1):
                        fd[i, r, c] -= fl[i - 1, r, k] * fl[i - 1, c, k]
        _cholesky(fd[i])
        _forward(fd[i], x[i])
    decrease = 0.0
    for i in range(m, -1, -1):
        if i < m:
            for k in range(6):
                for r in range(6):
                    x[i, k] -= fl[i, r, k] * x[i + 1, r]
        _backward(fd[i], x[i])
        for r in range(6):
            decrease -= 0.5 * work.gradient[i, r] * x[i, r]
    return decrease


@jit
def _stage(problem, control, eps, iterations, tolerance, work, trial):
    """Levenberg-Marquardt on the smoothed E; returns the iterations used."""
    damping = 1e-6
    for iteration in range(iterations):
        e = assemble(problem, control, eps, work)
        while True:
            decrease = solve_damped(problem, work, damping)
            if not decrease > tolerance * e:
                return iteration + 1
            trial[:] = control + work.step
            gain = (e - smooth_cost(problem, trial, eps)) / decrease
            if gain > 0.05:
                control[:] = trial
                damping *= 0.2 if gain > 0.5 else 1.0
                break
            damping = max(10 * damping, 1e-4)
            if damping > 1e8:
                return iteration + 1
        damping = max(damping, 1e-9)
    return iterations


@jit
def minimise(problem, control, effort):
    """Moves control (m + 1, 6) in place to a minimum of E; returns (E, iterations)."""
    work = workspace(len(problem.time) - 1)
    trial = np.empty_like(control)
    ratio = (effort.eps_last / effort.eps_first) ** (1.0 / max(effort.stages - 1, 1))
    eps = effort.eps_first
    used = 0
    for _ in range(effort.stages):
        used += _stage(problem, control, eps, effort.iterations, effort.tolerance, work, trial)
        eps *= ratio
    return problems.total_cost(problem, control), used
