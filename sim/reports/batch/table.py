"""The table of a batch: a row for each character of each run, in the order of levels and seeds."""

import csv
from pathlib import Path
from types import ModuleType

from sim.files import outputs
from sim.reports.batch.running import Row

PARQUET, CSV = "results.parquet", "results.csv"


def columns_of(rows: list[Row]) -> list[str]:
    """All columns, in the order in which they first appear."""
    return list(dict.fromkeys(name for row in rows for name in row))


def write_table(rows: list[Row], folder: Path) -> Path:
    """Writes the table: Parquet where pyarrow (the extra `batch`) is, else CSV. Returns its path."""
    arrow = _arrow()
    path = folder / (CSV if arrow is None else PARQUET)
    with outputs.whole(path) as part:
        if arrow is None:
            _csv(rows, part)
        else:
            _parquet(rows, part, arrow)
    return path


def _arrow() -> ModuleType | None:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        return None
    return pyarrow


def _csv(rows: list[Row], path: Path) -> None:
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns_of(rows), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def _parquet(rows: list[Row], path: Path, arrow: ModuleType) -> None:
    """Numbers as doubles, but for seeds and characters, so that a column is of one type whatever its rows hold."""
    kinds = {"level": arrow.string(), "name": arrow.string(), "error": arrow.string(), "gait.name": arrow.string(),
             "seed": arrow.int64(), "character": arrow.int32(), "reached_goal": arrow.bool_()}  # fmt: skip
    names = columns_of(rows)
    schema = arrow.schema([(name, kinds.get(name, arrow.float64())) for name in names])
    columns = [arrow.array([_value(row.get(name), kinds.get(name)) for row in rows], schema.field(name).type) for name in names]
    arrow.parquet.write_table(arrow.Table.from_arrays(columns, schema=schema), path)


def _value(value: object, kind: object) -> object:
    return float(value) if kind is None and isinstance(value, bool | int) else value
