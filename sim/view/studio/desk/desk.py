"""The studio's desk: the document that lies on it, what is chosen, what time is shown, and the motion over it. No GL, no imgui.

Every change is an edit of sim.files.studio. While the mouse drags, `preview` shows an edit and solves around it; `drop` does it
and solves the whole, so the motion that is left depends on the document alone.
"""

import time as clock
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from planner.script.acting import Act
from planner.script.footprint import Footprint
from sim.files.studio import keeping
from sim.files.studio.document import Document, Spot, footprints_in, new_document
from sim.files.studio.edits import Edit
from sim.files.studio.history import begun, tried
from sim.files.studio.keeping import Autosave, Opened
from sim.files.studio.runs.walked import document_in
from sim.stage.scripted.rehearsal import Rehearsal
from worlds.errors import InputError

NOTICE = 5.0
"""Seconds that a notice is shown."""
SELECT, PLACE, DRAW = "select", "place", "draw a path"
SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0)


@dataclass(frozen=True)
class Notice:
    """A sentence for a while."""

    text: str
    until: float
    wrong: bool = False


@dataclass
class Shown:
    """What of a scene is drawn."""

    plan: bool = True
    space: bool = True
    curve: bool = True
    daggers: bool = True
    ghosts: bool = False
    forces: bool = False
    strips: bool = True
    inspector: bool = True
    follow: bool = True
    help: bool = False
    history: bool = False


@dataclass
class Playing:
    """The time that is shown, and whether it runs."""

    time: float = 0.0
    on: bool = False
    speed: float = 1.0
    loop: tuple[float, float] | None = None

    def advance(self, seconds: float, end: float) -> None:
        """Lets wall time pass; at the end it begins anew. No time beyond the end is shown."""
        self.time = min(self.time, end)
        if not self.on:
            return
        first, last = self.loop or (0.0, end)
        self.time += seconds * self.speed
        if self.time > last or self.time < first:
            self.time = first


@dataclass
class Desk:
    """What is on the desk."""

    opened: Opened = field(default_factory=lambda: Opened(new_document(), None))
    taken: int = 0  # so many documents have been put on the desk

    def __post_init__(self) -> None:
        self.shown, self.playing, self.tool = Shown(), Playing(), SELECT
        self.clipboard: tuple[Footprint, ...] = ()
        self.notices: list[Notice] = []
        self.running, self.asked = True, ""
        self.autosave = Autosave()
        self.take(self.opened)

    def take(self, opened: Opened) -> None:
        """Puts another document on the desk. Raises InputError."""
        world = keeping.world_for(opened.document, opened.path)
        self.show = Rehearsal(opened.document.tracks, world)
        self.taken += 1
        self.opened, self.history, self.fault = opened, begun(opened.document), ""
        self.selection, self.track, self.path = set[Spot](), 0, -1
        self._preview: tuple[str, Document] | None = None
        self.playing.time, self.playing.loop = 0.0, None
        self.drawn: list[tuple[float, float]] = []

    @property
    def document(self) -> Document:
        """What is shown: the document, or what it would be where the mouse now is."""
        return self._preview[1] if self._preview else self.history.document

    @property
    def unsaved(self) -> bool:
        """Whether anything has changed since it was saved."""
        return self.history.document is not self.opened.document

    @property
    def spots(self) -> tuple[Spot, ...]:
        """What is chosen, in order."""
        return tuple(sorted(self.selection))

    def act(self, track: int) -> Act:
        """What became of a track."""
        return self.show.acts[track]

    def do(self, edit: Edit) -> bool:
        """Does an edit, whole; says why where it cannot be done."""
        self._preview = None
        said = self.history.do(edit)
        if said:
            self.say(said, wrong=True)
        self.refresh(whole=True)
        return said is None

    def preview(self, edit: Edit) -> None:
        """Shows what an edit would do, solved around it."""
        made = tried(edit, self.history.document)
        if isinstance(made, str):
            self.say(made, wrong=True)
            return
        self._preview = (edit.name, made)
        self.refresh()

    def drop(self) -> None:
        """The edit that is shown is done."""
        if self._preview:
            name, made = self._preview
            self._preview = None
            self.history.keep(name, made)
            self.refresh(whole=True, released=True)

    def cancel(self) -> None:
        """The edit that is shown is forgotten."""
        if self._preview:
            self._preview = None
            self.refresh(whole=True)

    @property
    def dragging(self) -> bool:
        """Whether an edit is shown that is not done yet."""
        return self._preview is not None

    def undo(self) -> None:
        """Takes the last edit back."""
        self._preview = None
        said = self.history.undo()
        self.say(f"Undone: {said}" if said else "Nothing to undo")
        self.refresh(whole=True)

    def redo(self) -> None:
        """Does again what was taken back."""
        said = self.history.redo()
        self.say(f"Done again: {said}" if said else "Nothing to do again")
        self.refresh(whole=True)

    def go(self, at: int) -> None:
        """Goes to any point of the history."""
        self._preview = None
        self.history.go(at)
        self.refresh(whole=True)

    def refresh(self, whole: bool = False, released: bool = False) -> None:
        """The motion follows the document; where feet cannot do that, the last motion stays and the fault is said."""
        document = self.document
        self.track = min(self.track, len(document.tracks) - 1)
        try:
            world = self.show.world
            if document.head is not self._head():
                world, self._headed = keeping.world_for(document, self.opened.path), document.head
            self.show.change(document.tracks, world, whole and not self.dragging, released)
            self.fault = ""
        except InputError as error:
            self.fault = str(error)
        counts = [len(footprints_in(track)) for track in document.tracks]
        self.selection = {s for s in self.selection if s.track < len(counts) and s.number < counts[s.track]}
        self.path = self.path if self.path < len(document.tracks[self.track].path) else -1

    def _head(self) -> object:
        """The keys of the file that the world was made of."""
        return getattr(self, "_headed", self.opened.document.head)

    def say(self, text: str, wrong: bool = False) -> None:
        """Shows a sentence for a while; the same one only once."""
        self.notices = [one for one in self.notices if one.text != text][-2:]
        self.notices.append(Notice(text, clock.monotonic() + NOTICE, wrong))

    def advance(self, seconds: float) -> None:
        """Lets wall time pass."""
        self.playing.advance(seconds, self.show.end)
        self.show.settle(seconds)
        self.notices = [one for one in self.notices if one.until > clock.monotonic()]
        if not self.dragging:
            self.autosave.look(self.history.document, self.opened)

    def trying(self, what: Callable[[], None]) -> bool:
        """Does something with files; says what went wrong."""
        try:
            what()
            return True
        except InputError as error:
            self.say(str(error), wrong=True)
            return False

    def begin(self, document: Document, name: str) -> None:
        """Takes a document that lies in no file yet, under a name. Raises InputError."""
        self.take(Opened(document, None))
        self.opened = Opened(new_document(), None)
        self.say(f"{name}: save it to keep it")

    def open(self, name: str | Path) -> None:
        """Opens a scene, or the footprints of a recording or saved state. Raises InputError."""
        if Path(name).suffix.lower() == ".npz":
            self.begin(document_in(name), Path(name).name)
            return
        self.take(keeping.open_scene(name))
        if self.opened.path is not None:
            keeping.remember(self.opened.path)

    def recover(self, left: Path) -> None:
        """Takes what a program that has ended had not saved. Raises InputError."""
        found = keeping.recover(left)
        self.take(found)
        self.opened = Opened(new_document(), found.path, found.written, found.digest)
        self.say("Recovered; save it to keep it")

    def save(self, path: Path, force: bool = False) -> None:
        """Saves the document. Raises InputError where somebody else's work would be lost."""
        path = path if path.suffix == ".toml" else path.with_suffix(".toml")
        self.opened = keeping.save(self.history.document, self.opened, path, force)
        self.autosave.forget()
        keeping.remember(path)
        self.say(f"Saved {path.name}")
