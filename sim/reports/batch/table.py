"""The table of a batch: a row for each character of each run, in the order of levels and seeds."""

from importlib.util import find_spec
from pathlib import Path

from sim.files import tables
from sim.reports.batch.running import Row

PARQUET, CSV = "results.parquet", "results.csv"
KINDS = {
    "level": "string", "name": "string", "error": "string", "gait.name": "string", "seed": "int64", "character": "int32",
    "reached_goal": "bool",
}  # fmt: skip
"""Types of Parquet's columns: a column is of one, whatever its rows hold. All others are doubles."""


def write_table(rows: list[Row], folder: Path) -> Path:
    """Writes the table: Parquet where pyarrow (the extra `batch`) is, else CSV. Returns its path."""
    path = folder / (PARQUET if _has_arrow() else CSV)
    names = list(dict.fromkeys(name for row in rows for name in row))  # in the order in which they first appear
    kinds = {name: KINDS.get(name, "double") for name in names}
    tables.write_table({name: [row.get(name) for row in rows] for name in names}, path, kinds)
    return path


def _has_arrow() -> bool:
    return find_spec("pyarrow") is not None
