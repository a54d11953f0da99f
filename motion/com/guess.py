"""First guesses of a curve, where nothing better is known."""

import numpy as np

from motion.com.problem import Problem
from worlds.compiled.jit import jit, jit_borrowing


@jit
def straight_guess(problem: Problem, control: np.ndarray, first: int) -> None:
    """Control points that are not fixed, from `first` on: above the mean of the feet under them, moving with them."""
    m = len(problem.time) - 1
    last_sample = problem.support_point.shape[0] - 1
    for i in range(first, m + 1):
        if problem.fixed[i]:
            continue
        sums = np.zeros(3)
        found = _add_origins(problem, max(i - 1, 0), last_sample, sums) + _add_origins(problem, min(i, m - 1), 0, sums)
        control[i, :3] = sums / max(found, 1)
        control[i, 2] += 0.97 * problem.nominal_length[0, 0, min(i, m - 1)]
    for i in range(first, m + 1):
        if not problem.fixed[i]:
            _guess_velocity(problem, control, i)


@jit
def _add_origins(problem: Problem, i: int, j: int, sums: np.ndarray) -> int:
    found = 0
    for leg in range(2):
        if problem.standing[j, leg, i]:
            sums += problem.leg_origin[j, leg, :, i]
            found += 1
    return found


@jit_borrowing
def _guess_velocity(problem: Problem, control: np.ndarray, i: int) -> None:
    """Slope through the neighbours; beside a flight (both feet off at the middle sample) the ballistic one."""
    m = len(problem.time) - 1
    before, after = max(i - 1, 0), min(i + 1, m)
    time = problem.time
    for axis in range(3):
        control[i, 3 + axis] = (control[after, axis] - control[before, axis]) / (time[after] - time[before])
    middle = problem.support_point.shape[0] // 2
    for segment, sign in ((i, 0.5), (i - 1, -0.5)):
        if 0 <= segment < m and not (problem.standing[middle, 0, segment] or problem.standing[middle, 1, segment]):
            duration = time[segment + 1] - time[segment]
            for axis in range(3):
                control[i, 3 + axis] = (control[segment + 1, axis] - control[segment, axis]) / duration
            control[i, 5] += sign * problem.gravity[segment] * duration
