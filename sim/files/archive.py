"""Files of arrays: .npz without pickles, with a JSON string `meta`, written whole or not at all."""

import json
import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from sim.files import outputs
from worlds.errors import InputError

Arrays = dict[str, np.ndarray]
_UNREADABLE = (
    ValueError, OSError, EOFError, zipfile.BadZipFile, zlib.error, KeyError, TypeError, SyntaxError, OverflowError,
    RuntimeError, MemoryError,
)  # fmt: skip
"""What zipfile and numpy raise for files that are damaged, encrypted, or declare more than any memory holds."""


def write(path: str | Path, arrays: Arrays, meta: dict, compressed: bool = True) -> None:
    """Writes arrays and meta. Raises InputError where that cannot be done; nothing is left half written."""
    save = np.savez_compressed if compressed else np.savez
    with outputs.whole(path) as temporary, open(temporary, "wb") as file:
        save(file, allow_pickle=False, **arrays, meta=np.array(json.dumps(meta, sort_keys=True)))  # type: ignore[arg-type]


def read(path: str | Path, what: str, hint: str, needed: tuple[str, ...], form: int) -> tuple[Arrays, dict]:
    """Arrays and meta of `what` (a recording, a saved state). Raises InputError for files that are none, or damaged.

    hint: how such a file is made; needed: arrays that it must have; form: the number `format` in its meta.
    """
    path = Path(path)
    if not path.is_file():
        raise InputError(f"{path}: no such file; {what} is made with {hint}")
    if not zipfile.is_zipfile(path):
        raise InputError(f"{path}: is not readable as {what}: it is no .npz file, or was cut short")
    try:
        with np.load(path, allow_pickle=False) as file:
            arrays = {name: file[name] for name in file.files}
        meta = json.loads(str(arrays.pop("meta"))) if "meta" in arrays else None
    except _UNREADABLE as error:
        raise InputError(f"{path}: is not readable as {what} ({error})") from None
    missing = [name for name in needed if name not in arrays]
    if missing or not isinstance(meta, dict):
        raise InputError(f"{path}: is not {what} of Footfall: lacks {', '.join(missing or ['meta'])}")
    if meta.get("format") != form:
        raise InputError(f"{path}: meta.format = {meta.get('format')!r}: {form} is needed; written by another version")
    return arrays, meta


def flat(prefix: str, table: tuple) -> Arrays:
    """A NamedTuple of arrays, and of such tuples, as arrays by their dotted names."""
    found: Arrays = {}
    for name, value in table._asdict().items():  # type: ignore[attr-defined]
        found |= flat(f"{prefix}.{name}", value) if isinstance(value, tuple) else {f"{prefix}.{name}": value}
    return found


def unflat(prefix: str, model: Any, arrays: Arrays, rows: int | None = None) -> Any:
    """What `flat` made arrays of, of the model's types, dimensions and, but where `rows` are given, numbers of rows.

    Raises KeyError, ValueError.
    """
    found = {}
    for name, expected in model._asdict().items():
        key = f"{prefix}.{name}"
        if isinstance(expected, tuple):
            found[name] = unflat(key, expected, arrays, rows)
            continue
        array = arrays[key]
        count = len(expected) if rows is None else rows
        if array.dtype != expected.dtype or array.ndim != expected.ndim or len(array) != count:
            raise ValueError(f"{key} is {array.dtype} {array.shape}")
        found[name] = np.ascontiguousarray(array)
    return type(model)(**found)
