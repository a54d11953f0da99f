"""Edits of several footprints at once: copies, order, tracks spliced, walks and runs."""

from dataclasses import dataclass

from planner.script.footprint import Footprint
from planner.script.shaping import Style
from planner.script.track import Track
from sim.files.studio.document import Document, footprint_at, footprints_in
from sim.files.studio.edits import Point, Spots
from sim.files.studio.prints import baked, other, updated, with_order
from worlds.errors import InputError


@dataclass(frozen=True)
class Paste:
    """Puts footprints after number `after` of a track, moved by so much [m]; sides alternate with those before."""

    track: int
    after: int
    prints: tuple[Footprint, ...]
    by: Point = (0.0, 0.0)

    @property
    def name(self) -> str:
        return "Paste a footprint" if len(self.prints) == 1 else f"Paste {len(self.prints)} footprints"

    def apply(self, document: Document) -> Document:
        track = document.tracks[self.track]
        order = footprints_in(track)
        before = order[self.after].footprint.side if 0 <= self.after < len(order) else None
        swap = bool(self.prints) and before == self.prints[0].side and (len(self.prints) < 2 or self.prints[1].side != before)
        new = [self._moved(one, swap) for one in self.prints]
        numbers: list[int | Footprint] = list(range(len(order)))
        numbers[self.after + 1 : self.after + 1] = new
        return document.with_track(self.track, with_order(track, numbers))

    def _moved(self, one: Footprint, swap: bool) -> Footprint:
        place = (one.position[0] + self.by[0], one.position[1] + self.by[1])
        return updated(one, {"position": place, "at": None, "side": other(one.side) if swap else one.side})


def copied(document: Document, spots: Spots) -> tuple[Footprint, ...]:
    """Footprints for the clipboard, in their order."""
    return tuple(footprint_at(document, spot) for spot in sorted(spots))


@dataclass(frozen=True)
class Reverse:
    """Walks over footprints in the other order, turned round, with sides that keep alternating."""

    spots: Spots
    name = "Reverse"

    def apply(self, document: Document) -> Document:
        for k in sorted({spot.track for spot in self.spots}):
            numbers = sorted(spot.number for spot in self.spots if spot.track == k)
            track = baked(document.tracks[k])
            prints = list(track.footprint)
            for to, source in zip(numbers, reversed(numbers), strict=True):
                old = track.footprint[source]
                prints[to] = updated(old, {"heading_deg": old.heading_deg + 180.0, "side": other(old.side), "at": None})
            document = document.with_track(k, track.model_copy(update={"footprint": tuple(prints)}))
        return document


@dataclass(frozen=True)
class Splice:
    """Lets a track go on with the footprints of another one, which is gone then."""

    track: int
    following: int
    name = "Splice two tracks"

    def apply(self, document: Document) -> Document:
        if self.track == self.following or len(document.tracks) < 2:
            raise InputError("two tracks are needed to splice them; there is one")
        first, then = baked(document.tracks[self.track]), baked(document.tracks[self.following])
        shift = len(first.footprint)
        tied = {
            name: getattr(first, name)
            + tuple(one.model_copy(update={"footprint": one.footprint + shift}) for one in getattr(then, name))
            for name in ("pull", "key")
        }
        stretches = first.stretch + tuple(
            one.model_copy(update={"first": one.first + shift, "last": one.last + shift}) for one in then.stretch
        )
        joined = first.model_copy(update={"footprint": first.footprint + then.footprint, "stretch": stretches, **tied})
        tracks = [joined if k == self.track else one for k, one in enumerate(document.tracks) if k != self.following]
        return Document(document.head, tuple(tracks))


@dataclass(frozen=True)
class AddTrack:
    """Another character in the scene."""

    character: str
    name = "Add a character"

    def apply(self, document: Document) -> Document:
        return Document(document.head, (*document.tracks, Track(character=self.character)))


@dataclass(frozen=True)
class RemoveTrack:
    """A character leaves the scene, with its footprints."""

    track: int
    name = "Remove a character"

    def apply(self, document: Document) -> Document:
        if len(document.tracks) < 2:
            raise InputError("the last character stays; delete its footprints instead")
        return Document(document.head, tuple(one for k, one in enumerate(document.tracks) if k != self.track))


@dataclass(frozen=True)
class SetTrack:
    """Sets a key of a track: character, style, stand_before, stand_after, support, segments."""

    track: int
    key: str
    value: str | float | Style
    name: str = "Change the character"

    def apply(self, document: Document) -> Document:
        track = document.tracks[self.track]
        values = {name: getattr(track, name) for name in Track.model_fields} | {self.key: self.value}
        return document.with_track(self.track, Track(**values))
