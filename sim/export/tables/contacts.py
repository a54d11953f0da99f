"""Contacts and supporting forces as a table: .csv or .parquet; or any array of a recording as .csv.

A row is one foot at one moment at which it stands: when, whose, on which footprint, where the force acts and how far from heel
to toe, the force and its impulse since the foot landed, per kilogram of the body (motion.measures.forces).
"""

import numpy as np

from motion.measures.forces import impulses, supporting_forces
from motion.track.footprints import SIDES
from sim.export.clip.asked import Asked
from sim.export.clip.clip import Actor, Clip
from sim.files.recording import Recording
from sim.files.tables import Columns, write_table
from worlds.errors import InputError
from worlds.errors.wording import nearest

MOST_COLUMNS = 1000


def export_contacts(clip: Clip, path: str, asked: Asked) -> None:
    """Writes the table of all characters of a clip, by time. Raises InputError."""
    parts = [contacts_of(actor, clip.time) for actor in clip.actors]
    columns = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
    order = np.lexsort((columns["foot"], columns["character"], columns["time"]))
    write_table({name: column[order] for name, column in columns.items()}, path)


def contacts_of(actor: Actor, time: np.ndarray) -> Columns:
    """The rows of one character over moments (F,) [s]."""
    pose = actor.pose
    force = supporting_forces(pose.com, pose.com_acceleration, pose.point_of_support, pose.contact)
    impulse = impulses(time, force, pose.contact)
    frame, foot = np.nonzero(pose.contact)
    point = pose.point_of_support[frame, foot]
    number = _footprint_under(actor, time[frame], foot)
    columns = {
        "time": time[frame], "character": np.full(len(frame), actor.index), "foot": np.array(SIDES)[foot], "footprint": number,
    }  # fmt: skip
    columns |= {axis: point[:, k] for k, axis in enumerate("xyz")}
    columns["heel_to_toe"] = _share(pose.heel[frame, foot], pose.toe[frame, foot], point)
    columns |= {f"force_{axis}": force[frame, foot, k] for k, axis in enumerate("xyz")}
    return columns | {f"impulse_{axis}": impulse[frame, foot, k] for k, axis in enumerate("xyz")}


def _share(heel: np.ndarray, toe: np.ndarray, point: np.ndarray) -> np.ndarray:
    """(N,) how far a point is from heel, 0, to toe, 1."""
    sole = toe - heel
    return np.clip(np.einsum("ni,ni->n", point - heel, sole) / np.maximum(np.einsum("ni,ni->n", sole, sole), 1e-12), 0, 1)


def _footprint_under(actor: Actor, time: np.ndarray, foot: np.ndarray) -> np.ndarray:
    """(N,) the number of the footprint that each foot stands on at a time: its latest one, from 0."""
    number = np.full(len(time), -1)
    for side in range(2):
        own = np.flatnonzero(actor.footprints.side == side)
        latest = np.searchsorted(actor.footprints.contact_time[own], time + 1e-9, side="right") - 1
        mine = (foot == side) & (latest >= 0)
        number[mine] = own[latest[mine]]
    return number


def export_array(recording: Recording, path: str, asked: Asked) -> None:
    """Writes one array of a recording as .csv: a row per frame or footprint, a column per number. Raises InputError."""
    name, arrays = str(asked.array), recording.arrays
    if name not in arrays:
        known = [key for key in arrays if arrays[key].ndim]
        raise InputError(f"--array {name}: the recording has {', '.join(sorted(known))}{nearest(name, known)}")
    array = arrays[name]
    if asked.character is not None and array.ndim > 1 and array.shape[:2] == arrays["com"].shape[:2]:
        if not 0 <= asked.character < array.shape[1]:
            raise InputError(f"--character-index {asked.character}: there are {array.shape[1]} characters, counted from 0")
        array = array[:, asked.character]
    width = int(np.prod(array.shape[1:]))
    if width > MOST_COLUMNS:
        raise InputError(f"--array {name}: {width} columns; {MOST_COLUMNS} are allowed: give --character-index")
    ends = [".".join(map(str, place)) for place in np.ndindex(*array.shape[1:])]
    flat = array.reshape(len(array), width)
    columns = {f"{name}.{end}" if end else name: flat[:, k] for k, end in enumerate(ends)}
    write_table(({"time": arrays["time"]} if len(array) == len(arrays["time"]) else {}) | columns, path)
