"""The latest footprints on the ground, kind by kind, in rings of fixed size: each look takes only what is new."""

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import Footprints
from sim.stage.cast import Cast

MOST = 4096
"""Footprints kept per kind of character."""
COLUMNS = 8
"""x, y, z, heading, normal, contact time: a footprint is there from its contact on."""


class Trail:
    """Footprints as rows (N, COLUMNS) float32 of each kind, the oldest overwritten."""

    def __init__(self, most: int = MOST) -> None:
        self.most = most
        self.rows: list[np.ndarray] = []
        self.count: list[int] = []
        self._next: list[int] = []
        self._seen = np.zeros(0, np.int64)
        self._kinds: list[Character] = []

    def look(self, sim: Cast) -> list[tuple[int, int, np.ndarray]]:
        """What is new since the last look: (kind, place in its ring, rows) each."""
        if self._kinds is not sim.kinds:
            return self._begin(sim)
        new = sim.placed_since(self._seen)
        if new is None:
            return self._begin(sim)
        self._seen = sim.steps_planned
        return self._add(sim.kind[new.character], _rows(new.footprints))

    def _begin(self, sim: Cast) -> list[tuple[int, int, np.ndarray]]:
        self._kinds, self._seen = sim.kinds, sim.steps_planned
        kinds = len(sim.kinds)
        self.rows = [np.zeros((self.most, COLUMNS), "f4") for _ in range(kinds)]
        self.count = [0] * kinds
        self._next = [0] * kinds
        known = sim.walked()
        return self._add(sim.kind[known.character], _rows(known.footprints))

    def _add(self, kind: np.ndarray, rows: np.ndarray) -> list[tuple[int, int, np.ndarray]]:
        pieces = []
        for k in range(len(self.rows)):
            mine = rows[kind == k][-self.most :]
            room = self.most - self._next[k]
            for at, piece in ((self._next[k], mine[:room]), (0, mine[room:])):
                if len(piece):
                    self.rows[k][at : at + len(piece)] = piece
                    pieces.append((k, at, piece))
            self._next[k] = (self._next[k] + len(mine)) % self.most
            self.count[k] = min(self.count[k] + len(mine), self.most)
        return pieces


def _rows(footprints: Footprints) -> np.ndarray:
    place = (footprints.position, footprints.heading, footprints.normal, footprints.contact_time)
    return np.column_stack(place).astype("f4")
