"""The normal equations of E: every sample's model spread over the coefficients of its piece (motion.track.basis).

With h_k the weights of the piece's four coefficients in the com and bend_k those in the acceleration, both polynomials in the
share s of the piece, a sample's model (motion.com.cost) sees omega_k = bend_k / T^2 - phi h_k, so it adds omega_k omega_l M +
h_k h_l C to the 3x3 block of coefficients k and l, C the comfort's matrix: ten symmetric blocks, 120 multiply-adds per sample,
LANES pieces at once. A coefficient couples with the next three, so H is a band of twelve.
"""

from typing import Any, NamedTuple

import numpy as np

from motion.com import cost, springs
from motion.com import problem as problems
from motion.com.cost import ComfortModel, PhysicsModel, Some, Three
from motion.com.pieces import Pieces, lay_jerk, mix_all, pieces_from, weights_at
from motion.com.problem import Problem
from motion.track.basis import ORDER, Basis, end_weight
from motion.track.curve import Weights
from motion.track.footprints import LEFT, RIGHT
from worlds.compiled.across import bits_of, total
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.lanes import LANES, load, root, store

BAND, WIDTH = 12, 16
"""Entries of a column from the diagonal down; with room for Lanes that begin at any of them."""


class Equations(NamedTuple):
    """H step = -gradient of n coefficients: 3 n unknowns."""

    band: np.ndarray  # (3 n + BAND, WIDTH) [column, row - column], the lower triangle
    gradient: np.ndarray  # (3 n + WIDTH,)
    blocks: np.ndarray  # (10, 6, LANES) of LANES pieces: coefficients k >= l as 00 10 11 20 21 22 30 ..., lower triangles
    slopes: np.ndarray  # (4, 3, LANES) their gradients


@jit
def empty_equations(n: int) -> Equations:
    """Of n coefficients."""
    return Equations(
        np.zeros((3 * n + BAND, WIDTH)), np.zeros(3 * n + WIDTH), np.zeros((10, 6, LANES)), np.zeros((4, 3, LANES))
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
def _add_models(
    equations: Equations, scale: Some, omega: Weights, physics: PhysicsModel, h: Weights, comfort: ComfortModel
) -> None:
    """Spreads a sample's models, `scale` times, over the pieces' coefficients, by their weights in what each model sees."""
    blocks, slopes = equations.blocks, equations.slopes
    m, c, g, f = physics.matrix, comfort.matrix, physics.gradient, comfort.gradient
    o0, o1, o2, o3 = omega
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
def _put_block(band: np.ndarray, k: int, row: int, column: int, block: np.ndarray, lane: int) -> None:
    """Adds the 3x3 block of coefficients `row` >= `column` to the band."""
    c, d = 3 * column, 3 * (row - column)
    x, y, z = block[k, 0, lane], block[k, 1, lane], block[k, 2, lane]
    u, v, w = block[k, 3, lane], block[k, 4, lane], block[k, 5, lane]
    band[c, d] += x
    band[c, d + 1] += y
    band[c, d + 2] += u
    band[c + 1, d] += z
    band[c + 1, d + 1] += v
    band[c + 2, d] += w
    if d > 0:  # of a block on the diagonal the lower triangle counts
        band[c + 1, d - 1] += y
        band[c + 2, d - 2] += u
        band[c + 2, d - 1] += v


@jit_inline
def _put_piece(equations: Equations, first: int, lane: int) -> None:
    """Adds a lane's blocks to the equations of its four coefficients."""
    n = 0
    for k in range(ORDER):
        for j in range(k + 1):
            _put_block(equations.band, n, first + k, first + j, equations.blocks, lane)
            n += 1
        for axis in range(3):
            equations.gradient[3 * (first + k) + axis] += equations.slopes[k, axis, lane]


@jit_inline
def _both(left: ComfortModel, right: ComfortModel) -> ComfortModel:
    """The two legs' models as one, for which nobody asks what it costs."""
    g, h, m, n = left.gradient, right.gradient, left.matrix, right.matrix
    matrix = (m[0] + n[0], m[1] + n[1], m[2] + n[2], m[3] + n[3], m[4] + n[4], m[5] + n[5])
    return ComfortModel(left.cost, (g[0] + h[0], g[1] + h[1], g[2] + h[2]), matrix)


@jit_inline
def _nothing(like: Some) -> ComfortModel:
    zero = 0.0 * like
    return ComfortModel(zero, (zero, zero, zero), (zero, zero, zero, zero, zero, zero))


@jit_inline
def _add_strength(problem: Problem, pieces: Pieces, w: Three, bends: Weights, equations: Equations) -> Some:
    """Adds what a force beyond the character's strength costs at a sample; returns it in lanes."""
    model = cost.strength_model(w, problem.strength, problem.strength_weight)
    _add_models(equations, pieces.scale, bends, model, bends, _nothing(pieces.scale))
    return pieces.scale * model.size


@jit_inline
def _sum_samples(problem: Problem, pieces: Pieces, i: int, eps: float, equations: Equations) -> Some:
    """Fills blocks and slopes with the models of all samples of the pieces from i on; returns their E in lanes."""
    samples = problem.support_point.shape[0]
    e = lay_jerk(samples * problem.jerk_weight, pieces, equations.blocks, equations.slopes)
    gravity = load(problem.gravity, (i,))
    for j in range(samples):
        h, bends = weights_at(pieces, (j + 0.5) / samples)
        com, (x, y, z) = mix_all(h, pieces), mix_all(bends, pieces)
        w = (x, y, z + gravity)
        physics = problems.physics_of_sample(problem, i, j, com, w, eps)
        left = problems.comfort_of_leg(problem, i, j, LEFT, com)
        right = problems.comfort_of_leg(problem, i, j, RIGHT, com)
        e += pieces.scale * (cost.smooth_norm(physics.size, eps) + left.cost + right.cost)
        phi = physics.phi
        omega = (bends[0] - phi * h[0], bends[1] - phi * h[1], bends[2] - phi * h[2], bends[3] - phi * h[3])
        _add_models(equations, pieces.scale, omega, physics, h, _both(left, right))
        if bits_of(root(x * x + y * y + w[2] * w[2]) > problem.strength) != 0:
            e += _add_strength(problem, pieces, w, bends, equations)
    return e


@jit_inline
def _beyond(problem: Problem, pieces: Pieces, i: int) -> int:
    """Bits of those pieces from i on at whose beginnings a leg is longer than max_length, and then of those at whose ends."""
    begins = problems.beyond(problem, i, 0, mix_all(weights_at(pieces, 0.0)[0], pieces))
    return begins | (problems.beyond(problem, i, 1, mix_all(weights_at(pieces, 1.0)[0], pieces)) << LANES)


@jit_inline
def _add_reach_at(
    problem: Problem, basis: Basis, coefficients: np.ndarray, piece: int, end: int, lane: int, equations: Equations
) -> float:
    """Adds the reach penalty at one end of a piece to the blocks of its lane."""
    first, x, y, z, n = basis.first[piece], 0.0, 0.0, 0.0, 0
    for k in range(ORDER):
        h = end_weight(basis, k, piece, end)
        x, y = x + h * coefficients[first + k, 0], y + h * coefficients[first + k, 1]
        z += h * coefficients[first + k, 2]
    share, limit = problem.end_reach[end, piece], problem.max_length
    e, slope, matrix = cost.reach_model(
        (x, y, z), problem.end_origin[end, :, :, piece], problem.end_standing[end, :, piece],
        (share * limit[0], share * limit[1]), problem.comfort_weight,
    )  # fmt: skip
    for k in range(ORDER):
        h = end_weight(basis, k, piece, end)
        if h == 0.0:  # one of the four begins or ends there
            n += k + 1
            continue
        for axis in range(3):
            equations.slopes[k, axis, lane] += h * slope[axis]
        for j in range(k + 1):
            g = end_weight(basis, j, piece, end)
            for r in range(6):
                equations.blocks[n, r, lane] += h * g * matrix[r]
            n += 1
    return e


@jit_borrowing
def _add_reach(problem: Problem, basis: Basis, coefficients: np.ndarray, i: int, beyond: int, equations: Equations) -> float:
    """Adds the reach penalties at those ends of the pieces from i on (_beyond) that can move to their blocks."""
    e = 0.0
    for lane in range(LANES):
        for end in range(2):
            if (beyond >> (end * LANES + lane)) & 1 and not problem.fixed[i + lane + end]:
                e += _add_reach_at(problem, basis, coefficients, i + lane, end, lane, equations)
    return e


@jit_borrowing
def assemble(problem: Problem, basis: Basis, coefficients: np.ndarray, eps: float, equations: Equations) -> float:
    """Fills the equations at coefficients (n, 3); returns the smoothed E."""
    equations.band[:] = 0.0
    equations.gradient[:] = 0.0
    m, e = len(problem.time) - 1, _add_anchor(problem, basis, coefficients, equations)
    for n in range(len(problem.pull)):
        e += springs.add_pull(problem.pull[n], basis, coefficients, equations.gradient, equations.band)
    for i in range(0, m, LANES):
        pieces = pieces_from(problem.time, problem.weight, problem.support_point.shape[0], basis, coefficients, i)
        e += total(_sum_samples(problem, pieces, i, eps, equations))
        beyond = _beyond(problem, pieces, i)
        if beyond != 0:
            e += _add_reach(problem, basis, coefficients, i, beyond, equations)
        for lane in range(min(LANES, m - i)):
            _put_piece(equations, basis.first[i + lane], lane)
    return e


@jit_borrowing
def _add_anchor(problem: Problem, basis: Basis, coefficients: np.ndarray, equations: Equations) -> float:
    """The springs at the end: its place is the last coefficient, its velocity a difference of the last two."""
    n, e, stiff = len(coefficients), 0.0, problem.anchor_stiffness
    rate = 3 / (problem.time[-1] - problem.time[basis.knot[n - 1]])
    for axis in range(3):
        last, before = 3 * (n - 1) + axis, 3 * (n - 2) + axis
        place = coefficients[n - 1, axis] - problem.anchor[axis]
        speed = rate * (coefficients[n - 1, axis] - coefficients[n - 2, axis]) - problem.anchor[3 + axis]
        e += 0.5 * (stiff[0] * place * place + stiff[1] * speed * speed)
        equations.gradient[last] += stiff[0] * place + stiff[1] * rate * speed
        equations.gradient[before] -= stiff[1] * rate * speed
        equations.band[last, 0] += stiff[0] + stiff[1] * rate * rate
        equations.band[before, 0] += stiff[1] * rate * rate
        equations.band[before, 3] -= stiff[1] * rate * rate
    return e
