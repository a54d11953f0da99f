"""Counter-based randomness: a number is a hash of (seed, character, step, purpose), so it depends on nothing else.

The hash chains splitmix64's finaliser (Steele, Lea & Flood 2014) over the four words.
"""

from typing import Any

import numpy as np

from worlds.compiled.jit import jit_borrowing

DRIFT, SIDE, LOOK, WAIT, PLACE, JAM, PACE, PACE_TOO, BANKS, AWAY = range(10)
"""Purposes: two questions of the same step get unrelated numbers."""


@jit_borrowing
def _mix(word: Any) -> Any:
    word = (word ^ (word >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    word = (word ^ (word >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return word ^ (word >> np.uint64(31))


@jit_borrowing
def uniform(seed: int, character: int, step: int, purpose: int) -> float:
    """A number in [0, 1) that belongs to these four integers."""
    golden = np.uint64(0x9E3779B97F4A7C15)
    word = _mix(np.uint64(seed) + golden)
    word = _mix(word ^ (np.uint64(character) + golden))
    word = _mix(word ^ (np.uint64(step) + golden))
    word = _mix(word ^ (np.uint64(purpose) + golden))
    return np.float64(word >> np.uint64(11)) * (1.0 / 9007199254740992.0)


@jit_borrowing
def near_one(seed: int, character: int, step: int, deviation: float) -> float:
    """A factor about 1 that belongs to a character's step; `deviation`: its standard deviation (triangular)."""
    a, b = uniform(seed, character, step, PACE), uniform(seed, character, step, PACE_TOO)
    return 1 + 2.449489742783178 * deviation * (a + b - 1)
