"""The 12-step tracks that solvers are compared on: the paper's layout, a segment per step, and a flight by itself."""

import numpy as np

from motion.com.problem import Problem, empty_problem

WALK: dict = dict()
RUN: dict = dict(step_length=1.1, step_time=0.36, stance_time=0.26, flights=True)
STAIRS: dict = dict(step_length=0.35, step_time=0.6, stance_time=0.75, rise=0.17)
TRACKS = {"walk12": WALK, "run12": RUN, "stairs12": STAIRS}


def twelve_steps(
    step_length: float = 0.7, step_time: float = 0.5, stance_time: float = 0.6, rise: float = 0.0, flights: bool = False,
    samples: int = 10, by_phase: bool = False,
) -> Problem:  # fmt: skip
    """12 steps, feet 0.2 m apart, l_nominal 0.9 m, k = 100, no hip offset, free ends, midpoint samples."""
    edges = [i * step_time for i in range(13)]
    if flights or by_phase:
        edges += [i * step_time + (stance_time if flights else stance_time - step_time) for i in range(12)]
    time = np.unique(np.round(edges, 9))
    problem = empty_problem(len(time) - 1, samples, 0.9, np.inf, 100.0)
    problem.time[:] = time
    for i, (begin, end) in enumerate(zip(time[:-1], time[1:], strict=True)):
        for j in range(samples):
            t = begin + (j + 0.5) / samples * (end - begin)
            for n in range(12):
                if n * step_time <= t < n * step_time + stance_time:
                    point = (n * step_length, 0.1 - 0.2 * (n % 2), n * rise)
                    problem.support_point[j, n % 2, :, i] = problem.leg_origin[j, n % 2, :, i] = point
                    problem.standing[j, n % 2, i] = True
    return problem
