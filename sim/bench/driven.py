"""Frames while somebody is driven by keys of chance, at 960x540 in memory, at the quality a window starts with in software.

A frame is two ticks (the choice of a footprint, its window), the pose, and the picture: what 30 frames a second have 33 ms for.
"""

from statistics import median
from time import perf_counter, process_time

import numpy as np

from motion.characters.character import character_names
from sim.stage.commands import steer_by_chance
from sim.stage.making import make_steered
from sim.stage.simulation import Simulation
from worlds.level import level_names

TICKS = 2
"""Between two frames."""
SETTLING = 5
"""Frames before anything is timed."""


def measure(level: str, character: str, frames: int, size: tuple[int, int]) -> dict | None:
    """Milliseconds of a frame by the clock, and of all threads' processor time; of its ticks alone; None without OpenGL."""
    from sim.view.graphics.gl import NoGL
    from sim.view.graphics.quality import LEVELS, SOFTWARE_LEVEL
    from sim.view.pictures.offscreen import Picture

    try:
        picture = Picture(size, LEVELS[SOFTWARE_LEVEL])
    except NoGL:
        return None
    sim, ticks, whole, processor = make_steered(level, character, 1, 1), [], [], []
    for _ in range(frames + SETTLING):
        begin, used = perf_counter(), process_time()
        _tick(sim)
        ticked = perf_counter()
        picture.frame(sim)
        ticks.append(1e3 * (ticked - begin))
        whole.append(1e3 * (perf_counter() - begin))
        processor.append(1e3 * (process_time() - used))
    ticks, whole = ticks[SETTLING:], whole[SETTLING:]
    return {
        "frame_ms_median": median(whole),
        "frame_ms_p95": float(np.percentile(whole, 95)),
        "processor_ms_median": median(processor[SETTLING:]),
        "ticks_ms_median": median(ticks),
        "ticks_ms_p99": float(np.percentile(ticks, 99)),
    }


def _tick(sim: Simulation) -> None:
    for _ in range(TICKS):
        sim.tick()
        steer_by_chance(sim)


def report(quick: bool, size: tuple[int, int]) -> dict[str, dict]:
    """By level and character: all that ship, or a few."""
    levels = ["forest"] if quick else level_names()
    rows = {f"{level} {who}": measure(level, who, 20 if quick else 150, size) for level in levels for who in character_names()}
    return {name: row for name, row in rows.items() if row}


def in_words(rows: dict[str, dict]) -> list[str]:
    """A line for each."""
    return [
        f"driven, {name}: a frame takes {row['frame_ms_median']:.1f} ms, 95 % {row['frame_ms_p95']:.1f} at most, "
        f"{row['processor_ms_median']:.0f} of a processor; its ticks {row['ticks_ms_median']:.2f}, {row['ticks_ms_p99']:.2f}"
        for name, row in rows.items()
    ]
