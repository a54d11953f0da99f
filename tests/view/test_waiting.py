"""The window of a first start: it comes only where something takes long, shows how far that is, and passes faults on."""

import os
import threading

import pytest

from sim.view.window import waiting
from worlds.errors import InputError
from worlds.level import load_level


@pytest.fixture
def pygame(monkeypatch):
    monkeypatch.setitem(os.environ, "SDL_VIDEODRIVER", "dummy")
    import pygame

    yield pygame
    pygame.display.quit()


def test_what_is_quick_opens_no_window(monkeypatch):
    monkeypatch.setattr(waiting, "_show", lambda *_: pytest.fail("a window"))
    heard = []
    waiting.wait_for(lambda tell: tell("compiling 1 of 2: poses ..."), heard.append, None, (320, 180))
    assert heard == ["compiling 1 of 2: poses ..."]


def test_what_takes_long_shows_the_world_and_a_bar_that_grows(pygame, monkeypatch):
    pictures, go_on = [], threading.Event()
    draw = waiting.draw

    def looked(pygame, surface, world, share, said):
        draw(pygame, surface, world, share, said)
        row = [tuple(surface.get_at((x, surface.get_height() - 10)))[:3] for x in range(surface.get_width())]
        sky = {tuple(surface.get_at((x, 40))) for x in range(0, surface.get_width(), 4)}
        pictures.append((share, sum(colour == waiting.DONE for colour in row), len(sky)))
        if len(pictures) == 3:
            go_on.set()

    def job(tell):
        tell("compiling 2 of 4: poses ...")
        go_on.wait(20)

    monkeypatch.setattr(waiting, "draw", looked)
    monkeypatch.setattr(waiting, "PATIENCE", 0.01)
    waiting.wait_for(job, lambda text: None, load_level("river_easy"), (640, 360))
    shares, widths = [one[0] for one in pictures], [one[1] for one in pictures]
    assert 0.25 <= shares[0] < shares[-1] < 0.5
    assert 120 < widths[0] <= widths[-1] < 330
    assert pictures[0][2] > 1  # not one colour: a river, trees


def test_faults_are_raised_where_it_is_waited(pygame, monkeypatch):
    monkeypatch.setattr(waiting, "PATIENCE", 0.01)

    def job(tell):
        raise InputError("no")

    with pytest.raises(InputError, match="no"):
        waiting.wait_for(job, lambda text: None, None, (320, 180))
