"""Feet, legs and heading: exact where they must be, smooth everywhere."""

import numpy as np
import pytest

from motion.characters.character import character_names, load_character
from motion.pose import legs, swing, trunk
from motion.pose.pose import empty_pose
from motion.pose.posing import pose_into
from motion.track import foot, heading
from motion.track.curve import Track
from tests.walks import solved, straight_walk


@pytest.mark.parametrize("name", character_names())
def test_pose_is_exact_and_smooth(name):
    b = load_character(name).biped
    footprints = straight_walk(b, turn=0.1)
    track = Track(footprints, solved(b, footprints))
    pose, last = empty_pose(1), None
    for t in np.arange(footprints.contact_time[4], footprints.contact_time[9], 1e-3):
        pose_into(b, track, t, pose)
        for side in (0, 1):
            if pose.contact[0, side]:
                n = max(i for i in range(14) if footprints.side[i] == side and footprints.contact_time[i] <= t)
                toe = foot.along_sole(footprints, n, 0.5 * b.foot.length, 0.0)
                np.testing.assert_allclose(pose.toe[0, side], toe, atol=1e-9)
            links = np.linalg.norm(pose.hip - pose.knee, axis=2)[0, side]
            assert links >= b.leg.thigh - 1e-9
        joints = np.concatenate([pose.knee, pose.hock, pose.ankle, pose.heel, pose.toe], axis=1)
        if last is not None:
            assert np.abs(joints - last).max() < 0.02 * (1 + b.gait.preferred_step)
        last = joints.copy()


def test_knees_bend_forward():
    for name in character_names():
        b = load_character(name).biped
        knee, hock = legs.joints(b, (0.0, 0.0, b.timing.hip_height), (0.0, 0.0, b.foot.ankle_height), (1.0, 0.0, 0.0))
        assert knee[0] > 0
        if b.leg.metatarsus:
            assert hock[0] < 0
        lengths = [np.linalg.norm(np.subtract(*pair)) for pair in (((0, 0, b.timing.hip_height), knee), (knee, hock))]
        assert lengths == pytest.approx([b.leg.thigh, b.leg.shank])


def test_point_of_support_rolls_from_heel_to_toe():
    b = load_character("human").biped
    footprints = straight_walk(b)
    for u in (0.0, 0.3, 1.0):
        at = foot.point_of_support(b, footprints, 3, u)
        assert at[0] - footprints.position[3, 0] == pytest.approx((u - 0.5) * b.foot.length)


def test_heel_off_lifts_the_ankle_nine_centimetres():
    b, footprints = load_character("human").biped, straight_walk(load_character("human").biped)
    flat, off = foot.stance_ankle(b, footprints, 3, 0.5), foot.stance_ankle(b, footprints, 3, 1.0)
    assert flat == pytest.approx(foot.stance_ankle(b, footprints, 3, 0.0))
    assert off[2] - flat[2] == pytest.approx(0.06, abs=0.03) and off[0] - flat[0] == pytest.approx(0.08, abs=0.03)


def test_swing_starts_and_ends_on_its_footprints():
    b = load_character("human").biped
    footprints = straight_walk(b)
    for s, n in ((0.0, 3), (1.0, 5)):
        sole = swing.sole_at(b, footprints, 3, 5, s)
        np.testing.assert_allclose(sole.ball, foot.along_sole(footprints, n, b.foot.ball_forward, 0.0), atol=1e-12)
        assert sole.pitch == pytest.approx(b.foot.heel_off_angle * (1 - s)) == sole.flex


def test_heading_is_the_box_average_of_the_line():
    b = load_character("human").biped
    footprints = straight_walk(b, turn=0.2)
    window_length = heading.window_length(b)
    value = 0.5 * (footprints.heading + np.append(footprints.heading[1:], footprints.heading[-1]))
    for t in (1.3, 2.2, 3.05):
        taus = np.linspace(t - window_length, t, 20001)
        expected = np.interp(taus, footprints.contact_time, value).mean()
        assert heading.body_heading(b, footprints, t) == pytest.approx(expected, abs=1e-4)


def test_who_stands_breathes_and_looks_around_and_who_walks_does_not():
    b = load_character("human").biped
    still, walking = trunk.Past(*[(0.0, 0.0, 0.0)] * 3), trunk.Past(*[(-1.3 * trunk.delay(b) * k, 0.0, 0.0) for k in range(3)])
    moments = np.arange(0.0, 60.0, 1 / 60)
    life = np.array([trunk.idle_life(b, still, t) for t in moments])
    assert np.abs(life[:, 0]).max() == pytest.approx(trunk.BREATH, rel=1e-3)
    assert 0.3 < np.abs(life[:, 1]).max() <= trunk.LOOKS_AROUND
    assert np.abs(np.diff(life, axis=0)).max() < 0.03  # no jump from frame to frame [rad]
    assert all(trunk.idle_life(b, walking, t) == (0.0, 0.0) for t in (0.0, 7.3))


@pytest.mark.parametrize("character", character_names())
def test_knees_do_not_turn_over_where_a_foot_is_kicked_up_behind(character):
    b = load_character(character).biped
    hip, d, knees = (0.0, 0.0, 1.0), 0.7 * b.leg.nominal_length, []
    for angle in np.linspace(-0.3, 2.2, 500):  # of the leg behind straight down
        ankle = (-d * np.sin(angle), 0.05 * d, 1.0 - d * np.cos(angle))
        knees.append(legs.joints(b, hip, ankle, (1.0, 0.0, 0.0))[0])
    assert np.linalg.norm(np.diff(knees, axis=0), axis=1).max() < 0.02 * b.leg.nominal_length


@pytest.mark.parametrize("name", character_names())
def test_a_foot_left_on_a_height_is_swung_under_the_hip(name):
    b = load_character(name).biped
    footprints = straight_walk(b)
    footprints.position[:7, 2] = 0.6 * b.leg.nominal_length  # and none lower than footprint 7
    footprints.lift[8], footprints.hold[8] = 0.65 * b.leg.nominal_length, swing.EDGE_HOLD
    track = Track(footprints, solved(b, footprints))
    begin, end, side = footprints.contact_time[6] + footprints.stance_time[6], footprints.contact_time[8], footprints.side[8]
    pose, before = empty_pose(1), None
    for t in np.arange(begin, end, 1 / 60):
        pose_into(b, track, t, pose)
        knee = (pose.knee[0] - pose.com[0])[side]
        if before is not None:
            assert np.linalg.norm(knee - before) < 0.25 * b.leg.nominal_length
        before = knee
        s, aside = (t - begin) / (end - begin), np.hypot(*(pose.ankle - pose.hip)[0, side, :2])
        if 0.3 < s < 0.7 and aside < 0.5 * b.leg.min_length:
            assert pose.ankle[0, side, 2] < pose.hip[0, side, 2] - 0.7 * b.leg.min_length


def moved(track, height):
    """The track of a body that is `height` [m] higher."""
    control = track.curve.control.copy()
    control[:, 2] += height
    return Track(track.footprints, track.curve._replace(control=control))


@pytest.mark.parametrize("name", character_names())
@pytest.mark.parametrize("height", [0.95, 1.2, 1.5])
def test_who_goes_low_does_not_push_a_swinging_foot_into_the_ground(name, height):
    b, pose = load_character(name).biped, empty_pose(1)
    footprints = straight_walk(b)
    track = Track(footprints, solved(b, footprints))
    hips = b.foot.ankle_height + height * b.leg.min_length
    low = moved(track, hips - b.leg.hip_up - track.curve.control[:, 2].max())
    for t in np.arange(footprints.contact_time[5], footprints.contact_time[8], 1 / 120):
        pose_into(b, low, t, pose)
        assert min(pose.heel[..., 2].min(), pose.ball[..., 2].min(), pose.toe[..., 2].min()) > -3e-3


@pytest.mark.parametrize("name", character_names())
def test_no_foot_jumps_where_its_leg_is_too_long_for_its_landing(name):
    b, pose, after, strike = load_character(name).biped, empty_pose(1), empty_pose(1), 0.3
    footprints = straight_walk(b)
    footprints.strike[:] = strike
    track = Track(footprints, solved(b, footprints))
    pose_into(b, track, footprints.contact_time[7], pose)
    way = (pose.hip - pose.ankle)[0, footprints.side[7]]
    long = moved(track, np.sqrt((1.02 * b.leg.max_length) ** 2 - way[0] ** 2 - way[1] ** 2) - way[2])
    pose_into(b, long, footprints.contact_time[7] - 1e-6, pose)
    pose_into(b, long, footprints.contact_time[7] + 1e-6, after)
    for joint, then in ((pose.knee, after.knee), (pose.hock, after.hock), (pose.ankle, after.ankle), (pose.toe, after.toe)):
        assert np.abs(joint - then).max() < 1e-4
    foot_up = np.arcsin((after.toe - after.heel)[0, footprints.side[7], 2] / b.foot.length)
    assert foot_up > strike + 0.01, "and it does tilt"


@pytest.mark.parametrize("name", character_names())
def test_a_foot_whose_leg_stays_too_long_does_not_change_over_from_heel_to_ball_at_once(name):
    b, poses = load_character(name).biped, (empty_pose(1), empty_pose(1))
    footprints = straight_walk(b)
    footprints.strike[:] = 0.3
    track, side = Track(footprints, solved(b, footprints)), footprints.side[7]
    flat = footprints.contact_time[7] + foot.FLAT_BY * footprints.stance_time[7]
    pose_into(b, track, flat, poses[0])
    way = (poses[0].hip - poses[0].ankle)[0, side]
    long = moved(track, np.sqrt((1.02 * b.leg.max_length) ** 2 - way[0] ** 2 - way[1] ** 2) - way[2])
    for pose, t in zip(poses, (flat - 1e-6, flat + 1e-6), strict=True):
        pose_into(b, long, t, pose)
    for joint in ("heel", "ball", "toe", "ankle", "knee"):
        assert np.abs(getattr(poses[0], joint) - getattr(poses[1], joint)).max() < 1e-4, joint
    assert (poses[1].toe - poses[1].heel)[0, side, 2] > 0.01, "the toes are up"


@pytest.mark.parametrize("name", [name for name in character_names() if load_character(name).biped.leg.metatarsus])
def test_no_knee_is_kicked_where_a_leg_of_three_links_opens(name):
    b = load_character(name).biped
    far, knees = b.leg.thigh + legs.FOLDED * (b.leg.shank + b.leg.metatarsus), []
    for d in np.linspace(0.9 * far, 1.1 * far, 401):  # ahead of the hip, where the thigh is drawn to the leg
        knees.append(legs.joints(b, (0.0, 0.0, 1.0), (d, 0.0, 1.0), (1.0, 0.0, 0.0))[0])
    speed = np.diff(knees, axis=0) / (0.0005 * far)
    assert np.linalg.norm(np.diff(speed, axis=0), axis=1).max() < 0.1
