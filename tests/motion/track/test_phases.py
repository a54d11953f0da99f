"""Phases of support against a dense scan of the timings."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motion.track import phases
from motion.track.footprints import Footprints
from tests import reference
from worlds.compiled.tables import empty


def built(side, contact, stance, begin, end):
    time, support = np.empty(2 * len(side) + 2), np.empty((2 * len(side) + 2, 2), np.int64)
    footprints = empty(Footprints, len(side))._replace(side=side, contact_time=contact, stance_time=stance)
    m = phases.build_phases(footprints, begin, end, time, support)
    return time[: m + 1], support[:m]


@settings(max_examples=60)
@given(st.integers(0, 10**6))
def test_phases_agree_with_a_dense_scan(seed):
    rng = np.random.default_rng(seed)
    n = rng.integers(2, 9)
    side = np.arange(n) % 2
    step = rng.uniform(0.3, 0.7, n)
    contact = np.cumsum(step) - step
    stance = step * rng.uniform(0.5, 1.25, n)
    begin, end = 0.1, contact[-1] + 0.2
    time, support = built(side, contact, stance, begin, end)
    assert time[0] == begin and time[-1] == pytest.approx(end)
    assert (np.diff(time) > 0).all()
    for t, left, right in reference.phases(side, contact, stance, begin, end):
        i = np.searchsorted(time, t) - 1
        if np.abs(time - t).min() > 2e-3:
            assert tuple(support[i]) == (left, right)


def test_one_phase_per_change_of_support():
    side, contact = np.array([0, 1, 0]), np.array([0.0, 0.5, 1.0])
    time, support = built(side, contact, np.array([0.6, 0.6, 0.6]), 0.0, 1.5)
    np.testing.assert_allclose(time, [0, 0.5, 0.6, 1.0, 1.1, 1.5])
    codes = [phases.phase_of(*row) for row in support]
    assert codes == [phases.LEFT_STANCE, phases.DOUBLE_STANCE, phases.RIGHT_STANCE, phases.DOUBLE_STANCE, 0]


def test_by_step_keeps_flights_apart():
    side, contact = np.array([0, 1, 0]), np.array([0.0, 0.5, 1.2])
    time, support = built(side, contact, np.array([0.6, 0.4, 0.5]), 0.0, 1.7)
    m = phases.merge_by_step(time, support, len(support))
    np.testing.assert_allclose(time[: m + 1], [0, 0.5, 0.9, 1.2, 1.7])
