"""A track: what one character of a scene does, as its file has it: single footprints, paths between them, and all in order."""

from math import cos, radians, sin
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import BeforeValidator, Field

from motion.characters.character import Character, Scale
from planner.script.footprint import Footprint, Pause
from planner.script.path import Path, footprints_along
from planner.script.shaping import ComPull, Key, Stretch, Style
from worlds.ground import Part

SHAPES = {"support", "segments", "style", "stretch", "pull", "key"}
"""Keys of a track that shape what is walked on its footprints."""
MOST_PRINTS = 20_000
"""A track has at most so many single footprints."""


def _listed(value: Any) -> Any:
    """One path may be written as a table, several as an array of tables."""
    return [value] if isinstance(value, dict) else value


def _laid_as(value: Any) -> Any:
    """Files before 0.11 called "steady" what is "smooth" now."""
    return "smooth" if value == "steady" else value


class Track(Part):
    """Who walks, on what. The first two footprints are stood on; single ones and paths follow each other as `after` says."""

    character: str = "human"
    character_scale: Scale = 1.0  # how much larger it is than its file says
    stand_before: Pause = 0.4
    stand_after: Pause = 0.6
    support: Literal["roll", "middle", "toe"] = "roll"  # where a standing foot presses: heel to toe, or the paper's either-or
    segments: Annotated[Literal["smooth", "phase", "step"], BeforeValidator(_laid_as)] = "smooth"  # window.LAYOUTS
    footprint: Annotated[tuple[Footprint, ...], Field(max_length=MOST_PRINTS)] = ()
    path: Annotated[tuple[Path, ...], BeforeValidator(_listed), Field(max_length=100)] = ()
    style: Style = Style()
    stretch: Annotated[tuple[Stretch, ...], Field(max_length=1000)] = ()
    pull: Annotated[tuple[ComPull, ...], Field(max_length=1000)] = ()
    key: Annotated[tuple[Key, ...], Field(max_length=10_000)] = ()


def completed(track: Track, character: Character, middle: tuple[float, float]) -> Track:
    """A track that can be stood on: where footprints are missing, the feet stand beside each other, or in the middle [m]."""
    if track.path or len(track.footprint) >= 2:
        return track
    first = track.footprint[0] if track.footprint else None
    side, heading = ("left", 0.0) if first is None else (first.side, first.heading_deg)
    away = (1 if side == "left" else -1) * float(character.biped.gait.step_width)
    x, y = middle if first is None else first.position
    place = (x + away * sin(radians(heading)), y - away * cos(radians(heading)))
    one = first or Footprint(side="left", position=(x, y))
    other = Footprint(side="right" if side == "left" else "left", position=place, heading_deg=heading)
    bare = {"stretch": (), "pull": (), "key": ()}
    return track.model_copy(update={"footprint": (one, other), **bare})


class Source(NamedTuple):
    """Where a footprint of a track is written."""

    path: int  # which of its paths lays it, -1: it is a single one
    place: int  # which footprint of the path, or which single one


class Placed(NamedTuple):
    """A footprint of a track, in the order in which they are walked."""

    footprint: Footprint
    source: Source


def placed(track: Track, character: Character) -> list[Placed]:
    """All footprints of a track, those of paths laid out for a character. Raises InputError.

    A path that others come before goes on from them: nothing is stood on at its beginning, and its feet alternate with theirs.
    """
    order = sorted(range(len(track.path)), key=lambda k: track.path[k].after)
    found: list[Placed] = []
    for i in range(len(track.footprint) + 1):
        for k in order:
            if track.path[k].after == i or (i == len(track.footprint) and track.path[k].after > i):
                found += _along(track.path[k], k, character, found)
        if i < len(track.footprint):
            found.append(Placed(track.footprint[i], Source(-1, i)))
    return found


def _along(path: Path, k: int, character: Character, before: list[Placed]) -> list[Placed]:
    """The footprints of path k after those before."""
    if before:
        path = path.model_copy(update={"first": "left" if before[-1].footprint.side == "right" else "right"})
    along = [Placed(footprint, Source(k, j)) for j, footprint in enumerate(footprints_along(path, character))]
    return along[2:] if before else along


def footprints_of(track: Track, character: Character) -> list[Footprint]:
    """All footprints of a track in order. Raises InputError."""
    return [one.footprint for one in placed(track, character)]
