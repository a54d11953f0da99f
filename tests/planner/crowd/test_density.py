"""How much of the ground ahead walls leave, and how dense it is between them."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.crowd.choosing import _dense
from planner.stepping.steering import BESIDE, LAST, open_ahead
from tests.planner.crowd.test_avoiding import around, nothing_held
from tests.planner.crowd.test_terms import B, other, waiting
from worlds.world import Wall, World

HUMAN, FAR = load_character("human").biped, 2.4


def neck(wide, end=30.0, begin=1.0):
    """A world with two walls along the course of who stands at 5, 5, so far from each other, from and to there."""
    off = 0.5 * (wide + 0.2)
    lines = [np.array([(begin, y), (end, y)]) for y in (5 - off, 5 + off)]
    return World("neck", (40.0, 10.0), walls=tuple(Wall(line, 0.2) for line in lines))


def part(world, room=0.3):
    return open_ahead(HUMAN, world.arrays, 5.0, 5.0, 0.0, room, FAR, 0.15)


@pytest.mark.parametrize("wide", [1.2, 2.0, 3.0])
def test_between_walls_the_share_of_a_section_across_the_half_disc_is_open(wide):
    """By centimetres of the furthest section, in which what is near counts more (terms.covered)."""
    y = np.arange(-FAR, FAR, 0.01)
    weight = np.maximum(1 - LAST**2 - (y / FAR) ** 2, 0)
    assert part(neck(wide)) == pytest.approx(weight[np.abs(y) < 0.5 * wide - BESIDE].sum() / weight.sum(), abs=0.02)
    assert part(neck(wide)) < part(neck(wide + 0.5)) < 1


def test_where_no_wall_is_near_all_is_open():
    assert part(World("plain", (40.0, 10.0)), room=5.0) == 1
    assert part(World("plain", (40.0, 10.0))) == pytest.approx(1, abs=0.01)


def test_who_comes_to_the_end_of_a_neck_counts_the_room_behind_it():
    assert part(neck(1.2, end=6.0)) > 0.9 > 0.5 > part(neck(1.2, end=9.0))


def test_nobody_sees_through_a_wall():
    across = Wall(np.array([(6.0, 1.0), (6.0, 9.0)]), 0.2)
    before = neck(1.2, end=6.0)
    shut = World("shut", before.size, walls=(*before.walls, across))
    assert part(shut) < 0.5 < 0.9 < part(before)


def test_no_less_is_open_than_is_asked_for():
    assert part(neck(0.1), room=0.05) == 0.15


def test_a_file_between_walls_is_denser_than_in_the_open():
    me, file = waiting()._replace(room=0.5), np.concatenate([other(1.0, 0.0), other(2.0, 0.0)]).view(np.recarray)
    covers = []
    for world in (neck(1.2), World("plain", (40.0, 10.0))):
        round = around(nothing_held(), world)._replace(bipeds=np.array([B], B.dtype).view(np.recarray))
        dense = np.zeros((2, 3))
        covers.append(dense[: _dense(round, me, file, dense), 2].sum())
    assert covers[0] > 2 * covers[1] > 0
