"""Pieces of a curve in Lanes: the coefficients that WIDE of them depend on, and their weights at a share of the piece."""

from typing import NamedTuple

import numpy as np

from motion.com.cost import Three, mix
from motion.track.basis import ORDER, Basis
from motion.track.curve import Weights
from worlds.compiled.beside.places import counted, counting, each_of, load_wide
from worlds.compiled.jit import jit_inline
from worlds.compiled.lanes import Some, fused, store


class Pieces(NamedTuple):
    """WIDE pieces from one on; beyond the last lie copies of it that count for nothing."""

    duration: Some  # lanes [s]
    scale: Some  # lanes: time per sample [s]
    bend: Some  # lanes: 1 / T^2
    powers: tuple  # of the four coefficients' weights: (constant, s, s^2, s^3), lanes
    x: tuple  # the four coefficients along each axis, lanes
    y: tuple
    z: tuple


@jit_inline
def _powers(basis: Basis, k: int, i: int) -> Weights:
    weights = basis.weights
    return (
        load_wide(weights, (k, 0, i)),
        load_wide(weights, (k, 1, i)),
        load_wide(weights, (k, 2, i)),
        load_wide(weights, (k, 3, i)),
    )


@jit_inline
def _along(coefficients: np.ndarray, first: Some, axis: int) -> Weights:
    c, at = coefficients, (axis,)
    return each_of(c, first, at), each_of(c, first + 1, at), each_of(c, first + 2, at), each_of(c, first + 3, at)


@jit_inline
def pieces_from(time: np.ndarray, weight: np.ndarray, samples: int, basis: Basis, coefficients: np.ndarray, i: int) -> Pieces:
    """The Pieces from i on, of those between time (m + 1,), of weight (M,), with so many samples each."""
    at = counted(i, len(time) - 1)
    duration, first = each_of(time, at + 1, ()) - each_of(time, at, ()), each_of(basis.first, at, ())
    scale = counting(i, len(time) - 1) * load_wide(weight, (i,)) * duration / samples
    powers = (_powers(basis, 0, i), _powers(basis, 1, i), _powers(basis, 2, i), _powers(basis, 3, i))
    return Pieces(
        duration, scale, 1 / (duration * duration), powers,
        _along(coefficients, first, 0), _along(coefficients, first, 1), _along(coefficients, first, 2),
    )  # fmt: skip


@jit_inline
def _share_of(p: Weights, s: float) -> Some:
    return fused(fused(fused(p[3], s, p[2]), s, p[1]), s, p[0])


@jit_inline
def _bend_of(p: Weights, bend: Some, s: float) -> Some:
    return bend * (2 * p[2] + (6 * s) * p[3])


@jit_inline
def weights_at(pieces: Pieces, s: float) -> tuple[Weights, Weights]:
    """Weights of the coefficients in the com and in the acceleration at share s."""
    p, bend = pieces.powers, pieces.bend
    return (
        (_share_of(p[0], s), _share_of(p[1], s), _share_of(p[2], s), _share_of(p[3], s)),
        (_bend_of(p[0], bend, s), _bend_of(p[1], bend, s), _bend_of(p[2], bend, s), _bend_of(p[3], bend, s)),
    )


@jit_inline
def begin_weights(pieces: Pieces) -> Weights:
    """Weights of the coefficients in the com where the pieces begin."""
    p = pieces.powers
    return p[0][0], p[1][0], p[2][0], p[3][0]


@jit_inline
def end_weights(pieces: Pieces) -> Weights:
    """The same where they end."""
    p = pieces.powers
    return _sum_of(p[0]), _sum_of(p[1]), _sum_of(p[2]), _sum_of(p[3])


@jit_inline
def _sum_of(p: Weights) -> Some:
    return p[0] + p[1] + p[2] + p[3]


@jit_inline
def mix_all(w: Weights, pieces: Pieces) -> Three:
    return mix(w, pieces.x), mix(w, pieces.y), mix(w, pieces.z)


@jit_inline
def _set_block(blocks: np.ndarray, first: int, size: Some) -> None:
    """The block whose rows begin at `first` becomes size times the identity."""
    zero = 0.0 * size
    store(blocks, (first, 0), size)
    store(blocks, (first + 1, 0), zero)
    store(blocks, (first + 2, 0), size)
    store(blocks, (first + 3, 0), zero)
    store(blocks, (first + 4, 0), zero)
    store(blocks, (first + 5, 0), size)


@jit_inline
def lay_jerk(weight: float, pieces: Pieces, blocks: np.ndarray, slopes: np.ndarray) -> Some:
    """Blocks and slopes (motion.com.equations.Equations) become those of weight |jerk|^2 in every sample; returns it in lanes.

    The same along each axis, and constant over a piece: the blocks are multiples of the identity.
    """
    p, third, n = pieces.powers, pieces.bend / pieces.duration, 0
    w = (6 * third * p[0][3], 6 * third * p[1][3], 6 * third * p[2][3], 6 * third * p[3][3])
    x, y, z = mix_all(w, pieces)
    scale = weight * pieces.scale
    for k in range(ORDER):
        a = scale * w[k]
        for j in range(k + 1):
            _set_block(blocks, 6 * n, a * w[j] * 2.0)
            n += 1
        store(slopes, (k, 0, 0), a * (2 * x))
        store(slopes, (k, 1, 0), a * (2 * y))
        store(slopes, (k, 2, 0), a * (2 * z))
    return scale * (x * x + y * y + z * z)
