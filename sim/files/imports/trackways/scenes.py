"""Scenes of trackways: the character that walks in them, scaled to the hip, and the TOML text of each."""

import json
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from motion.characters.character import Character, load_character
from motion.track.footprints import SIDES
from planner.script.footprint import Footprint
from planner.script.scene import Scene, one_track
from sim.files.imports.trackways.trackway import LAWS, Trackway
from worlds.errors import InputError
from worlds.world import World

MARGIN = 2.0
"""Ground around the prints, in hip heights."""
LARGEST = 2_000.0
"""No site is larger than this [m]."""
NAMES = {"alexander": "Alexander 1976", "ruiz": "Ruiz and Torices 2013"}


def site(trackways: Sequence[Trackway]) -> tuple[np.ndarray, np.ndarray]:
    """(origin, size) [m] of the one world in which all trackways lie. Raises InputError."""
    points, margin = np.vstack([way.points for way in trackways]), MARGIN * max(way.hip_height for way in trackways)
    origin = points.min(axis=0) - margin
    size = np.ceil(points.max(axis=0) + margin - origin)
    if size.max() > LARGEST:
        raise InputError(f"--scale: the prints reach over {size.max():,.0f} m; {LARGEST:,.0f} m at most are allowed")
    return origin, size


def scene_of(trackway: Trackway, origin: np.ndarray, size: np.ndarray, character: str, law: str) -> Scene:
    """The scene in which a character walks a trackway: every print where it is, at the speed of a law."""
    who, times = load_character(character), trackway.step_times(law)
    headings = np.degrees(trackway.headings)
    footprints = [
        Footprint(
            side=SIDES[side],  # type: ignore[arg-type]
            position=tuple(np.round(trackway.points[k] - origin, 5).tolist()),
            heading_deg=round(float(headings[k]), 3),
            step_time=round(float(times[k]), 5) if 0 < k < len(times) else None,
            inferred=bool(trackway.inferred[k]),
        )
        for k, side in enumerate(trackway.side.tolist())
    ]
    about = f"{trackway.name}: {trackway.speed(law):.3f} m/s by {NAMES[law]}, hip height {trackway.hip_height:g} m"
    world = World(trackway.name, tuple(size.tolist()), start=footprints[0].position)
    scale = trackway.hip_height / float(who.biped.timing.hip_height)
    made = one_track(trackway.name, world, footprint=tuple(footprints), character=character, character_scale=scale)
    return replace(made, about=about)


def walker(scene: Scene) -> Character:
    """Who walks in a scene."""
    return load_character(scene.track.character, scene.track.character_scale)


def text_of(scenes: Sequence[Scene], origin: np.ndarray, law: str) -> str:
    """The scenes, which lie in one world, as the TOML of one: everybody walks in it, from the same moment on."""
    first = scenes[0]
    names = " and ".join(scene.name for scene in scenes)
    head = [
        f"# Prints of a trackway; the site's place (0, 0) is ({-origin[0]:.5f}, {-origin[1]:.5f}) here.",
        f"# step_time: half a stride at the trackway's speed, {LAWS[law]} sqrt(g) S^1.67 h^-1.17.",
        "format = 1",
        f"name = {_quoted(names)}",
        f"about = {_quoted('; '.join(scene.about for scene in scenes))}",
        *_walker_text(first),
        "",
        "[world]",
        f"size = [{first.world.size[0]:g}, {first.world.size[1]:g}]",
        *_prints_text(first, "footprint"),
    ]
    for scene in scenes[1:]:
        head += ["", "[[track]]", *_walker_text(scene), *_prints_text(scene, "track.footprint")]
    return "\n".join([*head, ""])


def _walker_text(scene: Scene) -> list[str]:
    character, scale = scene.track.character, scene.track.character_scale
    return [f"character = {_quoted(character)}", f"character_scale = {scale!r}  # to the hip height"]


def _prints_text(scene: Scene, table: str) -> list[str]:
    lines = []
    for one in scene.track.footprint:
        lines += ["", f"[[{table}]]", f'side = "{one.side}"', f"position = [{one.position[0]!r}, {one.position[1]!r}]"]
        lines.append(f"heading_deg = {one.heading_deg!r}")
        lines += [f"step_time = {one.step_time!r}"] if one.step_time else []
        lines += ["inferred = true"] if one.inferred else []
    return lines


def _quoted(text: str) -> str:
    """A basic string of TOML, whose escapes are JSON's."""
    return json.dumps(text, ensure_ascii=True).replace("\x7f", "\\u007f")
