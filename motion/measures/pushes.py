"""What the legs of a moment give, and what is missing: the forces that the physics cost is the size of (paper, section 2.4).

Unit mass, w = a - g the force that is needed. Standing legs push along K = unit(com - point of support), never pull: F is the
non-negative combination of their directions nearest to w, and w - F is missing.
"""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY


class Pushes(NamedTuple):
    """Forces per mass of one moment [m/s^2], world."""

    legs: np.ndarray  # (2, 3) that the left and right leg give
    missing: np.ndarray  # (3,) that nothing gives


def pushes_of(com: np.ndarray, acceleration: np.ndarray, support: np.ndarray, standing: np.ndarray) -> Pushes:
    """The forces of a com (3,) with its acceleration (3,) over points of support (2, 3) of the feet that stand (2,)."""
    w = acceleration + np.array([0.0, 0.0, GRAVITY])
    legs = np.zeros((2, 3))
    along = np.array([com - support[k] for k in range(2)])
    unit = along / (np.linalg.norm(along, axis=1, keepdims=True) + 1e-300)
    on = np.flatnonzero(standing)
    shares = np.zeros(2)
    if len(on) == 2 and 1 - (unit[0] @ unit[1]) ** 2 > 1e-9:
        shares = np.linalg.solve(unit @ unit.T, unit @ w)
    if len(on) < 2 or (shares <= 0).any():
        single = np.where(standing, unit @ w, -np.inf)
        shares = np.zeros(2)
        if len(on) and single.max() > 0:
            shares[single.argmax()] = single.max()
    legs = shares[:, None] * np.where(np.asarray(standing, bool)[:, None], unit, 0.0)
    return Pushes(legs, np.asarray(w - legs.sum(axis=0)))
