"""The cost kernels against their twins, and their derivatives against finite differences."""

import numpy as np
import pytest

from motion import cost, newton, spline
from motion.problem import total_cost
from sim.bench.tracks import twelve_steps
from tests import reference

SUPPORTS = ([False, False], [True, False], [False, True], [True, True])


def random_moment(rng):
    com = np.array([0, 0, 0.9]) + rng.normal(0, 0.15, 3)
    w = np.array([0, 0, 9.81]) + rng.normal(0, 2, 3)
    points = np.array([[0.2, 0.1, 0.0], [-0.3, -0.1, 0.1]]) + rng.normal(0, 0.1, (2, 3))
    return com, w, points


@pytest.mark.parametrize("standing", SUPPORTS)
def test_physics_cost_is_the_nnls_residual(standing):
    rng = np.random.default_rng(1)
    standing = np.array(standing)
    for _ in range(300):
        com, w, points = random_moment(rng)
        if rng.random() < 0.2:
            w = -w  # legs that would have to pull
        expected = reference.physics_cost(com, w + reference.GRAVITY, list(points[standing]))
        assert cost.physics_cost(*com, *w, points, standing) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("standing", SUPPORTS)
def test_gradient_agrees_with_finite_differences(standing):
    rng = np.random.default_rng(2)
    standing = np.array(standing)
    for _ in range(100):
        com, w, points = random_moment(rng)
        h, g = np.zeros((6, 6)), np.zeros(6)
        e = cost.add_physics(*com, *w, points, standing, 1e-9, h, g)
        e += cost.add_comfort(*com, points + 0.05, standing, np.array([0.9, 0.85]), 100.0, h, g)
        x, numeric = np.concatenate([com, w]), np.empty(6)
        for k in range(6):
            d = np.zeros(6)
            d[k] = 1e-6
            numeric[k] = (moment_cost(x + d, points, standing) - moment_cost(x - d, points, standing)) / 2e-6
        if moment_cost(x, points, standing) > 0.05:
            assert e == pytest.approx(moment_cost(x, points, standing))
            np.testing.assert_allclose(g, numeric, rtol=1e-5, atol=1e-5 * np.abs(numeric).max())


def moment_cost(x, points, standing):
    e = cost.physics_cost(*x, points, standing)
    return e + cost.comfort_cost(*x[:3], points + 0.05, standing, np.array([0.9, 0.85]), 100.0)


def test_track_gradient_agrees_with_finite_differences():
    problem = twelve_steps()
    rng = np.random.default_rng(3)
    control = wobbly(problem, rng)
    work = newton.workspace(12)
    newton.assemble(problem, control, 1e-9, work)
    for _ in range(40):
        i, k = rng.integers(13), rng.integers(6)
        up, down = control.copy(), control.copy()
        up[i, k] += 1e-6
        down[i, k] -= 1e-6
        numeric = (total_cost(problem, up) - total_cost(problem, down)) / 2e-6
        assert work.gradient[i, k] == pytest.approx(numeric, rel=1e-5, abs=1e-5)


def wobbly(problem, rng):
    control = np.zeros((len(problem.time), 6))
    control[:, 0] = 1.4 * problem.time
    control[:, 2], control[:, 3] = 0.85, 1.4
    return control + rng.normal(0, 0.05, control.shape)


def test_total_cost_is_its_twin():
    problem = twelve_steps(by_phase=True)
    control = wobbly(problem, np.random.default_rng(4))
    assert total_cost(problem, control) == pytest.approx(reference.total_cost(problem, control), rel=1e-9)


def test_spline_is_its_twin():
    rng = np.random.default_rng(5)
    time, control = np.cumsum(rng.uniform(0.1, 0.6, 8)), rng.normal(size=(8, 6))
    out = np.empty((3, 3))
    for t in rng.uniform(time[0], time[-1], 50):
        spline.evaluate(time, control, t, out[0], out[1], out[2])
        np.testing.assert_allclose(out, reference.hermite(time, control, t), rtol=1e-9, atol=1e-9)
