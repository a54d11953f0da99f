"""Where everyone was, for tools of pedestrian dynamics: PedPy's text, JuPedSim's SQLite, Vadere's footsteps. Metres, x and y.

A person's place is the centre of mass seen from above.
"""

import sqlite3
from itertools import pairwise

import numpy as np

from sim import VERSION
from sim.export.clip.asked import Asked
from sim.export.clip.clip import Actor, Clip
from sim.export.tables.area import area_of
from sim.files import outputs
from sim.files.imports.trajectories import formats as words
from worlds.errors import InputError

_TABLES = f"""
CREATE TABLE {words.TABLE} (frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL NOT NULL, pos_y REAL NOT NULL,
                              ori_x REAL NOT NULL, ori_y REAL NOT NULL);
CREATE TABLE {words.META} (key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE geometry (hash INTEGER NOT NULL, wkt TEXT NOT NULL);
CREATE TABLE frame_data (frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL);
CREATE INDEX frame_id_idx ON {words.TABLE} (frame, id);
"""
"""JuPedSim's tables, version 2 (jupedsim-python, sqlite_serialization)."""


def export_text(clip: Clip, path: str, asked: Asked) -> None:
    """PedPy's and JuPedSim's text: id, frame, x, y, z, rows by id. Raises InputError."""
    with outputs.whole(path) as temporary, open(temporary, "w", encoding="utf-8", newline="\n") as file:
        file.write(f"# Footfall {VERSION}: {clip.name}\n# {words.RATE}: {clip.rate:g}\n# id frame x/m y/m z/m\n")
        for actor in clip.actors:
            rows = np.column_stack([np.full(len(clip.time), actor.index), np.arange(len(clip.time)), actor.pose.com])[
                actor.there
            ]
            np.savetxt(file, rows, fmt="%d %d %.6f %.6f %.6f")


def export_sqlite(clip: Clip, path: str, asked: Asked) -> None:
    """JuPedSim's SQLite, version 2, with the world less its walls as the walkable area. Raises InputError."""
    try:
        with outputs.whole(path) as temporary:
            file = sqlite3.connect(temporary)
            try:
                _fill(file, clip)
                file.commit()
            finally:
                file.close()
    except sqlite3.Error as error:
        raise InputError(f"{path}: cannot be written: {error}") from None


def _fill(file: sqlite3.Connection, clip: Clip) -> None:
    file.executescript(_TABLES)
    low_x, low_y, high_x, high_y = clip.world.arrays.bounds.tolist()
    wkt = area_of(clip.world, np.concatenate([actor.pose.com[actor.there, :2] for actor in clip.actors])).wkt
    bounds = {"xmin": low_x, "xmax": high_x, "ymin": low_y, "ymax": high_y}
    values = {"version": "2", words.FPS: f"{clip.rate:g}"} | {key: f"{value:g}" for key, value in bounds.items()}
    file.executemany(f"INSERT INTO {words.META} VALUES (?, ?)", values.items())
    file.execute("INSERT INTO geometry VALUES (1, ?)", (wkt,))
    file.executemany("INSERT INTO frame_data VALUES (?, 1)", ((k,) for k in range(len(clip.time))))
    for actor in clip.actors:
        rows = np.column_stack([actor.pose.com[:, :2], _ahead(actor)]).tolist()
        file.executemany(
            f"INSERT INTO {words.TABLE} VALUES (?, ?, ?, ?, ?, ?)",
            ((k, actor.index, *rows[k]) for k in np.flatnonzero(actor.there).tolist()),
        )


def _ahead(actor: Actor) -> np.ndarray:
    """(F, 2) where the body faces, of length 1."""
    w, x, y, z = actor.pose.body_rotation_wxyz.T
    ahead = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z)], axis=1)
    return ahead / np.maximum(np.linalg.norm(ahead, axis=1, keepdims=True), 1e-12)


def export_footsteps(clip: Clip, path: str, asked: Asked) -> None:
    """Vadere's footsteps (`postvis.traj`): where the person was at each contact of a foot and at the next one."""
    with outputs.whole(path) as temporary, open(temporary, "w", encoding="utf-8", newline="\n") as file:
        own, step = words.FOOTSTEP[:2], words.FOOTSTEP[2:]
        file.write(f"{' '.join([*own, *(f'{name}-PID1' for name in step)])} targetId-PID2\n")
        steps = [row for actor in clip.actors for row in _steps(actor)]
        for begin, end, who, *places in sorted(steps):
            file.write(f"{who + 1:d} {begin:.6f} {end:.6f} {' '.join(f'{value:.6f}' for value in places)} -1\n")


def _steps(actor: Actor) -> list[tuple]:
    """Begin and end [s], character, x and y at either [m] of each step within the clip, the first and last cut by its ends."""
    time, com = actor.time[actor.there], actor.pose.com[actor.there]
    contact = actor.footprints.contact_time
    inside = np.unique(np.concatenate([time[:1], contact[(contact > time[0]) & (contact < time[-1])], time[-1:]]))
    places = np.column_stack([np.interp(inside, time, com[:, k]) for k in range(2)]).tolist()
    return [
        (begin, end, actor.index, *here, *there)
        for (begin, end), (here, there) in zip(pairwise(inside.tolist()), pairwise(places), strict=True)
    ]
