"""Levels and scenes are switched between at once, in any window."""

import argparse

from planner.script.scene import scene_names
from sim.stage.scripted.performance import Performance
from sim.view.window.app import App
from sim.view.window.choosing import is_scene, maker, places
from worlds.level import level_names


def test_a_window_goes_to_any_level_and_scene():
    make = maker("wander", 2)
    app = App(make, make("forest", "bird", 0), argparse.Namespace(level="forest", character="bird", seed=0), level_names())
    for level, kind, planner in (("river_easy", "bird", "Wander"), ("sprint", "human", None), ("hills", "bird", "Wander")):
        app.choose(level=level)
        assert app.level == level and app.sim.characters[0].name == kind
        assert isinstance(app.sim, Performance) if planner is None else app.sim.planner.name == planner
        app.advance(0.1)
    app.choose(level="sprint"), app.choose(character="ostrich")
    assert app.sim.characters[0].name == "ostrich" or "ostrich" in app.notice
    assert set(places()) == {*level_names(), *scene_names()}


def test_rivers_are_crossed_or_wandered_as_the_command_says():
    for command, name in (("wander", "Wander"), ("river", "RockHop"), ("play", "RockHop"), ("steer", "Steered")):
        assert maker(command, 1)("river_easy", None, 0).planner.name == name


def test_files_are_told_apart_by_what_they_hold(tmp_path):
    scene, level = tmp_path / "scene.toml", tmp_path / "level.toml"
    scene.write_text('format = 1\nname = "a"\n[world]\nsize = [9, 9]\n[[footprint]]\nside = "left"\nposition = [1, 1]\n')
    level.write_text('format = 1\nname = "a"\n[world]\nsize = [9, 9]\n[start]\nposition = [3, 3]\n')
    assert is_scene(str(scene)) and not is_scene(str(level)) and is_scene("sprint") and not is_scene("forest")
