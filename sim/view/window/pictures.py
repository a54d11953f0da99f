"""Pictures of the window itself, drawn offscreen by the real one: for documents, and to look at."""

import argparse
from pathlib import Path
from typing import NamedTuple

from sim.stage.commands import SetGoal, apply, steer
from sim.stage.simulation import Simulation
from sim.view.pictures.offscreen import save_image
from sim.view.window.app import App
from sim.view.window.choosing import maker
from sim.view.window.screen import Screen3D
from worlds.level import level_names

LEVEL, SETTLING = 1, 3
"""The quality at which they are drawn, and frames until imgui has found its sizes."""


class Shot(NamedTuple):
    """A picture of the window."""

    size: tuple[int, int]
    scale: float
    command: str
    level: str
    character: str
    seconds: float
    characters: int = 1
    keys: tuple[str, ...] = ()  # pressed before it is drawn


SHOTS = {
    "wander": Shot((960, 540), 1.0, "wander", "forest", "bird", 14.0),
    "wander_large": Shot((1920, 1080), 2.0, "wander", "dense_forest", "human", 12.0),
    "wander_small": Shot((640, 400), 1.0, "wander", "hills", "dinosaur", 9.0),
    "river": Shot((960, 540), 1.0, "river", "river_leaps", "human", 6.6),
    "river_large": Shot((1920, 1080), 2.0, "river", "river_delta", "ostrich", 10.0),
    "river_small": Shot((640, 400), 1.0, "river", "river_easy", "bird", 8.0),
    "steer": Shot((960, 540), 1.0, "steer", "forest_river", "human", 7.0),
    "steer_large": Shot((1920, 1080), 2.0, "steer", "rock_field", "bird", 6.0),
    "steer_small": Shot((640, 400), 1.0, "steer", "rooms", "human", 5.0),
    "play": Shot((960, 540), 1.0, "play", "sprint", "human", 2.2),
    "play_large": Shot((1920, 1080), 2.0, "play", "fig17_large_leap", "human", 2.6),
    "play_small": Shot((640, 400), 1.0, "play", "stair_descent", "human", 5.0),
    "crowd": Shot((960, 540), 1.0, "wander", "forest", "bird", 12.0, 200, ("v", "a")),
    "help": Shot((640, 400), 1.0, "wander", "forest", "bird", 6.0, 1, ("h",)),
}
"""Pictures of docs/window.md by their names."""


def write_pictures(folder: Path) -> list[str]:
    """Draws all SHOTS as folder/NAME.jpg; returns the paths. Raises NoGL, InputError."""
    import pygame

    pygame.display.init()
    screen, paths = Screen3D(pygame, (960, 540)), []
    for name, shot in SHOTS.items():
        app = _app(shot)
        screen.draw_unseen(shot.size, LEVEL)
        for _ in range(SETTLING):
            screen.draw(app)
        paths.append(str(folder / f"{name}.jpg"))
        save_image(screen.pixels(), paths[-1])
    pygame.display.quit()
    return paths


def _app(shot: Shot) -> App:
    """What the window shows."""
    make = maker(shot.command, shot.characters)
    options = argparse.Namespace(level=shot.level, character=shot.character, seed=0, scale=shot.scale)
    app = App(make, make(shot.level, shot.character if shot.command != "play" else None, 0), options, level_names())
    sim = app.sim
    if isinstance(sim, Simulation) and shot.command == "wander" and shot.characters == 1:
        apply(sim, SetGoal(*(float(0.6 * size) for size in sim.world.size)))
    for tick in range(int(60 * shot.seconds)):
        if isinstance(sim, Simulation) and shot.command == "steer":
            steer(sim, sim.world.start_heading, "walk" if tick < 200 else "run")
        sim.tick()
    for key in shot.keys:
        app.key(key)
    app.camera.target = sim.com()[app.focus].copy() if app.camera.follow else app.camera.target
    return app
