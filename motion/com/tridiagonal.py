"""Block-tridiagonal equations by block LDL^T, a column of six and its right side in two Lanes, in time linear in the blocks.

Block row i is [B D B'^T | r]. Column by column, with d the pivot: l = column / d below the diagonal, and every column to the
right loses l times what stands in its row. The coupling B' to the next point is a continuation of the column, and r its row
6, so that both are eliminated by the same operation. What remains of r is z = D^-1 L^-1 r; backward, L^T step = z.
"""

from typing import NamedTuple

import numpy as np

from motion.com.cost import Some
from motion.com.equations import ROWS, Equations
from motion.com.problem import Problem
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.lanes import LANES, choose, lanes_of, load, store, total

DAMPING = 1e-6
"""Share of the diagonal that is added to it: keeps directions that nothing holds from running away."""
_LEAST = 1e-12


class Factor(NamedTuple):
    """Of m + 1 blocks, by columns."""

    own: np.ndarray  # (m + 1, 6, ROWS) L below its pivots in the own block, z in row 6
    next: np.ndarray  # (m + 1, 6, ROWS) L in the next block, z in row 6
    raw: np.ndarray  # (6, ROWS) the last block's `next`, not yet divided by the pivots
    step: np.ndarray  # (m + 1, 6)


@jit
def empty_factor(m: int) -> Factor:
    """For m segments."""
    return Factor(np.zeros((m + 1, 6, ROWS)), np.zeros((m + 1, 6, ROWS)), np.zeros((6, ROWS)), np.zeros((m + 1, 6)))


@jit_inline
def _clear(factor: Factor, i: int) -> None:
    """A point that does not move: no equation is left of it."""
    factor.own[i] = 0.0
    factor.next[i] = 0.0
    factor.raw[:] = 0.0


@jit_inline
def _load(equations: Equations, factor: Factor, i: int, coupled: bool) -> None:
    """Puts block i and its coupling to the next one in place, less what the one before leaves in it."""
    own, following, raw, p = factor.own, factor.next, factor.raw, i - 1
    for c in range(6):
        upper = load(equations.diagonal, (i, c, 0))
        lower = load(equations.diagonal, (i, c, LANES)) - lanes_of(0.0, 0.0, equations.gradient[i, c], 0.0)
        if i > 0:
            for k in range(6):
                upper -= load(following, (p, k, 0)) * raw[k, c]
                lower -= load(following, (p, k, LANES)) * raw[k, c]
        store(own, (i, c, 0), upper)
        store(own, (i, c, LANES), lower)
    for c in range(6):
        if coupled:
            store(raw, (c, 0), load(equations.lower, (i, c, 0)))
            store(raw, (c, LANES), load(equations.lower, (i, c, LANES)))
        else:
            store(raw, (c, 0), 0.0)
            store(raw, (c, LANES), 0.0)


@jit_inline
def _eliminate(equations: Equations, factor: Factor, i: int) -> None:
    """L of block i and of its coupling, column by column."""
    own, following, raw = factor.own, factor.next, factor.raw
    for c in range(6):
        upper, lower, pivot = load(own, (i, c, 0)), load(own, (i, c, LANES)), own[i, c, c]
        inverse = 1 / max(pivot + DAMPING * equations.diagonal[i, c, c], _LEAST)
        l0, l1 = upper * inverse, lower * inverse
        f0, f1 = load(raw, (c, 0)) * inverse, load(raw, (c, LANES)) * inverse
        f1 = choose(lanes_of(0.0, 0.0, 1.0, 0.0) > 0.0, l1, f1)
        for k in range(c + 1, 6):
            s = own[i, c, k]
            store(own, (i, k, 0), load(own, (i, k, 0)) - l0 * s)
            store(own, (i, k, LANES), load(own, (i, k, LANES)) - l1 * s)
            store(raw, (k, 0), load(raw, (k, 0)) - f0 * s)
            store(raw, (k, LANES), load(raw, (k, LANES)) - f1 * s)
        store(own, (i, c, 0), l0)
        store(own, (i, c, LANES), l1)
        store(following, (i, c, 0), f0)
        store(following, (i, c, LANES), f1)


@jit_inline
def _substitute(factor: Factor, i: int, u0: Some, u1: Some) -> None:
    """step of block i, from that of the next one as Lanes, -1 in row 6."""
    own, following, x = factor.own, factor.next, factor.step
    for c in range(5, -1, -1):
        x[i, c] = -total(load(following, (i, c, 0)) * u0 + load(following, (i, c, LANES)) * u1)
        for k in range(c + 1, 6):
            x[i, c] -= own[i, c, k] * x[i, k]


@jit_borrowing
def solve(problem: Problem, equations: Equations, factor: Factor) -> float:
    """step = -(H + DAMPING diag H)^-1 gradient, zero at fixed control points; returns the predicted decrease of E."""
    m = len(problem.time) - 1
    for i in range(m + 1):
        if problem.fixed[i]:
            _clear(factor, i)
        else:
            _load(equations, factor, i, i < m and not problem.fixed[i + 1])
            _eliminate(equations, factor, i)
    decrease, x = 0.0, factor.step
    u0, u1 = lanes_of(0.0, 0.0, 0.0, 0.0), lanes_of(0.0, 0.0, -1.0, 0.0)
    for i in range(m, -1, -1):
        _substitute(factor, i, u0, u1)
        u0, u1 = lanes_of(x[i, 0], x[i, 1], x[i, 2], x[i, 3]), lanes_of(x[i, 4], x[i, 5], -1.0, 0.0)
        for r in range(6):
            decrease -= 0.5 * equations.gradient[i, r] * x[i, r]
    return decrease
