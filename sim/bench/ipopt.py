"""A peer: the same problem given to IPOPT through casadi, an optional extra (peers).

Pushes are lifted: each sample has one unknown a >= 0 per standing leg and the residual r = w - sum of a K; norms are
sqrt(r^2 + eps^2). Second derivatives are casadi's own, exact and sparse; only solving is timed, not the building.
"""

from collections.abc import Callable
from importlib.util import find_spec

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.com.problem import Problem
from motion.track.basis import ORDER, basis_of, coefficients_of, control_of

INSTALLED = find_spec("casadi") is not None
OPTIONS = {"print_time": False, "ipopt": {"print_level": 0, "sb": "yes", "max_iter": 500, "tol": 1e-6}}


def solver(problem: Problem, eps: float) -> Callable[[np.ndarray], np.ndarray]:
    """Function of control (m + 1, 6), the start, that returns the optimum; nothing may be fixed or out of reach."""
    import casadi

    m, samples, basis = len(problem.time) - 1, len(problem.standing), basis_of(problem.time, problem.smooth)
    n = len(basis.knot) - ORDER
    x, pushes, e = casadi.SX.sym("x", 3, n), [], 0
    for i in range(m):
        duration = problem.time[i + 1] - problem.time[i]
        here, weights = x[:, basis.first[i] : basis.first[i] + ORDER], basis.weights[:, :, i]
        for j in range(samples):
            s = (j + 0.5) / samples
            com = here @ casadi.DM(weights @ [1, s, s * s, s**3])
            r = here @ casadi.DM(weights @ [0, 0, 2, 6 * s] / duration**2) + casadi.DM([0, 0, GRAVITY])
            part = 0
            for leg in np.flatnonzero(problem.standing[j, :, i]):
                pushes.append(casadi.SX.sym(f"a{i}_{j}_{leg}"))
                along = com - casadi.DM(problem.support_point[j, leg, :, i])
                r -= pushes[-1] * along / casadi.norm_2(along)
                stretch = casadi.norm_2(com - casadi.DM(problem.leg_origin[j, leg, :, i])) - problem.nominal_length[j, leg, i]
                part += problem.comfort_weight * problem.comfort_share[i] * stretch**2
            e += duration / samples * (casadi.sqrt(casadi.sumsqr(r) + eps**2) + part)
    unknowns = casadi.vertcat(casadi.vec(x), *pushes)
    ipopt = casadi.nlpsol("ipopt", "ipopt", {"x": unknowns, "f": e}, OPTIONS)
    least = np.concatenate([np.full(3 * n, -np.inf), np.zeros(len(pushes))])

    def solve(control: np.ndarray) -> np.ndarray:
        begin = coefficients_of(basis, problem.time, control, problem.bend).ravel()
        start = np.concatenate([begin, np.full(len(pushes), 0.5 * GRAVITY)])
        found, out = np.array(ipopt(x0=start, lbx=least)["x"]).ravel()[: 3 * n], np.empty_like(control)
        control_of(basis, problem.time, found.reshape(-1, 3), out)
        return out

    return solve
