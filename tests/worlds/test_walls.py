"""Walls: how far they are, what files say of them, and that nobody stands in one or goes through one."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion.characters.character import load_character
from planner.modes.walk_to import WalkTo
from planner.planner import checked_starts
from planner.stepping.footing import WALL, why_not_stand
from sim.stage.simulation import Simulation
from worlds import queries
from worlds.arrays import REACH
from worlds.errors import InputError
from worlds.level import load_level
from worlds.world import Wall, World

HUMAN = load_character("human")
ANGLE = Wall(np.array([[4.0, 2.0], [4.0, 7.0], [8.0, 9.0]]), 0.4)
WORLD = World("walls", (12.0, 12.0), walls=(ANGLE,), start=(1.0, 1.0))


@given(st.floats(0, 12), st.floats(0, 12))
def test_a_wall_is_as_far_as_its_nearest_piece(x, y):
    best = np.inf
    for a, b in zip(ANGLE.points, ANGLE.points[1:], strict=False):
        s = np.clip(np.dot((x, y) - a, b - a) / np.dot(b - a, b - a), 0, 1)
        best = min(best, np.linalg.norm((x, y) - a - s * (b - a)) - 0.2)
    assert queries.wall_clearance(WORLD.arrays, x, y) == pytest.approx(min(best, REACH), abs=1e-9)
    assert queries.clearance(WORLD.arrays, x, y) == pytest.approx(min(best, REACH, x, y, 12 - x, 12 - y), abs=1e-9)


def test_nobody_stands_in_a_wall_or_starts_beside_it():
    assert why_not_stand(HUMAN.biped, WORLD.arrays, 4.1, 4.0, 0.0) == WALL
    with pytest.raises(InputError, match="a tree or a wall"):
        checked_starts([(4.4, 4.0, 0.0)], WORLD, [HUMAN])
    with pytest.raises(InputError, match="is in a wall"):
        Simulation(WORLD, [HUMAN], WalkTo([(1, 1, 0)], [[(4.0, 4.0)]]))


def test_worlds_with_walls_go_through_plain_values():
    again = World.from_dict(WORLD.to_dict())
    np.testing.assert_array_equal(again.arrays.walls, WORLD.arrays.walls)
    for wrong in ({"points": [[0, 0]], "thickness": 1.0}, {"points": [[0, 0], [1, 1]], "thickness": -1.0}, {"points": 3}):
        with pytest.raises(InputError, match="walls.0"):
            World.from_dict(WORLD.to_dict() | {"walls": [wrong]})


def test_files_tell_what_is_wrong_with_a_wall(tmp_path):
    text = (
        'format = 1\nname = "w"\n[world]\nsize = [9.0, 9.0]\n[start]\nposition = [4.0, 4.0]\n'
        "[[wall]]\npoints = [[4.0, 1.0], [4.0, 8.0]]\n"
    )
    path = tmp_path / "w.toml"
    path.write_text(text, "utf-8")
    with pytest.raises(InputError, match="is inside a wall"):
        load_level(path)
    path.write_text(text + 'thickness = "much"\n', "utf-8")
    with pytest.raises(InputError, match="wall.0.thickness"):
        load_level(path)


def test_a_way_leads_around_walls_and_through_doors():
    world = load_level("rooms")
    sim = Simulation(world, [HUMAN], WalkTo([(4.0, 4.0, 0.0)], [[(4.0, 12.0)]]))
    sim.keep_footprints()
    nearest = np.inf
    while sim.time < 40 and not (sim.time > 5 and sim.crowd.standing[0]):
        sim.tick()
        x, y = sim.com()[0, :2]
        nearest = min(nearest, queries.wall_clearance(world.arrays, x, y))
    assert np.hypot(*(sim.com()[0, :2] - (4.0, 12.0))) < 0.8 and nearest > 0.15
    assert sim.walked().footprints.position[:, 0].max() > 11.3, "through both doors"
