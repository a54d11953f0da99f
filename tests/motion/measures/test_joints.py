"""Joint angles, their rates and the distance of the shanks, against signals and brute force."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion.arithmetic.rotations import quaternion, turned
from motion.measures import joints

TIME = np.arange(0, 10, 1 / 60)
POINT = st.tuples(*[st.floats(-1, 1)] * 3)
UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])


def legs(hip, knee, hock, ankle_bend, frames=1):
    """Frames of two legs in the x z plane whose joints have these angles [rad], the thigh `hip` forward."""

    def way(angle):
        return np.array([np.sin(angle), 0.0, -np.cos(angle)])

    at = {"hip": np.zeros(3)}
    at["knee"] = at["hip"] + 0.4 * way(hip)
    at["hock"] = at["knee"] + 0.4 * way(hip - knee)
    at["ankle"] = at["hock"] + 0.3 * way(hip - knee + hock)
    at["heel"] = at["ankle"] + [0.0, 0.0, -0.1]
    at["ball"] = at["heel"] + 0.2 * way(hip - knee + hock + ankle_bend)
    return {name: np.tile(point, (frames, 2, 1)) for name, point in at.items()} | {
        "body_rotation_wxyz": np.tile(UPRIGHT, (frames, 1))
    }


def test_angles_are_those_of_the_leg():
    found = joints.angles(legs(0.3, 0.7, 0.5, 1.4), three_links=True)
    assert {name: angle[0, 1] for name, angle in found.items()} == pytest.approx(
        {"hip": 0.3, "knee": 0.7, "hock": 0.5, "ankle": 1.4}
    )
    straight = joints.angles(legs(-0.2, 0.0, 0.0, 1.4), three_links=False)
    assert straight["knee"][0, 0] == pytest.approx(0, abs=1e-12) and straight["hip"][0, 0] == pytest.approx(-0.2)
    assert "hock" not in straight


@given(st.floats(-3, 3), st.floats(-1.4, 1.4), st.floats(-1, 1))
def test_angles_turn_with_the_body(yaw, pitch, roll):
    frames = legs(0.3, 0.7, 0.5, 1.4)
    rotated = {name: np.array([turned(yaw, pitch, roll, *p) for p in value.reshape(-1, 3)]).reshape(value.shape)
               for name, value in frames.items() if value.shape[-1] == 3}  # fmt: skip
    rotated["body_rotation_wxyz"] = np.array([quaternion(yaw, pitch, roll)])
    before, after = joints.angles(frames, True), joints.angles(rotated, True)
    for name in before:
        np.testing.assert_allclose(after[name], before[name], atol=1e-9)


def test_peaks_of_a_sine():
    w, size = 5.0, 0.6
    angle = np.column_stack([size * np.sin(w * TIME), np.zeros(len(TIME))])
    peaks = joints.peaks(angle, TIME)
    assert peaks["velocity"] == pytest.approx(size * w, rel=3e-3)
    assert peaks["acceleration"] == pytest.approx(size * w * w, rel=3e-3)
    assert peaks["most"] == pytest.approx(size, rel=1e-3) and peaks["least"] == pytest.approx(-size, rel=1e-3)
    assert peaks["acceleration_ratio"] < 1.05


def test_a_pop_stands_out():
    angle = np.column_stack([0.6 * np.sin(5 * TIME)] * 2)
    angle[300:, 1] += 0.1
    peaks = joints.peaks(angle, TIME)
    assert peaks["acceleration"] == pytest.approx(0.1 * 60**2, rel=0.05) and peaks["acceleration_ratio"] > 20
    assert peaks["acceleration_time"] == pytest.approx(5.0, abs=0.02)


def test_a_leg_that_does_not_move_has_no_peaks():
    peaks = joints.peaks(np.ones((50, 2)), TIME[:50])
    assert peaks["velocity"] == peaks["acceleration"] == 0 and peaks["acceleration_ratio"] == 1
    assert joints.peaks(np.ones((1, 2)), TIME[:1])["acceleration"] == 0


def distance_by_search(p, q, r, s):
    """Slow twin: a grid over both segments, refined about its best point."""
    p, q, r, s = (np.array(point) for point in (p, q, r, s))
    x, y, width = 0.5, 0.5, 0.5
    for _ in range(12):
        xs, ys = (np.clip(np.linspace(c - width, c + width, 41), 0, 1) for c in (x, y))
        gaps = np.linalg.norm((p + xs[:, None] * (q - p))[:, None] - (r + ys[:, None] * (s - r))[None], axis=2)
        i, j = np.unravel_index(gaps.argmin(), gaps.shape)
        x, y, width = xs[i], ys[j], width / 4
    return gaps.min()


@given(POINT, POINT, POINT, POINT)
def test_segment_distance_is_the_least(p, q, r, s):
    found = joints.segment_distance(*(np.array(point) for point in (p, q, r, s)))
    assert found == pytest.approx(distance_by_search(p, q, r, s), abs=1e-4)


@pytest.mark.parametrize(
    ("segments", "apart"),
    [
        (((0, 0, 0), (1, 0, 0), (0.5, 1, 0.2), (0.5, -1, 0.2)), 0.2),  # crossing
        (((0, 0, 0), (1, 0, 0), (0, 0.3, 0), (1, 0.3, 0)), 0.3),  # parallel
        (((0, 0, 0), (1, 0, 0), (2, 0.3, 0), (3, 0.3, 0)), 1.09**0.5),  # parallel, one behind the other
        (((0, 0, 0), (1, 0, 0), (0.4, 0.5, 0), (0.4, 0.5, 0)), 0.5),  # a point
        (((0, 0, 0), (0, 0, 0), (0, 0, 2), (0, 0, 2)), 2.0),  # two points
    ],
)
def test_segments_with_known_distance(segments, apart):
    assert joints.segment_distance(*(np.array(point, float) for point in segments)) == pytest.approx(apart)


def test_shanks_of_three_links_are_both_looked_at():
    left = np.array([[0.0, 0.1, 1.0], [0.0, 0.1, 0.5], [0.0, 0.1, 0.0]])
    right = np.array([[0.0, -0.1, 1.0], [0.0, -0.1, 0.5], [0.0, 0.07, 0.0]])
    knee, hock, ankle = (np.stack([left[k], right[k]])[None] for k in range(3))
    assert joints.shank_distance(knee, hock, ankle)[0] == pytest.approx(0.03, abs=2e-3)
    assert joints.shank_distance(knee, hock, hock)[0] == pytest.approx(0.2)
