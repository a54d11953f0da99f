"""Feet are set down beside each other, ankles apart."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion.characters.character import load_character
from motion.track.footprints import Foot
from planner.stepping.beside import HEELS, apart_from, beside, keeps_apart, middle_beside, shanks_apart, sole_heading

B = load_character("human").biped
ROOM = HEELS * B.leg.shank_radius


def ankle(side, place, heading):
    """Where a leg's ankle is [m]."""
    sole = sole_heading(B, side, heading)
    return np.add(place, B.foot.ankle_forward * np.array([np.cos(sole), np.sin(sole)]))


def outward_of(side, heading):
    """Unit vector to a foot's own side."""
    sign = 1 if side == 0 else -1
    return np.array([-sign * np.sin(heading), sign * np.cos(heading)])


@given(st.sampled_from((0, 1)), st.floats(-0.3, 0.3), st.floats(-0.15, 0.15), st.floats(-0.9, 0.9))
def test_a_place_is_moved_outward_until_ankles_are_apart(side, ahead, aside, turn):
    foot, place = Foot(side, 0.0, 0.0, 0.4, 0.0, 0.0), (ahead, aside)
    found = apart_from(B, foot, place, 0.4 + turn)
    across = np.dot(ankle(1 - side, place, 0.4 + turn) - ankle(side, (0.0, 0.0), 0.4), outward_of(1 - side, 0.4 + turn)) < 0
    if across:
        assert found == place
        return
    apart = np.linalg.norm(ankle(1 - side, found, 0.4 + turn) - ankle(side, (0.0, 0.0), 0.4))
    assert shanks_apart(B, foot, *found, 0.4 + turn) and apart >= ROOM - 1e-9
    if found != place:
        assert apart == pytest.approx(ROOM), "and no further"
        assert np.dot(np.subtract(found, place), outward_of(1 - side, 0.4 + turn)) > 0


def test_who_stands_and_who_turns_on_the_spot():
    left = Foot(0, 5.0, 5.0, 0.0, 0.0, 0.0)
    place = beside(B, 1, middle_beside(B, left), 0.0)
    assert apart_from(B, left, place, 0.0) == place and keeps_apart(B, left, *place, 0.0)
    turned = beside(B, 1, middle_beside(B, left), -B.reach.max_turn)
    assert not shanks_apart(B, left, *turned, -B.reach.max_turn), "its heels would be put together"
