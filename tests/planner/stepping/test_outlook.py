"""Where a way leads: to the furthest place of it that one sees, past the jambs of a door and straight on in it."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.stepping.arriving import look_down
from planner.stepping.field import fields_to
from sim.reports import flows

HUMAN = load_character("human").biped
GOAL = (38.0, 6.0)
DOOR = flows.bottleneck(0.9, 1).world
"""Its neck leads from (13.9, 6) to (15.1, 6), and is 0.9 m wide."""
FIELDS, CELL, _ = fields_to(DOOR, HUMAN, np.array([GOAL]))


def look(x, y):
    return look_down(HUMAN, DOOR.arrays, (x, y), FIELDS[0], CELL, GOAL)


@pytest.mark.parametrize("aside", [-0.2, -0.1, 0.0, 0.1, 0.2])
def test_in_a_door_one_walks_straight_on_wherever_in_it_one_is(aside):
    for x in (13.9, 14.1, 14.5):
        assert abs(look(x, 6 + aside).course) < np.radians(12), "the slope of the cells leads to the middle by up to 71 degrees"


@pytest.mark.parametrize("side", [-1, 1])
def test_from_beside_a_door_one_makes_for_its_jamb(side):
    jamb = np.arctan2(-side * 0.8, 0.6)  # to the place that a body keeps off the corner
    assert look(13.3, 6 + side * 1.0).course == pytest.approx(jamb, abs=0.2)
    assert side * look(13.3, 6 + side * 1.0).course < 0


def test_what_lies_ahead_is_told_beyond_what_is_seen():
    way = look(13.3, 8.0)
    assert np.hypot(way.ahead_x, way.ahead_y) == pytest.approx(1.0)
    assert np.arctan2(way.ahead_y, way.ahead_x) > way.course - 0.3


def test_who_sees_all_of_the_way_makes_for_its_end():
    way = look(20.0, 6.0)
    assert abs(way.course - np.arctan2(way.ahead_y, way.ahead_x)) < 1e-9 and abs(way.course) < 0.1
