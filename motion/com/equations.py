"""The normal equations of E: every sample's model spread over the control points around it.

With h_k the cubic and b_k the linear weights of the four knots (p0, T v0, p1, T v1) of a segment in com and acceleration,
a sample's model (motion.com.cost) sees omega_k = b_k / T^2 - phi h_k, so it adds omega_k omega_l M + h_k h_l C to the 3x3
block of knots k and l, C the comfort's matrix: ten symmetric blocks, 120 multiply-adds per sample, LANES segments at once.
"""

from typing import NamedTuple

import numpy as np

from motion.com import cost
from motion.com import problem as problems
from motion.track import spline
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.lanes import LANES, load, store, total

ROWS = 8
"""Of a column of six, so that it is two Lanes."""


class Equations(NamedTuple):
    """H step = -gradient of m segments: H = tridiagonal(lower, diagonal, lower^T) in 6x6 blocks, by columns."""

    diagonal: np.ndarray  # (m + 1, 6, ROWS) [point, column, row], lower triangles
    lower: np.ndarray  # (m, 6, ROWS): column of point i, row of point i + 1
    gradient: np.ndarray  # (m + 1, 6)
    blocks: np.ndarray  # (10, 6, LANES) of LANES segments: knots k >= l as 00 10 11 20 21 22 30 ..., lower triangles
    slopes: np.ndarray  # (4, 3, LANES) their gradients


@jit
def empty_equations(m):
    """Of m segments."""
    return Equations(
        np.zeros((m + 1, 6, ROWS)),
        np.zeros((m, 6, ROWS)),
        np.zeros((m + 1, 6)),
        np.zeros((10, 6, LANES)),
        np.zeros((4, 3, LANES)),
    )


@jit_inline
def _add_block(blocks, n, a, m, b, c):
    """blocks[n] += a m + b c, for lower triangles m and c."""
    store(blocks, (n, 0, 0), load(blocks, (n, 0, 0)) + (a * m[0] + b * c[0]))
    store(blocks, (n, 1, 0), load(blocks, (n, 1, 0)) + (a * m[1] + b * c[1]))
    store(blocks, (n, 2, 0), load(blocks, (n, 2, 0)) + (a * m[2] + b * c[2]))
    store(blocks, (n, 3, 0), load(blocks, (n, 3, 0)) + (a * m[3] + b * c[3]))
    store(blocks, (n, 4, 0), load(blocks, (n, 4, 0)) + (a * m[4] + b * c[4]))
    store(blocks, (n, 5, 0), load(blocks, (n, 5, 0)) + (a * m[5] + b * c[5]))


@jit_inline
def _add_slope(slopes, k, a, g, b, f):
    store(slopes, (k, 0, 0), load(slopes, (k, 0, 0)) + (a * g[0] + b * f[0]))
    store(slopes, (k, 1, 0), load(slopes, (k, 1, 0)) + (a * g[1] + b * f[1]))
    store(slopes, (k, 2, 0), load(slopes, (k, 2, 0)) + (a * g[2] + b * f[2]))


@jit_inline
def _add_sample(equations, segments, h, b, phi, g, m, f, c):
    """Spreads a sample's model, (g, m) of physics in dw - phi dc and (f, c) of comfort in dc, over the segments' knots."""
    blocks, slopes, bend, scale = equations.blocks, equations.slopes, segments.bend, segments.scale
    o0, o1, o2, o3 = bend * b[0] - phi * h[0], bend * b[1] - phi * h[1], bend * b[2] - phi * h[2], bend * b[3] - phi * h[3]
    a0, a1, a2, a3 = scale * o0, scale * o1, scale * o2, scale * o3
    b0, b1, b2, b3 = scale * h[0], scale * h[1], scale * h[2], scale * h[3]
    _add_block(blocks, 0, a0 * o0, m, b0 * h[0], c)
    _add_block(blocks, 1, a1 * o0, m, b1 * h[0], c)
    _add_block(blocks, 2, a1 * o1, m, b1 * h[1], c)
    _add_block(blocks, 3, a2 * o0, m, b2 * h[0], c)
    _add_block(blocks, 4, a2 * o1, m, b2 * h[1], c)
    _add_block(blocks, 5, a2 * o2, m, b2 * h[2], c)
    _add_block(blocks, 6, a3 * o0, m, b3 * h[0], c)
    _add_block(blocks, 7, a3 * o1, m, b3 * h[1], c)
    _add_block(blocks, 8, a3 * o2, m, b3 * h[2], c)
    _add_block(blocks, 9, a3 * o3, m, b3 * h[3], c)
    _add_slope(slopes, 0, a0, g, b0, f)
    _add_slope(slopes, 1, a1, g, b1, f)
    _add_slope(slopes, 2, a2, g, b2, f)
    _add_slope(slopes, 3, a3, g, b3, f)


@jit_inline
def _put(target, i, column, row, blocks, n, k, factor):
    """Adds factor times block n of lane k, whole, from target[i, column, row] on."""
    x, y, z = factor * blocks[n, 0, k], factor * blocks[n, 1, k], factor * blocks[n, 2, k]
    u, v, w = factor * blocks[n, 3, k], factor * blocks[n, 4, k], factor * blocks[n, 5, k]
    target[i, column, row] += x
    target[i, column, row + 1] += y
    target[i, column, row + 2] += u
    target[i, column + 1, row] += y
    target[i, column + 1, row + 1] += z
    target[i, column + 1, row + 2] += v
    target[i, column + 2, row] += u
    target[i, column + 2, row + 1] += v
    target[i, column + 2, row + 2] += w


@jit_inline
def _put_segment(equations, i, k, duration):
    """Adds lane k's blocks to the equations of segment i's two control points; a tangent is 1 / T of its knot."""
    blocks, slopes, square = equations.blocks, equations.slopes, duration * duration
    _put(equations.diagonal, i, 0, 0, blocks, 0, k, 1.0)
    _put(equations.diagonal, i, 0, 3, blocks, 1, k, duration)
    _put(equations.diagonal, i, 3, 3, blocks, 2, k, square)
    _put(equations.lower, i, 0, 0, blocks, 3, k, 1.0)
    _put(equations.lower, i, 3, 0, blocks, 4, k, duration)
    _put(equations.diagonal, i + 1, 0, 0, blocks, 5, k, 1.0)
    _put(equations.lower, i, 0, 3, blocks, 6, k, duration)
    _put(equations.lower, i, 3, 3, blocks, 7, k, square)
    _put(equations.diagonal, i + 1, 0, 3, blocks, 8, k, duration)
    _put(equations.diagonal, i + 1, 3, 3, blocks, 9, k, square)
    for axis in range(3):
        equations.gradient[i, axis] += slopes[0, axis, k]
        equations.gradient[i, 3 + axis] += duration * slopes[1, axis, k]
        equations.gradient[i + 1, axis] += slopes[2, axis, k]
        equations.gradient[i + 1, 3 + axis] += duration * slopes[3, axis, k]


@jit_inline
def _sum_samples(problem, segments, i, eps, equations):
    """Fills blocks and slopes with the models of all samples of the segments from i on; returns their E in lanes."""
    samples = problem.support_point.shape[0]
    equations.blocks[:] = 0.0
    equations.slopes[:] = 0.0
    e = 0.0 * segments.scale
    for j in range(samples):
        s = (j + 0.5) / samples
        h, b = spline.position_weights(s, 1.0), spline.acceleration_weights(s, 1.0)
        com, w = problems.state_of_sample(segments, h, b)
        r, phi, g, m = problems.physics_of_sample(problem, i, j, com, w, eps)
        e0, f0, c0 = problems.comfort_of_leg(problem, i, j, 0, com)
        e1, f1, c1 = problems.comfort_of_leg(problem, i, j, 1, com)
        e += segments.scale * (cost.smooth_norm(r, eps) + e0 + e1)
        f = (f0[0] + f1[0], f0[1] + f1[1], f0[2] + f1[2])
        c = (c0[0] + c1[0], c0[1] + c1[1], c0[2] + c1[2], c0[3] + c1[3], c0[4] + c1[4], c0[5] + c1[5])
        _add_sample(equations, segments, h, b, phi, g, m, f, c)
    return e


@jit_borrowing
def assemble(problem, control, eps, equations):
    """Fills the equations at control (m + 1, 6); returns the smoothed E."""
    equations.diagonal[:] = 0.0
    equations.lower[:] = 0.0
    equations.gradient[:] = 0.0
    m, e = len(problem.time) - 1, _add_anchor(problem, control, equations)
    for i in range(0, m, LANES):
        segments = problems.segments_from(problem, control, i)
        e += total(_sum_samples(problem, segments, i, eps, equations))
        for k in range(min(LANES, m - i)):
            _put_segment(equations, i + k, k, problem.time[i + k + 1] - problem.time[i + k])
        if problems.overreaches(problem, segments, i):
            e += _add_reach(problem, control, i, equations)
    return e


@jit_borrowing
def _add_anchor(problem, control, equations):
    last = len(control) - 1
    for k in range(6):
        equations.diagonal[last, k, k] += problem.anchor_stiffness[k // 3]
        equations.gradient[last, k] += problem.anchor_stiffness[k // 3] * (control[last, k] - problem.anchor[k])
    return problems.anchor_cost(problem, control)


@jit_borrowing
def _add_reach(problem, control, i, equations):
    e = 0.0
    for k in range(i, min(i + LANES, len(problem.time) - 1)):
        for end in range(2):
            if not problem.fixed[k + end]:
                e += cost.add_reach(
                    control[k + end], problem.end_origin[end, :, :, k], problem.end_standing[end, :, k], problem.max_length,
                    problem.comfort_weight, equations.diagonal[k + end], equations.gradient[k + end],
                )  # fmt: skip
    return e
