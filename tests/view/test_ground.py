"""The terrain in tiles: coarser afar, and nobody sees it."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.wander import Wander
from sim.stage.simulation import Simulation
from sim.view.graphics.gl import NoGL
from sim.view.pictures.offscreen import Picture
from sim.view.scenery import ground
from worlds.level import load_level

SIZE = (480, 270)


def picture(sim, distance, elevation):
    try:
        made = Picture(SIZE)
    except NoGL as error:
        pytest.skip(str(error))
    made.distance, made.camera.elevation = distance, elevation
    return made.frame(sim).astype(int), made.renderer._ground


SIGHTS = [("river_delta", 5.2, 0.32), ("river_delta", 14, 0.8), ("hills", 5.2, 0.1)]


@pytest.mark.parametrize("level, distance, elevation", SIGHTS)
def test_tiles_look_like_the_whole_grid(level, distance, elevation, monkeypatch):
    sim = Simulation(load_level(level), [load_character("bird")], Wander(), 0)
    tiles, drawn = picture(sim, distance, elevation)
    monkeypatch.setattr(ground, "COARSE_PIXELS", 0.0)
    monkeypatch.setattr(ground, "OFF_COLOUR", 1e-9)
    monkeypatch.setattr(ground.detail, "in_view", lambda view, middle, radius: np.ones(len(middle), bool))
    whole, all_of_it = picture(sim, distance, elevation)
    off = np.abs(tiles - whole).max(axis=2)
    assert drawn._mesh._chosen < 0.5 * all_of_it._mesh._chosen
    assert off.mean() < 1.0 and (off > 20).mean() < 1e-3


def test_skirts_look_outward_and_triangles_up():
    pattern = ground._pattern(5, 8, 4, (True,) * 4).reshape(-1, 3, 3).astype(float)
    corners = pattern[..., [1, 0, 2]] * (1, 1, -1)  # x, y, height: what hangs lies lower
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat = ~pattern[:, :, 2].any(axis=1)
    outward = corners.mean(axis=1)[:, :2] - (4, 2.5)
    assert (normals[flat, 2] > 0).all() and (np.sum(normals[~flat, :2] * outward[~flat], axis=1) > 0).all()
    assert 0.5 * normals[flat, 2].sum() == pytest.approx(5 * 8)


def test_skirts_are_where_tiles_of_another_kind_meet():
    sides = ground._sides(np.array([[0, 0, -1], [0, 2, 0]]))
    assert sides[0, 0].tolist() == [False] * 4 and sides[1, 1].tolist() == [True, True, False, True]
    assert sides[0, 1].tolist() == [False, False, True, False] and not sides[1, 2, 0] and sides[1, 2, 3]


def test_what_a_coarser_tile_is_off_by():
    tiles = np.zeros((2, 9, 9, 9))
    tiles[..., 0], tiles[..., 1] = np.meshgrid(np.arange(9), np.arange(9))
    assert not ground._off(tiles, 8).any()
    tiles[1, 4, 4, 2], tiles[1, 2, 2, 6] = 0.4, 2 * ground.OFF_COLOUR
    np.testing.assert_allclose(ground._off(tiles, 8), [(0, 0), (0.4, 2.0)])
    assert not ground._off(tiles, 1).any()
