"""A crowd whose motions are known beforehand: everybody on a way of its own, there from when it comes to when it goes."""

import numpy as np

from motion.motion import Motion
from sim.files.imports.walking.fitting import Fitted, extended
from sim.rows.footprint_log import Walked, from_arrays
from sim.stage.cast import TICK_RATE, Cast, Site
from worlds.compiled.tables import picked
from worlds.errors import InputError
from worlds.world import World

MOST_FOOTPRINTS = 400_000
"""Rows of the crowd's table: everybody has as many as whoever takes most steps."""
LEAST_ROWS, LEAST_SEGMENTS = 11, 30
"""What kernels read ahead of."""


class Procession(Cast):
    """Everybody's motion, solved before, is shown as time goes on."""

    def __init__(self, world: World, fitted: list[Fitted], tick_rate: int = TICK_RATE) -> None:
        """Raises InputError where that are more footprints than can be held."""
        self.end = max(one.until for one in fitted)
        motions = [extended(one.motion, 0.0, self.end) for one in fitted]
        rooms = np.array([len(motion.footprints.side) for motion in motions])
        rows = max(int(rooms.max()), LEAST_ROWS)
        if rows * len(fitted) > MOST_FOOTPRINTS:
            raise InputError(
                f"{len(fitted)} people with up to {rows} footprints each: {MOST_FOOTPRINTS:,} in all are the most; give fewer "
                "people, or a shorter time (--between)"
            )
        segments = max(max(len(motion.curve.time) for motion in motions), LEAST_SEGMENTS)
        characters = [motion.character for motion in motions]
        super().__init__(world, characters, 0, tick_rate, rows=rows, segments=segments)
        self.fitted = fitted
        self._since, self._until = (np.array([getattr(one, name) for one in fitted]) for name in ("since", "until"))
        for c, motion in enumerate(motions):
            self._put(c, motion)
        self._log(rooms)

    def _put(self, c: int, motion: Motion) -> None:
        """A motion into row c of the crowd."""
        row = self.crowd
        for column, values in zip(row.footprints, motion.footprints, strict=True):
            column[c, : len(values)] = values
        for column, values in zip(row.committed, motion.curve, strict=True):
            column[c, : len(values)] = values
        row.segments[c], row.number[c], row.real[c], row.standing[c] = len(motion.curve.time) - 1, 1, 2, True

    def _log(self, rooms: np.ndarray) -> None:
        """The log takes all footprints as if they had just been placed; and rows of those that are seen as time goes on."""
        self.footprints.keep(self.crowd)
        for n in range(3, int(rooms.max()) + 1):
            placed = (rooms >= n).astype(np.int64)
            self.crowd.real[placed > 0] = n
            self.footprints.add(self.crowd, placed)
        everything = from_arrays(self.footprints.arrays(self.crowd) | {"footprint_stands": np.zeros(self._count(), bool)})
        contact = everything.footprints.contact_time
        character = everything.character
        seen = (contact >= self._since[character] - 1.0) & (contact <= self._until[character])
        order = np.flatnonzero(seen)[np.argsort(contact[seen], kind="stable")]
        self._trodden = Walked(character[order], everything.recasts[order], picked(everything.footprints, (order,)))

    def _count(self) -> int:
        return len(self.footprints.arrays(self.crowd)["footprint_character"])

    @property
    def over(self) -> bool:
        """Whether the last has gone."""
        return self.time >= self.end

    @property
    def site(self) -> Site:
        """Where everybody is at some time."""
        places = np.vstack([one.way.place for one in self.fitted])
        low, high = places.min(axis=0), places.max(axis=0)
        height = 0.6 * self.leg(0)
        return Site(np.array([*(0.5 * (low + high)), height]), float(0.5 * np.hypot(*(high - low))) + 1.0)

    def present(self, time: float | None = None) -> np.ndarray:
        """(C,) bool: who has come and not yet gone."""
        at = self.moment(time)
        return (self._since <= at + 1e-9) & (at <= self._until + 1e-9)

    def moment(self, time: float | None) -> float:
        """The time [s] that is shown for `time`, by default now."""
        return min(max(super().moment(time), 0.0), self.end)

    @property
    def steps_planned(self) -> np.ndarray:
        """(C,) how many footprints of each have been seen so far."""
        until = int(np.searchsorted(self._trodden.footprints.contact_time, self.time, side="right"))
        return np.bincount(self._trodden.character[:until], minlength=len(self.characters))

    def placed_since(self, seen: np.ndarray) -> Walked | None:
        """The footprints since `steps_planned` was that; None where time has gone back."""
        if (self.steps_planned < seen).any():
            return None
        return self._between(int(seen.sum()))

    def walked(self) -> Walked:
        """The footprints that are to be seen by now."""
        return self._between(0)

    def _between(self, first: int) -> Walked:
        """Those from the first so many on, up to now."""
        until = int(np.searchsorted(self._trodden.footprints.contact_time, self.time, side="right"))
        trodden = self._trodden
        some = slice(first, until)
        return Walked(trodden.character[some], trodden.recasts[some], picked(trodden.footprints, (some,)))
