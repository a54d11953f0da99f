"""Feet, legs and heading: exact where they must be, smooth everywhere."""

import numpy as np
import pytest

from motion.characters.biped import CharacterError, character_names, load_biped
from motion.com import laying, newton
from motion.com.problem import straight_guess
from motion.pose import legs, swing
from motion.pose.pose import empty_pose, pose_kernel
from motion.track import foot, heading
from motion.track.footprints import Track


def straight_walk(b, n=14, stride=1.0, turn=0.0):
    step = stride * b.preferred_step
    side = np.arange(n) % 2
    yaw = turn * np.arange(n)
    along = np.cumsum(np.stack([np.cos(yaw), np.sin(yaw)], axis=1) * step, axis=0)
    across = np.stack([-np.sin(yaw), np.cos(yaw)], axis=1) * (b.step_width / 2 * (1 - 2 * side))[:, None]
    position = np.column_stack([along + across, np.zeros(n)])
    normal = np.tile([0.0, 0.0, 1.0], (n, 1))
    roll = np.tile([0.0, 1.0], (n, 1))
    time = 0.5 * (b.hip_height / 0.92) ** 0.5
    return Track(
        side, position, yaw, normal, time * np.arange(n), np.full(n, 1.2 * time), np.full(n, time), roll,
        np.full(n, b.nominal_length), np.zeros(n), np.full(n, 0.05), np.full(n, 0.1),
    )  # fmt: skip


def solved(b, track):
    problem, _ = laying.build_problem(b, track, track.contact_time[1], track.contact_time[-1], 5, False)
    control = np.zeros((len(problem.time), 6))
    straight_guess(problem, control, 0)
    newton.minimise(problem, control, newton.SCENE)
    return problem.time, control


@pytest.mark.parametrize("name", character_names())
def test_pose_is_exact_and_smooth(name):
    b = load_biped(name).record
    track = straight_walk(b, turn=0.1)
    time, control = solved(b, track)
    pose, last = empty_pose(1), None
    for t in np.arange(track.contact_time[4], track.contact_time[9], 1e-3):
        pose_kernel(b, track, time, control, t, pose, 0)
        for side in (0, 1):
            if pose.contact[0, side]:
                n = max(i for i in range(14) if track.side[i] == side and track.contact_time[i] <= t)
                toe = foot.along_sole(track.position[n], track.heading[n], track.normal[n], 0.5 * b.foot_length, 0.0)
                np.testing.assert_allclose(pose.toe[0, side], toe, atol=1e-9)
            links = np.linalg.norm(pose.hip - pose.knee, axis=2)[0, side]
            assert links >= b.thigh - 1e-9
        joints = np.concatenate([pose.knee, pose.hock, pose.ankle, pose.heel, pose.toe], axis=1)
        if last is not None:
            assert np.abs(joints - last).max() < 0.02 * (1 + b.preferred_step)
        last = joints.copy()


def test_knees_bend_forward():
    for name in character_names():
        b = load_biped(name).record
        knee, hock = legs.joints(b, (0.0, 0.0, b.hip_height), (0.0, 0.0, b.ankle_height), (1.0, 0.0, 0.0))
        assert knee[0] > 0
        if b.metatarsus:
            assert hock[0] < 0
        lengths = [np.linalg.norm(np.subtract(*pair)) for pair in (((0, 0, b.hip_height), knee), (knee, hock))]
        assert lengths == pytest.approx([b.thigh, b.shank])


def test_point_of_support_rolls_from_heel_to_toe():
    b = load_biped("human").record
    track = straight_walk(b)
    for u in (0.0, 0.3, 1.0):
        at = foot.point_of_support(b, track, 3, u)
        assert at[0] - track.position[3, 0] == pytest.approx((u - 0.5) * b.foot_length)


def test_heel_off_lifts_the_ankle_nine_centimetres():
    b, track = load_biped("human").record, straight_walk(load_biped("human").record)
    flat, off = foot.stance_ankle(b, track, 3, 0.5), foot.stance_ankle(b, track, 3, 1.0)
    assert flat == pytest.approx(foot.stance_ankle(b, track, 3, 0.0))
    assert off[2] - flat[2] == pytest.approx(0.06, abs=0.03) and off[0] - flat[0] == pytest.approx(0.08, abs=0.03)


def test_swing_starts_and_ends_on_its_footprints():
    b = load_biped("human").record
    track = straight_walk(b)
    for s, n in ((0.0, 3), (1.0, 5)):
        ball, yaw, _, pitch, flex = swing.sole_at(b, track, 3, 5, s)
        np.testing.assert_allclose(
            ball, foot.along_sole(track.position[n], track.heading[n], track.normal[n], b.ball_forward, 0.0), atol=1e-12
        )
        assert pitch == pytest.approx(b.heel_off_angle * (1 - s)) and flex == pytest.approx(b.heel_off_angle * (1 - s))


def test_heading_is_the_box_average_of_the_line():
    b = load_biped("human").record
    track = straight_walk(b, turn=0.2)
    window_length = heading.window_length(b)
    value = 0.5 * (track.heading + np.append(track.heading[1:], track.heading[-1]))
    for t in (1.3, 2.2, 3.05):
        taus = np.linspace(t - window_length, t, 20001)
        expected = np.interp(taus, track.contact_time, value).mean()
        assert heading.body_heading(b, track, t) == pytest.approx(expected, abs=1e-4)


def test_character_files_are_checked(tmp_path):
    with pytest.raises(CharacterError, match="there are bird"):
        load_biped("unicorn")
    path = tmp_path / "x.toml"
    path.write_text('format = 1\nname = "x"\n[biped]\nthigh = -1.0\nfoo = 2\n')
    with pytest.raises(CharacterError) as told:
        load_biped(path)
    assert all(part in str(told.value) for part in ("biped.thigh", "biped.foo", "biped.shank"))
