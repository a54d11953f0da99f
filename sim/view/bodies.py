"""Bodies shaped around a pose: legs and feet, which all share, and footprints. Lengths in units of the nominal leg."""

import numpy as np

from motion.biped import Biped
from motion.pose import Pose
from sim.view import plans
from sim.view.clay import Clay


def model(clay: Clay, biped: Biped, pose: Pose, rows: np.ndarray) -> None:
    """Adds the bodies of the characters `rows` (of one kind) to the clay."""
    shape = plans.PLANS.get(biped.body.get("plan", "human"), plans.human)
    shape(clay, biped, Pose(*(array[rows] for array in pose)))


def outline(biped: Biped) -> np.ndarray:
    """(Q, 3, 2) triangles of the character's footprint, forward and left of the sole's middle [m]."""
    b = biped.record
    half, wide = 0.5 * b.foot_length, 0.5 * b.foot_width
    if biped.body.get("plan", "human") == "human":
        return np.concatenate([_oval(-0.6 * half, 0, 0.42 * half, 0.62 * wide), _oval(0.3 * half, 0, 0.7 * half, wide)])
    ball = -0.35 * half
    parts = [_oval(ball, 0, 0.3 * half, 0.4 * wide)]
    for k in (-1, 0, 1):
        tip = (half if k == 0 else 0.72 * half, k * wide)
        w = 0.15 * wide
        parts.append(np.array([[(ball, -w), tip, (ball, w)]]))
    return np.concatenate(parts)


def _oval(x: float, y: float, a: float, b: float, sides: int = 12) -> np.ndarray:
    angles = np.linspace(0, 2 * np.pi, sides + 1)
    rim = np.stack([x + a * np.cos(angles), y + b * np.sin(angles)], axis=1)
    middle = np.broadcast_to((x, y), rim[:-1].shape)
    return np.stack([middle, rim[:-1], rim[1:]], axis=1)
