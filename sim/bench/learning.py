"""Footsteps a second of the world to learn in.

By the wall clock, and by the processor time of all threads, which does not count what other programs take.
"""

import time

import numpy as np

from sim.rows.stones import ACTIONS, AHEAD, REACH
from sim.stage.learning.stepping import SteppingStones

LEVELS = (0.0, 0.5, 1.0)
STEPS = 20


def onto(stones: SteppingStones, seen: np.ndarray) -> np.ndarray:
    """Actions (N, ACTIONS) that step to the middle of the next stones, of what is seen (N, SEEN)."""
    biped = stones.character.biped
    unit, actions = float(biped.leg.nominal_length) / 0.9, np.zeros((len(seen), ACTIONS))
    actions[:, 0] = (seen[:, 12] / unit - AHEAD) / REACH
    actions[:, 1] = (seen[:, 13] - float(biped.gait.step_width)) / unit / REACH
    return actions


def measure(rows: int, level: float) -> dict:
    """Everybody steps onto the next stone, again and again; who falls begins anew."""
    stones = SteppingStones(rows, level=level)
    stones.step(onto(stones, stones.reset(np.arange(rows))))
    seen, fell = stones.reset(np.arange(rows)), 0
    wall, processor = time.perf_counter(), time.process_time()
    for _ in range(STEPS):
        stepped = stones.step(onto(stones, seen))
        seen = stones.begin(np.flatnonzero(stepped.fell)) if stepped.fell.any() else stepped.seen
        fell += int(stepped.fell.sum())
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    done = rows * STEPS
    return {"footsteps_per_s": done / wall, "footsteps_per_processor_s": done / processor, "fell": fell / done}


def report(rows: int) -> dict[str, dict]:
    """By level."""
    return {f"{level:g}": measure(rows, level) for level in LEVELS}


def in_words(by_level: dict[str, dict]) -> list[str]:
    """A line for each level."""
    return [
        f"stepping stones, level {level}: {row['footsteps_per_s']:,.0f} footsteps/s, "
        f"{row['footsteps_per_processor_s']:,.0f} per processor second; {row['fell']:.1%} fell"
        for level, row in by_level.items()
    ]
