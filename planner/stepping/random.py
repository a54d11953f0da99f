"""Counter-based randomness: a number is a hash of (seed, character, step, purpose), so it depends on nothing else.

The hash chains splitmix64's finaliser (Steele, Lea & Flood 2014) over the four words.
"""

import numpy as np

from worlds.compiled.jit import jit_borrowing

DRIFT, SIDE, LOOK, WAIT, PLACE, JAM = range(6)
"""Purposes: two questions of the same step get unrelated numbers."""


@jit_borrowing
def _mix(x):
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


@jit_borrowing
def uniform(seed, character, step, purpose):
    """A number in [0, 1) that belongs to these four integers."""
    golden = np.uint64(0x9E3779B97F4A7C15)
    x = _mix(np.uint64(seed) + golden)
    x = _mix(x ^ (np.uint64(character) + golden))
    x = _mix(x ^ (np.uint64(step) + golden))
    x = _mix(x ^ (np.uint64(purpose) + golden))
    return np.float64(x >> np.uint64(11)) * (1.0 / 9007199254740992.0)
