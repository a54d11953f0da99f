"""The footprints of a run: what a recording and a measurement hold of them.

A footprint's timing is final once its second successor is placed (the next settles step and stance time, the one after it
may prolong the stance by standing on). So the log takes footprint n - 2 when n is placed, all characters at once, and the
last two of each are read off the crowd when somebody asks.
"""

from typing import NamedTuple

import numpy as np

from motion.track.footprints import Footprints
from sim.rows.crowd import Crowd
from worlds.compiled.tables import picked

TIDY = 4096
"""Where only so many footprints are kept, the oldest are forgotten once in so many ticks with new ones."""


class Walked(NamedTuple):
    """Footprints of several characters."""

    character: np.ndarray  # (K,)
    recasts: np.ndarray  # (K,) how often that character had become another one before it laid this footprint
    footprints: Footprints  # (K,)


class FootprintLog:
    """Footprints placed so far: the crowd's few latest, or all of them from `keep` on. A foot that stands on prolongs its
    footprint instead of leaving another."""

    def __init__(self, characters: int) -> None:
        self.steps = 0
        self.recasts = np.zeros(characters, np.int64)
        """How often each character has become another one; -1: nobody has been in the row yet."""
        self.away = np.zeros(characters, bool)
        """In which rows nobody is."""
        self._chunks: list[Walked] | None = None
        self._most: int | None = None

    def keep(self, crowd: Crowd, most: int | None = None) -> None:
        """From now on nothing is forgotten, or only the oldest of more than `most`; what the crowd still holds is taken."""
        if self._chunks is None:
            self._chunks, self._most = self._final(crowd), most
        elif most is None:
            self._most = None

    def add(self, crowd: Crowd, placed: np.ndarray) -> None:
        """Takes what became final when placed[c] (C,) footprints were placed."""
        for k in range(int(placed.max())):
            who = np.flatnonzero(placed > k)
            back = placed[who] - k  # footprints placed from this one on, the newest included
            self.steps += int((~crowd.footprints.stands[who, crowd.real[who] - back]).sum())
            if self._chunks is not None:
                self._chunks.append(self._gather(crowd, who, crowd.real[who] - back - 2))
        if self._most is not None and self._chunks is not None and len(self._chunks) > TIDY:
            self._forget()

    def _forget(self) -> None:
        """Joins what is kept, without the oldest beyond `most`."""
        assert self._chunks is not None and self._most is not None
        rows = _joined(self._chunks)
        first = max(len(rows.character) - self._most, 0)
        self._chunks = [_sorted(rows, np.arange(first, len(rows.character)))]

    def recast(self, crowd: Crowd, c: int) -> None:
        """Takes the last two footprints of character c, which is about to become another one."""
        if self._chunks is not None:
            self._chunks.append(self._gather(crowd, np.array([c, c]), crowd.real[c] - np.array([2, 1])))
        self.recasts[c] += 1

    def let_go(self, crowd: Crowd, rows: np.ndarray) -> None:
        """Takes the last two footprints of characters that go."""
        if self._chunks is not None:
            for back in (2, 1):
                self._chunks.append(self._gather(crowd, rows, crowd.real[rows] - back))
        self.away[rows] = True

    def begin_away(self, rows: np.ndarray) -> None:
        """Nobody has been in these rows yet."""
        self.recasts[rows], self.away[rows] = -1, True

    def come(self, c: int) -> None:
        """Another one is in row c, which was free."""
        self.recasts[c] += 1
        self.away[c] = False

    def walked(self, crowd: Crowd) -> Walked:
        """All that is known, in the order of the contacts; a foot that stands on prolongs its footprint."""
        rows = _without_standing_on(self.rows(crowd))
        return _sorted(rows, np.lexsort((rows.character, rows.footprints.contact_time)))

    def rows(self, crowd: Crowd) -> Walked:
        """The same with a row for each time that a foot stood on, character by character."""
        everyone = np.flatnonzero(~self.away)
        pending = [self._gather(crowd, everyone, crowd.real[everyone] - back) for back in (2, 1)]
        rows = _joined((self._final(crowd) if self._chunks is None else self._chunks) + pending)
        return _sorted(rows, np.lexsort((rows.footprints.contact_time, rows.recasts, rows.character)))

    def arrays(self, crowd: Crowd) -> dict[str, np.ndarray]:
        """The footprint_* arrays of a recording."""
        return {key: array for key, array in as_arrays(self.walked(crowd)).items() if key != "footprint_stands"}

    def kept(self) -> dict[str, np.ndarray]:
        """What `keep` has kept, as arrays to save; none where it was not asked for."""
        return {} if self._chunks is None else as_arrays(_joined(self._chunks))

    def take(self, steps: int, recasts: list[int], kept: dict[str, np.ndarray]) -> None:
        """Goes on from a saved state."""
        self.steps, self._chunks = steps, [from_arrays(kept)] if kept else None
        self.recasts[:] = recasts

    def placed_since(self, crowd: Crowd, seen: np.ndarray) -> Walked | None:
        """The footprints placed since the numbers `seen` (C,), the oldest first; None where rows have forgotten some."""
        new = crowd.number - seen
        if (new > crowd.real).any() or (new < 0).any():
            return None
        found = [self._gather(crowd, *np.zeros((2, 0), np.int64))]
        for back in range(int(new.max(initial=0)) - 1, -1, -1):
            who = np.flatnonzero(new > back)
            row = crowd.real[who] - 1 - back
            moved = ~crowd.footprints.stands[who, row]
            found.append(self._gather(crowd, who[moved], row[moved]))
        return _joined(found)

    def _final(self, crowd: Crowd) -> list[Walked]:
        """The crowd's footprints but for the last two of each character."""
        rows = [(np.flatnonzero(crowd.real - 2 > k), k) for k in range(int(crowd.real.max(initial=2)) - 2)]
        none = self._gather(crowd, *np.zeros((2, 0), np.int64))
        return [none, *(self._gather(crowd, who, np.full(len(who), k)) for who, k in rows)]

    def _gather(self, crowd: Crowd, who: np.ndarray, row: np.ndarray) -> Walked:
        return Walked(who, self.recasts[who], picked(crowd.footprints, (who, row)))


def as_arrays(walked: Walked) -> dict[str, np.ndarray]:
    """Arrays by their names in files."""
    columns = {f"footprint_{name}": column for name, column in walked.footprints._asdict().items()}
    return {"footprint_character": walked.character, "footprint_recasts": walked.recasts, **columns}


def from_arrays(arrays: dict[str, np.ndarray]) -> Walked:
    """What `as_arrays` made arrays of. Raises KeyError."""
    columns = (np.ascontiguousarray(arrays[f"footprint_{name}"]) for name in Footprints._fields)
    return Walked(arrays["footprint_character"], arrays["footprint_recasts"], Footprints(*columns))


def _joined(chunks: list[Walked]) -> Walked:
    columns = (np.concatenate(parts) for parts in zip(*(chunk.footprints for chunk in chunks), strict=True))
    character, recasts = (np.concatenate([chunk[k] for chunk in chunks]) for k in (0, 1))
    return Walked(character, recasts, Footprints(*columns))


def _sorted(walked: Walked, order: np.ndarray) -> Walked:
    return Walked(walked.character[order], walked.recasts[order], picked(walked.footprints, order))


def _without_standing_on(walked: Walked) -> Walked:
    """Merges each row that stands on into the same foot's row before it."""
    owner: dict[tuple, int] = {}
    rows = walked.footprints
    for i, key in enumerate(zip(walked.character.tolist(), walked.recasts.tolist(), rows.side.tolist(), strict=True)):
        if rows.stands[i] and key in owner:
            begun = owner[key]
            rows.stance_time[begun] = rows.contact_time[i] + rows.stance_time[i] - rows.contact_time[begun]
        else:
            owner[key] = i
    return _sorted(walked, np.flatnonzero(~rows.stands))
