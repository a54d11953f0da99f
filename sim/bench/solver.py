"""Solvers on the same 12-step problems: newton, greedy, and scipy's L-BFGS-B where scipy is installed."""

from statistics import median
from time import perf_counter

import numpy as np

from motion import greedy, newton
from motion.problem import straight_guess, total_cost
from sim.bench.tracks import TRACKS, twelve_steps

SMOOTHING = 1e-3
"""eps of the norm that L-BFGS-B is given [m/s^2]: it needs a smooth cost. Costs reported are the true ones."""


def compare(runs: int) -> dict:
    """{"walk12": {"newton_ms", "newton_cost", "greedy_ms", ...}, ...}"""
    return {name: _compare_on(twelve_steps(**shape), runs) for name, shape in TRACKS.items()}


def _compare_on(problem, runs: int) -> dict:
    guess = np.zeros((len(problem.time), 6))
    straight_guess(problem, guess, 0)
    rivals = {
        "newton": lambda x: newton.minimise(problem, x, newton.SCENE)[0],
        "newton_loose": lambda x: newton.minimise(problem, x, newton.LIVE)[0],
        "greedy": lambda x: greedy.minimise(problem, x, greedy.DELTAS)[0],
        "lbfgs": lambda x: _lbfgs(problem, x),
    }
    report: dict = {}
    for name, solve in rivals.items():
        report[f"{name}_cost"], seconds = float(solve(guess.copy())), []
        for _ in range(runs if name != "lbfgs" else min(runs, 3)):
            x = guess.copy()
            begin = perf_counter()
            solve(x)
            seconds.append(perf_counter() - begin)
        report[f"{name}_ms"] = 1e3 * median(seconds)
    best = newton.minimise(problem, guess, newton.TIGHT)[0]
    return report | {"best_cost": min(float(best), *(report[f"{name}_cost"] for name in rivals))}


def _lbfgs(problem, x: np.ndarray) -> float:
    try:
        from scipy.optimize import minimize
    except ImportError:
        return float("nan")
    work = newton.workspace(len(problem.time) - 1, problem.support_point.shape[1])

    def smooth(flat):
        return newton.assemble(problem, flat.reshape(-1, 6), SMOOTHING, work), work.gradient.ravel().copy()

    options = {"maxiter": 2000, "maxfun": 3000}
    found = minimize(smooth, x.ravel(), jac=True, method="L-BFGS-B", options=options)
    return total_cost(problem, found.x.reshape(-1, 6))
