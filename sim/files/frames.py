"""Arrays that grow frame by frame, for hours: in memory while they are small, else in a file without a name."""

import tempfile
from pathlib import Path
from typing import IO

import numpy as np

BLOCK = 2_000_000
"""Bytes that are collected before they are written to the file."""


class Frames:
    """Arrays of one shape and type, one after the other. The file goes when this does, or the program."""

    def __init__(self, folder: str | Path | None = None) -> None:
        self.folder = folder
        self._kept: list[np.ndarray] = []
        self._file: IO[bytes] | None = None
        self._bytes = 0

    def add(self, values: np.ndarray) -> None:
        """Takes an array, which must not be changed from now on. Raises OSError where the disk is full."""
        self._kept.append(values)
        self._bytes += values.nbytes
        if self._bytes > BLOCK:
            self._write()

    def _write(self) -> None:
        self._file = self._file or tempfile.TemporaryFile(dir=self.folder)  # noqa: SIM115 (it lives as long as this)
        self._file.write(np.array(self._kept).tobytes())
        self._file.flush()
        self._sample, self._bytes = self._kept[-1], 0
        self._kept.clear()

    def array(self, count: int) -> np.ndarray:
        """The first `count` of them, along a first axis; read from the file as they are needed."""
        if self._file is None:
            return np.array(self._kept[:count])
        if self._kept:
            self._write()
        return np.memmap(self._file, self._sample.dtype, "r", shape=(count, *self._sample.shape))
