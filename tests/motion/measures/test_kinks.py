"""Kinks against functions whose one-sided slopes are known."""

import numpy as np
import pytest

from motion.measures.kinks import APART, STEPS, kinks


def sampled(of, at):
    return np.array([of(at + k * APART) for k in STEPS])


def test_smooth_motion_has_none_however_strong_its_acceleration():
    fast = sampled(lambda t: np.array([np.sin(40 * t), 300 * t * t, np.exp(3 * t)]), 0.7)
    assert np.abs(kinks(fast)).max() < 1e-3


def test_a_jump_of_the_velocity_is_told_in_each_direction():
    bent = sampled(lambda t: np.array([[abs(t - 2.0), 5 * max(t - 2.0, 0.0) + 9 * t * t], [t, -0.01 * abs(t - 2.0)]]), 2.0)
    np.testing.assert_allclose(kinks(bent), [[2.0, 5.0], [0.0, -0.02]], atol=1e-6)


def test_a_jump_of_the_acceleration_alone_is_no_kink():
    assert kinks(sampled(lambda t: 400 * max(t - 1.0, 0.0) ** 2, 1.0)) == pytest.approx(0.0, abs=1e-6)
