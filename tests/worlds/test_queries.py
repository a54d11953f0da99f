"""Grid queries against brute force over everything in the world."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from worlds import queries
from worlds.arrays import REACH
from worlds.level import level_names, load_level
from worlds.world import River, World


def a_world(seed=0):
    rng = np.random.default_rng(seed)
    trees = np.column_stack([rng.uniform(0, 40, (80, 2)), rng.uniform(0.1, 0.6, 80)])
    rocks = np.column_stack([rng.uniform(0, 40, (40, 2)), rng.uniform(0.3, 1, 40), rng.uniform(0, 0.4, 40)])
    rivers = (River(rng.uniform(0, 40, (4, 2)), 3.0),)
    return World("t", (40.0, 40.0), "hills", (1.0, 20.0, 0.1, 0.2, 0.3), trees=trees, rivers=rivers, rocks=rocks)


WORLD = a_world()


def water_twin(world, x, y):
    best = np.inf
    for river in world.rivers:
        for a, b in zip(river.points, river.points[1:], strict=False):
            s = np.clip(np.dot((x, y) - a, b - a) / np.dot(b - a, b - a), 0, 1)
            best = min(best, np.linalg.norm((x, y) - a - s * (b - a)) - river.width / 2)
    return best


@settings(max_examples=200)
@given(st.floats(-2, 42), st.floats(-2, 42))
def test_clearance_is_the_brute_force_one(x, y):
    w = WORLD.arrays
    trees = (np.hypot(WORLD.trees[:, 0] - x, WORLD.trees[:, 1] - y) - WORLD.trees[:, 2]).min()
    border = min(x, y, 40 - x, 40 - y)
    expected = min(trees, border, water_twin(WORLD, x, y), REACH)
    if 0 <= x <= 40 and 0 <= y <= 40:
        assert queries.clearance(w, x, y) == pytest.approx(expected, abs=1e-9)
    else:
        assert queries.clearance(w, x, y) < 0
    inside = np.flatnonzero(np.hypot(WORLD.rocks[:, 0] - x, WORLD.rocks[:, 1] - y) <= WORLD.rocks[:, 2] - 0.05)
    assert (queries.rock_under(w, x, y, 0.05) in inside) == bool(len(inside))


def test_terrains():
    stairs = World("s", (20.0, 5.0), "stairs", (5.0, 0.2, 0.3, 4.0)).arrays
    heights = [queries.terrain_height(stairs, x, 1.0) for x in (4.9, 5.1, 5.4, 6.5)]
    assert heights == pytest.approx([0, 0.2, 0.4, 0.8])
    spiral = World("s", (10.0, 10.0), "spiral_stairs", (5.0, 5.0, 1.0, 3.0, 0.2, 4.0)).arrays
    assert queries.terrain_height(spiral, 5.0 - 1.4, 5.0 + 1.4) == pytest.approx(0.2)
    assert queries.terrain_height(spiral, 5.1, 5.0) == 0.0
    bumps = World("h", (4.0, 4.0), "heightmap", (2.0,), np.array([[0.0, 1.0], [2.0, 3.0]])).arrays
    assert queries.terrain_height(bumps, 1.0, 1.0) == pytest.approx(1.5)


def test_edits_give_other_worlds_and_dictionaries_round_trip():
    more = WORLD.with_tree(20.0, 20.0, 0.5).with_rock(3.0, 3.0, 0.5, 0.2)
    assert len(more.trees) == len(WORLD.trees) + 1 and len(more.rocks) == len(WORLD.rocks) + 1
    assert queries.tree_clearance(more.arrays, 20.0, 20.0) == pytest.approx(-0.5)
    less = more.without_tree(len(WORLD.trees)).without_rock(len(WORLD.rocks))
    np.testing.assert_array_equal(less.trees, WORLD.trees)
    again = World.from_dict(WORLD.to_dict())
    for mine, theirs in zip(again.arrays, WORLD.arrays, strict=True):
        np.testing.assert_array_equal(mine, theirs)


def test_ten_levels_ship_and_load():
    assert len(level_names()) >= 10
    for name in level_names():
        world = load_level(name)
        assert queries.clearance(world.arrays, *world.start) > 0.5
