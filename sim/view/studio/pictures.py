"""Pictures of the studio itself, drawn offscreen by the real window: for documents, and to look at."""

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np

from planner.script.shaping import Key
from sim.files.studio.document import Spot, new_document
from sim.files.studio.edits import Move, Place, Set
from sim.files.studio.keeping import Opened, open_scene
from sim.files.studio.paths import BendPath, DrawPath
from sim.files.studio.shapes import AddShape
from sim.view.pictures.offscreen import save_image
from sim.view.studio.desk.desk import DRAW, PLACE, Desk
from sim.view.studio.desk.keys import BY_KEY
from sim.view.studio.studio import Studio
from sim.view.studio.table.views import Views

SETTLING = 60
"""Frames until everything that is computed little by little is there."""


class Shot(NamedTuple):
    """A picture of the studio."""

    size: tuple[int, int]
    scale: float
    prepare: Callable[[Studio], None]


def window(desk: Desk, size: tuple[int, int], scale: float) -> Studio:
    """The studio in a window that nobody sees. Raises NoGL."""
    import pygame

    pygame.display.init()
    studio = Studio(pygame, size, desk, scale)
    studio.screen.draw_unseen()
    studio.screen.steady, studio.menus.lost, desk.autosave.place = True, [], None
    return studio


def draw_once(desk: Desk, path: str | Path, size: tuple[int, int], scale: float) -> None:
    """Draws the studio as it stands into a picture. Raises NoGL, InputError."""
    studio = window(desk, size, scale)
    _settle(studio)
    save_image(studio.screen.pixels(), path)
    studio.screen.close()


def _settle(studio: Studio) -> None:
    for _ in range(SETTLING):
        studio.frame(1 / 60)


def write_pictures(folder: Path) -> list[str]:
    """Draws all SHOTS as folder/NAME.jpg; returns the paths. Raises NoGL, InputError."""
    studio, paths = window(Desk(), (960, 540), 1.0), []
    for name, shot in SHOTS.items():
        desk = studio.desk = Desk()
        desk.autosave.place = None
        studio.views = studio.hands.views = Views()
        studio.inspector.healing.places = []
        studio.screen.resize(shot.size)
        studio.screen.set_scale(shot.scale)
        studio.screen.level = 0
        studio.frame(1 / 60)
        shot.prepare(studio)
        desk.notices = []
        _settle(studio)
        path = folder / f"{name}.jpg"
        save_image(studio.screen.pixels(), path)
        paths.append(str(path))
    studio.screen.close()
    return paths


def _open(studio: Studio, name: str, time: float, *chosen: int) -> Desk:
    """A scene that ships on the desk, at a time [s], with footprints chosen."""
    desk = studio.desk
    desk.take(open_scene(name))
    desk.playing.time = time
    studio.views.look(desk)
    studio.views.frame(desk, studio.screen.scale)
    desk.selection = {Spot(0, k) for k in chosen}
    return desk


def _begin(studio: Studio) -> None:
    studio.desk.tool = PLACE
    for k, place in enumerate(((4.6, 4.07), (4.6, 3.93), (5.2, 4.07), (5.85, 3.93))):
        studio.desk.do(Place(0, k - 1, place, 0.0))
    studio.views.plan.centre = np.array([6.0, 4.0])
    studio.views.mouse = studio.views.plan.project(np.array([[6.5, 4.1, 0.0]]))[0]


def _figure_1(studio: Studio) -> None:
    _open(studio, "fig01_steps_and_a_hop", 2.3, 4)


def _pinned(studio: Studio) -> None:
    desk = _open(studio, "fig01_steps_and_a_hop", 4.0, 6)
    desk.do(Set((Spot(0, 6),), "at", 4.0, "Pin to 4.00 s"))


def _bent(studio: Studio) -> None:
    desk = studio.desk
    desk.take(Opened(new_document(), None))
    desk.do(DrawPath(0, ((1.5, 2.0), (4.0, 2.2), (6.5, 4.5), (9.5, 4.6)), 0.7))
    desk.do(BendPath(0, 0, 1, (4.0, 1.6)))
    desk.do(Move((Spot(0, 8),), (0.0, 0.35)))
    desk.playing.time = 3.2
    studio.views.look(desk)
    studio.views.frame(desk, studio.screen.scale)
    desk.selection, desk.path = {Spot(0, 8)}, 0


def _exaggerated(studio: Studio) -> None:
    desk = _open(studio, "fig17_large_leap", 2.2, 4, 5)
    BY_KEY["e"].does(desk)
    desk.do(AddShape(0, Key(bone="upper_arm_right", footprint=4, after=0.3, rotation_deg=(0.0, -70.0, 0.0), blend=0.5)))
    desk.shown.ghosts = desk.shown.forces = True
    desk.shown.plan = False


def _small(studio: Studio) -> None:
    _open(studio, "fig17_walking_turn", 3.0, 5, 6)
    studio.desk.shown.inspector = False


def _large(studio: Studio) -> None:
    _open(studio, "stair_descent", 7.4, 12)


def _path_drawn(studio: Studio) -> None:
    studio.desk.tool = DRAW
    studio.desk.drawn = [(3.0, 3.0), (5.0, 4.5), (8.0, 4.0)]


def _help(studio: Studio) -> None:
    _figure_1(studio)
    studio.desk.shown.help = True


SHOTS = {
    "placing": Shot((960, 540), 1.0, _begin), "figure_1": Shot((960, 540), 1.0, _figure_1),
    "pinned": Shot((1280, 720), 1.0, _pinned), "path": Shot((1280, 720), 1.0, _bent),
    "drawing": Shot((960, 540), 1.0, _path_drawn), "exaggerated": Shot((1280, 720), 1.0, _exaggerated),
    "small": Shot((640, 400), 1.0, _small), "large": Shot((1920, 1080), 2.0, _large), "help": Shot((960, 540), 1.0, _help),
}  # fmt: skip
"""Pictures of docs/studio.md by their names."""
