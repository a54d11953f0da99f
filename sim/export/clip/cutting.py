"""The clip of a recording: which of its frames, which of its characters.

A recording holds whole poses at its frames, and bones follow from a pose alone (motion.motion.bones_of): so its bones are the
run's own, at each of its frames, and no time between two frames is made up.
"""

from typing import NamedTuple

import numpy as np

from motion.pose.pose import Pose
from sim.export.clip.asked import Asked
from sim.export.clip.clip import Actor, Clip
from sim.files.recording import UNEVEN, Recording
from sim.files.taking import EDGE, check_poses
from sim.view.bodies.dress import colours_of
from worlds.errors import InputError


def clip_of(recording: Recording, asked: Asked) -> Clip:
    """What is asked for of a recording. Raises InputError."""
    _check(recording)
    frames, count = _frames(recording, asked), len(recording.meta["characters"])
    if asked.character is not None and not 0 <= asked.character < count:
        raise InputError(f"--character-index {asked.character}: there are {count} characters, counted from 0")
    time = np.asarray(recording.arrays["time"][frames.which])
    each = range(count) if asked.character is None else [asked.character]
    check_poses(len(time), len(each))
    kinds = [recording.cast(c)[0].character for c in range(count)]
    colours = colours_of(kinds, recording.meta.get("seed", 0))
    actors = [_actor(recording, c, frames.which, time, {name: rows[c : c + 1] for name, rows in colours.items()}) for c in each]
    return Clip(recording.meta["level"], recording.world, time, frames.rate, tuple(actors), recording.meta.get("seed", 0))


class Frames(NamedTuple):
    """Which frames of a recording, and how many of them make a second."""

    which: np.ndarray  # (F,)
    rate: float


def _frames(recording: Recording, asked: Asked) -> Frames:
    """Every so many frames of a recording. Raises InputError where they are not evenly spaced, or not so many a second."""
    time = recording.arrays["time"]
    if len(time) < 2 or np.ptp(np.diff(time)) > UNEVEN:
        raise InputError("the recording's frames must be two or more and evenly spaced, to be exported")
    own = round((len(time) - 1) / float(time[-1] - time[0]), 3)
    rate = asked.rate or own
    every = round(own / rate)
    if every < 1 or abs(own / every - rate) > 1e-3 * rate:
        allowed = ", ".join(f"{own / k:g}" for k in range(1, 13) if own % k == 0)
        raise InputError(f"--fps {rate:g}: a recording of {own:g} frames per second has {allowed}; no moment is made up")
    begin = time[0] if asked.begin is None else asked.begin
    end = time[-1] if asked.end is None else asked.end
    which = np.flatnonzero((time >= begin - EDGE) & (time <= end + EDGE))[::every]
    if len(which) < 2:
        raise InputError(f"--between {begin:g} {end:g}: the recording is from {time[0]:.2f} to {time[-1]:.2f} s")
    return Frames(which, own / every)


def _check(recording: Recording) -> None:
    lacks = [name for name in (*Pose._fields, "footprint_character") if name not in recording.arrays]
    if lacks:
        raise InputError(f"the recording lacks {', '.join(lacks)}; record the run again with this version")


def _actor(recording: Recording, c: int, frames: np.ndarray, time: np.ndarray, colours: dict[str, np.ndarray]) -> Actor:
    """Character c, who must be the same one all the time."""
    became = recording.cast(c)
    changes = [one for one in became[1:] if time[0] <= one.time < time[-1]]
    if changes:
        raise InputError(
            f"character {c} becomes {changes[0].character.name} at {changes[0].time:.2f} s: give --between, before or after"
        )
    recasts = sum(one.time < time[-1] for one in became) - 1
    pose = Pose(*(np.ascontiguousarray(recording.arrays[name][frames, c]) for name in Pose._fields))
    footprints, keys = recording.footprints(c, recasts), tuple(recording.hand_keys(c))
    return Actor(c, became[recasts].character, pose, footprints, colours, time, keys)
