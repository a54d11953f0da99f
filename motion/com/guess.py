"""First guesses of a curve, where nothing better is known."""

import numpy as np

from motion.com.problem import Problem
from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def straight_guess(problem: Problem, control: np.ndarray, first: int) -> None:
    """Control points that are not fixed, from `first` on: above the mean of the feet under them, moving with them."""
    m = len(problem.time) - 1
    for i in range(first, m + 1):
        if not problem.fixed[i]:
            _guess_place(problem, control, i)
    for i in range(first, m + 1):
        if not problem.fixed[i]:
            _guess_velocity(problem, control, i)


@jit_borrowing
def _guess_place(problem: Problem, control: np.ndarray, i: int) -> None:
    """Above the mean of the legs' origins in the last sample before it and the first after it."""
    m, found, x, y, z = len(problem.time) - 1, 0, 0.0, 0.0, 0.0
    for segment, j in ((max(i - 1, 0), problem.support_point.shape[0] - 1), (min(i, m - 1), 0)):
        for leg in range(2):
            if problem.standing[j, leg, segment]:
                q = problem.leg_origin[j, leg, :, segment]
                x, y, z, found = x + q[0], y + q[1], z + q[2], found + 1
    many = max(found, 1)
    control[i, 0], control[i, 1] = x / many, y / many
    control[i, 2] = z / many + 0.97 * problem.nominal_length[0, 0, min(i, m - 1)]


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
