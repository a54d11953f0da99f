"""The plan view, which is all there is without OpenGL: it draws every level and every scene that ships."""

import argparse

import numpy as np
import pytest

from planner.script.scene import load_scene, scene_names
from sim.stage.making import make_simulation
from sim.stage.scripted.performance import Performance
from sim.view.pictures import plan_view
from sim.view.pictures.results import Wanted
from sim.view.window import window
from worlds.level import level_names

LEVELS = [name for name in level_names() if name != "river_impossible"]


def cast(name):
    if name in scene_names():
        return Performance(load_scene(name))
    return make_simulation(name, "bird", 1, 0, name in level_names(with_goal=True))


@pytest.mark.parametrize("name", [*LEVELS, *scene_names()])
def test_every_level_and_scene_is_drawn(name):
    sim = cast(name)
    for _ in range(30):
        sim.tick()
    pixels = plan_view.plan_picture(sim, (320, 180))
    assert pixels.shape == (180, 320, 3)
    assert tuple(pixels[90, 160]) == plan_view.BODY  # the first character, in the middle
    seen = {tuple(colour) for colour in np.unique(pixels.reshape(-1, 3), axis=0).tolist()}
    allowed = {plan_view.GRASS, plan_view.WATER, plan_view.TREE, plan_view.STONE, plan_view.SOLE, plan_view.BODY}
    allowed |= {plan_view.PLASTER}
    assert plan_view.BODY in seen <= allowed


@pytest.mark.parametrize("name", ["forest", "river_easy", "rock_field", "fig01_steps_and_a_hop"])
def test_a_window_without_opengl_runs_to_its_end(name, monkeypatch, tmp_path, capsys):
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")  # a display that has no OpenGL
    options = argparse.Namespace(level=name, character="bird", seed=0, seconds=0.2, size=(320, 180), json=False)
    wanted = Wanted(record=str(tmp_path / "run.npz"))
    assert window.run_window(lambda *_: cast(name), cast(name), options, [name], wanted, lambda: False) == 0
    assert "showing the plan view" in capsys.readouterr().err
    with np.load(tmp_path / "run.npz") as run:
        assert len(run["time"]) == 13
