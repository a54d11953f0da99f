"""A file of trajectories, of whatever format, as ways."""

from pathlib import Path

from sim.files.imports import texts
from sim.files.imports.trajectories import formats
from sim.files.imports.trajectories.annotated import read_homography, read_splines
from sim.files.imports.trajectories.database import is_database, read_database
from sim.files.imports.trajectories.tables import format_of, read_table, split
from sim.files.imports.trajectories.ways import Way
from worlds.errors import InputError

WHAT = "a file of trajectories"


def read_ways(
    path: str | Path, kind: str | None = None, fps: float | None = None, homography: str | None = None
) -> list[Way]:  # fmt: skip
    """Where people were; `kind` is one of formats.FORMATS, by default as the file looks. Raises InputError naming faults.

    homography: a file of nine numbers, for .vsp.
    """
    database = is_database(path)
    if kind is not None and database != (kind == formats.JUPEDSIM):
        found = "is a database of SQLite" if database else "is no database of SQLite"
        raise InputError(f"{path}: {found}, so not of format {kind}")
    try:
        if database and homography is not None:
            raise InputError("--homography is for .vsp files, whose places are pixels")
        if database:
            return read_database(path, fps)
        text = texts.text_of(path, WHAT)
        splines = formats.SPLINES_BEGIN in text[: text.find("\n") + 1] or Path(path).suffix.lower() == ".vsp"
        if kind == formats.SPLINES or (kind is None and splines):
            return read_splines(text, fps, None if homography is None else read_homography(homography))
        if homography is not None:
            raise InputError("--homography is for .vsp files, whose places are pixels")
        lines = split(text)
        return read_table(kind or format_of(Path(path).name, lines), lines, fps)
    except InputError as error:
        own = str(path), str(homography)
        said = [one if one.startswith(own) else f"{path}: {one}" for one in str(error).split("\n")]
        raise InputError("\n".join(said)) from None
