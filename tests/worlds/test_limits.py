"""What no world can be is refused where it is made, with the key; what can be is listed as brute force lists it."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from worlds.arrays import CELL, bucket
from worlds.contents.scatter import Scatter, scattered
from worlds.errors import InputError
from worlds.level import load_level
from worlds.world import River, World

NAN, INF = float("nan"), float("inf")
SIZE = (20.0, 20.0)
BAD = {
    "size": {"size": (0.0, 20.0)},
    "size.x": {"size": (NAN, 20.0)},
    "square metres": {"size": (9000.0, 9000.0)},
    "terrain =": {"terrain": "moon"},
    "hills needs 5": {"terrain": "hills"},
    "wavelength": {"terrain": "hills", "terrain_parameters": (1.0, 0.0, 0.0, 0.0, 0.0)},
    "spacing": {"terrain": "heightmap", "terrain_parameters": (INF,)},
    "inner radius": {"terrain": "spiral_stairs", "terrain_parameters": (5.0, 5.0, 3.0, 1.0, 0.2, 8)},
    "heights": {"heights": np.array([[0.0, NAN], [0.0, 0.0]])},
    "heights of shape": {"heights": np.zeros(3)},
    "trees: finite": {"trees": np.array([[1.0, INF, 0.3]])},
    "trees.0": {"trees": np.array([[1.0, 1.0, -0.3]])},
    "trees of shape": {"trees": np.zeros((2, 4))},
    "not of str": {"rocks": [["1", "1", "1", "1"]]},
    "rocks.1": {"rocks": np.array([[1.0, 1.0, 0.3, 0.1], [1e155, 1.0, 0.3, 0.1]])},
    "cells of the grid": {"size": (2000.0, 2000.0), "trees": np.tile([1000.0, 1000.0, 900.0], (20, 1))},
    "rivers.0.width": {"rivers": (River(np.zeros((2, 2)), NAN),)},
    "rivers.0.points": {"rivers": (River(np.zeros((1, 2)), 1.0),)},
    "start.x": {"start": (True, 1.0)},
    "start_heading": {"start_heading": NAN},
    "goal": {"goal": (1.0,)},
    "goal_radius": {"goal_radius": -1.0},
    "name": {"name": 3},
}


@pytest.mark.parametrize("said", BAD)
def test_what_no_world_can_be_is_refused(said):
    with pytest.raises(InputError, match=said):
        World(**({"name": "w", "size": SIZE} | BAD[said]))


def test_a_dictionary_is_as_strict_as_the_class():
    whole = World("w", SIZE, goal=(1.0, 2.0), rivers=(River(np.zeros((2, 2)), 1.0),)).to_dict()
    assert World.from_dict(whole).to_dict() == whole
    for changed in ({"trees": "abc"}, {"rivers": [1]}, {"size": None}, {"moons": 2}, {"heights": [["1"]]}):
        with pytest.raises(InputError):
            World.from_dict(whole | changed)


def test_heights_may_lie_elsewhere():
    world = World("w", SIZE, "heightmap", (1.0,), np.arange(6.0).reshape(2, 3))
    assert world.to_dict(heights=False)["heights"] is None
    again = World.from_dict(world.to_dict(heights=False), world.heights)
    np.testing.assert_array_equal(again.heights, world.heights)


def bucket_twin(boxes, shape):
    cells = [
        [i for i, (x0, y0, x1, y1) in enumerate(np.floor(boxes / CELL)) if x0 <= column <= x1 and y0 <= row <= y1]
        for row in range(shape[0])
        for column in range(shape[1])
    ]
    return np.cumsum([0] + [len(cell) for cell in cells]), [i for cell in cells for i in cell]


@settings(max_examples=60)
@given(st.lists(st.tuples(st.floats(-9, 19), st.floats(-9, 19), st.floats(0, 9), st.floats(0, 9)), max_size=8))
def test_cells_list_what_meets_them(found):
    boxes = np.array([(x, y, x + w, y + h) for x, y, w, h in found]).reshape(-1, 4)
    start, index = bucket(boxes, (4, 6))
    twin_start, twin_index = bucket_twin(boxes, (4, 6))
    assert start.tolist() == twin_start.tolist() and index.tolist() == twin_index


def test_scattered_things_keep_their_distances():
    bare = World("w", (60.0, 60.0), start=(30.0, 30.0), rivers=(River(np.array([[0.0, 5.0], [60.0, 5.0]]), 2.0),))
    world = scattered(bare, Scatter(seed=2, trees=400, tree_spacing=1.5, rocks=30))
    apart = np.hypot(*(world.trees[:, None, :2] - world.trees[None, :, :2]).T) - world.trees[:, 2] - world.trees[None, :, 2].T
    assert len(world.trees) > 200 and (apart + np.eye(len(apart)) * 9).min() >= 1.5 - 1e-9
    assert (np.hypot(*(world.trees[:, :2] - 30).T) - world.trees[:, 2]).min() >= 3.0 - 1e-9
    assert (np.abs(world.trees[:, 1] - 5) - 1 - world.trees[:, 2]).min() > 0.5 - 1e-9 and len(world.rocks) == 30


TOML = 'format = 1\nname = "t"\n[world]\nsize = [20.0, 20.0]\n[start]\nposition = [5.0, 5.0]\n'


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_a_text_says_how_it_is_written(tmp_path, encoding):
    path = tmp_path / "level.toml"
    path.write_bytes(TOML.replace("\n", "\r\n").replace('"t"', '"Fußweg"').encode(encoding))
    assert load_level(path).name == "Fußweg"


WRONG = {
    "UTF-8": TOML.replace('"t"', '"ü"').encode("latin-1"),
    "C:/folder/file": (TOML + '[world.heightmap]\nfile = "C:\\users\\x.png"\n').encode(),
    "nested too deeply": (TOML + "tree = " + "[" * 9000 + "]" * 9000).encode(),
    "format = true": TOML.replace("format = 1", "format = true").encode(),
    "position.0 = '12'": (TOML + '[[tree]]\nposition = ["12", 3.0]\nradius = 1\n').encode(),
    "radius = true": (TOML + "[[tree]]\nposition = [12, 3.0]\nradius = true\n").encode(),
    "square metres": TOML.replace("size = [20.0, 20.0]", "size = [10000, 10000]").encode(),
}


@pytest.mark.parametrize("said", WRONG)
def test_what_is_wrong_with_a_file_is_told(tmp_path, said):
    path = tmp_path / "level.toml"
    path.write_bytes(WRONG[said])
    with pytest.raises(InputError, match=said):
        load_level(path)


def test_names_that_no_file_can_have_are_refused(tmp_path):
    for name in ("x" * 5000, "a\0b", str(tmp_path)):
        with pytest.raises(InputError):
            load_level(name)


def test_a_picture_too_large_is_refused_before_it_is_unpacked(tmp_path):
    head = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + (20000).to_bytes(4, "big") * 2 + b"\x10\0\0\0\0\0\0\0\0"
    (tmp_path / "map.png").write_bytes(head)
    (tmp_path / "level.toml").write_text(
        TOML.replace("[start]", 'terrain = "heightmap"\n[world.heightmap]\nfile = "map.png"\n[start]')
    )
    with pytest.raises(InputError, match="20000 x 20000 pixels"):
        load_level(tmp_path / "level.toml")
