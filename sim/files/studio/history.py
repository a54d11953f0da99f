"""What was done to a document, and undone: a list of documents, each whole and never changed, so undo is exact to the bit."""

from dataclasses import dataclass, field

from pydantic import ValidationError

from sim.files.studio.document import Document
from sim.files.studio.edits import Edit
from worlds.errors import InputError
from worlds.errors.wording import faults_of


@dataclass(frozen=True)
class Step:
    """A document and what was done to reach it."""

    name: str
    document: Document


@dataclass
class History:
    """Documents in the order in which they came to be. `at` is the present one; those after it can be redone."""

    steps: list[Step] = field(default_factory=list)
    at: int = 0

    @property
    def document(self) -> Document:
        """The present one."""
        return self.steps[self.at].document

    def do(self, edit: Edit) -> str | None:
        """Does an edit, from which on redoing is over; returns why it cannot be done, and then nothing has changed."""
        new = tried(edit, self.document)
        if isinstance(new, str):
            return new
        self.keep(edit.name, new)
        return None

    def keep(self, name: str, document: Document) -> None:
        """Takes a document that somebody else has made, as a drag does."""
        if document != self.document:
            self.steps[self.at + 1 :] = [Step(name, document)]
            self.at += 1

    def undo(self) -> str | None:
        """Goes back by one; returns what is undone."""
        if self.at == 0:
            return None
        self.at -= 1
        return self.steps[self.at + 1].name

    def redo(self) -> str | None:
        """Goes forward by one; returns what is redone."""
        if self.at + 1 == len(self.steps):
            return None
        self.at += 1
        return self.steps[self.at].name

    def go(self, at: int) -> None:
        """Goes to any of the documents."""
        self.at = min(max(at, 0), len(self.steps) - 1)


def begun(document: Document, name: str = "Open") -> History:
    """A history that begins with a document."""
    return History([Step(name, document)])


def tried(edit: Edit, document: Document) -> Document | str:
    """The document after an edit, or why it cannot be done."""
    try:
        return edit.apply(document)
    except InputError as error:
        return str(error)
    except ValidationError as error:
        return f"{edit.name}: {faults_of(error, type(document.head))[0]}"
