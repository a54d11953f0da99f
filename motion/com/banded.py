"""Banded equations by L D L^T, column by column, in time linear in the unknowns.

With d the pivot of a column, l = column / d below it; each of the columns to the right that it reaches loses l times what
stands in its row, as Lanes, and so does the right side. Backward, L^T step = D^-1 L^-1 (-gradient).
"""

import numpy as np

from motion.com.equations import BAND, Equations
from motion.track.basis import Basis, is_fixed
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import LANES, load, store, total

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
def _eliminate(band: np.ndarray, z: np.ndarray, c: int) -> None:
    """L of a column, which replaces it below its pivot, taken from the columns and the right side that it reaches."""
    inverse = 1 / max(band[c, 0], _LEAST)
    for k in range(1, BAND):
        s = band[c, k] * inverse
        if s != 0.0:
            z[c + k] -= s * z[c]
            for q in range(0, BAND - k, LANES):
                store(band, (c + k, q), load(band, (c + k, q)) - s * load(band, (c, k + q)))
    band[c, 0] = 0.0
    for q in range(0, BAND, LANES):
        store(band, (c, q), load(band, (c, q)) * inverse)
    z[c] *= inverse


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
    for c in range(3 * n):
        _eliminate(band, step, c)
    decrease = 0.0
    for c in range(3 * n - 1, -1, -1):
        ahead = load(band, (c, 0)) * load(step, (c,)) + load(band, (c, 4)) * load(step, (c + 4,))
        step[c] -= total(ahead + load(band, (c, 8)) * load(step, (c + 8,)))
        decrease -= 0.5 * gradient[c] * step[c]
    return decrease
