"""The normal equations of E: every sample's model spread over the coefficients of its piece (motion.track.basis).

With h_k the weights of the piece's four coefficients in the com and bend_k those in the acceleration, both polynomials in the
share s of the piece, a sample's model (motion.com.cost) sees omega_k = bend_k / T^2 - phi h_k, so it adds omega_k omega_l M +
h_k h_l C to the 3x3 block of coefficients k and l, C the comfort's matrix: ten symmetric blocks, 120 multiply-adds per sample,
WIDE pieces at once. A coefficient couples with the next three, so H is a band of twelve.
"""

from typing import NamedTuple

import numpy as np

from motion.com import cost, springs
from motion.com import problem as problems
from motion.com.cost import ComfortModel, PhysicsModel, Three
from motion.com.pieces import Pieces, begin_weights, end_weights, lay_jerk, mix_all, pieces_from, weights_at
from motion.com.problem import Problem
from motion.track.basis import ORDER, Basis
from motion.track.curve import Weights
from motion.track.footprints import LEFT, RIGHT
from worlds.compiled.across import bits_of, isnt, total, total_in_turn, turned
from worlds.compiled.beside.places import counted, each_of, load_wide
from worlds.compiled.beside.wide import WIDE
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.lanes import LANES, Some, fused, load, root, store

BAND, WIDTH = 12, 16
"""Entries of a column from the diagonal down; with room for Lanes that begin at any of them."""

_NOTHING = 10 * 6
"""The row of a piece's blocks that stays 0."""


def _laid_down() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """How a piece's blocks lie in the band, LANES entries of a column after the other: their column in the piece's own, how far
    below its diagonal they begin, and (N, LANES) the rows of the blocks that they are.

    From the last column back, so that of pieces that share a column of the band the first one adds first.
    """
    column, down, entry = [], [], []
    for c in reversed(range(BAND)):
        for d in range(0, BAND - c, LANES):
            column.append(c)
            down.append(d)
            entry.append([_row_of(c + d + k, c) if c + d + k < BAND else _NOTHING for k in range(LANES)])
    return np.array(column), np.array(down), np.array(entry)


def _row_of(row: int, column: int) -> int:
    """The row of the blocks in which an entry of a piece's twelve equations lies, from the diagonal down."""
    (k, r), (j, c) = divmod(row, 3), divmod(column, 3)
    low, high = min(r, c), max(r, c)  # of a block the lower triangle is there, for it is symmetric
    return 6 * (k * (k + 1) // 2 + j) + high * (high + 1) // 2 + low


_COLUMN, _DOWN, _ENTRY = _laid_down()


class Equations(NamedTuple):
    """H step = -gradient of n coefficients: 3 n unknowns."""

    band: np.ndarray  # (3 n + BAND, WIDTH) [column, row - column], the lower triangle
    gradient: np.ndarray  # (3 n + WIDTH,)
    blocks: np.ndarray  # (61, WIDE) of WIDE pieces: ten lower triangles of six, coefficients k >= l as 00 10 11 20 ...; zero
    slopes: np.ndarray  # (4, 3, WIDE) their gradients


@jit
def empty_equations(n: int) -> Equations:
    """Of n coefficients."""
    return Equations(
        np.zeros((3 * n + BAND, WIDTH)), np.zeros(3 * n + WIDTH), np.zeros((_NOTHING + 1, WIDE)), np.zeros((4, 3, WIDE))
    )


@jit_inline
def _add_both(rows: np.ndarray, first: int, a: Some, physics: tuple, b: Some, comfort: tuple) -> None:
    """The rows from `first` on get a times the numbers of one model and b times those of another."""
    for r in range(len(physics)):
        store(rows, (first + r, 0), fused(a, physics[r], fused(b, comfort[r], load_wide(rows, (first + r, 0)))))


@jit_inline
def _add_models(
    equations: Equations, scale: Some, omega: Weights, physics: PhysicsModel, h: Weights, comfort: ComfortModel
) -> None:
    """Spreads a sample's models, `scale` times, over the pieces' coefficients, by their weights in what each model sees."""
    n = 0
    for k in range(ORDER):
        a, b = scale * omega[k], scale * h[k]
        for j in range(k + 1):
            _add_both(equations.blocks, 6 * n, a * omega[j], physics.matrix, b * h[j], comfort.matrix)
            n += 1
        _add_both(equations.slopes[k], 0, a, physics.gradient, b, comfort.gradient)


@jit_inline
def _add_scaled(rows: np.ndarray, first: int, a: Some, numbers: tuple) -> None:
    """The rows from `first` on get a times the numbers, of which there are as many as of a gradient, or of a lower triangle."""
    for r in range(len(numbers)):
        store(rows, (first + r, 0), fused(a, numbers[r], load_wide(rows, (first + r, 0))))


@jit_inline
def _add_model(equations: Equations, scale: Some, h: Weights, model: PhysicsModel | ComfortModel) -> None:
    """Spreads one model, `scale` times, over the pieces' coefficients, by their weights in what it sees."""
    n = 0
    for k in range(ORDER):
        for j in range(k + 1):
            _add_scaled(equations.blocks, 6 * n, scale * h[k] * h[j], model.matrix)
            n += 1
        _add_scaled(equations.slopes[k], 0, scale * h[k], model.gradient)


@jit_inline
def _put_pieces(equations: Equations, first: np.ndarray, i: int, count: int) -> None:
    """Adds the blocks of so many pieces from i on to the equations of their coefficients, the `first` of which each has."""
    for k in range(0, count, LANES):
        _put_blocks(equations, first, i, k, count - k)
    for k in range(count):
        for j in range(ORDER):
            for axis in range(3):
                equations.gradient[3 * (first[i + k] + j) + axis] += equations.slopes[j, axis, k]


@jit_inline
def _put_blocks(equations: Equations, first: np.ndarray, i: int, k: int, count: int) -> None:
    """Adds the blocks of LANES pieces from i + k on, or of the `count` that there are."""
    band, blocks = equations.band, equations.blocks
    for n in range(len(_COLUMN)):
        c, d = _COLUMN[n], _DOWN[n]
        x, y, z, w = turned(
            load(blocks, (_ENTRY[n, 0], k)), load(blocks, (_ENTRY[n, 1], k)), load(blocks, (_ENTRY[n, 2], k)),
            load(blocks, (_ENTRY[n, 3], k)),
        )  # fmt: skip
        _add_down(band, 3 * first[i + k] + c, d, x)
        if count > 1:
            _add_down(band, 3 * first[i + k + 1] + c, d, y)
        if count > 2:
            _add_down(band, 3 * first[i + k + 2] + c, d, z)
        if count > 3:
            _add_down(band, 3 * first[i + k + 3] + c, d, w)


@jit_inline
def _add_down(band: np.ndarray, column: int, down: int, x: Some) -> None:
    store(band, (column, down), load(band, (column, down)) + x)


@jit_inline
def _both(left: ComfortModel, right: ComfortModel) -> ComfortModel:
    """The two legs' models as one, for which nobody asks what it costs."""
    g, h, m, n = left.gradient, right.gradient, left.matrix, right.matrix
    matrix = (m[0] + n[0], m[1] + n[1], m[2] + n[2], m[3] + n[3], m[4] + n[4], m[5] + n[5])
    return ComfortModel(left.cost, (g[0] + h[0], g[1] + h[1], g[2] + h[2]), matrix)


@jit_inline
def _add_strength(problem: Problem, pieces: Pieces, w: Three, bends: Weights, equations: Equations) -> Some:
    """Adds what a force beyond the character's strength costs at a sample; returns it in lanes."""
    model = cost.strength_model(w, problem.strength, problem.strength_weight)
    _add_model(equations, pieces.scale, bends, model)
    return pieces.scale * model.size


@jit_inline
def _sum_samples(problem: Problem, pieces: Pieces, i: int, eps: float, equations: Equations) -> Some:
    """Fills blocks and slopes with the models of all samples of the pieces from i on; returns their E in lanes."""
    samples = problem.support_point.shape[0]
    e = lay_jerk(samples * problem.jerk_weight, pieces, equations.blocks, equations.slopes)
    gravity = load_wide(problem.gravity, (i,))
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
def _reach_of_leg(problem: Problem, i: int, end: int, leg: int, com: Three) -> ComfortModel:
    """motion.com.cost.reach_model of one leg at one end of the pieces from i on, where that can move."""
    held = each_of(problem.fixed, counted(i, len(problem.time) - 1) + end, ())
    on = load_wide(problem.end_standing, (end, leg, i)) & isnt(held)
    limit = load_wide(problem.end_reach, (end, leg, i)) * problem.max_length[leg]
    return cost.reach_model(com, problems.triple(problem.end_origin, end, leg, i), on, limit, problem.comfort_weight)


@jit_inline
def _add_reach_at(problem: Problem, pieces: Pieces, i: int, end: int, h: Weights, equations: Equations) -> Some:
    """Adds the reach penalties at one end of the pieces from i on; returns them in lanes. h: weights of the com there."""
    com, none = mix_all(h, pieces), 0.0 * pieces.scale
    if not problems.reaches_beyond(problem, i, end, com):
        return none
    left, right = _reach_of_leg(problem, i, end, LEFT, com), _reach_of_leg(problem, i, end, RIGHT, com)
    _add_model(equations, none + 1.0, h, _both(left, right))
    return left.cost + right.cost


@jit_borrowing
def assemble(problem: Problem, basis: Basis, coefficients: np.ndarray, eps: float, equations: Equations) -> float:
    """Fills the equations at coefficients (n, 3); returns the smoothed E."""
    equations.band[:] = 0.0
    equations.gradient[:] = 0.0
    m, e = len(problem.time) - 1, _add_anchor(problem, basis, coefficients, equations)
    for n in range(len(problem.pull)):
        e += springs.add_pull(problem.pull[n], basis, coefficients, equations.gradient, equations.band)
    for i in range(0, m, WIDE):
        pieces = pieces_from(problem.time, problem.weight, problem.support_point.shape[0], basis, coefficients, i)
        e += total(_sum_samples(problem, pieces, i, eps, equations))
        begins = _add_reach_at(problem, pieces, i, 0, begin_weights(pieces), equations)
        ends = _add_reach_at(problem, pieces, i, 1, end_weights(pieces), equations)
        e += total_in_turn(begins, ends)
        _put_pieces(equations, basis.first, i, min(WIDE, m - i))
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
