"""How compiled kernels are kept: whatever happened to a file, what comes out of it is what was put in, or nothing.

numba's own cache believes its files: a flipped bit is machine code that is run. Here every file begins with its digest; one
that does not fit is thrown away with a word, and made anew. Files are found by the place of a kernel in the program and what
its source says, so a folder may be moved or copied.
"""

import hashlib
import os
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

from numba.core import caching

from worlds.compiled.cache import ROOT
from worlds.compiled.telling import tell

_DIGEST = hashlib.sha256().digest_size


class _Place(caching.UserProvidedCacheLocator):  # type: ignore[misc]
    """A kernel of the program: kept by where it is in it, not by where the program is."""

    def __init__(self, function: Callable, file: str) -> None:
        super().__init__(function, file)
        self._cache_path = str(Path(os.environ["NUMBA_CACHE_DIR"]) / Path(file).resolve().relative_to(ROOT).parent)

    @classmethod
    def from_function(cls, py_func: Callable, py_file: str) -> Any:
        return super().from_function(py_func, py_file) if Path(py_file).resolve().is_relative_to(ROOT) else None


class _Kernel(caching.CompileResultCacheImpl):  # type: ignore[misc]
    _locator_classes = [_Place, *caching.CacheImpl._locator_classes]


class _Files(caching.IndexDataCacheFile):  # type: ignore[misc]
    """numba's two kinds of files, each with its digest before it."""

    def _load_index(self) -> dict:
        try:
            version, stamp, overloads = self._read(self._index_path)
        except OSError:
            return {}
        return overloads if (version, stamp) == (self._version, self._source_stamp) else {}

    def _save_index(self, overloads: dict) -> None:
        self._write(self._index_path, (self._version, self._source_stamp, overloads))

    def _load_data(self, name: str) -> Any:
        return self._read(self._data_path(name))

    def _save_data(self, name: str, data: Any) -> None:
        self._write(self._data_path(name), data)

    def _write(self, path: str, value: Any) -> None:
        data = self._dump(value)
        with self._open_for_write(path) as file:
            file.write(hashlib.sha256(data).digest() + data)

    def _read(self, path: str) -> Any:
        """What was written there. Raises OSError where that is not to be had: it is then compiled, and written, once more."""
        data = Path(path).read_bytes()
        if hashlib.sha256(data[_DIGEST:]).digest() != data[:_DIGEST]:
            Path(path).unlink(missing_ok=True)
            tell(f"{path} was damaged; it is compiled anew")
            raise OSError("damaged")
        return pickle.loads(data[_DIGEST:])


class Kept(caching.FunctionCache):  # type: ignore[misc]
    """What numba asks for kernels that were compiled before. Raises RuntimeError for functions that come from no file."""

    _impl_class = _Kernel

    def __init__(self, function: Callable) -> None:
        super().__init__(function)
        self._cache_file = _Files(self._cache_path, self._impl.filename_base, self._impl.locator.get_source_stamp())

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keeps a kernel; where the disk is full, it is compiled the next time, too."""
        try:
            super().save_overload(sig, data)
        except OSError as error:
            tell(f"{self._cache_path}: a compiled kernel cannot be kept: {error.strerror}")
