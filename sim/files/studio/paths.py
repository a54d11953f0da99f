"""Edits of paths: drawn, bent, given other steps. The footprints follow, those moved by hand with their offset."""

from dataclasses import dataclass, field
from typing import Any

from planner.script.path import Path
from sim.files.studio.document import Document, footprints_in
from sim.files.studio.edits import Point
from sim.files.studio.prints import baked
from worlds.errors import InputError

STEP = 0.6
"""Length of the steps of a new path [m], where its character prefers none."""


@dataclass(frozen=True)
class DrawPath:
    """A new path through points [m], at the end of a track."""

    track: int
    points: tuple[Point, ...]
    step_length: float = STEP
    name = "Draw a path"

    def apply(self, document: Document) -> Document:
        track = document.tracks[self.track]
        path = Path(points=self.points, step_length=self.step_length, after=len(track.footprint))
        return document.with_track(self.track, track.model_copy(update={"path": (*track.path, path)}))


def path_of(document: Document, track: int, path: int) -> Path:
    """A path of the document. Raises InputError."""
    paths = document.tracks[track].path
    if not 0 <= path < len(paths):
        raise InputError(f"path {path}: there are {len(paths)} paths in this track")
    return paths[path]


def _with_path(document: Document, track: int, k: int, path: Path) -> Document:
    paths = document.tracks[track].path
    new = document.tracks[track].model_copy(update={"path": (*paths[:k], path, *paths[k + 1 :])})
    footprints_in(new)  # raises where it has too many
    return document.with_track(track, new)


@dataclass(frozen=True)
class SetPath:
    """Sets keys of a path: step_length, step_width, stagger, crouch, step_time, stance_time, points ..."""

    track: int
    path: int
    keys: dict[str, Any] = field(hash=False)
    name: str = "Change a path"

    def apply(self, document: Document) -> Document:
        path = path_of(document, self.track, self.path)
        values = {name: getattr(path, name) for name in Path.model_fields} | self.keys
        return _with_path(document, self.track, self.path, Path(**values))


@dataclass(frozen=True)
class BendPath:
    """Moves a point of a path, or turns its tangent."""

    track: int
    path: int
    point: int
    to: Point
    tangent: bool = False

    @property
    def name(self) -> str:
        return "Turn a path's tangent" if self.tangent else "Bend a path"

    def apply(self, document: Document) -> Document:
        path = path_of(document, self.track, self.path)
        if not 0 <= self.point < len(path.points):
            raise InputError(f"point {self.point}: the path has {len(path.points)}")
        if not self.tangent:
            points = tuple(self.to if k == self.point else one for k, one in enumerate(path.points))
            return SetPath(self.track, self.path, {"points": points}).apply(document)
        tangents = list(path.tangents or tangents_of(path))
        tangents[self.point] = self.to
        return SetPath(self.track, self.path, {"tangents": tuple(tangents)}).apply(document)


def tangents_of(path: Path) -> tuple[Point, ...]:
    """The tangents [m] that a path has at its points."""
    if path.tangents is not None:
        return path.tangents
    p, last = path.points, len(path.points) - 1
    ends = [(max(k - 1, 0), min(k + 1, last)) for k in range(len(p))]
    return tuple(((p[b][0] - p[a][0]) / (b - a), (p[b][1] - p[a][1]) / (b - a)) for a, b in ends)


@dataclass(frozen=True)
class AddPoint:
    """Another point of a path, between two or beyond its end; the tangents of the others stay as they are."""

    track: int
    path: int
    after: int
    at: Point
    name = "Add a point to a path"

    def apply(self, document: Document) -> Document:
        path, k = path_of(document, self.track, self.path), self.after + 1
        keys: dict[str, Any] = {"points": (*path.points[:k], self.at, *path.points[k:])}
        if path.tangents is not None:
            last = path.points[min(max(self.after, 0), len(path.points) - 1)]
            slope = (self.at[0] - last[0], self.at[1] - last[1])
            keys["tangents"] = (*path.tangents[:k], slope, *path.tangents[k:])
        return SetPath(self.track, self.path, keys).apply(document)


@dataclass(frozen=True)
class RemovePoint:
    """A path without one of its points; without its second last one, it is gone."""

    track: int
    path: int
    point: int
    name = "Remove a point of a path"

    def apply(self, document: Document) -> Document:
        path, k = path_of(document, self.track, self.path), self.point
        if len(path.points) <= 2:
            return RemovePath(self.track, self.path).apply(document)
        keys: dict[str, Any] = {"points": (*path.points[:k], *path.points[k + 1 :])}
        if path.tangents is not None:
            keys["tangents"] = (*path.tangents[:k], *path.tangents[k + 1 :])
        return SetPath(self.track, self.path, keys).apply(document)


@dataclass(frozen=True)
class RemovePath:
    """A path and its footprints go away."""

    track: int
    path: int
    name = "Remove a path"

    def apply(self, document: Document) -> Document:
        path_of(document, self.track, self.path)
        track = document.tracks[self.track]
        left = tuple(one for k, one in enumerate(track.path) if k != self.path)
        count = len(footprints_in(track.model_copy(update={"path": left})))
        bare = {"stretch": tuple(s for s in track.stretch if s.last < count)}
        tied = {name: tuple(one for one in getattr(track, name) if one.footprint < count) for name in ("pull", "key")}
        return document.with_track(self.track, track.model_copy(update={"path": left, **bare, **tied}))


@dataclass(frozen=True)
class FreePath:
    """The footprints of a track's paths become single ones, where they are."""

    track: int
    name = "Free footprints from paths"

    def apply(self, document: Document) -> Document:
        return document.with_track(self.track, baked(document.tracks[self.track]))
