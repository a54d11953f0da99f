"""What files hold, and pipes: no more than is asked for, and never a wait without an end."""

import os
import select
import stat
from pathlib import Path

PATIENCE = 10.0
"""Seconds that a pipe is waited for."""
_READ: dict[tuple[int, int], bytes] = {}
"""What came through pipes: it comes once, and may be asked for twice."""


def content(path: Path, most: int) -> bytes | None:
    """What the file holds; None where that is more than `most` bytes. Raises OSError."""
    found = os.stat(path)
    if stat.S_ISREG(found.st_mode):
        with open(path, "rb") as file:
            return _capped(file.read(most + 1), most)
    key = (found.st_dev, found.st_ino)
    if key not in _READ:
        _READ[key] = _through(path, most + 1)
    return _capped(_READ[key], most)


def _capped(data: bytes, most: int) -> bytes | None:
    return data if len(data) <= most else None


def _through(path: Path, most: int) -> bytes:
    """What comes through a pipe, or out of a device, up to `most` bytes. Raises OSError where nothing comes."""
    pipe = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    data = b""
    try:
        while len(data) < most:
            if os.name == "posix" and not select.select([pipe], [], [], PATIENCE)[0]:
                raise TimeoutError(0, f"nothing has come through it for {PATIENCE:.0f} s")
            piece = os.read(pipe, min(most - len(data), 1 << 16))
            if not piece:
                break
            data += piece
    finally:
        os.close(pipe)
    return data
