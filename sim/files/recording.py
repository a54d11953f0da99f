"""Recordings: a run as arrays in one .npz file, without pickles, written whole or not at all."""

import platform
from dataclasses import dataclass
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from typing import NamedTuple

import numpy as np

from motion.characters.character import Character, character_names, load_character
from motion.pose.pose import Pose
from motion.track.footprints import Footprints
from planner.script.track import Track
from planner.script.turned import BoneKey
from sim.files import archive
from sim.files.frames import Frames
from sim.files.guests import Guests
from sim.files.schema import RunMeta, check_run
from sim.stage.cast import Cast, Change
from sim.stage.commands import Recast, from_plain
from sim.stage.edits import Edit
from worlds.compiled.tables import empty
from worlds.errors import InputError
from worlds.reading import checked
from worlds.world import World

FORMAT = 1
RATE = 60
"""Frames per second of simulated time."""
UNEVEN = 1e-6
"""Frames further than this [s] from even spacing have no central differences, and make no clip."""
NEEDED = ("time", "com", "contact", "phase", "physics_cost", "footprint_position")


class Recorder:
    """Collects frames of a simulation, about 2 KB per character and frame: beyond some megabytes in a file without a name."""

    def __init__(self, sim: Cast, folder: str | Path | None = None) -> None:
        """folder: where the file without a name lies, by default where temporary files do."""
        self.sim = sim
        sim.keep_footprints()
        self.time: list[float] = []
        self._poses = {name: Frames(folder) for name in Pose._fields}
        self._present, self._guests = Frames(folder), Guests(sim)

    def capture(self, time: float | None = None) -> None:
        """Adds the present moment, or another of the last step [s], as a frame."""
        time = self.sim.time if time is None else time
        for frames, values in zip(self._poses.values(), self.sim.snapshot(time), strict=True):
            frames.add(values)
        self._present.add(self._guests.see(time))
        self.time.append(time)

    def arrays(self) -> dict[str, np.ndarray]:
        """All arrays of the file (names and shapes in README, Recordings)."""
        frames = {name: frames.array(len(self.time)) for name, frames in self._poses.items()}
        world = self.sim.world
        return {
            "time": np.array(self.time),
            **frames,
            **self.sim.footprints.arrays(self.sim.crowd),
            **({"present": self._present.array(len(self.time))} if self._guests.come_and_go else {}),
            "tree": world.arrays.trees,
            "rock": world.arrays.rocks,
            "wall": world.arrays.walls,
            "bounds": world.arrays.bounds,
            archive.HEIGHTS: world.heights,
        }

    def recording(self) -> "Recording":
        """What has been collected so far, as `load_recording` would read it."""
        return Recording(self.arrays(), self._meta())

    def _meta(self) -> dict:
        sim = self.sim
        packages = {name: version(name) for name in ("numpy", "numba")}
        return {
            "format": FORMAT,
            "program": "footfall",
            "level": sim.world.name,
            "seed": sim.seed,
            "rate": sim.tick_rate,
            "characters": [character.to_dict() for character in sim.first_characters],
            "hand_keys": [[key._asdict() for key in sim.hand_keys(c)] for c in range(len(sim.characters))],
            "shapes": [sim.shapes(c) for c in range(len(sim.characters))],
            "looks": [character.look.model_dump(mode="json") for character in sim.first_characters],
            "world": sim.world.to_dict(heights=False),
            "first_world": None if sim.world is sim.first_world else sim.first_world.to_dict(heights=False),
            "changes": [change._asdict() for change in sim.changes],
            **self._guests.meta(),
            "versions": {"python": platform.python_version(), **packages},
        }

    def save(self, path: str | Path) -> None:
        """Writes the recording. Raises InputError where it cannot be written."""
        archive.write(path, self.arrays(), self._meta())


class Stay(NamedTuple):
    """Who was in a row of the crowd from a time on."""

    time: float  # after which it was so [s]
    recasts: int  # how many had been in the row before
    dimensions: dict  # Character.to_dict
    look: dict

    @property
    def character(self) -> Character:
        """Who that is. Raises InputError."""
        return Character.from_dict(self.dimensions, self.look)


class Span(NamedTuple):
    """Somebody, and when it was there."""

    stay: Stay
    frames: np.ndarray  # (F,) bool


@dataclass(frozen=True)
class Recording:
    """A recorded run: its arrays by name, its meta, and the world it ran in."""

    arrays: dict[str, np.ndarray]
    meta: dict

    @property
    def changes(self) -> list[Change]:
        """What was changed during the run, for sim.stage.commands.replay."""
        return [Change(**change) for change in self.meta.get("changes", [])]

    @property
    def world(self) -> World:
        """The world as it was at the end of the run."""
        return World.from_dict(self.meta["world"], self.arrays.get("heights"))

    @cached_property
    def worlds(self) -> list[tuple[float, World]]:
        """The worlds of the run, each with the time [s] after which it was there; the first from the beginning."""
        first = self.meta.get("first_world") or self.meta["world"]
        world = World.from_dict(first, self.arrays.get("heights"))
        found = [(-np.inf, world)]
        for tick, plain in self.changes:
            command = from_plain(plain)
            if isinstance(command, Edit):
                world = command.on(world)
                found.append((tick / self.meta["rate"], world))
        return found

    @cached_property
    def present(self) -> np.ndarray:
        """(F, C) bool: who is there at each frame."""
        everyone = np.ones((len(self.arrays["time"]), len(self.meta["characters"])), bool)
        return np.asarray(self.arrays.get("present", everyone))

    def stays(self, c: int) -> list[Stay]:
        """Who was in row c, one after the other: characters may be recast, and people come and go."""
        plain = self.meta
        looks = plain.get("looks") or [_look_of(one["name"]) for one in plain["characters"]]
        found = [Stay(-np.inf, 0, plain["characters"][c], looks[c])]
        if plain.get("visitors") is not None:
            kinds, mine = plain["kinds"], [one for one in plain["visitors"] if one["character"] == c]
            who = [(one, kinds[one["kind"]]) for one in mine]
            return [Stay(one["begin"], one["recasts"], kind["dimensions"], kind["look"]) for one, kind in who]
        for tick, change in self.changes:
            command = from_plain(change)
            if isinstance(command, Recast) and command.character == c:
                found.append(Stay(tick / plain["rate"], len(found), command.dimensions, command.look))
        return found

    def spans(self, c: int) -> list[Span]:
        """Whoever was in row c, each with the frames at which it was there."""
        time, there, stays = self.arrays["time"], self.present[:, c], self.stays(c)
        ends = [*(stay.time for stay in stays), np.inf][1:]  # none where nobody was
        return [Span(stay, (time > stay.time) & (time <= end) & there) for stay, end in zip(stays, ends, strict=False)]

    def footprints(self, c: int, recasts: int = 0) -> Footprints:
        """The footprints (K,) of character c by contact time, of those after it had become another one so often."""
        character = self.arrays["footprint_character"]
        cast = self.arrays.get("footprint_recasts", np.zeros_like(character))
        mine = np.flatnonzero((character == c) & (cast == recasts))
        found = empty(Footprints, len(mine))
        for name, column in found._asdict().items():
            if f"footprint_{name}" in self.arrays:
                column[...] = self.arrays[f"footprint_{name}"][mine]
        return found

    def shapes(self, c: int) -> Track:
        """What a scene said of character c beside its footprints, as a track without any; of versions up to 0.8.0 the style."""
        shapes = self.meta.get("shapes") or [{"style": style} for style in self.meta.get("styles") or []]
        return Track(**shapes[c]) if shapes else Track()

    def hand_keys(self, c: int) -> list[BoneKey]:
        """The hand keys of character c: its bones are those of its poses, turned by them."""
        every = self.meta.get("hand_keys") or []
        return [BoneKey(**key) for key in every[c]] if every else []


def _look_of(name: str) -> dict:
    """The looks of a character of a recording that holds none: those of the one of that name that ships, else grey."""
    return load_character(name).look.model_dump(mode="json") if name in character_names() else {}


def load_recording(path: str | Path) -> Recording:
    """Reads a recording. Raises InputError for files that are none, or damaged."""
    arrays, meta = archive.read(path, "a recording", "--record RUN.npz", NEEDED, FORMAT)
    recording = Recording(arrays, meta)
    try:
        check_run(arrays, checked("meta", meta, RunMeta))
        recording.worlds  # noqa: B018  (raises what is wrong with them)
        World.from_dict(meta["world"], arrays.get("heights"))
    except (ValueError, TypeError, KeyError, AttributeError, IndexError) as error:
        raise InputError(f"{path}: is damaged: {error}") from None
    return recording
