"""The standing foot: it pivots on its ball where the way turns sharply, and nowhere else."""

import numpy as np
import pytest

from motion.characters.character import character_names, load_character
from motion.pose.pose import empty_pose
from motion.pose.posing import pose_into
from motion.track import foot
from motion.track.curve import Track
from tests.walks import solved, straight_walk

TWIST = np.radians(25)
SHARP = np.radians(75)


def turning_once(character, turn):
    """A straight walk that goes on in another direction from footprint 7 on."""
    b = load_character(character).biped
    footprints = straight_walk(b)
    bend, c, s = footprints.position[6].copy(), np.cos(turn), np.sin(turn)
    ahead = footprints.position[7:, :2] - bend[:2]
    footprints.position[7:, :2] = bend[:2] + ahead @ np.array([[c, s], [-s, c]])
    footprints.heading[7:] = turn
    return b, footprints


@pytest.mark.parametrize("character", character_names())
def test_no_foot_pivots_in_turns_that_its_walker_likes(character):
    b, footprints = turning_once(character, float(load_character(character).biped.reach.max_turn))
    assert all(foot.turned_by(b, footprints, n, 1.0) == 0.0 for n in range(len(footprints.side)))


def test_a_foot_pivots_on_its_ball_and_stays_within_what_its_knee_bears():
    b, footprints = turning_once("human", SHARP)
    track, pose, n = Track(footprints, solved(b, footprints)), empty_pose(1), 6
    side, twists, balls = footprints.side[n], [], []
    begin = footprints.contact_time[n]
    for t in np.arange(begin, begin + footprints.stance_time[n], 0.01):
        pose_into(b, track, t, pose)
        hip, knee, ankle = pose.hip[0, side], pose.knee[0, side], pose.ankle[0, side]
        bend = knee - hip - (ankle - hip) * ((knee - hip) @ (ankle - hip)) / ((ankle - hip) @ (ankle - hip))
        sole = pose.toe[0, side] - pose.ball[0, side]
        twists.append(np.arctan2(bend[0] * sole[1] - bend[1] * sole[0], bend[:2] @ sole[:2]))
        if foot.stance_share(footprints, n, t) > foot.FLAT_BY:
            balls.append(pose.ball[0, side].copy())
    assert np.abs(foot.turned_by(b, footprints, n, 1.0)) > 0.3
    assert np.abs(twists).max() < TWIST
    assert np.ptp(balls, axis=0).max() < 1e-9


def test_a_foot_that_pivoted_swings_on_from_where_it_turned_to():
    b, footprints = turning_once("human", SHARP)
    track, n = Track(footprints, solved(b, footprints)), 6
    side, leaves = footprints.side[n], footprints.contact_time[n] + footprints.stance_time[n]
    before, after = empty_pose(1), empty_pose(1)
    pose_into(b, track, leaves - 1e-7, before)
    pose_into(b, track, leaves + 1e-7, after)
    assert before.contact[0, side] and not after.contact[0, side]
    for name in ("heel", "ball", "toe", "ankle", "knee"):
        assert np.linalg.norm(getattr(after, name)[0, side] - getattr(before, name)[0, side]) < 1e-5, name
