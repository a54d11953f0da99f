"""Edits of footprints: each has a name, and makes another document of one. None draws, none solves, all can be undone.

Raises InputError, or ValueError of a checked key, where it cannot be done; `History.do` makes a sentence of that.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, cos, degrees, hypot, radians, sin
from typing import Any, Protocol

from planner.script.footprint import Footprint
from planner.script.track import Track
from sim.files.studio.document import Document, Spot, footprint_at, footprints_in
from sim.files.studio.prints import baked, other, updated, with_changed, with_order
from worlds.errors import InputError

Spots = tuple[Spot, ...]
Point = tuple[float, float]


class Edit(Protocol):
    """A change of a document."""

    @property
    def name(self) -> str:
        """What it does, in words, as undo says it."""

    def apply(self, document: Document) -> Document:
        """The document after it."""


def counted(what: str, spots: Spots) -> str:
    """ "Move a footprint", "Move 3 footprints"."""
    return f"{what} a footprint" if len(spots) == 1 else f"{what} {len(spots)} footprints"


def each_its_own(document: Document, changes: dict[Spot, dict[str, Any]]) -> Document:
    """The document with keys of footprints changed, those of each to its own values."""
    for k in sorted({spot.track for spot in changes}):
        updates = {spot.number: keys for spot, keys in changes.items() if spot.track == k}
        document = document.with_track(k, with_changed(document.tracks[k], updates))
    return document


def each(document: Document, spots: Spots, change: Callable[[Footprint], dict[str, Any]]) -> Document:
    """The document with keys of some footprints changed, by what they are."""
    return each_its_own(document, {spot: change(footprint_at(document, spot)) for spot in spots})


def middle_of(document: Document, spots: Spots) -> Point:
    """The middle of some footprints [m]."""
    places = [footprint_at(document, spot).position for spot in spots]
    return sum(x for x, _ in places) / len(places), sum(y for _, y in places) / len(places)


@dataclass(frozen=True)
class Place:
    """A new footprint, after number `after` of a track (-1: first of all); its side alternates where it is not given."""

    track: int
    after: int
    position: Point
    heading_deg: float
    side: str | None = None
    name = "Place a footprint"

    def apply(self, document: Document) -> Document:
        track = document.tracks[self.track]
        order = footprints_in(track)
        before = order[self.after].footprint.side if 0 <= self.after < len(order) else "right"
        side = self.side or other(before)
        new = Footprint(side=side, position=self.position, heading_deg=self.heading_deg)  # type: ignore[arg-type]
        if self.after == len(order) - 1 and (not track.path or all(path.after < len(track.footprint) for path in track.path)):
            return document.with_track(self.track, _appended(track, new))
        numbers: list[int | Footprint] = list(range(len(order)))
        numbers.insert(self.after + 1, new)
        return document.with_track(self.track, with_order(track, numbers))


def _appended(track: Track, new: Footprint) -> Track:
    return track.model_copy(update={"footprint": (*track.footprint, new)})


@dataclass(frozen=True)
class Move:
    """Moves footprints [m]."""

    spots: Spots
    by: Point

    @property
    def name(self) -> str:
        return counted("Move", self.spots)

    def apply(self, document: Document) -> Document:
        dx, dy = self.by

        def moved(one: Footprint) -> dict[str, Any]:  # to a nanometre: sums of decimals are none
            return {"position": (round(one.position[0] + dx, 9), round(one.position[1] + dy, 9))}

        return each(document, self.spots, moved)


@dataclass(frozen=True)
class Put:
    """Puts footprints to places [m], each to its own."""

    spots: Spots
    places: tuple[Point, ...]
    name: str = "Snap"

    def apply(self, document: Document) -> Document:
        return each_its_own(document, {spot: {"position": to} for spot, to in zip(self.spots, self.places, strict=True)})


@dataclass(frozen=True)
class Turn:
    """Turns footprints about their middle, and with it."""

    spots: Spots
    by_deg: float

    @property
    def name(self) -> str:
        return counted("Turn", self.spots)

    def apply(self, document: Document) -> Document:
        (u, v), c, s = middle_of(document, self.spots), cos(radians(self.by_deg)), sin(radians(self.by_deg))

        def turned(one: Footprint) -> dict[str, Any]:
            x, y = one.position[0] - u, one.position[1] - v
            place = (u + c * x - s * y, v + s * x + c * y) if len(self.spots) > 1 else one.position
            return {"position": place, "heading_deg": one.heading_deg + self.by_deg}

        return each(document, self.spots, turned)


@dataclass(frozen=True)
class ScaleStride:
    """Makes the way over some footprints longer or shorter: places about the first of them."""

    spots: Spots
    factor: float
    name = "Scale the stride"

    def apply(self, document: Document) -> Document:
        for k in sorted({spot.track for spot in self.spots}):
            mine = tuple(sorted(spot for spot in self.spots if spot.track == k))
            first = footprint_at(document, mine[0]).position
            places = tuple(self._place(first, footprint_at(document, spot).position) for spot in mine)
            document = Put(mine, places).apply(document)
        return document

    def _place(self, first: Point, place: Point) -> Point:
        return first[0] + self.factor * (place[0] - first[0]), first[1] + self.factor * (place[1] - first[1])


@dataclass(frozen=True)
class Set:
    """Sets a key of footprints: stance_time, step_time, at, stand, crouch, facing_deg, heading_deg; None: automatic."""

    spots: Spots
    key: str
    value: float | None
    name: str = "Change a footprint"

    def apply(self, document: Document) -> Document:
        return each(document, self.spots, lambda one: {self.key: self.value})


@dataclass(frozen=True)
class Retime:
    """Sets step and stance times [s] of footprints, each its own; None: automatic."""

    spots: Spots
    step_times: tuple[float | None, ...]
    stance_times: tuple[float | None, ...]
    name: str = "Retime"

    def apply(self, document: Document) -> Document:
        times = zip(self.step_times, self.stance_times, strict=True)
        keys = [{"step_time": step, "stance_time": stance} for step, stance in times]
        return each_its_own(document, dict(zip(self.spots, keys, strict=True)))


@dataclass(frozen=True)
class AutoTime:
    """Times of footprints follow from the distance stepped again, pins included."""

    spots: Spots
    name = "Automatic timing"

    def apply(self, document: Document) -> Document:
        return each(document, self.spots, lambda one: {"step_time": None, "stance_time": None, "at": None})


@dataclass(frozen=True)
class Flip:
    """Changes the side of footprints."""

    spots: Spots
    name = "Flip the side"

    def apply(self, document: Document) -> Document:
        for k in sorted({spot.track for spot in self.spots}):
            track = baked(document.tracks[k])
            numbers = {spot.number for spot in self.spots if spot.track == k}
            prints = tuple(
                updated(one, {"side": other(one.side)}) if i in numbers else one for i, one in enumerate(track.footprint)
            )
            document = document.with_track(k, track.model_copy(update={"footprint": prints}))
        return document


@dataclass(frozen=True)
class Mirror:
    """Mirrors footprints across the line along their mean heading through their middle: left becomes right."""

    spots: Spots
    name = "Mirror"

    def apply(self, document: Document) -> Document:
        prints = [footprint_at(document, spot) for spot in self.spots]
        axis = mean_heading(prints)
        u, v = middle_of(document, self.spots)
        flipped = Flip(self.spots).apply(document)

        def mirrored(one: Footprint) -> dict[str, Any]:
            x, y, c, s = one.position[0] - u, one.position[1] - v, cos(2 * axis), sin(2 * axis)
            place = (u + c * x + s * y, v + s * x - c * y)
            return {"position": place, "heading_deg": 2 * degrees(axis) - one.heading_deg, "facing_deg": -one.facing_deg}

        return each(flipped, self.spots, mirrored)


def mean_heading(prints: list[Footprint]) -> float:
    """The mean of headings [rad]."""
    x = sum(cos(radians(one.heading_deg)) for one in prints)
    y = sum(sin(radians(one.heading_deg)) for one in prints)
    return atan2(y, x) if hypot(x, y) > 1e-9 else 0.0


@dataclass(frozen=True)
class Delete:
    """Takes footprints away; keys that hang on them go with them."""

    spots: Spots

    @property
    def name(self) -> str:
        return counted("Delete", self.spots)

    def apply(self, document: Document) -> Document:
        for k in sorted({spot.track for spot in self.spots}):
            gone = {spot.number for spot in self.spots if spot.track == k}
            track = document.tracks[k]
            if not gone <= set(range(len(footprints_in(track)))):
                raise InputError("a footprint that is not there cannot be deleted")
            left = [i for i in range(len(footprints_in(track))) if i not in gone]
            document = document.with_track(k, with_order(track, left))
        return document
