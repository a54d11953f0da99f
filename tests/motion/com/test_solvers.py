"""Newton and greedy on the design's 12-step tracks, against each other and against scipy."""

import numpy as np
import pytest
from scipy.optimize import minimize

from motion.com import greedy, newton, tridiagonal
from motion.com.equations import assemble, empty_equations
from motion.com.problem import straight_guess, total_cost
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
    equations = empty_equations(len(control) - 1)

    def smooth(x):
        value = assemble(problem, x.reshape(-1, 6), 1e-4, equations)
        return value, equations.gradient.ravel().copy()

    found = minimize(smooth, control.ravel(), jac=True, method="L-BFGS-B", options={"maxiter": 500})
    assert e <= 1.002 * total_cost(problem, found.x.reshape(-1, 6))


@pytest.mark.parametrize("by_phase", [False, True])
@pytest.mark.parametrize("name", TRACKS)
def test_scenes_come_within_two_percent_of_the_best(name, by_phase):
    problem = twelve_steps(**TRACKS[name], by_phase=by_phase)
    assert solved(problem, newton, newton.SCENE)[0] <= 1.02 * solved(problem, newton, newton.TIGHT)[0]


def block(columns):
    """The symmetric 6x6 block of columns whose lower triangle counts."""
    lower = np.tril(columns[:, :6].T)
    return lower + np.tril(lower, -1).T


def test_step_solves_the_damped_normal_equations():
    """Against a dense matrix of the same blocks, with control points fixed at an end and in the middle."""
    problem = twelve_steps()
    problem.fixed[[0, 5]] = True
    control = np.zeros((13, 6))
    straight_guess(problem, control, 0)
    equations, factor = empty_equations(12), tridiagonal.empty_factor(12)
    assemble(problem, control, 0.1, equations)
    decrease = tridiagonal.solve(problem, equations, factor)
    h = np.zeros((13, 6, 13, 6))
    for i in range(13):
        h[i, :, i] = block(equations.diagonal[i])
        if i < 12:
            h[i + 1, :, i] = equations.lower[i, :, :6].T
            h[i, :, i + 1] = equations.lower[i, :, :6]
    free = np.flatnonzero(np.repeat(~problem.fixed, 6))
    h = h.reshape(78, 78)[np.ix_(free, free)]
    h += tridiagonal.DAMPING * np.diag(np.diag(h))
    expected = np.zeros(78)
    expected[free] = -np.linalg.solve(h, equations.gradient.ravel()[free])
    np.testing.assert_allclose(factor.step.ravel(), expected, rtol=1e-6, atol=1e-9)
    assert decrease == pytest.approx(-0.5 * expected @ equations.gradient.ravel())


def test_hessian_is_the_samples_models_spread():
    """assemble's blocks against J^T M J + C of every sample, written with numpy."""
    problem = twelve_steps(by_phase=True, samples=5)
    rng = np.random.default_rng(3)
    control = np.zeros((25, 6))
    straight_guess(problem, control, 0)
    control += rng.normal(0, 0.02, control.shape)
    equations = empty_equations(24)
    assemble(problem, control, 0.1, equations)
    h, g = reference.normal_equations(problem, control, 0.1)
    for i in range(25):
        np.testing.assert_allclose(block(equations.diagonal[i]), h[i, :, i], rtol=1e-9, atol=1e-6)
        if i < 24:
            np.testing.assert_allclose(equations.lower[i, :, :6].T, h[i + 1, :, i], rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(equations.gradient, g, rtol=1e-9, atol=1e-9)


def test_fixed_control_points_stay():
    problem = twelve_steps()
    problem.fixed[[0, 5, 12]] = True
    control = np.zeros((13, 6))
    control[:, :3] = problem.time[:, None] * [1.4, 0, 0] + [0, 0, 0.85]
    before = control.copy()
    straight_guess(problem, control, 0)
    newton.minimise(problem, control, newton.SCENE)
    np.testing.assert_array_equal(control[problem.fixed], before[problem.fixed])
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
        problem, _ = laying.build_problem(b, straight_walk(b, n), 0.0, (n - 1) * 0.5, laying.Layout(5, False))
        control = np.zeros((len(problem.time), 6))
        straight_guess(problem, control, 0)
        e, used = newton.minimise(problem, control, newton.LIVE)
        assert used <= 12
        costs.append(e / len(control))
    assert costs[1] == pytest.approx(costs[0], rel=0.1)
