"""A run that is over as a cast: what the view reads of it, at the moments that it holds."""

from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.pose.pose import Pose
from motion.track.footprints import Footprints
from sim.rows.footprint_log import Walked
from sim.stage.cast import Cast
from worlds.compiled.tables import empty
from worlds.world import World


class Part(NamedTuple):
    """One character of it."""

    character: Character
    pose: Pose  # (F,) one after the other
    footprints: Footprints  # (K,)
    there: np.ndarray  # (F,) bool


class Replay(Cast):
    """Its ticks are the moments, from the first to the last. It has no curves: overlays show none."""

    def __init__(self, world: World, parts: list[Part], moments: np.ndarray, rate: int, seed: int) -> None:
        """moments: (F,) [s]; rate: how many of them a second. Raises InputError."""
        super().__init__(world, [part.character for part in parts], seed, rate)
        self._parts, self._moments = parts, moments
        self._none = Walked(np.zeros(0, np.int64), np.zeros(0, np.int64), empty(Footprints, 0))

    @property
    def time(self) -> float:
        """The moment [s] that is shown."""
        return float(self._moments[min(self.ticks, len(self._moments) - 1)])

    @property
    def over(self) -> bool:
        """Whether the last moment is shown."""
        return self.ticks >= len(self._moments) - 1

    def _frame(self, time: float | None) -> int:
        """The moment that is nearest to a time [s]."""
        return int(np.abs(self._moments - self.moment(time)).argmin())

    def pose_into(self, pose: Pose, time: float, rows: np.ndarray) -> None:
        """Fills `pose`, of K rows, with the characters `rows` (K,) at the moment nearest to `time` [s]."""
        frame = self._frame(time)
        for row, c in enumerate(rows):
            for column, values in zip(pose, self._parts[c].pose, strict=True):
                column[row] = values[frame]

    def com(self, time: float | None = None) -> np.ndarray:
        """Centres of mass (C, 3) at the moment nearest to `time` [s], by default now."""
        frame = self._frame(time)
        return np.array([part.pose.com[frame] for part in self._parts])

    def present(self, time: float | None = None) -> np.ndarray:
        """(C,) bool: who is there at the moment nearest to `time` [s], by default now."""
        frame = self._frame(time)
        return np.array([part.there[frame] for part in self._parts])

    def walked(self) -> Walked:
        """All footprints of the run: they are seen from their contacts on."""
        who = np.repeat(np.arange(len(self._parts)), [len(part.footprints.side) for part in self._parts])
        columns = (np.concatenate(column) for column in zip(*(part.footprints for part in self._parts), strict=True))
        return Walked(who, np.zeros_like(who), Footprints(*columns))

    def placed_since(self, seen: np.ndarray) -> Walked | None:
        """None are placed any more."""
        return self._none
