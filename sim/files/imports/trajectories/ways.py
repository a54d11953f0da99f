"""Ways: where people were at which time, whatever file said so."""

from dataclasses import dataclass

import numpy as np

from worlds.errors import InputError

MOST_PEOPLE = 20_000
MOST_ROWS = 5_000_000
LONGEST = 100_000.0
"""A file spans no more seconds than this."""
WIDEST = 2_000.0
"""Nor more metres."""


@dataclass(frozen=True)
class Way:
    """Where somebody was. Times in seconds of the file, places in its metres."""

    name: str
    time: np.ndarray  # (n,) ascending
    place: np.ndarray  # (n, 2) middle of the body
    landed: np.ndarray  # (n,) bool: a footstep of the file's own ends there, to be taken as it is

    @property
    def begin(self) -> float:
        """When it is first known."""
        return float(self.time[0])

    @property
    def end(self) -> float:
        """When it is last known."""
        return float(self.time[-1])

    def at(self, times: np.ndarray) -> np.ndarray:
        """(k, 2) places at times (k,), straight between those that are known; before and after, its ends."""
        return np.column_stack([np.interp(times, self.time, self.place[:, axis]) for axis in (0, 1)])


def ways_of(names: list[str], time: np.ndarray, place: np.ndarray, landed: np.ndarray | None = None) -> list[Way]:
    """Rows (n,) of a file, in any order, as ways, by name as they first appear. Raises InputError."""
    if not len(time):
        raise InputError("nobody is in it")
    index = {name: k for k, name in enumerate(dict.fromkeys(names))}
    if len(index) > MOST_PEOPLE:
        raise InputError(f"{len(index):,} people; {MOST_PEOPLE:,} at most are read")
    who = np.array([index[name] for name in names])
    _check(time, place)
    order = np.lexsort((time, who))
    who, time, place = who[order], time[order], place[order]
    landed = np.zeros(len(who), bool) if landed is None else landed[order]
    again = np.flatnonzero((np.diff(time) == 0) & (np.diff(who) == 0))
    if len(again):
        name = list(index)[who[again[0]]]
        raise InputError(f"id {name} is in two places at {time[again[0]]:g} s ({len(again)} such rows)")
    parts = np.split(np.arange(len(who)), np.flatnonzero(np.diff(who)) + 1)
    return [Way(name, time[part], place[part], landed[part]) for name, part in zip(index, parts, strict=True)]


def between(ways: list[Way], times: tuple[float, float] | list[float] | None) -> list[Way]:
    """The ways between two times [s] of the file, told from the first on; by default all. Raises InputError where nobody is."""
    start = min(way.begin for way in ways)
    low, high = (start, np.inf) if times is None else (times[0], times[1])
    found = [_cut(way, low, high) for way in ways if way.end > low and way.begin < high]
    found = [way for way in found if len(way.time) > 1]
    if not found:
        end = max(way.end for way in ways)
        raise InputError(f"nobody is seen twice between {low:g} and {high:g} s; the file is of {start:g} to {end:g} s")
    return found


def _cut(way: Way, low: float, high: float) -> Way:
    """The rows of a way between two times, from the first on as 0 s."""
    kept = (way.time >= low) & (way.time <= high)
    return Way(way.name, way.time[kept] - low, way.place[kept], way.landed[kept])


def _check(time: np.ndarray, place: np.ndarray) -> None:
    if np.ptp(time) > LONGEST:
        raise InputError(f"spans {np.ptp(time):,.0f} s; {LONGEST:,.0f} s at most are read: are its times seconds?")
    if np.ptp(place, axis=0).max() > WIDEST:
        wide = np.ptp(place, axis=0).max()
        raise InputError(f"spans {wide:,.0f} m; {WIDEST:,.0f} m at most are read: are its places metres?")
