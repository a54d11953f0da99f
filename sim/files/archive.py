"""Files of arrays: .npz without pickles, with a JSON string `meta`, written whole or not at all."""

import json
import math
import struct
import tokenize
import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from sim.files import outputs
from worlds.errors import InputError
from worlds.reading import is_regular

Arrays = dict[str, np.ndarray]
HEIGHTS = "heights"
"""The array of a heightmap."""
LARGEST, SURELY, DENSEST = 16_000_000_000, 1_000_000_000, 200
"""Bytes that the arrays of a file may take in memory; up to SURELY, or so many times as many as the file has: what unpacks to
more was made to."""
LARGEST_META = 400_000_000
"""Bytes of the JSON string in memory, four to a letter."""
ENCRYPTED = 1
"""The bit of a member's flags that says so."""
MOST_MEMBERS = 1000
"""Arrays in a file."""
PACKED, TABLE, LONG = ".packed", ".table", 10_000
"""A float array of at least so many numbers, of which few differ (a heightmap's), is kept as places in a table of them."""
UNREADABLE = (
    ValueError, OSError, EOFError, zipfile.BadZipFile, zlib.error, KeyError, TypeError, NotImplementedError, RuntimeError,
    MemoryError, OverflowError, SyntaxError, struct.error, AttributeError, IndexError, tokenize.TokenError,
)  # fmt: skip
"""What a damaged or forged archive makes its readers raise; nested too deeply is a RuntimeError."""


def write(path: str | Path, arrays: Arrays, meta: dict, compressed: bool = True) -> None:
    """Writes arrays and meta. Raises InputError where that cannot be done; nothing is left half written."""
    save, arrays = np.savez_compressed if compressed else np.savez, _packed(arrays)
    with outputs.whole(path) as temporary, open(temporary, "wb") as file:
        save(file, allow_pickle=False, **arrays, meta=np.array(json.dumps(meta, sort_keys=True)))  # type: ignore[arg-type]


def read(path: str | Path, what: str, hint: str, needed: tuple[str, ...], form: int) -> tuple[Arrays, dict]:
    """Arrays and meta of `what` (a recording, a saved state). Raises InputError for files that are none, or damaged.

    hint: how such a file is made; needed: arrays that it must have; form: the number `format` in its meta.
    """
    path = Path(path)
    if not is_regular(path):
        raise InputError(f"{path}: no such file; {what} is made with {hint}")
    if not zipfile.is_zipfile(path):
        raise InputError(f"{path}: is not readable as {what}: it is no .npz file, or was cut short")
    try:
        _check_sizes(path)
        with np.load(path, allow_pickle=False) as file:
            arrays = _unpacked({name: file[name] for name in file.files})
        meta = json.loads(str(arrays.pop("meta"))) if "meta" in arrays else None
    except UNREADABLE as error:
        raise InputError(f"{path}: is not readable as {what} ({error})") from None
    missing = [name for name in needed if name not in arrays]
    if missing or not isinstance(meta, dict):
        raise InputError(f"{path}: is not {what} of Footfall: lacks {', '.join(missing or ['meta'])}")
    if meta.get("format") != form:
        raise InputError(f"{path}: meta.format = {meta.get('format')!r}: {form} is needed; written by another version")
    return arrays, meta


def _packed(arrays: Arrays) -> Arrays:
    """The same, with long arrays of few different numbers as 16-bit places in a table of these: a quarter of the bytes."""
    found: Arrays = {}
    for name, array in arrays.items():
        if name == HEIGHTS and array.size >= LONG and array.dtype == np.float64:
            table, places = np.unique(array, return_inverse=True)
            if len(table) <= 2**16:
                found |= {name + PACKED: places.reshape(array.shape).astype(np.uint16), name + TABLE: table}
                continue
        found[name] = array
    return found


def _unpacked(arrays: Arrays) -> Arrays:
    """What `_packed` has packed. Raises IndexError, ValueError for places that are none."""
    places, table = (arrays.pop(HEIGHTS + end, None) for end in (PACKED, TABLE))
    if places is not None and table is not None:
        if places.dtype != np.uint16 or table.dtype != np.float64 or table.ndim != 1:
            raise ValueError(f"{HEIGHTS}{PACKED}: 16-bit places in a row of numbers are needed")
        arrays[HEIGHTS] = table[places]
    return arrays


def _check_sizes(path: Path) -> None:
    """Raises ValueError for an archive whose arrays are too large, or not as large as it says, before memory is asked for."""
    total, most = 0, min(max(SURELY, DENSEST * path.stat().st_size), LARGEST)
    with zipfile.ZipFile(path) as archive:
        if len(archive.infolist()) > MOST_MEMBERS:
            raise ValueError(f"has {len(archive.infolist())} members; at most {MOST_MEMBERS} are read")
        for info in archive.infolist():
            size = _size(archive, info)
            if info.filename == "meta.npy" and size > LARGEST_META:
                raise ValueError(f"meta takes {size} bytes; at most {LARGEST_META} are read")
            total += size
            if total > most:
                raise ValueError(f"takes {total} bytes or more; at most {most} are read from a file of this size")


def _size(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> int:
    """Bytes of an array, as its header tells. Raises ValueError where the archive tells otherwise."""
    if info.flag_bits & ENCRYPTED:
        raise ValueError(f"{info.filename} is encrypted, which nothing that Footfall writes is")
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise ValueError(f"{info.filename} is packed in a way that numpy does not write")
    with archive.open(info) as member:
        major, _ = np.lib.format.read_magic(member)
        read_header = np.lib.format.read_array_header_1_0 if major == 1 else np.lib.format.read_array_header_2_0
        shape, _, dtype = read_header(member)
        size = math.prod(shape) * dtype.itemsize
        if min(shape, default=0) < 0 or member.tell() + size != info.file_size:
            raise ValueError(f"{info.filename} tells {size} bytes, and has {info.file_size}")
    return size


def flat(prefix: str, table: tuple) -> Arrays:
    """A NamedTuple of arrays, and of such tuples, as arrays by their dotted names."""
    found: Arrays = {}
    for name, value in table._asdict().items():  # type: ignore[attr-defined]
        found |= flat(f"{prefix}.{name}", value) if isinstance(value, tuple) else {f"{prefix}.{name}": value}
    return found


def unflat(prefix: str, model: Any, arrays: Arrays, rows: int | None = None) -> Any:
    """What `flat` made arrays of, of the model's types and shapes; where `rows` are given, of its dimensions, and so many rows.

    Columns that the model's `shared()` names are of all together, and may have any number of rows. Floats must be finite, but
    for columns that `endless()` names, which may hold inf. Raises KeyError, ValueError.
    """
    found = {}
    for name, expected in model._asdict().items():
        key = f"{prefix}.{name}"
        if isinstance(expected, tuple):
            found[name] = unflat(key, expected, arrays, rows)
            continue
        array, free = arrays[key], name in getattr(type(model), "shared", tuple)()
        fits = array.shape == expected.shape if rows is None else array.ndim == expected.ndim and (free or len(array) == rows)
        if array.dtype != expected.dtype or not fits:
            raise ValueError(f"{key} is {array.dtype} {array.shape}")
        endless = name in getattr(type(model), "endless", tuple)()
        if array.dtype.kind == "f" and not (np.isfinite(array) | (array == np.inf if endless else False)).all():
            raise ValueError(f"{key}: finite numbers are needed")
        found[name] = np.ascontiguousarray(array)
    return type(model)(**found)
