"""The latest footprints on the ground, kind by kind, in rings of fixed size: each look takes only what is new."""

import numpy as np

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
        self._sim: Cast | None = None

    def look(self, sim: Cast) -> list[tuple[int, int, np.ndarray]]:
        """What is new since the last look: (kind, place in its ring, rows) each."""
        if self._sim is not sim:
            return self._begin(sim)
        crowd, new = sim.crowd, sim.crowd.number - self._seen
        most = int(new.max())
        if most == 0:
            return []
        if most > int(crowd.real.min()):
            return self._begin(sim)  # so many that the crowd has forgotten some
        found = []
        for back in range(most - 1, -1, -1):
            who = np.flatnonzero(new > back)
            row = crowd.real[who] - 1 - back
            moved = ~crowd.stands[who, row]
            who, row = who[moved], row[moved]
            found.append((crowd.kind[who], _rows(*(getattr(crowd, key)[who, row] for key in KEYS))))
        self._seen = crowd.number.copy()
        return self._add(np.concatenate([kind for kind, _ in found]), np.concatenate([rows for _, rows in found]))

    def _begin(self, sim: Cast) -> list[tuple[int, int, np.ndarray]]:
        self._sim, self._seen = sim, sim.crowd.number.copy()
        kinds = int(sim.crowd.kind.max()) + 1
        self.rows = [np.zeros((self.most, COLUMNS), "f4") for _ in range(kinds)]
        self.count = [0] * kinds
        self._next = [0] * kinds
        log = sim.footprints.arrays(sim.crowd)
        return self._add(sim.crowd.kind[log["footprint_character"]], _rows(*(log[f"footprint_{key}"] for key in KEYS)))

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


KEYS = ("position", "heading", "normal", "contact_time")


def _rows(position: np.ndarray, heading: np.ndarray, normal: np.ndarray, contact: np.ndarray) -> np.ndarray:
    return np.column_stack([position, heading, normal, contact]).astype("f4")
