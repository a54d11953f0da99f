"""Where documents are kept: opened, saved whole or not at all, saved every few seconds, and found after a crash."""

import hashlib
import json
import os
import sys
import threading
import time as clock
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from planner.script.scene import SCENES, Sheet, read_sheet, world_of
from sim.files import outputs
from sim.files.studio.document import Document, document_of, sheet_of
from sim.files.studio.places import home
from sim.files.studio.writing import text_of
from worlds import reading
from worlds.errors import InputError
from worlds.world import World

PIPED = "-"
"""The name of a scene that comes through a pipe."""
EVERY = 2.0
"""Seconds between two savings by itself."""
MOST_RECENT = 12


@dataclass(frozen=True)
class Opened:
    """A document and where it comes from."""

    document: Document
    path: Path | None  # None: it has never been saved
    written: str = ""  # the file's text as it was read
    digest: str = ""  # of the file's bytes then


def open_scene(name_or_path: str | Path) -> Opened:
    """A scene that ships, by name, or any scene file, finished or not. Raises InputError naming every fault."""
    path = reading.named_file(SCENES, name_or_path, "scene")
    document, written, digest = _read(path)
    return Opened(document, path.resolve(), written, digest)


def piped(stream: BinaryIO) -> Document:
    """The document that comes through a pipe; heightmaps lie in the present folder. Raises InputError naming every fault."""
    name, raw = "what came through the pipe", stream.read(reading.LARGEST_FILE + 1)
    if len(raw) > reading.LARGEST_FILE:
        raise InputError(f"{name}: more than {reading.LARGEST_FILE} bytes; a scene has at most that many")
    try:
        plain = tomllib.loads(reading.text_of(Path(name), raw))
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{name}: is no TOML: {error}") from None
    return document_of(reading.checked(name, plain, Sheet))


def _read(path: Path) -> tuple[Document, str, str]:
    sheet = read_sheet(path)
    world_of(path, sheet)
    raw = path.read_bytes()
    return document_of(sheet), reading.text_of(path, raw), hashlib.sha256(raw).hexdigest()


def world_for(document: Document, path: Path | None) -> World:
    """The world of a document; heightmaps lie beside its file. Raises InputError."""
    return world_of(path or Path.cwd() / "scene.toml", sheet_of(document))


def changed_on_disk(opened: Opened) -> bool:
    """Whether somebody else has written the file since it was opened or saved."""
    if opened.path is None or not opened.digest:
        return False
    try:
        return hashlib.sha256(opened.path.read_bytes()).hexdigest() != opened.digest
    except OSError:
        return False  # it is gone: nothing is overwritten


def save(document: Document, opened: Opened, path: Path, force: bool = False) -> Opened:
    """Writes a document, and returns it as opened from there.

    Raises InputError where it cannot be written, or would replace what somebody else has written, unless `force`.
    """
    if not force:
        if path == opened.path and changed_on_disk(opened):
            raise InputError(f"{path}: somebody else has changed it since it was opened; save under another name, or over it")
        if path != opened.path and path.exists():
            raise InputError(f"{path}: is there already; save over it, or under another name")
    if SCENES.resolve() in path.resolve().parents:
        raise InputError(f"{path}: is a scene that ships, and stays as it is; save under another name")
    text = text_of(document, opened.written)
    with outputs.whole(path) as part:
        part.write_bytes(text.encode("utf-8"))
    return Opened(document, path.resolve(), text, hashlib.sha256(text.encode("utf-8")).hexdigest())


def recent() -> list[str]:
    """Files that were opened or saved lately, the latest first, those that are still there."""
    try:
        names = json.loads((home() / "recent.json").read_text("utf-8"))
    except (OSError, RuntimeError, ValueError):
        return []
    return [one for one in names if isinstance(one, str) and Path(one).is_file()][:MOST_RECENT]


def remember(path: Path) -> None:
    """Puts a file first among the recent ones; where that cannot be written, nothing is remembered."""
    names = [str(path.resolve()), *(one for one in recent() if one != str(path.resolve()))]
    try:
        with outputs.whole(home() / "recent.json") as part:
            part.write_text(json.dumps(names[:MOST_RECENT]), "utf-8")
    except (OSError, RuntimeError, InputError):
        return


class Autosave:
    """Keeps a document that has not been saved where it is found after a crash; a thread of its own writes it."""

    def __init__(self, every: float = EVERY) -> None:
        self.every, self._last, self._kept = every, clock.monotonic(), None
        self._thread: threading.Thread | None = None
        self.place = self._slot()

    def _slot(self) -> Path | None:
        try:
            folder = home() / "unsaved"
            folder.mkdir(exist_ok=True)
            return folder / f"{os.getpid()}.toml"
        except (OSError, RuntimeError):
            return None

    def look(self, document: Document, opened: Opened) -> None:
        """Called every frame: writes where something is new and enough time has passed."""
        busy = self._thread is not None and self._thread.is_alive()
        if self.place is None or busy or clock.monotonic() - self._last < self.every or document is self._kept:
            return
        self._last, self._kept = clock.monotonic(), document  # type: ignore[assignment]
        if document is opened.document:
            self.forget()
            return
        self._thread = threading.Thread(target=self._write, args=(document, opened), daemon=True)
        self._thread.start()

    def _write(self, document: Document, opened: Opened) -> None:
        assert self.place is not None
        origin = f"# {opened.path}\n" if opened.path else "# \n"
        try:
            with outputs.whole(self.place) as part:
                part.write_text(origin + text_of(document, opened.written), "utf-8")
        except InputError:
            return  # a full disk: the next one may fit

    def forget(self) -> None:
        """All is saved, or is not wanted."""
        if self._thread is not None:
            self._thread.join()
        if self.place is not None:
            self.place.unlink(missing_ok=True)


def lost() -> list[Path]:
    """What programs that have ended without saving have left, the latest first."""
    try:
        found = list((home() / "unsaved").glob("*.toml"))
    except (OSError, RuntimeError):
        return []
    ended = [one for one in found if one.stem.isdigit() and not _runs(int(one.stem))]
    return sorted(ended, key=lambda one: one.stat().st_mtime, reverse=True)


def _runs(process: int) -> bool:
    """Whether a process is there."""
    if process == os.getpid():
        return True
    if sys.platform == "win32":
        return False
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True
    return True


def recover(left: Path) -> Opened:
    """What a program has left: as opened from where it came from, not saved there yet. Raises InputError."""
    sheet = read_sheet(left)
    first, _, rest = left.read_text("utf-8").partition("\n")
    origin = first.removeprefix("#").strip()
    path = Path(origin) if origin else None
    digest = ""
    if path is not None and path.is_file():
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
    return Opened(document_of(sheet), path, rest, digest)
