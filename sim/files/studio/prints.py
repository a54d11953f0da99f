"""Footprints of a track changed one by one: single ones where they are written, those of paths as what was moved by hand.

Where the number of footprints changes, paths become single footprints first; keys, pulls and stretches go with the footprints
that they are tied to, and those of a footprint that goes away go with it.
"""

from collections.abc import Callable, Sequence
from math import cos, radians, sin
from typing import Any

from planner.script.footprint import Footprint
from planner.script.path import OWN, Moved, directions_along
from planner.script.track import Track
from sim.files.studio.document import footprints_in, plain_of

Update = Callable[[Footprint], dict[str, Any]]
"""What of a footprint is changed, by its keys."""


def updated(footprint: Footprint, keys: dict[str, Any]) -> Footprint:
    """A footprint with other keys, checked. Raises ValueError."""
    return Footprint(**{**{name: getattr(footprint, name) for name in Footprint.model_fields}, **keys})


def with_changed(track: Track, updates: dict[int, dict[str, Any]]) -> Track:
    """The track with keys of some footprints changed, by their numbers. Raises ValueError."""
    order, single = footprints_in(track), list(track.footprint)
    paths = list(track.path)
    for number, keys in updates.items():
        footprint, source = order[number]
        new = updated(footprint, keys)
        if source.path < 0:
            single[source.place] = new
        else:
            path = paths[source.path]
            plain = plain_of(track, source.path, number)[source.place]
            one = _moved(source.place, plain, new, float(directions_along(path)[source.place]))
            others = tuple(other for other in path.moved if other.step != source.place)
            paths[source.path] = path.model_copy(update={"moved": (*others, one)})
    return track.model_copy(update={"footprint": tuple(single), "path": tuple(paths)})


def _moved(step: int, plain: Footprint, new: Footprint, direction: float) -> Moved:
    """What was changed by hand about a path's footprint."""
    x, y = new.position[0] - plain.position[0], new.position[1] - plain.position[1]
    c, s = cos(direction), sin(direction)
    own = {name: getattr(new, name) for name in OWN if getattr(new, name) != getattr(plain, name)}
    return Moved(step=step, offset=(c * x + s * y, c * y - s * x), turn_deg=new.heading_deg - plain.heading_deg, **own)


def baked(track: Track) -> Track:
    """The track with single footprints only, where they are."""
    if not track.path:
        return track
    return track.model_copy(update={"footprint": tuple(one.footprint for one in footprints_in(track)), "path": ()})


def with_order(track: Track, order: Sequence[int | Footprint]) -> Track:
    """The track with its footprints in another order: old ones by number, new ones as they are."""
    old = baked(track).footprint
    found = tuple(old[one] if isinstance(one, int) else one for one in order)
    new_number = {one: k for k, one in enumerate(order) if isinstance(one, int)}
    tied = {
        name: tuple(
            one.model_copy(update={"footprint": new_number[one.footprint]})
            for one in getattr(track, name)
            if one.footprint in new_number
        )
        for name in ("pull", "key")
    }
    stretches = []
    for one in track.stretch:
        inside = [new_number[k] for k in range(one.first, one.last + 1) if k in new_number]
        if inside:
            stretches.append(one.model_copy(update={"first": min(inside), "last": max(inside)}))
    return track.model_copy(update={"footprint": found, "path": (), "stretch": tuple(stretches), **tied})


def ahead_of(footprint: Footprint, along: float, left: float) -> tuple[float, float]:
    """A place [m] so far ahead and to the left of a footprint, in its heading."""
    (x, y), heading = footprint.position, radians(footprint.heading_deg)
    return x + along * cos(heading) - left * sin(heading), y + along * sin(heading) + left * cos(heading)


def other(side: str) -> str:
    """The other foot."""
    return "right" if side == "left" else "left"
