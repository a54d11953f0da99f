"""Gauss-Newton on block-tridiagonal normal equations: the default solver.

E sums norms |r|, whose exact gradient is J^T r / |r|. Weighting the squared residual by 1 / max(|r|, eps) gives that
gradient and a positive definite Hessian 1/|r| J^T J (iteratively reweighted least squares). It minimises Huber's smoothed
norm exactly; eps shrinks from a smooth problem (squared norm) to a sharp one, each stage warm-started by the last. A
control point couples only with its neighbours, so the normal equations are block tridiagonal with 6x6 blocks (half
bandwidth 12), factored by block Cholesky in time linear in the segments.
"""

from typing import NamedTuple

import numpy as np

from motion.com import problem as problems
from motion.com.equations import Equations, assemble, empty_equations
from motion.com.problem import Problem
from motion.com.tridiagonal import Factor, empty_factor, solve
from worlds.compiled.jit import jit, jit_borrowing, jit_inline


class Effort(NamedTuple):
    """How hard to try: the more, the nearer to the optimum."""

    stages: int  # eps goes from eps_first to eps_last in this many equal ratios
    eps_first: float  # [m/s^2] large: squared norm, fast and smooth
    eps_last: float  # [m/s^2] small: the norm itself
    iterations: int  # at most, per stage
    tolerance: float  # a stage ends when the predicted decrease is below this share of E


TIGHT = Effort(9, 3.0, 3e-4, 60, 1e-7)
SCENE = Effort(2, 0.1, 3e-3, 12, 1e-3)
LIVE = Effort(1, 3e-4, 3e-4, 16, 1e-2)
HARDER = Effort(4, 1.0, 3e-3, 10, 1e-3)

_BACK = 0.3
"""Share of a step that is tried next where the whole step has raised E."""


class Workspace(NamedTuple):
    """What a solve of m segments needs."""

    equations: Equations
    factor: Factor
    kept: np.ndarray  # (m + 1, 6) control points from which the step goes


@jit
def workspace(m: int) -> Workspace:
    """For m segments."""
    return Workspace(empty_equations(m), empty_factor(m), np.empty((m + 1, 6)))


@jit_borrowing
def _stage(
    problem: Problem, control: np.ndarray, eps: float, iterations: int, tolerance: float, work: Workspace
) -> tuple[float, int]:
    """Full steps on the smoothed E, each checked by the next assembly, the last by the costs; returns (true E, iterations)."""
    before, share, kept, used, near = np.inf, 1.0, work.kept, 0, False
    while used < iterations and not near:
        e = assemble(problem, control, eps, work.equations)
        if not e <= before:
            share *= _BACK
        else:
            near = not solve(problem, work.equations, work.factor) > tolerance * e
            _copy(control, kept)
            before, share = e, 1.0
        _move(control, kept, share, work.factor.step)
        used += 1
    e, true = problems.total_costs(problem, control, eps)
    if not e <= before:
        _copy(kept, control)
        true = problems.total_cost(problem, control)
    return true, used


@jit_inline
def _copy(source: np.ndarray, goal: np.ndarray) -> None:
    for i in range(len(source)):
        for k in range(6):
            goal[i, k] = source[i, k]


@jit_inline
def _move(control: np.ndarray, kept: np.ndarray, share: float, step: np.ndarray) -> None:
    for i in range(len(control)):
        for k in range(6):
            control[i, k] = kept[i, k] + share * step[i, k]


@jit
def minimise(problem: Problem, control: np.ndarray, effort: Effort) -> tuple[float, int]:
    """Moves control (m + 1, 6) in place to a minimum of E; returns (E, iterations)."""
    work = workspace(len(problem.time) - 1)
    ratio = (effort.eps_last / effort.eps_first) ** (1.0 / max(effort.stages - 1, 1))
    eps = effort.eps_first
    e, used = 0.0, 0
    for _ in range(effort.stages):
        e, more = _stage(problem, control, eps, effort.iterations, effort.tolerance, work)
        used += more
        eps *= ratio
    return e, used
