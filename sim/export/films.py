"""Films and sprite sheets of a clip, by the code that films a run as it goes (sim.view.pictures)."""

import numpy as np

from motion.arithmetic.rotations import yaw_of
from motion.characters.character import Character
from sim.export.clip.asked import Asked
from sim.export.clip.clip import Clip
from sim.files.replay import Part, Replay
from sim.view.graphics.gl import NoGL
from sim.view.pictures.film import Film
from sim.view.pictures.offscreen import Picture, save_image
from sim.view.pictures.sheet import VIEWS
from worlds.errors import InputError

COLUMNS = 8
SPRITES = 64
"""A sheet holds no more than so many sprites."""
PER_SECOND = 12.0
"""Sprites per second where nothing else is asked for."""
SIDE, TAIL = 3.8, 2.9
"""How far the side is looked at from, in nominal legs: crests and long necks are seen; and at least in lengths of a tail."""
CELL, USUAL = (128, 128), (960, 540)
"""Size of a sprite, where --size is left as it is for films [pixels]."""


def export_film(clip: Clip, path: str, asked: Asked) -> None:
    """A film that follows the first character. Raises InputError."""
    cast = replay_of(clip)
    film = Film(cast, path, asked.size)
    film.picture.renderer.show_overlays = False
    film.go_on(len(clip.time) - 1)
    film.close()


def replay_of(clip: Clip) -> Replay:
    """The clip as what the view reads. Raises InputError where its rate is no whole number, or too small for a film."""
    rate = round(clip.rate)
    if abs(rate - clip.rate) > 1e-6 or rate < 10:
        raise InputError(f"--fps {clip.rate:g}: a film has a whole number of moments per second, 10 or more")
    parts = [Part(actor.character, actor.pose, actor.footprints, actor.there) for actor in clip.actors]
    return Replay(clip.world, parts, clip.time, rate, clip.seed)


def export_sprites(clip: Clip, path: str, asked: Asked) -> None:
    """The first character seen from its side, moment after moment, without what is around it. Raises InputError."""
    every = max(round(clip.rate / (asked.rate or PER_SECOND)), 1)
    frames = np.arange(0, len(clip.time), every)
    if len(frames) > SPRITES:
        raise InputError(f"{path}: {len(frames)} sprites; {SPRITES} are allowed: give --between T0 T1, or fewer --fps")
    cast = replay_of(clip)
    try:
        picture = Picture(asked.size if asked.size != USUAL else CELL)
    except NoGL as error:
        raise InputError(f"{path}: {error}") from None
    picture.distance = _distance(clip.actors[0].character)
    cells = []
    for time in clip.time[frames]:
        heading = float(yaw_of(cast.snapshot(time, np.array([0])).body_rotation_wxyz[0]))
        picture.camera.azimuth, picture.camera.elevation = heading + VIEWS["side"][0], VIEWS["side"][1]
        cells.append(picture.cut_out(cast, time))
    empty = [np.zeros_like(cells[0])] * (-len(cells) % COLUMNS)
    rows = [np.hstack(row) for row in np.array([*cells, *empty]).reshape(-1, COLUMNS, *cells[0].shape)]
    save_image(np.vstack(rows), path)


def _distance(character: Character) -> float:
    """From which the whole of a character is seen from its side, in nominal legs."""
    body = character.biped.body
    return max(SIDE, TAIL * float(body.tail_length - body.tail_forward) / float(character.biped.leg.nominal_length))
