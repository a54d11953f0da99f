"""Keys and mouse, through SDL's offscreen driver.

These run before the pictures of test_view: SDL cannot open a window once the process holds a context without one.
"""

import argparse
import os

import numpy as np
import pytest

from motion.characters.character import character_names
from sim.stage.making import make_simulation
from sim.view.graphics import gl


@pytest.fixture
def app():
    from sim.view.window.app import App

    options = argparse.Namespace(level="river_easy", character="human", seed=0)

    def make(level="river_easy", character="human", seed=0):
        return make_simulation(level, character, 1, seed, True)

    made = App(make, make(), options, ["river_easy", "river_impossible", "river_leaps"])
    made.ticking = float("inf")  # however slow this machine
    return made


def test_keys_do_what_the_help_says(app):
    before = app.sim.ticks
    app.key(".")
    assert app.paused and app.sim.ticks == before + 1
    app.advance(1.0)
    assert app.sim.ticks == before + 1
    app.key("space")
    app.advance(0.05)
    assert app.sim.ticks == before + 4
    app.advance(100.0)
    assert app.sim.ticks <= before + 4 + 6
    app.key("[")
    assert app.speed == 0.5
    for _ in character_names()[character_names().index(app.character) :]:
        app.key("c")
    assert app.character == "bird" and app.sim.characters[0].name == "bird"
    app.key("n")
    assert "no way" in app.message and app.sim.characters[0].name == "bird"
    app.key("escape")
    assert not app.running


def test_a_crowd_is_looked_at_as_a_whole_or_one_by_one():
    from sim.view.graphics.detail import in_view
    from sim.view.window.app import App

    def make(level="forest", character="human", seed=0):
        return make_simulation(level, character, 40, seed, False)

    app = App(make, make(), argparse.Namespace(level="forest", character="human", seed=0), ["forest"])
    assert app.camera.follow and in_view(app.camera.matrix(1.6), app.sim.com(), 0.0).mean() > 0.2
    app.key("left")
    assert app.focus == 39 and app.camera.distance < 15
    app.key("right"), app.key("right")
    assert app.focus == 1
    app.key("a")
    assert not app.camera.follow and in_view(app.camera.matrix(1.6), app.sim.com(), 0.0).mean() > 0.9
    app.camera.frame(app.sim.com()[25], 0.0, 5.0)
    app.click(0.0, 0.0, 1.6)
    assert app.focus == 25 and app.camera.follow


def test_slow_ticks_do_not_stop_the_pictures(app):
    before = app.sim.ticks
    app.ticking = 0.0
    app.advance(1.0)
    assert app.sim.ticks == before + 1 and app.behind <= 1.0


def test_mouse_edits_reach_the_world(app):
    trees = len(app.sim.world.trees)
    app.edit("t", 4.0, 12.0)
    assert len(app.sim.world.trees) == trees + 1
    app.edit("x", 4.0, 12.1)
    assert len(app.sim.world.trees) == trees
    app.edit("g", 22.0, 4.0)
    assert app.sim.world.goal == (22.0, 4.0)
    rocks = app.sim.world
    for _ in range(40):
        app.edit("x", 13.0, 8.0)
    app.edit("t", *app.sim.world.start)
    assert "foot" in app.message
    assert len(app.sim.world.rocks) <= len(rocks.rocks)


def test_real_events_drive_a_window(monkeypatch, app):
    monkeypatch.setitem(os.environ, "SDL_VIDEODRIVER", "offscreen")
    gl.prefer_egl_without_display()
    import pygame

    from sim.view.window.window import PlanScreen, _open_screen, handle

    pygame.display.init()
    try:
        screen = _open_screen(pygame, (320, 200))
        if isinstance(screen, PlanScreen):
            pytest.skip("no OpenGL window here")
        azimuth, distance = app.camera.azimuth, app.camera.distance
        for event in (
            pygame.event.Event(pygame.KEYDOWN, key=pygame.K_SPACE),
            pygame.event.Event(pygame.MOUSEMOTION, pos=(300, 100), rel=(40, 0), buttons=(1, 0, 0)),
            pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=2),
        ):
            pygame.event.post(event)
        for event in pygame.event.get():
            handle(app, screen, event, pygame)
        assert app.paused and app.camera.azimuth != azimuth and app.camera.distance < distance
        screen.draw(app)
        app.key("h")
        screen.draw(app)
    finally:
        pygame.display.quit()


def test_a_goal_for_a_wanderer_is_walked_to():
    from sim.view.window.app import App

    def make(level="forest", character="bird", seed=0):
        return make_simulation(level, character, 1, seed, False)

    app = App(make, make(), argparse.Namespace(level="forest", character="bird", seed=0), ["forest"])
    app.edit("g", 20.0, 20.0)
    assert app.sim.world.goal == (20.0, 20.0) and "walk there" in app.message
    assert app.sim.plans.steps[0] > 0


def test_the_window_asks_for_a_profile_that_every_machine_has():
    import pygame

    from sim.view.window.screen import context_attributes

    asked = context_attributes(pygame)
    assert asked[pygame.GL_CONTEXT_PROFILE_MASK] == pygame.GL_CONTEXT_PROFILE_CORE
    assert asked[pygame.GL_CONTEXT_FLAGS] == pygame.GL_CONTEXT_FORWARD_COMPATIBLE_FLAG
    assert (asked[pygame.GL_CONTEXT_MAJOR_VERSION], asked[pygame.GL_CONTEXT_MINOR_VERSION]) == (3, 3)


def test_what_was_walked_goes_to_the_studio(app, monkeypatch):
    """Enter hands the studio all that was walked."""
    from sim.view.window import beside

    opened = []
    monkeypatch.setattr(beside, "open_studio", opened.append)
    for _ in range(900):
        app.sim.tick()
    app.key("return")
    assert app.paused and len(opened) == 1 and opened[0].head.name == app.sim.world.name
    assert len(opened[0].tracks[0].footprint) == app.sim.walked().footprints.side.size


def test_level_character_and_seed_are_chosen_at_once(app):
    app.choose(level="river_leaps", character="bird")
    assert app.sim.world.name == "Leaps and dead ends" and app.sim.characters[0].name == "bird" and app.notice
    app.choose(level="river_impossible")
    assert app.level == "river_leaps" and app.sim.world.name == "Leaps and dead ends" and "no way" in app.notice


def test_notices_go_away(app, monkeypatch):
    from sim.view.window import app as module

    app.say("done")
    assert app.notice == "done"
    late = module.clock.monotonic() + module.NOTICE + 1
    monkeypatch.setattr(module.clock, "monotonic", lambda: late)
    assert app.notice == "" and app.message == "done"


def test_overlays_come_and_go_one_by_one(app):
    app.toggle_overlay("daggers")
    assert app.shown == {"curve", "tangents", "headings", "next steps"}
    app.toggle_overlay("daggers")
    assert "daggers" in app.shown


def test_a_recording_is_begun_and_ended_in_the_window(app, tmp_path, monkeypatch):
    from sim.files.recording import load_recording
    from sim.view.pictures.results import Results, Wanted
    from sim.view.window.window import _record

    monkeypatch.chdir(tmp_path)
    results = Results(Wanted(), app.sim)

    def frames(count):
        for _ in range(count):
            app.advance(1 / 60)
            _record(app, results)
            results.follow(app.sim)

    frames(30), app.key("m"), frames(40)
    begun = app.sim.ticks
    app.key("m"), frames(20)
    (path,) = tmp_path.glob("footfall_*.npz")
    time = load_recording(path).arrays["time"]
    assert (
        app.notice == f"wrote {path.name}"
        and results.done == [path.name]
        and len(time) in (40, 41)
        and np.isclose(time[-1], begun / 60, atol=0.02)
    )


def test_the_camera_stays_above_hills():
    from sim.view.graphics.camera import Camera
    from worlds.queries import terrain_height
    from worlds.world import World

    world, low = World("hills", (60.0, 60.0), "hills", (2.5, 20.0, 0.3, 1.1, 2.0)), 0
    for x, y, azimuth in np.random.default_rng(0).uniform((10, 10, -3), (50, 50, 3), (60, 3)):
        camera = Camera(azimuth=float(azimuth), elevation=0.02, distance=9.0)
        camera.target = np.array([x, y, terrain_height(world.arrays, x, y) + 0.9])
        low += camera.eye[2] < terrain_height(world.arrays, *map(float, camera.eye[:2]))
        camera.stay_above(world)
        eye = camera.eye
        inside = (eye[:2] >= 0).all() and (eye[:2] <= world.size).all()
        assert not inside or eye[2] > terrain_height(world.arrays, float(eye[0]), float(eye[1]))
        assert camera.elevation == 0.02  # what was asked for is not forgotten
    assert low > 0
