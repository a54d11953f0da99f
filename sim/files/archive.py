"""Files of arrays: .npz without pickles, with a JSON string `meta`, written whole or not at all."""

import json
import os
import zipfile
import zlib
from pathlib import Path

import numpy as np

from worlds.errors import InputError

Arrays = dict[str, np.ndarray]


def write(path: str | Path, arrays: Arrays, meta: dict, compressed: bool = True) -> None:
    """Writes arrays and meta. Raises InputError where that cannot be done; nothing is left half written."""
    path = Path(path)
    temporary = path.with_name(path.name + ".part")
    save = np.savez_compressed if compressed else np.savez
    try:
        with open(temporary, "wb") as file:
            save(file, allow_pickle=False, **arrays, meta=np.array(json.dumps(meta, sort_keys=True)))  # type: ignore[arg-type]
        os.replace(temporary, path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None


def read(path: str | Path, what: str, hint: str, needed: tuple[str, ...], form: int) -> tuple[Arrays, dict]:
    """Arrays and meta of `what` (a recording, a saved state). Raises InputError for files that are none, or damaged.

    hint: how such a file is made; needed: arrays that it must have; form: the number `format` in its meta.
    """
    path = Path(path)
    if not path.is_file():
        raise InputError(f"{path}: no such file; {what} is made with {hint}")
    try:
        with np.load(path, allow_pickle=False) as file:
            arrays = {name: file[name] for name in file.files}
        meta = json.loads(str(arrays.pop("meta"))) if "meta" in arrays else None
    except (ValueError, OSError, EOFError, zipfile.BadZipFile, zlib.error, KeyError, TypeError, NotImplementedError) as error:
        raise InputError(f"{path}: is not readable as {what} ({error})") from None
    missing = [name for name in needed if name not in arrays]
    if missing or not isinstance(meta, dict):
        raise InputError(f"{path}: is not {what} of Footfall: lacks {', '.join(missing or ['meta'])}")
    if meta.get("format") != form:
        raise InputError(f"{path}: meta.format = {meta.get('format')!r}: {form} is needed; written by another version")
    return arrays, meta
