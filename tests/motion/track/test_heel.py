"""The heel rises where a leg would be too long."""

import numpy as np
import pytest

from motion.track.heel import AT_MOST, BEYOND, kept_in_reach

BALL, HEEL, ANKLE, FULL = (0.0, 0.0, 0.0), (-0.19, 0.0, 0.0), (-0.13, 0.0, 0.07), 0.9


def hip(length, way):
    """So far from the ankle, along a way."""
    return tuple(np.add(ANKLE, length * np.array(way) / np.linalg.norm(way)).tolist())


def leg(found, at):
    return float(np.linalg.norm(np.subtract(found[1], at)))


def test_a_leg_within_reach_keeps_its_heel():
    assert kept_in_reach(BALL, HEEL, ANKLE, hip(0.899, (0.3, 0.05, 1.0)), FULL) == (HEEL, ANKLE)


@pytest.mark.parametrize("beyond", [1.005, 1.01, 1.02, 1.04])
@pytest.mark.parametrize("way", [(0.4, 0.0, 1.0), (0.2, 0.15, 1.0), (0.1, -0.1, 1.0)])
def test_a_leg_that_is_too_long_draws_its_heel_up(beyond, way):
    at = hip(beyond * FULL, way)
    heel, ankle = found = kept_in_reach(BALL, HEEL, ANKLE, at, FULL)
    assert BEYOND * FULL < leg(found, at) < AT_MOST * FULL
    assert heel[2] > HEEL[2] and ankle[2] > ANKLE[2]
    for moved, was in ((heel, HEEL), (ankle, ANKLE)):
        assert np.linalg.norm(moved) == pytest.approx(np.linalg.norm(was)), "the foot is rigid"
    assert np.linalg.norm(np.subtract(heel, ankle)) == pytest.approx(np.linalg.norm(np.subtract(HEEL, ANKLE)))


def test_it_begins_gradually_and_never_pushes_the_heel_down():
    lengths = np.linspace(1.0, 1.03, 301) * FULL
    heights = np.array([kept_in_reach(BALL, HEEL, ANKLE, hip(d, (0.3, 0.0, 1.0)), FULL)[0][2] for d in lengths])
    assert heights.min() == 0.0 and (np.diff(heights) >= -1e-12).all() and np.diff(heights, 2).max() < 5e-5
    assert kept_in_reach(BALL, HEEL, ANKLE, hip(1.02 * FULL, (-1.0, 0.0, 0.1)), FULL)[0][2] >= 0.0
