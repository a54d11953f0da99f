"""The normal equations of E: every sample's model spread over the control points around it.

With h_k the cubic and bend_k the linear weights of the four knots (p0, T v0, p1, T v1) of a segment in com and acceleration,
a sample's model (motion.com.cost) sees omega_k = bend_k / T^2 - phi h_k, so it adds omega_k omega_l M + h_k h_l C to the 3x3
block of knots k and l, C the comfort's matrix: ten symmetric blocks, 120 multiply-adds per sample, LANES segments at once.
"""

from typing import Any, NamedTuple

import numpy as np

from motion.com import cost
from motion.com import problem as problems
from motion.com.cost import ComfortModel, PhysicsModel, Some
from motion.com.problem import Problem, Segments
from motion.track.curve import Weights, acceleration_weights, position_weights
from motion.track.footprints import LEFT, RIGHT
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
def empty_equations(m: int) -> Equations:
    """Of m segments."""
    return Equations(
        np.zeros((m + 1, 6, ROWS)),
        np.zeros((m, 6, ROWS)),
        np.zeros((m + 1, 6)),
        np.zeros((10, 6, LANES)),
        np.zeros((4, 3, LANES)),
    )


@jit_inline
def _add_block(blocks: np.ndarray, n: int, a: Some, physics: Any, b: Some, comfort: Any) -> None:
    """blocks[n] += a physics + b comfort, for their lower triangles."""
    store(blocks, (n, 0, 0), load(blocks, (n, 0, 0)) + (a * physics[0] + b * comfort[0]))
    store(blocks, (n, 1, 0), load(blocks, (n, 1, 0)) + (a * physics[1] + b * comfort[1]))
    store(blocks, (n, 2, 0), load(blocks, (n, 2, 0)) + (a * physics[2] + b * comfort[2]))
    store(blocks, (n, 3, 0), load(blocks, (n, 3, 0)) + (a * physics[3] + b * comfort[3]))
    store(blocks, (n, 4, 0), load(blocks, (n, 4, 0)) + (a * physics[4] + b * comfort[4]))
    store(blocks, (n, 5, 0), load(blocks, (n, 5, 0)) + (a * physics[5] + b * comfort[5]))


@jit_inline
def _add_slope(slopes: np.ndarray, k: int, a: Some, physics: Any, b: Some, comfort: Any) -> None:
    """slopes[k] += a physics + b comfort, for their gradients."""
    store(slopes, (k, 0, 0), load(slopes, (k, 0, 0)) + (a * physics[0] + b * comfort[0]))
    store(slopes, (k, 1, 0), load(slopes, (k, 1, 0)) + (a * physics[1] + b * comfort[1]))
    store(slopes, (k, 2, 0), load(slopes, (k, 2, 0)) + (a * physics[2] + b * comfort[2]))


@jit_inline
def _add_sample(
    equations: Equations, segments: Segments, h: Weights, bends: Weights, physics: PhysicsModel, comfort: ComfortModel
) -> None:
    """Spreads a sample's models over the segments' knots, whose weights are h in its com and `bends` in its acceleration."""
    blocks, slopes, bend, scale = equations.blocks, equations.slopes, segments.bend, segments.scale
    phi, m, c, g, f = physics.phi, physics.matrix, comfort.matrix, physics.gradient, comfort.gradient
    o0, o1, o2, o3 = (
        bend * bends[0] - phi * h[0],
        bend * bends[1] - phi * h[1],
        bend * bends[2] - phi * h[2],
        bend * bends[3] - phi * h[3],
    )
    a0, a1, a2, a3 = scale * o0, scale * o1, scale * o2, scale * o3
    p0, p1, p2, p3 = scale * h[0], scale * h[1], scale * h[2], scale * h[3]
    _add_block(blocks, 0, a0 * o0, m, p0 * h[0], c)
    _add_block(blocks, 1, a1 * o0, m, p1 * h[0], c)
    _add_block(blocks, 2, a1 * o1, m, p1 * h[1], c)
    _add_block(blocks, 3, a2 * o0, m, p2 * h[0], c)
    _add_block(blocks, 4, a2 * o1, m, p2 * h[1], c)
    _add_block(blocks, 5, a2 * o2, m, p2 * h[2], c)
    _add_block(blocks, 6, a3 * o0, m, p3 * h[0], c)
    _add_block(blocks, 7, a3 * o1, m, p3 * h[1], c)
    _add_block(blocks, 8, a3 * o2, m, p3 * h[2], c)
    _add_block(blocks, 9, a3 * o3, m, p3 * h[3], c)
    _add_slope(slopes, 0, a0, g, p0, f)
    _add_slope(slopes, 1, a1, g, p1, f)
    _add_slope(slopes, 2, a2, g, p2, f)
    _add_slope(slopes, 3, a3, g, p3, f)


@jit_inline
def _put(target: np.ndarray, i: int, column: int, row: int, blocks: np.ndarray, n: int, k: int, factor: float) -> None:
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
def _put_segment(equations: Equations, i: int, k: int, duration: float) -> None:
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
def _both(left: ComfortModel, right: ComfortModel) -> ComfortModel:
    """The two legs' models as one, for which nobody asks what it costs."""
    g, h, m, n = left.gradient, right.gradient, left.matrix, right.matrix
    matrix = (m[0] + n[0], m[1] + n[1], m[2] + n[2], m[3] + n[3], m[4] + n[4], m[5] + n[5])
    return ComfortModel(left.cost, (g[0] + h[0], g[1] + h[1], g[2] + h[2]), matrix)


@jit_inline
def _sum_samples(problem: Problem, segments: Segments, i: int, eps: float, equations: Equations) -> Some:
    """Fills blocks and slopes with the models of all samples of the segments from i on; returns their E in lanes."""
    samples = problem.support_point.shape[0]
    equations.blocks[:] = 0.0
    equations.slopes[:] = 0.0
    e = 0.0 * segments.scale
    for j in range(samples):
        s = (j + 0.5) / samples
        h, bends = position_weights(s, 1.0), acceleration_weights(s, 1.0)
        com, w = problems.state_of_sample(segments, h, bends)
        physics = problems.physics_of_sample(problem, i, j, com, w, eps)
        left = problems.comfort_of_leg(problem, i, j, LEFT, com)
        right = problems.comfort_of_leg(problem, i, j, RIGHT, com)
        e += segments.scale * (cost.smooth_norm(physics.size, eps) + left.cost + right.cost)
        _add_sample(equations, segments, h, bends, physics, _both(left, right))
    return e


@jit_borrowing
def assemble(problem: Problem, control: np.ndarray, eps: float, equations: Equations) -> float:
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
def _add_anchor(problem: Problem, control: np.ndarray, equations: Equations) -> float:
    last = len(control) - 1
    for k in range(6):
        equations.diagonal[last, k, k] += problem.anchor_stiffness[k // 3]
        equations.gradient[last, k] += problem.anchor_stiffness[k // 3] * (control[last, k] - problem.anchor[k])
    return problems.anchor_cost(problem, control)


@jit_borrowing
def _add_reach(problem: Problem, control: np.ndarray, i: int, equations: Equations) -> float:
    e = 0.0
    for k in range(i, min(i + LANES, len(problem.time) - 1)):
        for end in range(2):
            if not problem.fixed[k + end]:
                e += cost.add_reach(
                    control[k + end], problem.end_origin[end, :, :, k], problem.end_standing[end, :, k], problem.max_length,
                    problem.comfort_weight, equations.diagonal[k + end], equations.gradient[k + end],
                )  # fmt: skip
    return e
