"""Where compiled kernels are kept: a folder for these very sources.

numba itself notices only edits of the file that holds a kernel, so an edited helper would leave its callers stale: the folder
is named by a hash of all sources that hold kernels. A checkout keeps it beside the code, an installation in the user's own
cache; where neither can be written, it is a temporary one that is ours alone, or none.
"""

import hashlib
import os
import shutil
import stat
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
_PACKAGES = ("motion", "worlds", "planner", "sim")
_WITHOUT_KERNELS = {"cli", "export", "files", "learning", "people", "reports", "view"}
"""Rooms that only call kernels: an edit there leaves what is compiled as it is."""
_KEPT = 4
"""Folders of other sources that are left alone, the newest: going back to what was edited compiles nothing."""


def source_key() -> str:
    """Hash of the sources that hold kernels."""
    digest = hashlib.sha256()
    for package in _PACKAGES:
        for path in sorted((ROOT / package).rglob("*.py")):
            if not _WITHOUT_KERNELS.intersection(path.relative_to(ROOT / package).parts):
                digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def _home() -> Path:
    """The user's own folder for what can be made anew. Raises RuntimeError for users without a home."""
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def folder() -> Path | None:
    """The folder for compiled kernels, made where it is missing; None where there is none that is ours alone."""
    key = source_key()
    is_checkout = (ROOT / "pyproject.toml").is_file()
    places = (lambda: ROOT / ".numba_cache", lambda: _home() / "footfall")
    for find in places if is_checkout else places[1:]:
        try:
            place = find()
            (place / key).mkdir(parents=True, exist_ok=True)
        except (OSError, RuntimeError):
            continue
        if os.access(place / key, os.W_OK) and _is_trusted(place / key):
            _forget_old(place, key)
            return place / key
    return _temporary(key)


def _is_trusted(place: Path) -> bool:
    """Whether nobody but us, or who owns the sources that we run, can have put anything there: it is code."""
    if os.name != "posix":
        return True
    found = place.lstat()
    return (
        stat.S_ISDIR(found.st_mode) and found.st_uid in (os.getuid(), ROOT.stat().st_uid) and not found.st_mode & stat.S_IWOTH
    )


def _temporary(key: str) -> Path | None:
    """A folder of our own among those that everyone shares."""
    place = Path(tempfile.gettempdir()) / (f"footfall-{os.getuid()}" if os.name == "posix" else "footfall")
    try:
        place.mkdir(mode=0o700, exist_ok=True)
        found = place.lstat()
        if os.name == "posix" and (not stat.S_ISDIR(found.st_mode) or found.st_uid != os.getuid() or found.st_mode & 0o077):
            return None
        (place / key).mkdir(exist_ok=True)
        _forget_old(place, key)
        return place / key
    except OSError:
        return None


def _forget_old(place: Path, key: str) -> None:
    """Removes the folders of sources that have long been edited."""
    others = sorted((path for path in place.iterdir() if path.is_dir() and path.name != key), key=lambda p: p.stat().st_mtime)
    for path in others[:-_KEPT]:
        shutil.rmtree(path, ignore_errors=True)
