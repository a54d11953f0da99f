"""Knees that come too near turn outward, hocks of three links, and nothing else moves."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.measures.joints import shank_distance
from motion.pose import legs
from motion.pose.knees import Shank, keep_apart
from motion.pose.pose import empty_pose

B = load_character("human").biped
LOW = B.foot.ankle_height


def apart_at(yaw, pose, biped=B):
    legs = [Shank(*(tuple(joint[0, side].tolist()) for joint in _joints(pose))) for side in range(2)]
    for side, leg in enumerate(keep_apart(biped, yaw, *legs)):
        for joint, place in zip(_joints(pose), leg, strict=True):
            joint[0, side] = place


def _joints(pose):
    return pose.hip, pose.knee, pose.hock, pose.ankle


CLOSE = [
    ((0.2, -0.05, LOW), (0.0, 0.06, LOW)),  # crossed, the left foot in front
    ((-0.2, -0.09, LOW + 0.08), (0.0, 0.01, LOW)),  # the left foot comes from behind the right one
    ((0.0, -0.02, LOW), (0.33, 0.07, LOW + 0.01)),  # the right foot goes ahead of the left one
]
"""Ankles of left and right legs whose shanks are in each other, but not their feet."""


def posed(yaw, left, right, biped=B):
    """Legs on ankles (forward, to the left, up) of a body that heads `yaw`."""
    pose, c, s = empty_pose(1), np.cos(yaw), np.sin(yaw)
    for side, (x, y, z) in enumerate((left, right)):
        wide = biped.leg.hip_side * (1 - 2 * side)
        hip, ankle = (-wide * s, wide * c, biped.timing.hip_height), (x * c - y * s, x * s + y * c, z)
        knee, hock = legs.joints(biped, hip, ankle, (c, s, 0.0))
        for joint, place in ((pose.hip, hip), (pose.knee, knee), (pose.ankle, ankle), (pose.hock, hock)):
            joint[0, side] = place
    return pose


def apart(pose, biped=B):
    """Gap between the shanks [m]."""
    return shank_distance(pose.knee, pose.hock, pose.ankle)[0] - 2 * biped.leg.shank_radius


@pytest.mark.parametrize("yaw", [0.0, 2.5])
@pytest.mark.parametrize(("left", "right"), CLOSE)
def test_shanks_that_touch_are_turned_apart(yaw, left, right):
    pose = posed(yaw, left, right)
    was = {name: getattr(pose, name).copy() for name in ("hip", "knee", "ankle")}
    assert apart(pose) < -0.002
    apart_at(yaw, pose)
    assert apart(pose) > 0
    for name in ("hip", "ankle"):
        np.testing.assert_array_equal(getattr(pose, name), was[name])
    for end in ("hip", "ankle"):
        before, now = (np.linalg.norm(joints - was[end], axis=2) for joints in (was["knee"], pose.knee))
        np.testing.assert_allclose(now, before, atol=1e-12, err_msg="bones are rigid")


def test_knees_that_are_apart_stay():
    pose = posed(0.3, (0.2, 0.07, LOW), (-0.2, -0.07, LOW))
    knee = pose.knee.copy()
    apart_at(0.3, pose)
    np.testing.assert_array_equal(pose.knee, knee)


def test_a_foot_that_comes_past_turns_them_by_and_by():
    steps = []
    for x in np.arange(-0.4, 0.4, 1e-3):
        pose = posed(0.0, (x, 0.0, LOW + 0.1), (0.0, -0.1, LOW))
        apart_at(0.0, pose)
        steps.append(pose.knee[0].copy())
    assert np.abs(np.diff(steps, axis=0)).max() < 6e-3
    assert np.abs(np.diff(steps, n=2, axis=0)).max() < 6e-4


@pytest.mark.parametrize("yaw", [0.0, 2.5])
@pytest.mark.parametrize("name", ["bird", "dinosaur", "ostrich"])
def test_hocks_turn_outward_below_knees_that_stay(name, yaw):
    """Turned as one with their knees, which are ahead of the leg, these came inward: shanks crossed."""
    biped = load_character(name).biped
    wide, ahead, low = 0.5 * biped.leg.shank_radius, 0.05 * biped.leg.nominal_length, biped.foot.ankle_height
    pose = posed(yaw, (ahead, -wide, low), (-ahead, wide, low), biped)
    was = {name: getattr(pose, name).copy() for name in ("knee", "hock", "ankle")}
    gap = apart(pose, biped)
    apart_at(yaw, pose, biped)
    assert apart(pose, biped) > gap + wide
    for end in ("knee", "ankle"):
        np.testing.assert_array_equal(getattr(pose, end), was[end])
        before, now = (np.linalg.norm(joints - was[end], axis=2) for joints in (was["hock"], pose.hock))
        np.testing.assert_allclose(now, before, atol=1e-12, err_msg="bones are rigid")


def test_a_larger_character_turns_its_knees_as_far():
    twice = load_character("human", 2.0).biped
    for left, right in CLOSE:
        small, large = posed(0.0, left, right), posed(0.0, np.multiply(left, 2), np.multiply(right, 2), twice)
        apart_at(0.0, small)
        apart_at(0.0, large, twice)
        np.testing.assert_allclose(large.knee, 2 * small.knee, atol=1e-9)
