"""Edits of what shapes a motion beyond its footprints: stretches that exaggerate, pulls on the centre of mass, hand keys."""

from dataclasses import dataclass
from typing import Literal

from planner.script.shaping import ComPull, Key, Stretch
from sim.files.studio.document import Document, footprints_in
from worlds.errors import InputError

Shape = Stretch | ComPull | Key
Kind = Literal["stretch", "pull", "key"]
WORDS = {"stretch": "a stretch", "pull": "a pull on the com", "key": "a hand key"}


def kind_of(shape: Shape) -> Kind:
    """The key under which tracks hold such a shape."""
    return "stretch" if isinstance(shape, Stretch) else "pull" if isinstance(shape, ComPull) else "key"


@dataclass(frozen=True)
class AddShape:
    """One more stretch, pull or key."""

    track: int
    shape: Shape

    @property
    def name(self) -> str:
        return f"Add {WORDS[kind_of(self.shape)]}"

    def apply(self, document: Document) -> Document:
        track, kind = document.tracks[self.track], kind_of(self.shape)
        last = self.shape.last if isinstance(self.shape, Stretch) else self.shape.footprint
        if last >= len(footprints_in(track)):
            raise InputError(f"footprint {last}: the track has {len(footprints_in(track))}; the first is 0")
        return document.with_track(self.track, track.model_copy(update={kind: (*getattr(track, kind), self.shape)}))


@dataclass(frozen=True)
class SetShape:
    """Another stretch, pull or key in the place of one; None: that one goes away."""

    track: int
    kind: Kind
    index: int
    shape: Shape | None

    @property
    def name(self) -> str:
        return f"{'Remove' if self.shape is None else 'Change'} {WORDS[self.kind]}"

    def apply(self, document: Document) -> Document:
        track = document.tracks[self.track]
        shapes = getattr(track, self.kind)
        if not 0 <= self.index < len(shapes):
            raise InputError(f"{WORDS[self.kind]} {self.index}: there are {len(shapes)} in this track")
        new = () if self.shape is None else (self.shape,)
        changed = (*shapes[: self.index], *new, *shapes[self.index + 1 :])
        return document.with_track(self.track, track.model_copy(update={self.kind: changed}))
