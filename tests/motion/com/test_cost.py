"""The cost kernels against their twins, and their derivatives against finite differences."""

import numpy as np
import pytest

from motion.com import cost
from motion.com.equations import assemble, empty_equations
from motion.com.problem import total_cost, with_effort
from motion.com.springs import PULL
from motion.track import curve
from motion.track.basis import basis_of, coefficients_of, control_of
from motion.track.curve import Curve
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
        assert cost.physics_cost(com, w + reference.GRAVITY, points, standing) == pytest.approx(expected, abs=1e-9)


def model(x, points, standing, eps):
    """(E, gradient in com and acceleration) of a moment by the kernels; both legs' comfort with other origins."""
    points = [tuple(point) for point in points]
    r, phi, g, m = cost.physics_model(tuple(x[:3]), tuple(x[3:]), *points, *standing, eps)
    e, gradient = r, np.concatenate([-phi * np.array(g), g])
    for leg, nominal in enumerate((0.9, 0.85)):
        origin = tuple(np.array(points[leg]) + 0.05)
        more, f, _ = cost.comfort_model(tuple(x[:3]), origin, standing[leg], nominal, 1.02 * nominal, 100.0)
        e, gradient = e + more, gradient + np.concatenate([f, np.zeros(3)])
    return e, gradient, m


@pytest.mark.parametrize("standing", SUPPORTS)
def test_gradient_agrees_with_finite_differences(standing):
    rng = np.random.default_rng(2)
    standing = np.array(standing)
    for _ in range(100):
        com, w, points = random_moment(rng)
        x, numeric = np.concatenate([com, w]), np.empty(6)
        e, g, _ = model(x, points, standing, 1e-9)
        for k in range(6):
            d = np.zeros(6)
            d[k] = 1e-6
            numeric[k] = (model(x + d, points, standing, 1.0)[0] - model(x - d, points, standing, 1.0)[0]) / 2e-6
        if e > 0.05:
            np.testing.assert_allclose(g, numeric, rtol=1e-5, atol=1e-5 * np.abs(numeric).max())


@pytest.mark.parametrize("standing", SUPPORTS)
def test_model_is_the_projector_on_what_the_legs_cannot_give(standing):
    """M max(|r|, eps) = N but for the caution on shares of a double stance, which is only seen within the legs' plane."""
    rng = np.random.default_rng(7)
    for _ in range(50):
        com, w, points = random_moment(rng)
        r, phi, g, lower = cost.physics_model(tuple(com), tuple(w), *(tuple(p) for p in points), *standing, 1e-9)
        m = np.zeros((3, 3))
        m[np.tril_indices(3)] = lower
        m += np.tril(m, -1).T
        legs = np.array([com - p for p in points[np.array(standing)]]).reshape(-1, 3)
        legs /= np.linalg.norm(legs, axis=1, keepdims=True) if len(legs) else 1.0
        shares = np.linalg.lstsq(legs.T, w, rcond=None)[0] if len(legs) else np.zeros(0)
        if (shares <= 0).any():
            continue  # outside the cone other legs carry
        np.testing.assert_allclose(m @ np.array(g), np.array(g) / r, rtol=1e-6)
        assert phi == pytest.approx(sum(a / np.linalg.norm(com - p) for a, p in zip(shares, points[np.array(standing)])))
        held = sum(cost.CAUTION / max(a, 1.0) ** 2 for a in shares) if len(legs) == 2 else 0.0
        dual = np.linalg.pinv(legs.T) if len(legs) else np.zeros((0, 3))
        expected = (np.eye(3) - dual.T @ legs) / r
        if held:
            expected += sum(cost.CAUTION / max(a, 1.0) ** 2 * np.outer(u, u) for a, u in zip(shares, dual, strict=True))
        np.testing.assert_allclose(m, expected, atol=1e-9 / r)


@pytest.mark.parametrize("smooth", [False, True])
def test_track_gradient_agrees_with_finite_differences(smooth):
    pulls = np.array([(3, 0.3, 1.0, 0.1, 0.9, 40.0), (3, 0.8, 1.2, -0.1, 1.0, 7.0), (9, 0.0, 3.0, 0.0, 0.8, 300.0)])
    assert pulls.shape[1] == PULL
    problem = with_effort(twelve_steps()._replace(smooth=smooth), 12.0, 1e-5, pulls)
    problem.gravity[2:5], problem.weight[4:7] = 4.0, 0.3
    rng, control = np.random.default_rng(3), np.empty((13, 6))
    basis = basis_of(problem.time, smooth)
    coefficients = coefficients_of(basis, problem.time, wobbly(problem, rng), problem.bend)
    equations = empty_equations(len(coefficients))
    assemble(problem, basis, coefficients, 1e-9, equations)

    def e(k, change):
        coefficients.flat[k] += change
        control_of(basis, problem.time, coefficients, control)
        coefficients.flat[k] -= change
        return total_cost(problem, control)

    for k in rng.integers(coefficients.size, size=40):
        assert equations.gradient[k] == pytest.approx((e(k, 1e-6) - e(k, -1e-6)) / 2e-6, rel=1e-4, abs=1e-4)


@pytest.mark.parametrize("strength", [5.0, 40.0])
def test_strength_counts_beyond_itself_alone(strength):
    w = np.array([3.0, -4.0, 12.0])
    size, _, force, lower = cost.strength_model(tuple(w), strength, 0.02)
    over = max(13.0 - strength, 0.0)
    assert size == pytest.approx(0.02 * over**2)
    np.testing.assert_allclose(force, 0.04 * over * w / 13.0, atol=1e-12)
    numeric = [(np.array(cost.strength_model(tuple(w + 1e-6 * axis), strength, 0.02)[2]) - force) / 1e-6 for axis in np.eye(3)]
    np.testing.assert_allclose(reference.whole(lower), numeric, atol=1e-5)


def test_reach_model_is_the_derivative_of_its_cost():
    com, q = np.array([0.3, 0.1, 0.95]), np.array([[0.0, 0.1, 0.05], [0.55, -0.1, 0.05]])
    standing, limit = np.array([True, True]), np.array([0.9, 0.9])
    legs = [cost.reach_model(tuple(com), tuple(q[k]), standing[k], limit[k], 100.0) for k in range(2)]
    e, force = sum(leg.cost for leg in legs), np.sum([leg.gradient for leg in legs], axis=0)
    assert e == pytest.approx(cost.reach_cost(com, q, standing, limit, 100.0)) and e > 0
    assert cost.reach_model(tuple(com), tuple(q[0]), False, limit[0], 100.0).cost == 0
    for axis in np.eye(3):
        near = [cost.reach_cost(com + d * axis, q, standing, limit, 100.0) for d in (1e-6, -1e-6)]
        assert force @ axis == pytest.approx((near[0] - near[1]) / 2e-6, rel=1e-5, abs=1e-4)


def wobbly(problem, rng):
    control = np.zeros((len(problem.time), 6))
    control[:, 0] = 1.4 * problem.time
    control[:, 2], control[:, 3] = 0.85, 1.4
    return control + rng.normal(0, 0.05, control.shape)


def test_total_cost_is_its_twin():
    problem = twelve_steps(by_phase=True)
    control = wobbly(problem, np.random.default_rng(4))
    assert total_cost(problem, control) == pytest.approx(reference.total_cost(problem, control), rel=1e-9)


def test_curve_is_its_twin():
    rng = np.random.default_rng(5)
    time, control = np.cumsum(rng.uniform(0.1, 0.6, 8)), rng.normal(size=(8, 6))
    out = np.empty((3, 3))
    for t in rng.uniform(time[0], time[-1], 50):
        curve.evaluate(Curve(time, control, np.full((8, 2), -1)), t, out[0], out[1], out[2])
        np.testing.assert_allclose(out, reference.hermite(time, control, t), rtol=1e-9, atol=1e-9)
