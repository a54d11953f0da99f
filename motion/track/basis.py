"""The unknowns of a curve: coefficients of cubic B-splines on its pieces.

Between two pieces the acceleration is continuous (`smooth`: simple knots), so forces are, too; or it may jump there, and the
coefficients are the Bezier points of the paper's Hermite curve (double knots). With f a cubic about tau, the coefficient over
the knots t1, t2, t3 is its blossom

    c = f + f' (d1 + d2 + d3) / 3 + f'' (d1 d2 + d1 d3 + d2 d3) / 6 + f''' d1 d2 d3 / 6,    d = t - tau

(Ramshaw 1989); a curve becomes coefficients by it with tau the middle knot, exactly where it is such a spline.
"""

from typing import NamedTuple

import numpy as np

from motion.track.curve import acceleration_weights
from worlds.compiled.beside.wide import WIDE
from worlds.compiled.jit import jit, jit_borrowing, jit_inline

ORDER = 4
"""Coefficients that a cubic piece depends on."""


class Basis(NamedTuple):
    """n coefficients of m pieces."""

    first: np.ndarray  # (m + WIDE - 1,) the first coefficient of each piece
    weights: np.ndarray  # (4, 4, m + WIDE - 1) [coefficient, power of s, piece], s the share of the piece
    knot: np.ndarray  # (n + 4,) which of the pieces' ends each knot is
    smooth: bool


@jit
def basis_of(time: np.ndarray, smooth: bool) -> Basis:
    """Of pieces that end at time (m + 1,), with full knots at either end."""
    m, times = len(time) - 1, 1 if smooth else 2
    n = ORDER + times * (m - 1)
    first, weights, knot = (
        np.zeros(m + WIDE - 1, np.int64),
        np.zeros((ORDER, ORDER, m + WIDE - 1)),
        np.zeros(n + ORDER, np.int64),
    )
    basis = Basis(first, weights, knot, smooth)
    _lay_basis(time, times, basis)
    return basis


@jit_borrowing
def _lay_basis(time: np.ndarray, times: int, basis: Basis) -> None:
    """With knots that count so many times."""
    m, knot = len(time) - 1, basis.knot
    for k in range(len(knot)):
        knot[k] = min(max((k - ORDER) // times + 1, 0), m) if k >= ORDER else 0
    for i in range(m):
        basis.first[i] = times * i
        _lay_piece(time, knot, basis.first[i], basis.weights[:, :, i])


@jit_borrowing
def _lay_piece(time: np.ndarray, knot: np.ndarray, first: int, weights: np.ndarray) -> None:
    """Fills weights (4, 4) with the polynomials of the piece's four B-splines, by their recursion (de Boor 1972)."""
    span = first + ORDER - 1
    begin = time[knot[span]]
    duration = time[knot[span + 1]] - begin
    weights[:] = 0.0
    weights[ORDER - 1, 0] = 1.0
    for degree in range(1, ORDER):
        for row in range(ORDER - 1 - degree, ORDER):  # upward: row r of this degree needs rows r and r + 1 of the one before
            j = first + row
            low, high = time[knot[j]], time[knot[j + degree + 1]]
            rise = 1 / (time[knot[j + degree]] - low) if row >= ORDER - degree else 0.0
            fall = 1 / (high - time[knot[j + 1]]) if row < ORDER - 1 else 0.0
            for power in range(degree, -1, -1):
                before, under = weights[row, power], weights[row, power - 1] if power > 0 else 0.0
                value = rise * ((begin - low) * before + duration * under)
                if row < ORDER - 1:
                    before, under = weights[row + 1, power], weights[row + 1, power - 1] if power > 0 else 0.0
                    value += fall * ((high - begin) * before - duration * under)
                weights[row, power] = value


@jit
def coefficients_of(basis: Basis, time: np.ndarray, control: np.ndarray, bend: np.ndarray) -> np.ndarray:
    """Coefficients (n, 3) of a curve with control points (m + 1, 6) and accelerations bend (2, 3) at its ends."""
    out = np.empty((len(basis.knot) - ORDER, 3))
    lay_coefficients(basis, time, control, bend, out)
    return out


@jit_borrowing
def lay_coefficients(basis: Basis, time: np.ndarray, control: np.ndarray, bend: np.ndarray, out: np.ndarray) -> None:
    """coefficients_of, into out (n, 3)."""
    n, last = len(out), len(time) - 1
    for j in range(n):
        k = basis.knot[j + 2]
        if j < 3 and (j < 2 or basis.smooth):
            k = 0
        elif j >= n - 3 and (j >= n - 2 or basis.smooth):
            k = last
        d1, d2, d3 = time[basis.knot[j + 1]] - time[k], time[basis.knot[j + 2]] - time[k], time[basis.knot[j + 3]] - time[k]
        for axis in range(3):
            curvature = bend[0, axis] if k == 0 else (bend[1, axis] if k == last else _bend_at(time, control, k, axis))
            first = control[k, axis] + control[k, 3 + axis] * (d1 + d2 + d3) / 3
            out[j, axis] = first + curvature * (d1 * d2 + d1 * d3 + d2 * d3) / 6


@jit_borrowing
def _bend_at(time: np.ndarray, control: np.ndarray, k: int, axis: int) -> float:
    """Mean of the accelerations on both sides of control point k."""
    total = 0.0
    for i, s in ((k - 1, 1.0), (k, 0.0)):
        w = acceleration_weights(s, time[i + 1] - time[i])
        total += w[0] * control[i, axis] + w[1] * control[i, 3 + axis]
        total += w[2] * control[i + 1, axis] + w[3] * control[i + 1, 3 + axis]
    return 0.5 * total


@jit_inline
def end_weight(basis: Basis, k: int, piece: int, end: int) -> float:
    """Weight of a piece's coefficient k in the position where the piece begins, or, with `end`, where it ends."""
    w = basis.weights
    return w[k, 0, piece] + w[k, 1, piece] + w[k, 2, piece] + w[k, 3, piece] if end else w[k, 0, piece]


@jit_borrowing
def control_of(basis: Basis, time: np.ndarray, coefficients: np.ndarray, control: np.ndarray) -> None:
    """Fills control (m + 1, 6) with the positions and velocities at the ends of the pieces."""
    m = len(time) - 1
    for i in range(m + 1):
        piece, end = min(i, m - 1), int(i == m)
        duration = time[piece + 1] - time[piece]
        for axis in range(3):
            place = speed = 0.0
            for k in range(ORDER):
                w, c = basis.weights[k, :, piece], coefficients[basis.first[piece] + k, axis]
                place += c * end_weight(basis, k, piece, end)
                speed += c * (w[1] + 2 * w[2] + 3 * w[3] if end else w[1])
            control[i, axis], control[i, 3 + axis] = place, speed / duration


@jit_borrowing
def is_fixed(basis: Basis, fixed: np.ndarray, j: int) -> bool:
    """Whether coefficient j may not move, as the control points (m + 1,) `fixed` may not.

    Of a smooth curve only the ends can be fixed, with their acceleration.
    """
    n = len(basis.knot) - ORDER
    if basis.smooth:
        return (j < 3 and fixed[0]) or (j >= n - 3 and fixed[-1])
    return fixed[j // 2]
