"""Contact sheets: the key poses of a run from the side, the front and above, in one picture."""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
from PIL import Image, ImageDraw

from motion.arithmetic.rotations import yaw_of
from motion.track.footprints import Footprints
from planner.script.scene import load_scene, scene_names
from sim.files import outputs
from sim.stage.scripted.performance import Performance
from sim.view.graphics.quality import Quality
from sim.view.pictures.offscreen import Picture, save_image

CELL = (230, 250)
COLUMNS = 8
CAPTION = 26
VIEWS = {"side": (-np.pi / 2, 0.10), "front": (0.35, 0.12), "above": (-np.pi / 2, 1.25)}
"""Azimuth from the body's heading, and elevation [rad]."""
LOADING, MIDDLE, LEAVING = 0.2, 0.5, 0.97
"""Shares of a stance: the leg takes the load, carries the body alone, and leaves."""


class Moment(NamedTuple):
    """A key pose of a step."""

    time: float  # [s]
    name: str


def key_moments(footprints: Footprints, count: int = COLUMNS) -> list[Moment]:
    """The key poses of successive steps around the most eventful one of a run: contact, loading, middle, push-off, apex.

    Most eventful: with the longest flight, else with the greatest turn or rise, else in the middle.
    """
    first = max(_most_eventful(footprints) - 1, 2)
    moments = [moment for n in range(first, len(footprints.side) - 1) for moment in _of_stance(footprints, n)]
    if len(moments) < count:
        first = 2
        moments = [moment for n in range(first, len(footprints.side) - 1) for moment in _of_stance(footprints, n)]
    return sorted(moments)[:count]


def _flight(footprints: Footprints, n: int) -> float:
    """Time in the air before footprint n lands [s], below zero for an overlap."""
    return float(footprints.contact_time[n] - footprints.contact_time[n - 1] - footprints.stance_time[n - 1])


def _most_eventful(footprints: Footprints) -> int:
    """The footprint about which most happens."""
    inner = range(3, max(len(footprints.side) - 2, 4))
    flights = {n: _flight(footprints, n) for n in inner if n < len(footprints.side)}
    longest = max(flights, key=lambda n: flights[n], default=2)
    if flights and flights[longest] > 1.2 * sorted(flights.values())[len(flights) // 2] and flights[longest] > 0:
        return longest
    rise = np.abs(np.diff(footprints.position[:, 2])) + np.abs(np.diff(footprints.heading))
    eventful = [n for n in flights if rise[n - 1] > 0.5 * rise.max() > 0.05]
    return eventful[len(eventful) // 2] if eventful else len(footprints.side) // 2


def _of_stance(footprints: Footprints, n: int) -> Iterator[Moment]:
    """The key poses of the step that ends on footprint n, and of the stance there until the other foot's contact."""
    if footprints.stands[n]:
        return
    contact, stance = float(footprints.contact_time[n]), float(footprints.stance_time[n])
    if _flight(footprints, n) > 0:
        yield Moment(contact - 0.5 * _flight(footprints, n), "apex")
    yield Moment(contact, "contact")
    yield Moment(contact + LOADING * stance, "loading")
    yield Moment(contact + MIDDLE * stance, "mid-stance")
    if footprints.contact_time[n + 1] >= contact + stance:  # nobody else carries: a push-off of its own
        yield Moment(contact + LEAVING * stance, "push-off")


def contact_sheet(picture: Picture, scene: Performance) -> np.ndarray:
    """(height, width, 3) uint8: a column per key pose, a row per view."""
    moments = key_moments(scene.walked().footprints)
    rows = [np.hstack([_drawn(picture, scene, moment.time, *view) for moment in moments]) for view in VIEWS.values()]
    sheet = Image.fromarray(np.vstack([np.full((CAPTION, rows[0].shape[1], 3), 255, np.uint8), *rows]))
    draw = ImageDraw.Draw(sheet)
    draw.text((8, 6), f"{scene.scene.name}: {scene.scene.about}", fill=(20, 20, 20))
    for k, moment in enumerate(moments):
        draw.text((k * CELL[0] + 6, CAPTION + 4), f"{moment.time:.2f} s {moment.name}", fill=(20, 20, 20))
    return np.asarray(sheet)


def _drawn(picture: Picture, scene: Performance, t: float, azimuth: float, elevation: float) -> np.ndarray:
    camera = picture.camera
    camera.azimuth = azimuth + float(yaw_of(scene.snapshot(t).body_rotation_wxyz[0]))
    camera.elevation = elevation
    return picture.frame(scene, time=t)


def write_sheets(scenes: dict[str, Performance], folder: Path) -> list[str]:
    """A sheet per scene as folder/NAME.jpg; returns the paths. Raises NoGL, InputError."""
    picture = Picture(CELL, Quality(1024, 4, 4, 1.0))
    picture.distance = 3.9
    picture.renderer.show_overlays = False  # nothing before the body
    paths = []
    for name, scene in scenes.items():
        path = folder / f"{name}.jpg"
        save_image(contact_sheet(picture, scene), path)
        paths.append(str(path))
    return paths


def write_index(folder: Path) -> str:
    """A page folder/README.md with the sheets of all scenes; returns its path."""
    lines = ["# Scenes", "", "Made by `python main.py sheets`; played by `python main.py play NAME`."]
    for name in scene_names():
        scene = load_scene(name)
        figure = f" (figure {scene.figure} of the paper)" if scene.figure else ""
        lines += ["", f"## {name}", "", f"{scene.about}{figure}", "", f"![{scene.name}]({name}.jpg)"]
    path = folder / "README.md"
    with outputs.whole(path) as temporary:
        temporary.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return str(path)
