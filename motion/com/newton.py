"""Gauss-Newton on banded normal equations: the default solver.

E sums norms |r|, whose exact gradient is J^T r / |r|. Weighting the squared residual by 1 / max(|r|, eps) gives that
gradient and a positive definite Hessian 1/|r| J^T J (iteratively reweighted least squares). It minimises Huber's smoothed
norm exactly; eps shrinks from a smooth problem (squared norm) to a sharp one, each stage warm-started by the last. The unknowns
are coefficients of B-splines (motion.track.basis), each of which couples with the next three, so the normal equations are a
band of twelve, factored in time linear in the pieces.
"""

from typing import NamedTuple

import numpy as np

from motion.com import problem as problems
from motion.com.banded import solve
from motion.com.equations import Equations, assemble, empty_equations
from motion.com.problem import Problem
from motion.track.basis import ORDER, Basis, basis_of, control_of, lay_coefficients
from worlds.compiled.jit import jit, jit_borrowing, jit_inline


class Effort(NamedTuple):
    """How hard to try: the more, the nearer to the optimum."""

    stages: int  # eps goes from eps_first to eps_last in this many equal ratios
    eps_first: float  # [m/s^2] large: squared norm, fast and smooth
    eps_last: float  # [m/s^2] small: the norm itself
    iterations: int  # at most, per stage
    tolerance: float  # a stage ends when the predicted decrease is below this share of E
    hard: float = 0.4  # [m/s^2] a live window of a greater mean cost gets more: leaps, which are rare; walking stays below


TIGHT = Effort(9, 3.0, 3e-4, 60, 1e-7)
SCENE = Effort(4, 3.0, 1e-3, 100, 1e-4)
LIVE = Effort(1, 1e-2, 1e-2, 16, 1e-1)
"""Of the live window. Each step is solved in several windows before it is walked, so a window need not be solved to its end:
what comes of it is no worse than of windows that are (bench --only window: E over that with windows solved tightly)."""
HARDER = Effort(4, 1.0, 3e-3, 10, 1e-3)
ANEW = Effort(4, 1.0, 3e-3, 20, 1e-3)
"""From a cold start: with half as many iterations windows of walks ended far from the optimum, and bodies were thrown about."""

_BACK = 0.3
"""Share of a step that is tried next where the whole step has raised E."""


class Workspace(NamedTuple):
    """What a solve needs."""

    basis: Basis
    equations: Equations
    coefficients: np.ndarray  # (n, 3)
    kept: np.ndarray  # (n, 3) coefficients from which the step goes
    step: np.ndarray  # (3 n + ...,)


@jit
def workspace(problem: Problem) -> Workspace:
    """For a problem."""
    basis = basis_of(problem.time, problem.smooth)
    n = len(basis.knot) - ORDER
    equations = empty_equations(n)
    return Workspace(basis, equations, np.empty((n, 3)), np.empty((n, 3)), np.zeros(len(equations.gradient)))


@jit_borrowing
def _stage(
    problem: Problem, control: np.ndarray, eps: float, iterations: int, tolerance: float, work: Workspace
) -> tuple[float, int]:
    """Full steps on the smoothed E, each checked by the next assembly, the last by the costs; returns (true E, iterations)."""
    basis, coefficients = work.basis, work.coefficients
    before, share, kept, used, near = np.inf, 1.0, work.kept, 0, False
    while used < iterations and not near:
        e = assemble(problem, basis, coefficients, eps, work.equations)
        if not e <= before:
            share *= _BACK
        else:
            near = not solve(problem.fixed, basis, work.equations, work.step) > tolerance * e
            _copy(coefficients, kept)
            before, share = e, 1.0
        _move(coefficients, kept, share, work.step)
        used += 1
    control_of(basis, problem.time, coefficients, control)
    e, true = problems.total_costs(problem, control, eps)
    if not e <= before:
        _copy(kept, coefficients)
        control_of(basis, problem.time, coefficients, control)
        true = problems.total_cost(problem, control)
    return true, used


@jit_inline
def _copy(source: np.ndarray, goal: np.ndarray) -> None:
    for i in range(len(source)):
        for k in range(3):
            goal[i, k] = source[i, k]


@jit_inline
def _move(coefficients: np.ndarray, kept: np.ndarray, share: float, step: np.ndarray) -> None:
    for i in range(len(coefficients)):
        for k in range(3):
            coefficients[i, k] = kept[i, k] + share * step[3 * i + k]


@jit_borrowing
def minimise_in(work: Workspace, problem: Problem, control: np.ndarray, effort: Effort) -> tuple[float, int]:
    """minimise, with its workspace at hand."""
    lay_coefficients(work.basis, problem.time, control, problem.bend, work.coefficients)
    _copy(work.coefficients, work.kept)
    ratio = (effort.eps_last / effort.eps_first) ** (1.0 / max(effort.stages - 1, 1))
    eps = effort.eps_first
    e, used = 0.0, 0
    for _ in range(effort.stages):
        e, more = _stage(problem, control, eps, effort.iterations, effort.tolerance, work)
        used += more
        eps *= ratio
    return e, used


@jit
def minimise(problem: Problem, control: np.ndarray, effort: Effort) -> tuple[float, int]:
    """Moves control (m + 1, 6) in place to a minimum of E; returns (E, iterations)."""
    return minimise_in(workspace(problem), problem, control, effort)
