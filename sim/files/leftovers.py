"""Files in the making, and those that a killed run has left in a folder.

Whoever makes a file holds a lock on it, which ends with the process, however that ends: so a file that bears our mark and can
be locked is nobody's any more. Where locks are not to be had, as on some shared disks, it cannot be told, and nothing is
removed.
"""

import os
import re
import stat
import tempfile
from contextlib import suppress
from pathlib import Path

try:
    import fcntl
except ImportError:  # Windows removes no file that somebody holds open
    fcntl = None  # type: ignore[assignment]

MARK, END = ".footfall-held-", ".part"
_OURS = re.compile(re.escape(MARK) + r"[a-z0-9_]{8}" + re.escape(END))


class Held:
    """A new, empty file that is ours while this process lives, whoever writes to it by its name."""

    def __init__(self, folder: Path) -> None:
        """Raises OSError where none can be made."""
        while True:
            self._handle, name = tempfile.mkstemp(END, MARK, folder)
            self.path = Path(name)
            if _lock(self._handle) and self.path.exists():
                return
            self.drop()  # somebody was quicker, and took it for a leftover

    def become(self, target: Path) -> None:
        """It takes the place of another file. Raises OSError; it is then there still."""
        if fcntl is None:
            self._let_go()
        os.replace(self.path, target)
        self._let_go()

    def drop(self) -> None:
        """It is gone, whether it was there or not."""
        if fcntl is None:
            self._let_go()
        self.path.unlink(missing_ok=True)
        self._let_go()

    def _let_go(self) -> None:
        handle, self._handle = self._handle, -1
        if handle >= 0:
            os.close(handle)


def held_in(folder: Path) -> Held:
    """A new file in a folder, from which what killed runs have left is removed. Raises OSError."""
    clean(folder)
    return Held(folder)


def clean(folder: Path) -> None:
    """Removes what is ours and nobody's any more."""
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if _OURS.fullmatch(entry.name):
                with suppress(OSError):
                    _remove_if_left(Path(entry.path))


def _remove_if_left(path: Path) -> None:
    """Removes a file that was left. Raises OSError where it is held, somebody else's, or not to be told."""
    found = path.lstat()
    if not stat.S_ISREG(found.st_mode) or (os.name == "posix" and found.st_uid != os.getuid()):
        return
    if fcntl is None:
        path.unlink()
        return
    handle = os.open(path, os.O_RDWR | os.O_NOFOLLOW | os.O_NONBLOCK)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        path.unlink()
    finally:
        os.close(handle)


def _lock(handle: int) -> bool:
    """Holds a file for as long as the process lives, where its disk knows locks; whether nobody else does."""
    try:
        if fcntl is not None:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        return True
    return True
