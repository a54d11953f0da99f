"""Solvers on the same 12-step problems: newton, greedy, scipy's L-BFGS-B and IPOPT, the peers only where installed."""

from statistics import median
from time import perf_counter

import numpy as np

from motion.com import greedy, newton
from motion.com.equations import assemble, empty_equations
from motion.com.guess import straight_guess
from motion.com.problem import Problem, total_cost
from motion.track.basis import basis_of, coefficients_of, control_of
from sim.bench import ipopt
from sim.bench.tracks import TRACKS, twelve_steps

SMOOTHING = 1e-3
"""eps of the norm that L-BFGS-B and IPOPT are given [m/s^2]: they need a smooth cost. Costs reported are the true ones."""
_SLOW = ("lbfgs", "ipopt")


def compare(runs: int) -> dict:
    """{"walk12": {"newton_ms", "newton_cost", "greedy_ms", ...}, ...}; with a segment per phase "walk12_by_phase", ..."""
    steps = {name: twelve_steps(**shape) for name, shape in TRACKS.items()}
    phases = {f"{name}_by_phase": twelve_steps(**shape, by_phase=True) for name, shape in TRACKS.items()}
    return {name: _compare_on(problem, runs) for name, problem in (steps | phases).items()}


def _compare_on(problem: Problem, runs: int) -> dict:
    guess = np.zeros((len(problem.time), 6))
    straight_guess(problem, guess, 0)
    rivals = {
        "newton": lambda x: newton.minimise(problem, x, newton.SCENE)[0],
        "newton_loose": lambda x: newton.minimise(problem, x, newton.LIVE)[0],
        "greedy": lambda x: greedy.minimise(problem, x, greedy.DELTAS)[0],
        "lbfgs": lambda x: _lbfgs(problem, x),
    }
    if ipopt.INSTALLED:
        ipopt_solve = ipopt.solver(problem, SMOOTHING)
        rivals["ipopt"] = lambda x: total_cost(problem, ipopt_solve(x))
    report: dict = {}
    for name, solve in rivals.items():
        report[f"{name}_cost"], seconds = float(solve(guess.copy())), []
        for _ in range(min(runs, 3) if name in _SLOW else runs):
            x = guess.copy()
            begin = perf_counter()
            solve(x)
            seconds.append(perf_counter() - begin)
        report[f"{name}_ms"] = 1e3 * median(seconds)
    best = newton.minimise(problem, guess, newton.TIGHT)[0]
    return report | {"best_cost": min(float(best), *(report[f"{name}_cost"] for name in rivals))}


def _lbfgs(problem: Problem, x: np.ndarray) -> float:
    try:
        from scipy.optimize import minimize
    except ImportError:
        return float("nan")
    basis = basis_of(problem.time, problem.smooth)
    start = coefficients_of(basis, problem.time, x, problem.bend)
    equations = empty_equations(len(start))

    def smooth(flat: np.ndarray) -> tuple[float, np.ndarray]:
        e = assemble(problem, basis, flat.reshape(-1, 3), SMOOTHING, equations)
        return e, equations.gradient[: flat.size].copy()

    options = {"maxiter": 2000, "maxfun": 3000}
    found = minimize(smooth, start.ravel(), jac=True, method="L-BFGS-B", options=options)
    control_of(basis, problem.time, found.x.reshape(-1, 3), x)
    return total_cost(problem, x)
