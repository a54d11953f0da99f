"""JuPedSim's trajectories: a database of SQLite (`formats`), opened to be read only, and nothing in it is run."""

import os
import sqlite3
from contextlib import closing
from pathlib import Path

import numpy as np

from sim.files.imports import texts
from sim.files.imports.plans.wkt import plan_of
from sim.files.imports.trajectories import formats
from sim.files.imports.trajectories.ways import MOST_ROWS, Way, ways_of
from worlds.errors import InputError

LARGEST = 2_000_000_000
"""Bytes."""
MOST_GEOMETRIES = 20
"""Of a file: more are parts of a drawing that changes, and none is the one to show."""


def is_database(path: str | Path) -> bool:
    """Whether a file begins as one of SQLite does."""
    try:
        if not Path(path).is_file():
            return False
        with open(path, "rb") as file:
            return file.read(len(formats.SQLITE_BEGINS)) == formats.SQLITE_BEGINS
    except (OSError, ValueError):
        return False


def read_database(path: str | Path, fps: float | None) -> list[Way]:
    """The ways of everybody in it. Raises InputError."""
    if os.path.getsize(path) > LARGEST:
        raise InputError(f"more than {LARGEST:,} bytes; a database of trajectories has at most that many")
    try:
        with closing(sqlite3.connect(f"{Path(path).resolve().as_uri()}?mode=ro&immutable=1", uri=True)) as opened:
            opened.execute("PRAGMA trusted_schema = OFF")
            return _ways(opened, fps)
    except (sqlite3.Error, OverflowError, UnicodeDecodeError) as error:
        raise InputError(f"is a damaged database: {error}") from None


def geometry_of(path: str | Path) -> tuple[np.ndarray, ...]:
    """Borders of where people could walk, each (P, 2) [m], as a database of JuPedSim tells; none in other files.

    A box that is all of it tells no more than how far the ways reach, and is left out. Raises InputError.
    """
    if not is_database(path):
        return ()
    try:
        with closing(sqlite3.connect(f"{Path(path).resolve().as_uri()}?mode=ro&immutable=1", uri=True)) as opened:
            opened.execute("PRAGMA trusted_schema = OFF")
            tables = {name for (name,) in opened.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
            if formats.GEOMETRY not in tables:
                return ()
            texts_of = opened.execute(f"SELECT wkt FROM {formats.GEOMETRY} LIMIT {MOST_GEOMETRIES}").fetchall()
    except (sqlite3.Error, OverflowError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: is a damaged database: {error}") from None
    found = [line for (text,) in texts_of for line in plan_of(str(text), f"{path}: {formats.GEOMETRY}").lines]
    return () if len(found) == 1 and _is_box(found[0]) else tuple(found)


def _is_box(ring: np.ndarray) -> bool:
    corners = np.unique(np.round(ring, 6), axis=0)
    return len(corners) == 4 and len(np.unique(corners[:, 0])) == len(np.unique(corners[:, 1])) == 2


def _ways(opened: sqlite3.Connection, fps: float | None) -> list[Way]:
    tables = {name for (name,) in opened.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    if lacking := {formats.TABLE, formats.META} - tables:
        raise InputError(f"is no database of JuPedSim: no table {', '.join(sorted(lacking))}")
    rate = fps or _rate(opened)
    columns, most = ", ".join(formats.ROWS), MOST_ROWS + 1
    rows = opened.execute(f"SELECT {columns} FROM {formats.TABLE} ORDER BY id, frame LIMIT {most}").fetchall()
    if len(rows) > MOST_ROWS:
        raise InputError(f"more than {MOST_ROWS:,} rows; take fewer people, or fewer frames a second")
    wrong = [row for row in rows if not all(_is_number(value) for value in row[1:])]
    if wrong:
        raise InputError(f"{formats.TABLE}: {wrong[0]}: {', '.join(formats.ROWS)} must be numbers ({len(wrong)} rows are not)")
    found = np.array([row[1:] for row in rows], np.float64).reshape(-1, 3)
    return ways_of([str(row[0])[:100] for row in rows], found[:, 0] / rate, found[:, 1:])


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and abs(value) <= texts.FARTHEST


def _rate(opened: sqlite3.Connection) -> float:
    found = opened.execute(f"SELECT value FROM {formats.META} WHERE key = ?", (formats.FPS,)).fetchone()
    rate = texts.number(str(found[0])) if found else None
    if rate is None or not 0 < rate <= 10_000:
        raise InputError(f"{formats.META}.{formats.FPS} = {found and found[0]!r}: a number above 0 is needed; give --fps")
    return rate
