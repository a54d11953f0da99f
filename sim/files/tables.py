"""Tables of numbers and words as .csv or .parquet: named columns of one length, written whole."""

import csv
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from sim.files import outputs

Columns = Mapping[str, np.ndarray | Sequence[Any]]
BLOCK = 10_000
"""Rows that are turned into text at a time."""


def write_table(columns: Columns, path: str | Path, kinds: Mapping[str, str] | None = None) -> None:
    """A table (N,) per column, by the ending of its name; None is nothing. Raises InputError.

    kinds: Parquet's types by column ("int64", "string", ...), where they are not those of the values; numbers become doubles.
    """
    with outputs.whole(path) as temporary:
        if str(path).lower().endswith(".parquet"):
            _write_parquet(columns, temporary, kinds or {})
        else:
            _write_csv(columns, temporary)


def _write_csv(columns: Columns, path: Path) -> None:
    """Numbers as short as they are read back to the bit."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        count = len(next(iter(columns.values()), ()))
        for begin in range(0, count, BLOCK):
            part = [_plain(column[begin : begin + BLOCK]) for column in columns.values()]
            writer.writerows(zip(*part, strict=True))


def _plain(column: np.ndarray | Sequence[Any]) -> Sequence[Any]:
    return column.tolist() if isinstance(column, np.ndarray) else column


def _write_parquet(columns: Columns, path: Path, kinds: Mapping[str, str]) -> None:
    import pyarrow
    from pyarrow import parquet

    def array(name: str, column: np.ndarray | Sequence[Any]) -> Any:
        if name not in kinds:
            return pyarrow.array(column)
        if kinds[name] == "double":
            column = [None if value is None else float(value) for value in column]
        return pyarrow.array(column, pyarrow.type_for_alias(kinds[name]))

    parquet.write_table(pyarrow.table({name: array(name, column) for name, column in columns.items()}), str(path))
