"""A file of trajectories, of whatever format, as ways."""

from pathlib import Path

from sim.files.imports import texts
from sim.files.imports.trajectories import formats
from sim.files.imports.trajectories.database import is_database, read_database
from sim.files.imports.trajectories.tables import format_of, read_table, split
from sim.files.imports.trajectories.ways import Way
from worlds.errors import InputError

WHAT = "a file of trajectories"


def read_ways(path: str | Path, kind: str | None = None, fps: float | None = None) -> list[Way]:
    """Where people were; `kind` is one of formats.FORMATS, by default as the file looks. Raises InputError naming faults."""
    database = is_database(path)
    if kind is not None and database != (kind == formats.JUPEDSIM):
        found = "is a database of SQLite" if database else "is no database of SQLite"
        raise InputError(f"{path}: {found}, so not of format {kind}")
    try:
        if database:
            return read_database(path, fps)
        lines = split(texts.text_of(path, WHAT))
        return read_table(kind or format_of(Path(path).name, lines), lines, fps)
    except InputError as error:
        said = str(error).split("\n")
        raise InputError("\n".join(one if one.startswith(str(path)) else f"{path}: {one}" for one in said)) from None
