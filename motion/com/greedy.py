"""The paper's coordinate search (Fig. 10): the reference that `newton` is measured against.

Each coordinate of each control point is tried at v + delta and v - delta (the figure prints v + delta twice); a
direction that helps is repeated while it helps. Only the two segments that a control point touches are evaluated again.
Sweeps repeat until none helps, with delta = 6 cm, then 2 cm (and cm/s for tangents).
"""

import numpy as np

from motion.com.problem import Problem, costs_from, total_cost
from worlds.compiled.jit import jit

DELTAS = np.array([0.06, 0.02])
MAX_SWEEPS = 500


@jit
def _touched_cost(problem: Problem, control: np.ndarray, i: int) -> float:
    """Of the segments on both sides of control point i, and of the next ones, which do not change."""
    return costs_from(problem, control, max(i - 1, 0), 1.0)[1]


@jit
def _search_coordinate(problem: Problem, control: np.ndarray, i: int, k: int, delta: float) -> bool:
    """Walks one coordinate downhill; returns whether it moved."""
    best = _touched_cost(problem, control, i)
    moved = False
    for step in (delta, -delta):
        while True:
            value = control[i, k]
            control[i, k] = value + step
            e = _touched_cost(problem, control, i)
            if not e < best:
                control[i, k] = value
                break
            best = e
            moved = True
        if moved:
            break
    return moved


@jit
def minimise(problem: Problem, control: np.ndarray, deltas: np.ndarray) -> tuple[float, int]:
    """Moves control (m + 1, 6) in place; returns (E, sweeps)."""
    sweeps = 0
    for delta in deltas:
        for _ in range(MAX_SWEEPS):
            moved = False
            sweeps += 1
            for i in range(len(control)):
                if not problem.fixed[i]:
                    for k in range(6):
                        moved |= _search_coordinate(problem, control, i, k, delta)
            if not moved:
                break
    return total_cost(problem, control), sweeps
