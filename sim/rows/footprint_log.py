"""The footprints of a run: what a recording and a measurement hold of them.

A footprint's timing is final once its second successor is placed (the next settles step and stance time, the one after it
may prolong the stance by standing on). So the log takes footprint n - 2 when n is placed, all characters at once, and the
last two of each are read off the crowd when somebody asks.
"""

import numpy as np

from sim.rows.crowd import Crowd

KEYS = (
    "side", "position", "heading", "normal", "contact_time", "stance_time", "step_time", "rock", "roll", "nominal_length",
    "facing", "lift", "hold",
)  # fmt: skip


class FootprintLog:
    """Footprints placed so far: the crowd's few latest, or all of them from `keep` on. A foot that stands on prolongs its
    footprint instead of leaving another."""

    def __init__(self) -> None:
        self.steps = 0
        self._chunks: list[dict[str, np.ndarray]] | None = None

    def keep(self, crowd: Crowd) -> None:
        """From now on nothing is forgotten; what the crowd still holds is taken."""
        if self._chunks is None:
            self._chunks = _final(crowd)

    def add(self, crowd: Crowd, placed: np.ndarray) -> None:
        """Takes what became final when placed[c] (C,) footprints were placed."""
        for k in range(int(placed.max())):
            who = np.flatnonzero(placed > k)
            back = placed[who] - k  # footprints placed from this one on, the newest included
            self.steps += int((~crowd.stands[who, crowd.real[who] - back]).sum())
            if self._chunks is not None:
                self._chunks.append(_gather(crowd, who, crowd.real[who] - back - 2))

    def arrays(self, crowd: Crowd) -> dict[str, np.ndarray]:
        """The footprint_* arrays of a recording, in the order of their contacts."""
        everyone = np.arange(len(crowd.kind))
        pending = [_gather(crowd, everyone, crowd.real - 2), _gather(crowd, everyone, crowd.real - 1)]
        rows = _joined((_final(crowd) if self._chunks is None else self._chunks) + pending)
        order = np.lexsort((rows["contact_time"], rows["character"]))
        rows = _without_standing_on({key: value[order] for key, value in rows.items()})
        order = np.lexsort((rows["character"], rows["contact_time"]))
        return {f"footprint_{key}": value[order] for key, value in rows.items() if key != "stands"}

    def kept(self) -> dict[str, np.ndarray]:
        """What `keep` has kept, as arrays to save; none where it was not asked for."""
        return {} if self._chunks is None else _joined(self._chunks)

    def take(self, steps: int, kept: dict[str, np.ndarray]) -> None:
        """Goes on from a saved state."""
        self.steps, self._chunks = steps, [kept] if kept else None


def _final(crowd: Crowd) -> list[dict[str, np.ndarray]]:
    """The crowd's footprints but for the last two of each character."""
    rows = [(np.flatnonzero(crowd.real - 2 > k), k) for k in range(int(crowd.real.max(initial=2)) - 2)]
    return [_gather(crowd, who, np.full(len(who), k)) for who, k in rows] or [_gather(crowd, *np.zeros((2, 0), np.int64))]


def _joined(chunks: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    return {key: np.concatenate([chunk[key] for chunk in chunks]) for key in chunks[0]}


def _gather(crowd: Crowd, who: np.ndarray, row: np.ndarray) -> dict[str, np.ndarray]:
    chunk = {key: getattr(crowd, key)[who, row] for key in KEYS}
    return {"character": who, **chunk, "stands": crowd.stands[who, row]}


def _without_standing_on(rows: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """Merges each row that stands on into the same foot's row before it."""
    owner: dict[tuple[int, int], int] = {}
    for i, key in enumerate(zip(rows["character"].tolist(), rows["side"].tolist(), strict=True)):
        if rows["stands"][i] and key in owner:
            first = owner[key]
            rows["stance_time"][first] = rows["contact_time"][i] + rows["stance_time"][i] - rows["contact_time"][first]
        else:
            owner[key] = i
    return {key: value[~rows["stands"]] for key, value in rows.items()}
