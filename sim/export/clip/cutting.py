"""The clip of a recording: which of its frames, which of its characters.

A recording holds whole poses at its frames, and bones follow from a pose alone (motion.motion.bones_of): so its bones are the
run's own, at each of its frames, and no time between two frames is made up.
"""

from typing import NamedTuple

import numpy as np

from motion.pose.pose import Pose
from sim.export.clip.asked import Asked
from sim.export.clip.clip import Actor, Clip
from sim.files.recording import UNEVEN, Recording, Stay
from sim.files.taking import EDGE, check_poses
from sim.view.bodies.dress import colours_of
from worlds.errors import InputError


def clip_of(recording: Recording, asked: Asked) -> Clip:
    """What is asked for of a recording; where people come and go, each of them is a character. Raises InputError."""
    _check(recording)
    frames = _frames(recording, asked)
    time = np.asarray(recording.arrays["time"][frames.which])
    parts = _guests(recording, frames.which) if "present" in recording.arrays else _whole(recording, time)
    if asked.character is not None and not 0 <= asked.character < len(parts):
        raise InputError(f"--character-index {asked.character}: there are {len(parts)} characters, counted from 0")
    each = range(len(parts)) if asked.character is None else [asked.character]
    check_poses(len(time), len(each))
    kinds = [part.first.character for part in parts]
    colours = colours_of(kinds, recording.meta.get("seed", 0))
    actors = [
        _actor(recording, (k, parts[k]), frames.which, time, {name: rows[k : k + 1] for name, rows in colours.items()})
        for k in each
    ]
    return Clip(recording.meta["level"], recording.world, time, frames.rate, tuple(actors), recording.meta.get("seed", 0))


class Part(NamedTuple):
    """Who is a character of the clip: a row of the run, for as long as one is in it."""

    row: int
    stay: Stay
    there: np.ndarray  # (F,) bool
    first: Stay  # of the row


def _whole(recording: Recording, time: np.ndarray) -> list[Part]:
    """Everyone, who must be the same one all the time. Raises InputError where a part is asked for in which it is not."""
    found = []
    for c in range(len(recording.meta["characters"])):
        stays = [stay for stay in recording.stays(c) if stay.time < time[-1]]
        found.append(Part(c, stays[-1], np.ones(len(time), bool), stays[0]))
    return found


def _guests(recording: Recording, frames: np.ndarray) -> list[Part]:
    """Those who are there at two frames or more, in the order in which they came. Raises InputError where there are none."""
    found = [
        Part(c, stay, there[frames], stay)
        for c in range(len(recording.meta["characters"]))
        for stay, there in recording.spans(c)
        if there[frames].sum() > 1
    ]
    if not found:
        raise InputError("nobody is there at two or more of these moments; give other times")
    return sorted(found, key=lambda part: (part.stay.time, part.row))


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


def _actor(
    recording: Recording, who: tuple[int, Part], frames: np.ndarray, time: np.ndarray, colours: dict[str, np.ndarray]
) -> Actor:  # fmt: skip
    """One of the clip's characters, by its number."""
    index, (c, stay, there, _) = who
    changes = [] if "present" in recording.arrays else [one for one in recording.stays(c)[1:] if time[0] <= one.time < time[-1]]
    if changes:
        raise InputError(
            f"character {c} becomes {changes[0].character.name} at {changes[0].time:.2f} s: give --between, before or after"
        )
    held = frames[np.interp(np.arange(len(frames)), np.flatnonzero(there), np.flatnonzero(there)).astype(int)]
    pose = Pose(*(np.ascontiguousarray(recording.arrays[name][held, c]) for name in Pose._fields))
    pose.contact[~there] = False
    footprints, keys = recording.footprints(c, stay.recasts), tuple(recording.hand_keys(c))
    return Actor(index, stay.character, pose, footprints, colours, time, there, keys)
