"""What a file stands for, and what is taken of it: a recording is there, a saved state goes on, a scene is played."""

import zipfile
from collections.abc import Callable
from typing import NamedTuple

from planner.script.scene import load_scene
from sim.files.recording import Recorder, Recording, load_recording
from sim.files.saving import restore
from sim.stage.cast import Cast
from sim.stage.scripted.performance import Performance
from worlds.errors import InputError

Told = Callable[[float], None]
"""Hears how much is done, 0 to 1."""
LIVE = 20.0
"""A state goes on for so long [s] where nothing else is asked for."""
LONGEST = 3600.0
"""A state goes on for no longer than this [s]."""
MOST_POSES = 2_000_000
"""Moments times characters that are taken at once: a pose takes 2 KB, and bones as much."""
EDGE = 1e-6
"""A moment this near [s] to the end of what is asked for belongs to it."""


def is_recording(path: str) -> bool:
    """Whether this is a recording, by what it holds; a file that is nothing of ours is called one, and refused as such."""
    try:
        with zipfile.ZipFile(path) as archive:
            return "crowd.kind.npy" not in archive.namelist()
    except (OSError, ValueError, zipfile.BadZipFile):
        return True


def opened(path: str) -> Recording | Cast:
    """What a file, or the name of a scene, stands for. Raises InputError."""
    if not path.lower().endswith(".npz"):
        return Performance(load_scene(path))
    return load_recording(path) if is_recording(path) else restore(path)


class Span(NamedTuple):
    """From when to when [s]."""

    begin: float
    end: float


def span_of(cast: Cast, begin: float | None, end: float | None) -> Span:
    """What there is of the times that are asked for: all of a scene, of a state what comes. Raises InputError."""
    first = cast.time
    last = cast.end if isinstance(cast, Performance) else first + LONGEST
    usual = last if isinstance(cast, Performance) else first + LIVE
    found = Span(first if begin is None else begin, usual if end is None else min(end, last))
    if not first <= found.begin < found.end:
        raise InputError(f"--between {found.begin:g} {found.end:g}: there are {first:.2f} to {last:.2f} s")
    return found


def taken(cast: Cast, span: Span, rate: float, told: Told) -> Recording:
    """A recording of a scene or a state, of so many moments per second. Raises InputError where that is too much."""
    count = int((span.end - span.begin) * rate + EDGE) + 1
    check_poses(count, len(cast.characters))
    recorder = Recorder(cast)
    for k in range(count):
        time = span.begin + k / rate
        while cast.time < time - EDGE:
            cast.tick()
        recorder.capture(time)
        if k % 30 == 0 or k == count - 1:
            told((k + 1) / count)
    return recorder.recording()


def check_poses(moments: int, characters: int) -> None:
    """Raises InputError where these are more than memory is asked for."""
    if moments * characters > MOST_POSES:
        raise InputError(
            f"{moments} moments of {characters} characters: {MOST_POSES} poses are allowed: "
            "give --between T0 T1, fewer --fps, or, of a recording, --character-index C"
        )
