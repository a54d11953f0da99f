"""Ways around: distances against known ones, and courses that lead down them."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.stepping.field import course_down, fields_to
from worlds.world import Wall, World

HUMAN = load_character("human").biped
GOAL = np.array([[8.0, 5.0]])


def fields(*walls):
    world = World("w", (10.0, 10.0), walls=tuple(Wall(np.array(points, float), 0.2) for points in walls))
    found, cell, which = fields_to(world, HUMAN, GOAL)
    assert which.tolist() == [0]
    return found[0], cell


def at(field, cell, x, y):
    return field[int(y / cell), int(x / cell)]


def test_nothing_in_the_way_needs_no_field():
    found, _, which = fields_to(World("w", (10.0, 10.0)), HUMAN, GOAL)
    assert len(found) == 0 and which.tolist() == [-1]


def test_distances_in_the_open_are_straight():
    field, cell = fields([(0.5, 9.5), (0.6, 9.5)])
    for x, y in ((2.0, 5.0), (3.0, 2.0), (7.0, 8.0)):
        straight = np.hypot(int(x / cell) * cell + cell / 2 - 8, int(y / cell) * cell + cell / 2 - 5)
        assert at(field, cell, x, y) == pytest.approx(straight, rel=0.06, abs=0.1)
        assert course_down(field, cell, x, y, 9.0) == pytest.approx(np.arctan2(5 - y, 8 - x), abs=0.12)


def test_a_way_leads_around_the_end_of_a_wall():
    field, cell = fields([(5.0, 0.0), (5.0, 8.0)])
    around = np.hypot(3.0, 3.4) + 0.7 + np.hypot(2.7, 3.4)
    assert at(field, cell, 2.0, 5.0) == pytest.approx(around, rel=0.12)
    assert 0.5 < course_down(field, cell, 2.0, 5.0, 9.0) < 1.2
    assert not np.isfinite(at(field, cell, 5.0, 4.0)), "nobody is in the wall"


def test_where_no_way_leads_one_goes_straight():
    field, cell = fields([(5.0, 0.0), (5.0, 10.0)])
    assert not np.isfinite(at(field, cell, 2.0, 5.0)) and course_down(field, cell, 2.0, 5.0, 0.3) == 0.3
