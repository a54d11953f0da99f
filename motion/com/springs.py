"""Springs on the curve: those that hold its end, and those that pull the com at a time toward a place.

A spring of stiffness k [1/s/m] that pulls the com c(t) toward q costs k / 2 |c(t) - q|^2; as c(t) = sum h_j C_j in the four
coefficients C_j of its piece, it adds k h_i (c(t) - q) to their gradients and k h_i h_j to their equations, exactly.
"""

import numpy as np

from motion.track.basis import ORDER, Basis
from motion.track.curve import position_weights
from worlds.compiled.jit import jit_borrowing, jit_inline

PULL = 6
"""Numbers of a spring that pulls: segment, share of it, place [m], stiffness [1/s/m]."""


@jit_borrowing
def anchor_cost(anchor: np.ndarray, stiffness: np.ndarray, control: np.ndarray) -> float:
    """Energy of the springs that hold the last control point: of its position and of its velocity."""
    e, last = 0.0, len(control) - 1
    for k in range(6):
        e += 0.5 * stiffness[k // 3] * (control[last, k] - anchor[k]) ** 2
    return e


@jit_borrowing
def pull_cost(pulls: np.ndarray, time: np.ndarray, control: np.ndarray) -> float:
    """Energy of springs (P, PULL) on the curve of control points (m + 1, 6)."""
    e = 0.0
    for n in range(len(pulls)):
        i = int(pulls[n, 0])
        h = position_weights(pulls[n, 1], time[i + 1] - time[i])
        for k in range(3):
            place = h[0] * control[i, k] + h[1] * control[i, 3 + k] + h[2] * control[i + 1, k] + h[3] * control[i + 1, 3 + k]
            e += 0.5 * pulls[n, 5] * (place - pulls[n, 2 + k]) ** 2
    return e


@jit_inline
def _weight_at(w: np.ndarray, k: int, s: float) -> float:
    """Weight of coefficient k of a piece at the share s of it."""
    return w[k, 0] + s * (w[k, 1] + s * (w[k, 2] + s * w[k, 3]))


@jit_borrowing
def add_pull(pull: np.ndarray, basis: Basis, coefficients: np.ndarray, gradient: np.ndarray, band: np.ndarray) -> float:
    """A spring on the com at one time: its place is a mixture of the four coefficients of its piece. Returns its energy."""
    piece, s, stiff, e = int(pull[0]), pull[1], pull[5], 0.0
    first, w = basis.first[piece], basis.weights[:, :, piece]
    for axis in range(3):
        off = -pull[2 + axis]
        for k in range(ORDER):
            off += _weight_at(w, k, s) * coefficients[first + k, axis]
        e += 0.5 * stiff * off * off
        for k in range(ORDER):
            h = _weight_at(w, k, s)
            gradient[3 * (first + k) + axis] += stiff * off * h
            for j in range(k + 1):
                band[3 * (first + j) + axis, 3 * (k - j)] += stiff * h * _weight_at(w, j, s)
    return e
