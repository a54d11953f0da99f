"""Tables of numbers and words as .csv or .parquet: named columns of one length, written whole."""

import csv
from pathlib import Path

import numpy as np

from sim.files import outputs

Columns = dict[str, np.ndarray]
BLOCK = 10_000
"""Rows that are turned into text at a time."""


def write_table(columns: Columns, path: str) -> None:
    """A table (N,) per column, by the ending of its name. Raises InputError."""
    with outputs.whole(path) as temporary:
        if path.lower().endswith(".parquet"):
            _write_parquet(columns, temporary)
        else:
            _write_csv(columns, temporary)


def _write_csv(columns: Columns, path: Path) -> None:
    """Numbers as short as they are read back to the bit."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        count = len(next(iter(columns.values())))
        for begin in range(0, count, BLOCK):
            part = [column[begin : begin + BLOCK].tolist() for column in columns.values()]
            writer.writerows(zip(*part, strict=True))


def _write_parquet(columns: Columns, path: Path) -> None:
    import pyarrow
    from pyarrow import parquet

    parquet.write_table(pyarrow.table({name: pyarrow.array(column) for name, column in columns.items()}), str(path))
