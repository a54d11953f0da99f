"""A hand for tests of the studio: what it does are events, as a window sends them."""

import os

import numpy as np
import pytest

from sim.view.graphics import gl

FIGURE_1 = ((1.5, 4.1), (1.5, 3.9), (1.95, 4.1), (2.4, 3.9), (2.95, 3.93), (3.4, 4.1), (3.85, 3.9), (3.85, 4.1))


class Hand:
    """Mouse and keys."""

    def __init__(self, studio, pygame):
        self.studio, self.pygame, self.desk = studio, pygame, studio.desk
        self.place = (0, 0)

    def frames(self, count=1):
        for _ in range(count):
            self.studio.frame(1 / 60)

    def key(self, name, mod=0):
        pg = self.pygame
        code = pg.key.key_code(name)
        for kind in (pg.KEYDOWN, pg.KEYUP):
            text = name if len(name) == 1 and not mod else ""
            self.studio.handle(pg.event.Event(kind, key=code, mod=mod, unicode=text))
        self.frames()

    def move(self, x, y):
        self.place = (int(x), int(y))
        self.studio.handle(self.pygame.event.Event(self.pygame.MOUSEMOTION, pos=self.place, rel=(1, 1), buttons=(0, 0, 0)))
        self.frames()

    def press(self, button=1):
        self.studio.handle(self.pygame.event.Event(self.pygame.MOUSEBUTTONDOWN, pos=self.place, button=button))
        self.frames()

    def release(self, button=1):
        self.studio.handle(self.pygame.event.Event(self.pygame.MOUSEBUTTONUP, pos=self.place, button=button))
        self.frames()

    def click(self, x, y, button=1):
        self.move(x, y), self.press(button), self.release(button)

    def drag(self, start, end, steps=6):
        self.move(*start), self.press()
        for share in np.linspace(0, 1, steps + 1)[1:]:
            self.move(*(np.array(start) + share * (np.array(end) - np.array(start))))
        self.release()

    def on_plan(self, x, y):
        """Where a place of the world is in the plan."""
        return self.studio.views.plan.project(np.array([[x, y, 0.0]]))[0]


@pytest.fixture(scope="session")
def window():
    os.environ["SDL_VIDEODRIVER"] = "offscreen"
    gl.prefer_egl_without_display()
    import pygame

    from sim.view.studio.desk.desk import Desk
    from sim.view.studio.studio import Studio

    pygame.display.init()
    try:
        made = Hand(Studio(pygame, (960, 540), Desk()), pygame)
        made.studio.menus.lost = []  # of other runs on this machine
        return made
    except (gl.NoGL, pygame.error) as error:
        pytest.skip(f"no OpenGL window here: {error}")


@pytest.fixture
def hand(window, monkeypatch, tmp_path):
    """The window with an empty desk."""
    monkeypatch.setitem(os.environ, "FOOTFALL_STATE", str(tmp_path / "state"))
    from sim.view.studio.desk.desk import Desk
    from sim.view.studio.studio import Views

    window.studio.desk = window.desk = Desk()
    window.studio.views = window.studio.hands.views = Views()
    window.studio.screen.resize((960, 540))
    window.studio.screen.set_scale(1.0)
    window.frames(3)
    return window


def build(hand):
    """Fig. 1 of the paper, by clicks."""
    hand.studio.views.plan.centre, hand.studio.views.plan.zoom = np.array([3.0, 4.0]), 80.0
    hand.key("n")
    for k, (x, y) in enumerate(FIGURE_1):
        hand.click(*hand.on_plan(x, y))
        if k == 4:
            hand.key("f")  # a hop: the same foot again
    hand.key("escape")
