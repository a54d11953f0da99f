"""Banded equations by L D L^T, column by column, in time linear in the unknowns.

With d the pivot of a column, l = column / d below it; each of the columns to the right that it reaches loses l times what
stands in its row, as Lanes, and so does the right side. Backward, L^T step = D^-1 L^-1 (-gradient).
"""

from typing import Any

import numpy as np

from motion.com.equations import BAND, Equations
from motion.track.basis import Basis, is_fixed
from worlds.compiled.across import lane, shifted
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import fused, lanes_of, load, store

DAMPING = 1e-9
"""Share of the diagonal that is added to it: keeps directions that nothing holds from running away."""
_LEAST = 1e-12


@jit_inline
def _hold(equations: Equations, column: int) -> None:
    """An unknown that does not move: no equation is left of it."""
    band = equations.band
    band[column, 0], equations.gradient[column] = 1.0, 0.0
    for k in range(1, BAND):
        band[column, k] = 0.0
        if k <= column:
            band[column - k, k] = 0.0


@jit_inline
def _left_of(band: np.ndarray, column: int, s: float, x: Any, y: Any, w: Any) -> tuple[Any, Any, Any]:
    """A column less s times the lanes x, y and w, from its pivot down."""
    return fused(-s, x, load(band, (column, 0))), fused(-s, y, load(band, (column, 4))), fused(-s, w, load(band, (column, 8)))


@jit_inline
def _take_one(band: np.ndarray, column: int, s: float, x: Any) -> None:
    """A column loses s times the lanes x, from its pivot down."""
    store(band, (column, 0), fused(-s, x, load(band, (column, 0))))


@jit_inline
def _take_two(band: np.ndarray, column: int, s: float, x: Any, y: Any) -> None:
    _take_one(band, column, s, x)
    store(band, (column, 4), fused(-s, y, load(band, (column, 4))))


@jit_inline
def _take_three(band: np.ndarray, column: int, s: float, x: Any, y: Any, w: Any) -> None:
    _take_two(band, column, s, x, y)
    store(band, (column, 8), fused(-s, w, load(band, (column, 8))))


@jit_inline
def _eliminate(band: np.ndarray, c: int, x: Any, y: Any, w: Any, inverse: float) -> tuple[Any, Any, Any, Any, Any, Any]:
    """L of a column x, y, w, which replaces it below its pivot, taken from the columns that it reaches; L, and the next column.

    Both stay in registers: read again from where they were just written, at other places, they would be waited for.
    """
    none = lanes_of(0.0, 0.0, 0.0, 0.0)
    u, v, t = x * inverse, y * inverse, w * inverse
    store(band, (c, 0), u)
    store(band, (c, 4), v)
    store(band, (c, 8), t)
    band[c, 0] = 0.0
    after = _left_of(band, c + 1, lane(u, 1), shifted(x, y, 1), shifted(y, w, 1), shifted(w, none, 1))
    _take_three(band, c + 2, lane(u, 2), shifted(x, y, 2), shifted(y, w, 2), shifted(w, none, 2))
    _take_three(band, c + 3, lane(u, 3), shifted(x, y, 3), shifted(y, w, 3), shifted(w, none, 3))
    _take_two(band, c + 4, lane(v, 0), y, w)
    _take_two(band, c + 5, lane(v, 1), shifted(y, w, 1), shifted(w, none, 1))
    _take_two(band, c + 6, lane(v, 2), shifted(y, w, 2), shifted(w, none, 2))
    _take_two(band, c + 7, lane(v, 3), shifted(y, w, 3), shifted(w, none, 3))
    _take_one(band, c + 8, lane(t, 0), w)
    _take_one(band, c + 9, lane(t, 1), shifted(w, none, 1))
    _take_one(band, c + 10, lane(t, 2), shifted(w, none, 2))
    _take_one(band, c + 11, lane(t, 3), shifted(w, none, 3))
    return u, v, t, after[0], after[1], after[2]


@jit_inline
def _eliminate_all(band: np.ndarray, z: np.ndarray, n: int) -> None:
    """The band of n columns becomes L, and the right side z becomes D^-1 L^-1 z; what comes next of both is in registers.

    One pivot waits for the other, so the next one is reckoned by itself, as its lane is.
    """
    x, y, w = load(band, (0, 0)), load(band, (0, 4)), load(band, (0, 8))
    p, q, r, pivot = load(z, (0,)), load(z, (4,)), load(z, (8,)), band[0, 0]
    for c in range(n):
        inverse, own, below = 1 / max(pivot, _LEAST), lane(p, 0), lane(x, 1)
        pivot = fused(-below * inverse, below, band[c + 1, 0])
        u, v, t, x, y, w = _eliminate(band, c, x, y, w, inverse)
        z[c] = own * inverse
        p, q, r = fused(u, -own, p), fused(v, -own, q), fused(t, -own, r)
        p, q, r = shifted(p, q, 1), shifted(q, r, 1), shifted(r, load(z, (c + BAND,)), 1)


@jit_borrowing
def solve(fixed: np.ndarray, basis: Basis, equations: Equations, step: np.ndarray) -> float:
    """Fills step (3 n + WIDTH,) with -(H + DAMPING diag H)^-1 gradient, zero at what is fixed.

    Returns the predicted decrease of E. The equations are used up, but for their gradient.
    """
    band, gradient, n = equations.band, equations.gradient, len(basis.knot) - 4
    for j in range(n):
        if is_fixed(basis, fixed, j):
            for axis in range(3):
                _hold(equations, 3 * j + axis)
    for c in range(len(step)):
        step[c] = -gradient[c]
    for c in range(3 * n):
        band[c, 0] *= 1 + DAMPING
    _eliminate_all(band, step, 3 * n)
    return _substitute(band, gradient, step, 3 * n)


@jit_inline
def _substitute(band: np.ndarray, gradient: np.ndarray, step: np.ndarray, n: int) -> float:
    """L^T step = the right side that step holds, n unknowns, the last first; returns the predicted decrease of E.

    The twelve that were found last stay in registers, as in _eliminate, with 0 for the one that is sought. The newest is
    waited for: all else of a sum is there before.
    """
    decrease, newest, none, second = 0.0, 0.0, lanes_of(0.0, 0.0, 0.0, 0.0), lanes_of(0.0, 1.0, 0.0, 0.0)
    x, y, w = none, none, none
    for c in range(n - 1, -1, -1):
        later, last = load(band, (c, 4)) * y, load(band, (c, 8)) * w
        sums = load(band, (c, 0)) * x + later + last
        first = band[c, 1] * newest + lane(later, 1) + lane(last, 1)
        found = step[c] - (lane(sums, 0) + first + lane(sums, 2) + lane(sums, 3))
        decrease -= 0.5 * gradient[c] * found
        step[c] = found
        x += newest * second
        x, y, w, newest = shifted(none, x, 3), shifted(x, y, 3), shifted(y, w, 3), found
    return decrease
