"""Where a motion borrows: physics [m/s^2], comfort, and legs out of reach [m], sampled along time, a little in each frame.

What a frame has no time for is sampled in the next ones; what an edit has left as it was is not sampled again.
"""

import time as clock
from dataclasses import dataclass, field

import numpy as np

from motion.track.curve import Curve
from planner.script.acting import Act
from sim.stage.scripted.rehearsal import Rehearsal

STEP = 1 / 30
"""Seconds between two samples."""
BUDGET = 0.003
"""Seconds of a frame that are given to sampling."""
PHYSICS, COMFORT, REACH = 0, 1, 2
FULL = (4.0, 4.0, 0.05)
"""What fills a strip: m/s^2 of physics and of comfort's cost, and metres of a leg beyond its length."""
WORTH = (0.6, 2.5, 0.006)
"""From this on a place is worth a word."""


@dataclass
class Debts:
    """Of one track: values (3, T) at times k STEP, NaN where they have not been sampled yet."""

    values: np.ndarray = field(default_factory=lambda: np.zeros((3, 0)))
    curve: Curve | None = None

    def look(self, show: Rehearsal, c: int, around: float, budget: float = BUDGET) -> None:
        """Samples what is missing, the nearest to a time [s] first, as long as the budget lasts."""
        act = show.acts[c]
        self._take(act)
        missing = np.flatnonzero(np.isnan(self.values[0]))
        if not len(missing):
            return
        order = missing[np.argsort(np.abs(missing * STEP - around), kind="stable")]
        begin = clock.perf_counter()
        for k in order:
            self.values[:, k] = debts_at(show, c, float(k * STEP))
            if clock.perf_counter() - begin > budget:
                return

    def _take(self, act: Act) -> None:
        """Forgets what is of another motion, from the first difference on."""
        curve = act.motion.curve
        if curve is self.curve:
            return
        count, old = int(act.end / STEP) + 1, self.values
        self.values = np.full((3, count), np.nan)
        if self.curve is not None:
            n = min(len(curve.time), len(self.curve.time))
            same = (curve.control[:n] == self.curve.control[:n]).all(axis=1) & (curve.time[:n] == self.curve.time[:n])
            kept = n if same.all() else int(same.argmin())
            until = min(int(max(float(curve.time[kept - 1]) - 1.0, 0.0) / STEP), old.shape[1], count) if kept else 0
            self.values[:, :until] = old[:, :until]
        self.curve = curve

    def total(self, begin: float, end: float) -> float:
        """What is owed between two times, each kind in shares of what is worth a word, summed over time [s]."""
        part = np.nan_to_num(self.values[:, int(begin / STEP) : int(end / STEP) + 1])
        return float((part / np.array(WORTH)[:, None]).sum() * STEP)

    def worst(self, most: int = 4, apart: float = 0.6) -> list[tuple[float, int]]:
        """The worst places, (time [s], kind) each, no two within `apart` [s]."""
        share = np.nan_to_num(self.values) / np.array(WORTH)[:, None]
        found = list[tuple[float, int]]()
        for flat in np.argsort(share, axis=None)[::-1][: 40 * most]:
            kind, k = np.unravel_index(flat, share.shape)
            if share[kind, k] < 1 or len(found) == most:
                break
            if all(abs(k * STEP - t) > apart for t, _ in found):
                found.append((float(k * STEP), int(kind)))
        return found


def debts_at(show: Rehearsal, c: int, t: float) -> tuple[float, float, float]:
    """(physics, comfort, reach) of a character at a time [s]."""
    pose = show.snapshot(t, np.array([c]))
    over = np.linalg.norm(pose.hip[0] - pose.ankle[0], axis=1) - float(show.acts[c].character.biped.leg.max_length)
    beyond = np.where(pose.contact[0], over, 0.0).max(initial=0.0)
    return float(pose.physics_cost[0]), float(pose.comfort_cost[0]), float(max(beyond, 0.0))
