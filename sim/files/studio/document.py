"""The document of the studio: a scene as its file has it, never changed but replaced, and its footprints in order.

Its type is that of the file (planner.script.scene.Sheet), so there is one schema. A `Spot` names a footprint of it: the track,
and its number in the order in which they are walked, paths included.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

from motion.characters.character import Character, load_character
from planner.script.footprint import Footprint
from planner.script.path import Path, footprints_along
from planner.script.scene import Sheet
from planner.script.track import Placed, Track, placed
from worlds.ground import WorldTable

MOST_KNOWN = 256
SIZE = (12.0, 8.0)
"""Of the world of a new document [m]."""


class Spot(NamedTuple):
    """A footprint of a document."""

    track: int
    number: int  # in the order in which they are walked


@dataclass(frozen=True)
class Document:
    """A scene as it is edited: what its file says but for the tracks, and the tracks."""

    head: Sheet  # without tracks
    tracks: tuple[Track, ...]

    def with_track(self, k: int, track: Track) -> "Document":
        """The same with another track k."""
        return Document(self.head, (*self.tracks[:k], track, *self.tracks[k + 1 :]))


def new_document() -> Document:
    """An empty scene on flat ground, for one human."""
    return Document(Sheet(format=1, name="A scene", world=WorldTable(size=SIZE)), (Track(),))


def document_of(sheet: Sheet) -> Document:
    """The document of a file's keys."""
    bare = {key: field.get_default() for key, field in Track.model_fields.items()}
    return Document(sheet.model_copy(update={**bare, "track": ()}), sheet.all_tracks())


def sheet_of(document: Document) -> Sheet:
    """The file's keys of a document: its first track stands at the top."""
    first = {key: getattr(document.tracks[0], key) for key in Track.model_fields}
    return document.head.model_copy(update={**first, "track": document.tracks[1:]})


@lru_cache(maxsize=64)
def character_of(name: str, scale: float) -> Character:
    """A character by its name or file, so many times as large. Raises InputError."""
    return load_character(name, scale)


_KNOWN: dict[int, tuple[Track, tuple[Placed, ...]]] = {}
"""Tracks by what they are, not by what they hold: comparing those takes longer than laying them."""


def footprints_in(track: Track) -> tuple[Placed, ...]:
    """The footprints of a track in order. Raises InputError."""
    known = _KNOWN.get(id(track))
    if known is None:
        if len(_KNOWN) >= MOST_KNOWN:
            _KNOWN.pop(next(iter(_KNOWN)))
        known = _KNOWN[id(track)] = (track, tuple(placed(track, character_of(track.character, track.character_scale))))
    return known[1]


def footprint_at(document: Document, spot: Spot) -> Footprint:
    """A footprint of the document."""
    return footprints_in(document.tracks[spot.track])[spot.number].footprint


def spots_of(document: Document) -> list[Spot]:
    """All footprints of a document."""
    return [Spot(k, i) for k, track in enumerate(document.tracks) for i in range(len(footprints_in(track)))]


def plain_of(track: Track, k: int, number: int) -> list[Footprint]:
    """The footprints of path k of a track as nobody has moved them, for the feet that it has there.

    number: of any footprint of the path: its side tells which foot begins.
    """
    path, one = track.path[k], footprints_in(track)[number]
    plain = footprints_along(path.model_copy(update={"moved": ()}), character_of(track.character, track.character_scale))
    if plain[one.source.place].side != one.footprint.side:
        other: Path = path.model_copy(update={"moved": (), "first": "right" if path.first == "left" else "left"})
        plain = footprints_along(other, character_of(track.character, track.character_scale))
    return plain
