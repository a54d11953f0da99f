"""Contact sheets: moments of a run from the side, the front and above, in one picture."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from motion.arithmetic.rotations import yaw_of
from planner.script.scene import load_scene, scene_names
from sim.files import outputs
from sim.stage.performance import Performance
from sim.view.graphics.quality import Quality
from sim.view.pictures.offscreen import Picture, save_image

CELL = (230, 250)
COLUMNS = 8
CAPTION = 26
VIEWS = {"side": (-np.pi / 2, 0.10), "front": (0.35, 0.12), "above": (-np.pi / 2, 1.25)}
"""Azimuth from the body's heading, and elevation [rad]."""


def contact_sheet(picture: Picture, scene: Performance, begin: float = 0.0, end: float | None = None) -> np.ndarray:
    """(height, width, 3) uint8: COLUMNS moments between begin and end [s], a row per view."""
    end = scene.end if end is None else end
    times = begin + (np.arange(COLUMNS) + 0.5) / COLUMNS * (end - begin)
    rows = [np.hstack([_moment(picture, scene, t, *view) for t in times]) for view in VIEWS.values()]
    sheet = Image.fromarray(np.vstack([np.full((CAPTION, rows[0].shape[1], 3), 255, np.uint8), *rows]))
    draw = ImageDraw.Draw(sheet)
    draw.text((8, 6), f"{scene.scene.name}: {scene.scene.about}", fill=(20, 20, 20))
    for k, t in enumerate(times):
        draw.text((k * CELL[0] + 6, CAPTION + 4), f"{t:.2f} s", fill=(20, 20, 20))
    return np.asarray(sheet)


def _moment(picture: Picture, scene: Performance, t: float, azimuth: float, elevation: float) -> np.ndarray:
    camera = picture.camera
    camera.azimuth = azimuth + float(yaw_of(scene.snapshot(t).body_rotation_wxyz[0]))
    camera.elevation = elevation
    return picture.frame(scene, time=t)


def write_sheets(scenes: dict[str, Performance], folder: Path) -> list[str]:
    """A sheet per scene as folder/NAME.jpg; returns the paths. Raises NoGL, InputError."""
    picture = Picture(CELL, Quality(1024, 4, 4, 1.0))
    picture.distance = 3.6
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
