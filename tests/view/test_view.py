"""Pictures through the real renderer, and clicks on the ground."""

import numpy as np
import pytest

from sim.stage.making import make_simulation
from sim.view.graphics.camera import Camera
from sim.view.window import picking
from worlds.level import load_level


@pytest.mark.parametrize("character", ["bird", "dinosaur", "human"])
def test_a_picture_shows_the_character(picture, character):
    sim = make_simulation("forest", character, 1, 0, False)
    for _ in range(120):
        sim.tick()
    picture.renderer.show_overlays = False
    shown = picture.frame(sim).astype(int)
    assert shown.shape == (180, 320, 3) and shown.std() > 20
    main = np.array(sim.characters[0].look.main)
    middle = shown[40:140, 120:200].reshape(-1, 3)
    hue = middle / np.maximum(middle.sum(axis=1, keepdims=True), 1)
    assert (np.abs(hue - main / main.sum()).sum(axis=1) < 0.12).mean() > 0.01


def test_overlays_and_world_edits_are_seen(picture):
    sim = make_simulation("river_easy", "human", 1, 0, True)
    for _ in range(240):
        sim.tick()
    picture.renderer.show_overlays = False
    plain = picture.frame(sim).astype(int)
    picture.renderer.show_overlays = True
    assert np.abs(picture.frame(sim).astype(int) - plain).max() > 60


def test_clicks_find_the_ground():
    world = load_level("hills")
    camera = Camera(target=np.array([35.0, 35.0, 0.0]), distance=20.0)
    place = picking.ground_point(world, *camera.ray(0.0, 0.0, 1.6))
    assert place == pytest.approx((35.0, 35.0), abs=2.5)
    assert picking.ground_point(world, camera.eye, np.array([0.0, 0.0, 1.0])) is None
