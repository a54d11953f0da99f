"""Keys and gamepads drive the one who is followed, as the camera looks; no window is needed."""

import argparse

import numpy as np
import pytest

from sim.stage.making import make_steered
from sim.view.window.app import App
from sim.view.window.driving import HELP, Driver, Pad, Sticks


@pytest.fixture
def app():
    options = argparse.Namespace(level="forest", character="human", seed=0)

    def make(level="forest", character="human", seed=0):
        return make_steered(level, character, 2, seed)

    made = App(make, make(), options, ["forest"])
    made.ticking, made.camera.azimuth = float("inf"), np.pi  # behind one who looks along +x
    return made


def told(app, c=0):
    plans = app.sim.plans
    return float(plans.direction[c]), int(plans.pace[c]), float(plans.aside[c])


def test_keys_say_where_and_how(app):
    for keys, direction, pace in (
        (["w"], 0.0, 3),
        (["a"], np.pi / 2, 3),
        (["down"], np.pi, 3),
        (["w", "d", "left shift"], -np.pi / 4, 4),
        (["up", "left ctrl"], 0.0, 2),
    ):
        for key in keys:
            app.key(key)
        app.advance(1 / 60)
        assert np.cos(told(app)[0] - direction) > 0.999999 and told(app)[1] == pace
        for key in keys:
            app.key_up(key)
        app.advance(1 / 60)
        assert told(app)[1] == 0


def test_a_sidestep_keeps_the_heading(app):
    feet = app.sim.feet()
    heading = float(feet.heading[0, 1] - feet.toe_out[0, 1])
    app.key("q"), app.advance(1 / 60)
    direction, pace, aside = told(app)
    assert pace == 3 and np.isclose(aside, np.pi / 2) and np.cos(direction - heading - np.pi / 2) > 0.999999


def test_space_leaps_once_and_p_pauses(app):
    app.key("space"), app.advance(1 / 60)
    assert [change.command["leap"] for change in app.sim.changes] == [[True]] and not app.paused
    app.advance(1 / 60)
    assert len(app.sim.changes) == 1
    app.key("p")
    assert app.paused and app.help is HELP


def test_the_camera_is_in_front_of_nothing_that_is_ahead(app):
    """Forward is where the camera looks, whatever its azimuth."""
    app.camera.azimuth = 0.7
    app.key("w"), app.advance(1 / 60)
    looks = app.camera.target - app.camera.eye
    assert np.isclose(np.cos(told(app)[0] - np.arctan2(looks[1], looks[0])), 1.0)


def test_who_is_followed_no_more_stands(app):
    app.key("w"), app.advance(1 / 60)
    app.follow(1), app.advance(1 / 60)
    assert told(app, 0)[1] == 0 and told(app, 1)[1] == 3


class FakePad:
    """A pygame with one gamepad."""

    def __init__(self, *axes, button=False):
        self.axes, self.button, self.joystick = axes, button, self

    def init(self):
        pass

    def get_count(self):
        return int(bool(self.axes))

    def Joystick(self, k):
        return self

    def get_numaxes(self):
        return len(self.axes)

    def get_axis(self, k):
        return self.axes[k]

    def get_numbuttons(self):
        return 1

    def get_button(self, k):
        return self.button


def test_sticks_walk_run_turn_and_leap():
    assert Pad(FakePad()).read() == Sticks()
    driver = Driver()
    for axes, pace in (((0.1, 0.1), "stand"), ((0.0, -0.4), "creep"), ((0.0, -0.7), "walk"), ((1.0, 0.0), "run")):
        assert driver._wish(np.pi, Pad(FakePad(*axes)).read()).pace == pace
    right = driver._wish(np.pi, Pad(FakePad(0.7, 0.0)).read())
    assert np.isclose(np.cos(right.direction + np.pi / 2), 1.0)
    assert driver._wish(np.pi, Pad(FakePad(0.0, 0.0, 0.0, 1.0, 0.0)).read()).pace == "turn"


def test_a_button_that_is_held_leaps_once(app):
    app.sticks = Pad(FakePad(0.0, -1.0, button=True)).read()
    app.advance(1 / 60), app.advance(1 / 60)
    assert sum(any(change.command["leap"]) for change in app.sim.changes) == 1
