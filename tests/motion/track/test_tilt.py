"""A standing foot tilts where its leg would be too long."""

import numpy as np
import pytest

from motion.track.tilt import AT_MOST, BEYOND, tilt_of, tilted

BALL, HEEL, ANKLE, FULL = (0.0, 0.0, 0.0), (-0.19, 0.0, 0.0), (-0.13, 0.0, 0.07), 0.9
TRAILING = [(0.4, 0.0, 1.0), (0.2, 0.15, 1.0), (0.1, -0.1, 1.0)]
LEADING = [(-0.4, 0.0, 1.0), (-0.5, 0.15, 1.0), (-0.3, -0.1, 1.0)]


def hip(length, way):
    """So far from the ankle, along a way."""
    return tuple(np.add(ANKLE, length * np.array(way) / np.linalg.norm(way)).tolist())


def far_end(pivot, far, at):
    """(tilt, far end, ankle) of a foot that tilts about a pivot for a hip."""
    tilt = tilt_of(pivot, far, ANKLE, at, FULL)
    return tilt, *((tilted(tilt, far), tilted(tilt, ANKLE)) if tilt.by else (far, ANKLE))


@pytest.mark.parametrize(("pivot", "far"), [(BALL, HEEL), (HEEL, BALL)])
def test_a_leg_within_reach_keeps_its_foot(pivot, far):
    for way in (*TRAILING, *LEADING):
        assert tilt_of(pivot, far, ANKLE, hip(0.999 * BEYOND * FULL, way), FULL).by == 0.0


@pytest.mark.parametrize("beyond", [1.005, 1.01, 1.02, 1.04])
@pytest.mark.parametrize(("pivot", "far", "way"), [(BALL, HEEL, w) for w in TRAILING] + [(HEEL, BALL, w) for w in LEADING])
def test_a_leg_that_is_too_long_draws_the_far_end_up(beyond, pivot, far, way):
    at = hip(beyond * FULL, way)
    _, end, ankle = far_end(pivot, far, at)
    assert BEYOND * FULL < np.linalg.norm(np.subtract(ankle, at)) < AT_MOST * FULL
    assert end[2] > 0.0
    for moved, was in ((end, far), (ankle, ANKLE)):
        assert np.linalg.norm(np.subtract(moved, pivot)) == pytest.approx(np.linalg.norm(np.subtract(was, pivot)))
    assert np.linalg.norm(np.subtract(end, ankle)) == pytest.approx(np.linalg.norm(np.subtract(far, ANKLE))), "rigid"


def test_it_begins_gradually_and_never_pushes_the_sole_down():
    lengths = np.linspace(1.0, 1.03, 301) * FULL
    heights = np.array([far_end(BALL, HEEL, hip(d, (0.3, 0.0, 1.0)))[1][2] for d in lengths])
    assert heights.min() == 0.0 and (np.diff(heights) >= -1e-12).all() and np.diff(heights, 2).max() < 5e-5
    assert far_end(BALL, HEEL, hip(1.02 * FULL, (-1.0, 0.0, 0.1)))[1][2] >= 0.0
