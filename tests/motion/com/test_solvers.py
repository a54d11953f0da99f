"""Newton and greedy on the design's 12-step tracks, against each other and against scipy."""

import numpy as np
import pytest
from scipy.interpolate import BSpline
from scipy.optimize import minimize

from motion.com import banded, greedy, newton
from motion.com.equations import BAND, assemble, empty_equations
from motion.com.guess import straight_guess
from motion.com.problem import Layout, total_cost, with_effort
from motion.track.basis import basis_of, coefficients_of, control_of
from sim.bench.tracks import TRACKS, twelve_steps
from tests import reference


def solved(problem, method, how):
    control = np.zeros((len(problem.time), 6))
    straight_guess(problem, control, 0)
    return method.minimise(problem, control, how)[0], control


def test_newton_reaches_the_best_known_walk():
    assert solved(twelve_steps(), newton, newton.SCENE)[0] <= 1.212
    assert solved(twelve_steps(), newton, newton.TIGHT)[0] == pytest.approx(1.2006, abs=5e-4)


@pytest.mark.parametrize("name", TRACKS)
def test_newton_is_never_above_greedy(name):
    problem = twelve_steps(**TRACKS[name])
    best = solved(problem, greedy, greedy.DELTAS)[0]
    assert solved(problem, newton, newton.SCENE)[0] <= best
    assert solved(problem, newton, newton.LIVE)[0] <= best


@pytest.mark.parametrize("name", TRACKS)
def test_scipy_finds_nothing_better_nearby(name):
    problem = twelve_steps(**TRACKS[name])
    e, control = solved(problem, newton, newton.TIGHT)
    basis = basis_of(problem.time, problem.smooth)
    start = coefficients_of(basis, problem.time, control, problem.bend)
    equations = empty_equations(len(start))

    def smooth(x):
        value = assemble(problem, basis, x.reshape(-1, 3), 1e-4, equations)
        return value, equations.gradient[: x.size].copy()

    found = minimize(smooth, start.ravel(), jac=True, method="L-BFGS-B", options={"maxiter": 500})
    control_of(basis, problem.time, found.x.reshape(-1, 3), control)
    assert e <= 1.002 * total_cost(problem, control)


@pytest.mark.parametrize("by_phase", [False, True])
@pytest.mark.parametrize("name", TRACKS)
def test_scenes_come_within_two_percent_of_the_best(name, by_phase):
    problem = twelve_steps(**TRACKS[name], by_phase=by_phase)
    assert solved(problem, newton, newton.SCENE)[0] <= 1.02 * solved(problem, newton, newton.TIGHT)[0]


def matrix_of(equations, unknowns):
    """The band as a whole symmetric matrix."""
    h = np.zeros((unknowns, unknowns))
    for column in range(unknowns):
        for k in range(min(BAND, unknowns - column)):
            h[column + k, column] = h[column, column + k] = equations.band[column, k]
    return h


def assembled(smooth, eps=0.1, seed=3):
    """A wobbly problem: (problem, basis, coefficients, equations), strength and jerk included where it is smooth."""
    problem = twelve_steps(by_phase=True, samples=5)._replace(smooth=smooth)
    if smooth:
        problem = with_effort(problem, 11.0, 1e-4, problem.pull)
    control = np.zeros((len(problem.time), 6))
    straight_guess(problem, control, 0)
    basis = basis_of(problem.time, smooth)
    coefficients = coefficients_of(basis, problem.time, control, problem.bend)
    coefficients += np.random.default_rng(seed).normal(0, 0.004, coefficients.shape)
    equations = empty_equations(len(coefficients))
    assemble(problem, basis, coefficients, eps, equations)
    return problem, basis, coefficients, equations


@pytest.mark.parametrize("smooth", [False, True])
def test_step_solves_the_damped_normal_equations(smooth):
    """Against a dense matrix of the same band, with an end fixed, and of a rough curve a point in the middle."""
    problem, basis, coefficients, equations = assembled(smooth)
    problem.fixed[[0] if smooth else [0, 5]] = True
    count = coefficients.size
    free = [k for k in range(count) if (k >= 9 if smooth else k >= 6 and not 30 <= k < 36)]
    h = matrix_of(equations, count)[np.ix_(free, free)]
    h += banded.DAMPING * np.diag(np.diag(h))
    expected, gradient = np.zeros(count), equations.gradient[:count].copy()
    expected[free] = -np.linalg.solve(h, gradient[free])
    step = np.zeros(len(equations.gradient))
    decrease = banded.solve(problem.fixed, basis, equations, step)
    np.testing.assert_allclose(step[:count], expected, rtol=1e-5, atol=1e-5 * np.abs(expected).max())
    assert decrease == pytest.approx(-0.5 * expected @ gradient, rel=1e-4)


@pytest.mark.parametrize("smooth", [False, True])
def test_hessian_is_the_samples_models_spread(smooth):
    """assemble's band against J^T M J + C of every sample, written with numpy and scipy's splines."""
    problem, basis, coefficients, equations = assembled(smooth)
    h, g = reference.normal_equations(problem, basis, coefficients, 0.1)
    count = coefficients.size
    scale = np.abs(h).max()
    np.testing.assert_allclose(matrix_of(equations, count), h.reshape(count, count), rtol=1e-7, atol=1e-9 * scale)
    np.testing.assert_allclose(equations.gradient[:count], g.ravel(), rtol=1e-7, atol=1e-9 * np.abs(g).max())


@pytest.mark.parametrize("smooth", [False, True])
def test_a_basis_is_scipys(smooth):
    """Values, ends and the way back from control points, on pieces of any length."""
    rng = np.random.default_rng(5)
    time = np.cumsum(rng.uniform(0.02, 0.6, 9))
    basis = basis_of(time, smooth)
    coefficients = rng.normal(size=(len(basis.knot) - 4, 3))
    curve, control = BSpline(time[basis.knot], coefficients, 3), np.empty((9, 6))
    for i, s in np.ndindex(8, 5):
        share = (s + 0.5) / 5
        here = basis.weights[:, :, i] @ share ** np.arange(4) @ coefficients[basis.first[i] : basis.first[i] + 4]
        np.testing.assert_allclose(here, curve(time[i] + share * (time[i + 1] - time[i])), atol=1e-12)
    control_of(basis, time, coefficients, control)
    np.testing.assert_allclose(control[:, :3], curve(time), atol=1e-12)
    np.testing.assert_allclose(control[:, 3:], curve(time, 1), atol=1e-9)
    bend = np.array([curve(time[0], 2), curve(time[-1] - 1e-12, 2)])
    np.testing.assert_allclose(coefficients_of(basis, time, control, bend), coefficients, atol=1e-7)


def test_forces_of_a_smooth_curve_do_not_jump():
    problem = twelve_steps(by_phase=True)._replace(smooth=True)
    _, control = solved(problem, newton, newton.SCENE)
    for i in range(1, len(problem.time) - 1):
        t = problem.time[i]
        before, after = (reference.hermite(problem.time, control, t + d)[2] for d in (-1e-9, 1e-9))
        np.testing.assert_allclose(before, after, atol=1e-5)


def test_fixed_control_points_stay():
    problem = twelve_steps()
    problem.fixed[[0, 5, 12]] = True
    control = np.zeros((13, 6))
    control[:, :3] = problem.time[:, None] * [1.4, 0, 0] + [0, 0, 0.85]
    before = control.copy()
    straight_guess(problem, control, 0)
    newton.minimise(problem, control, newton.SCENE)
    np.testing.assert_allclose(control[problem.fixed], before[problem.fixed], atol=1e-12)
    assert not np.allclose(control[~problem.fixed], before[~problem.fixed])


def test_greedy_never_climbs():
    problem = twelve_steps()
    control = np.zeros((13, 6))
    straight_guess(problem, control, 0)
    before = total_cost(problem, control)
    coarse, _ = greedy.minimise(problem, control, np.array([0.06]))
    fine, _ = greedy.minimise(problem, control, np.array([0.02]))
    assert fine <= coarse < before


def test_long_tracks_grow_no_worse_than_their_problems():
    """Twice the footprints, twice the segments and the same cost per segment: the sizes that times are linear in."""
    from motion.characters.character import load_character
    from motion.com import laying
    from tests.walks import straight_walk

    b = load_character("human").biped
    costs = []
    for n in (500, 1000):
        problem, _ = laying.build_problem(b, straight_walk(b, n), 0.0, (n - 1) * 0.5, Layout(5, False, False, False, 0.0))
        control = np.zeros((len(problem.time), 6))
        straight_guess(problem, control, 0)
        e, used = newton.minimise(problem, control, newton.LIVE)
        assert used <= newton.LIVE.iterations
        costs.append(e / len(control))
    assert costs[1] == pytest.approx(costs[0], rel=0.1)
