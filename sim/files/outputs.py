"""Where results go: asked before a run begins, and written whole or not at all.

A file is made beside what it replaces, under a name that is nobody's, and takes its place when it is complete. A link is
followed; a device or a pipe cannot be replaced, so it is written to as such. What a killed run has left half made is removed by
the next one that writes to the folder (sim.files.leftovers).
"""

import os
import shutil
import stat
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from sim.files import leftovers
from sim.files.leftovers import Held
from worlds.compiled import leaving
from worlds.errors import InputError

AS_SUCH = ("/dev/", "/proc/")
"""What lies below is written to, never replaced: /dev/stdout is whatever it stands for."""


def check(wanted: dict[str, str | None]) -> None:
    """Raises InputError naming every one of the wanted files, by their options, that cannot be written."""
    given = {option: path for option, path in wanted.items() if path is not None}
    faults = [f"{option} {path}: {fault}" for option, path in given.items() if (fault := _fault(path))]
    seen: dict[str, str] = {}
    for option, path in given.items():
        if not faults and not _as_such(path):
            other = seen.setdefault(os.path.realpath(path), option)
            faults += [f"{option} {path}: is the file of {other}, too; each needs its own"] if other != option else []
    if faults:
        raise InputError("\n".join(faults))


def _fault(path: str) -> str | None:
    """Why this cannot be written, or None."""
    if not path:
        return "an empty name; the name of a file is needed"
    try:
        mode = os.stat(path).st_mode
    except FileNotFoundError:
        return _fault_of_folder(path)
    except (OSError, ValueError) as error:
        return f"cannot be written: {_reason(error)}"
    if stat.S_ISDIR(mode):
        return "is a folder; the name of a file is needed"
    if stat.S_ISSOCK(mode) or stat.S_ISBLK(mode):
        return "is a socket or a disk, no file"
    if not os.access(path, os.W_OK):
        return "is there, and must not be written"
    return None if _as_such(path) else _fault_of_folder(path)


def _fault_of_folder(path: str) -> str | None:
    """Why no file can be made in the folder of this one, or None."""
    try:
        target = Path(os.path.realpath(path))
        if not target.parent.is_dir():
            return f"the folder {target.parent} does not exist"
        leftovers.held_in(target.parent).drop()
    except FileNotFoundError:
        return "the folder that this is called in does not exist any more"
    except (OSError, ValueError) as error:
        return f"no file can be written there: {_reason(error)}"
    return None


def _as_such(path: str | Path) -> bool:
    """Whether this is a device or a pipe, or stands for one."""
    with suppress(OSError):
        return str(path).startswith(AS_SUCH) or not stat.S_ISREG(os.stat(path).st_mode)
    return False


class Part:
    """A file in the making: write to `path`, then `keep` it as what was wanted, or `drop` it. Raises InputError."""

    def __init__(self, wanted: str | Path) -> None:
        self.wanted = wanted
        try:
            self._target = None if _as_such(wanted) else Path(os.path.realpath(wanted))
            self._held: Held = leftovers.held_in(self._target.parent if self._target else Path(tempfile.gettempdir()))
            self.path = self._held.path
        except OSError as error:
            raise InputError(f"{wanted}: cannot be written: {_reason(error)}") from None
        leaving.remember(self, self.drop)

    def keep(self) -> None:
        """What was written takes its place."""
        try:
            if self._target is None:
                with open(self.path, "rb") as made, open(self.wanted, "wb") as device:
                    shutil.copyfileobj(made, device)
                self._held.drop()
            else:
                os.chmod(self.path, _rights(self._target))
                self._held.become(self._target)
            leaving.forget(self)
        except OSError as error:
            self.drop()
            raise InputError(f"{self.wanted}: cannot be written: {_reason(error)}") from None

    def drop(self) -> None:
        """Nothing is left of it."""
        leaving.forget(self)
        self._held.drop()


def _rights(target: Path) -> int:
    """Those of the file that is replaced, else those that any new file gets."""
    with suppress(OSError):
        return stat.S_IMODE(target.stat().st_mode)
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


@contextmanager
def whole(wanted: str | Path) -> Iterator[Path]:
    """A path to write to: it becomes the wanted file if nothing is raised, else nothing is left. Raises InputError."""
    part = Part(wanted)
    try:
        yield part.path
    except OSError as error:
        part.drop()
        raise InputError(f"{wanted}: cannot be written: {_reason(error)}") from None
    except BaseException:
        part.drop()
        raise
    part.keep()


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)


def write_all(jobs: dict[str, Callable[[], None]]) -> tuple[list[str], list[str]]:
    """Does every job, whatever becomes of the others: the files that were written, and what went wrong with the rest."""
    done, faults = [], []
    for path, job in jobs.items():
        try:
            job()
            done.append(path)
        except InputError as error:
            faults.append(str(error))
    return done, faults
