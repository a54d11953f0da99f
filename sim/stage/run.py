"""A headless run: ticks, a progress bar, a summary."""

from collections.abc import Callable

import numpy as np

from sim.stage.cast import Cast
from worlds.compiled.telling import is_watched, tell

STANDS_STILL = 2.0
"""A run to a goal ends this long [s] after everyone has reached it."""


def _never() -> bool:
    return False


def run(
    sim: Cast, seconds: float, *after_tick: Callable[[], None], quiet: bool = False, stop: Callable[[], bool] = _never
) -> dict:
    """Ticks until `seconds` of simulated time, until all reached their goal, or until `stop` says so; returns the summary.

    Each of after_tick is called after every tick. The bar goes to stderr.
    """
    watch, bar = _Watch(sim), Bar()
    ticks = int(round(seconds * sim.tick_rate)) - sim.ticks
    for k in range(ticks):
        sim.tick()
        for look in after_tick:
            look()
        watch.look()
        if not quiet and (k % 30 == 0 or k == ticks - 1):
            bar.show((k + 1) / ticks)
        if stop() or sim.over or (watch.all_there_since is not None and sim.time - watch.all_there_since > STANDS_STILL):
            break
    if not quiet:
        bar.end()
    watch.measure()
    return watch.summary()


class Bar:
    """How much is done, as a bar that stays in its line; where that goes to a file, a line for each tenth."""

    def __init__(self) -> None:
        self._told = -1

    def show(self, share: float) -> None:
        """share: what is done, 0 to 1."""
        full, tenths = int(30 * share), int(10 * share)
        bar = f"  [{'#' * full}{'.' * (30 - full)}] {share:4.0%}"
        if is_watched():
            tell(f"\r{bar}", end="")
        elif tenths > self._told:
            tell(bar)
        self._told = tenths

    def end(self) -> None:
        """Goes on below it."""
        if is_watched():
            tell("")


class _Watch:
    """Goals as they are reached, without keeping poses."""

    def __init__(self, sim: Cast) -> None:
        self.sim = sim
        self.reached = np.full(len(sim.characters), np.nan)
        self.all_there_since: float | None = None

    def look(self) -> None:
        """After a tick: six times a simulated second is enough."""
        if self.sim.ticks % 10 == 0:
            self.measure()

    def measure(self) -> None:
        """Who is there."""
        there = self.sim.reached_goal
        self.reached[there & np.isnan(self.reached)] = self.sim.time
        self.all_there_since = (self.all_there_since or self.sim.time) if there.all() else None

    def summary(self) -> dict:
        """The run summary of --json. distance [m] is the mean over the characters, or over all who came."""
        there, counts = ~np.isnan(self.reached), self.sim.counts()
        people = counts["people"]["came"] if "people" in counts else len(self.sim.characters)
        return {
            "level": self.sim.world.name,
            "characters": len(self.sim.characters),
            "seed": self.sim.seed,
            "seconds": self.sim.time,
            "steps": self.sim.footprints.steps,
            "distance": float(self.sim.distance.sum() / max(people, 1)),
            "reached_goal": bool(there.all()),
            "seconds_to_goal": float(self.reached.max()) if there.all() else None,
            **counts,
        }
