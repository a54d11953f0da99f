"""Scene files: a world, and one or several characters, each with a scripted track: footprints one by one, or along paths.

The keys of a scene's first track may stand at the top of the file; further ones are `[[track]]` tables.
"""

from dataclasses import dataclass, replace
from pathlib import Path as FilePath
from typing import Annotated, Any

from pydantic import Field, model_validator

from motion.characters.character import Character
from planner.script import track as tracks
from planner.script.footprint import Footprint
from planner.script.path import Path
from planner.script.track import Track
from worlds import ground, reading
from worlds.contents import checks
from worlds.errors import InputError
from worlds.ground import Goal, Ground
from worlds.world import World

SCENES = FilePath(__file__).parent / "scenes"
NEEDS = "format, name, character, [world] and [[footprint]] or [path]"


class Sheet(Ground, Track):
    """A scene as its file has it, finished or not."""

    about: str = ""
    figure: str = ""
    goal: Goal | None = None  # only to be seen
    track: Annotated[tuple[Track, ...], Field(max_length=64)] = ()

    def all_tracks(self) -> tuple[Track, ...]:
        """The tracks: that at the top of the file first, if there is one."""
        top = Track.model_construct(**{key: getattr(self, key) for key in Track.model_fields})
        return self.track if self.track and not (top.footprint or top.path) else (top, *self.track)


class _Finished(Sheet):
    """A scene that can be played."""

    @model_validator(mode="after")
    def _whole(self) -> "_Finished":
        for k, track in enumerate(self.all_tracks()):
            _check(track, f"track.{k}." if k else "")
        return self


def _check(track: Track, at: str) -> None:
    """Whether a track can be walked from standing. Raises ValueError."""
    if not track.footprint and not track.path:
        raise ValueError(f"{at}: give either [[footprint]] or [path], or both" if at else "give either [[footprint]] or [path]")
    if not track.path and len(track.footprint) < 3:
        raise ValueError(f"{at}footprint: at least three: two to stand on, and a step")
    first = track.footprint[:2]
    if len(first) == 2 and not any(path.after < 2 for path in track.path) and first[0].side == first[1].side:
        raise ValueError(f"{at}footprint.1.side: the first two are stood on, one left and one right")


@dataclass(frozen=True)
class Scene:
    """A world and what is done in it. Times in seconds, angles in degrees as in the file."""

    name: str
    world: World
    tracks: tuple[Track, ...]
    about: str = ""
    figure: str = ""

    @property
    def track(self) -> Track:
        """The first."""
        return self.tracks[0]

    def changed(self, **keys: Any) -> "Scene":
        """The same with other keys of its first track."""
        return replace(self, tracks=(self.track.model_copy(update=keys), *self.tracks[1:]))

    def footprints_of(self, character: Character) -> list[Footprint]:
        """The footprints of the first track, those along a path laid out for a character; the first two are stood on."""
        return tracks.footprints_of(self.track, character)


def one_track(name: str, world: World, path: Path | None = None, **keys: Any) -> Scene:
    """A scene of one track, with these keys of Track."""
    return Scene(name, world, (Track(path=() if path is None else (path,), **keys),))


def scene_names() -> list[str]:
    """Names of the scenes that ship."""
    return reading.names_in(SCENES)


def load_scene(name_or_path: str | FilePath) -> Scene:
    """A shipped scene by name, or any scene file by path. Raises InputError naming every fault."""
    path = reading.named_file(SCENES, name_or_path, "scene")
    return scene_of(path, read_sheet(path, _Finished))


def read_sheet(path: FilePath, kind: type[Sheet] = Sheet) -> Sheet:
    """A scene file's keys, finished or not. Raises InputError naming every fault."""
    plain = reading.read_toml(path, "scene", NEEDS)
    try:
        return reading.checked(path, plain, kind)
    except InputError as error:  # one path may be written as a table: it has no number then
        one = isinstance(plain.get("path"), dict)
        raise InputError(str(error).replace(": path.0.", ": path.") if one else str(error)) from None


def scene_of(path: FilePath, sheet: Sheet) -> Scene:
    """The scene that a file's keys make; heightmaps lie beside `path`. Raises InputError naming every fault."""
    return Scene(sheet.name, world_of(path, sheet), sheet.all_tracks(), sheet.about, sheet.figure)


def world_of(path: FilePath, sheet: Sheet) -> World:
    """The world of a scene. Raises InputError naming every fault."""
    world, faults = ground.build(path, sheet, _start(sheet), 0.0, sheet.goal)
    starts = any(track.footprint or track.path for track in sheet.all_tracks())
    faults += [fault for fault in checks.faults(world) if starts or not fault.startswith("start.")]
    if faults:
        raise InputError("\n".join(f"{path}: {fault}" for fault in faults))
    return world


def _start(sheet: Sheet) -> tuple[float, float]:
    """Where its first track begins, or the middle of the world."""
    for track in sheet.all_tracks():
        if track.footprint:
            return track.footprint[0].position
        if track.path:
            return track.path[0].points[0]
    return 0.5 * sheet.world.size[0], 0.5 * sheet.world.size[1]
