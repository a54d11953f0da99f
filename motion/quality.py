"""How good a motion is, from recorded arrays: F frames of one character, feet in the order LEFT, RIGHT."""

import numpy as np

from motion import cost, phases

PHASES = {"left": phases.LEFT_STANCE, "right": phases.RIGHT_STANCE, "double": phases.DOUBLE_STANCE}
PHASES |= {"flight": phases.FLIGHT}


def stance_slide(toe: np.ndarray, contact: np.ndarray) -> float:
    """Largest way of a toe [m] from one frame to the next while its foot is on the ground. toe (F, 2, 3), contact (F, 2)."""
    held = contact[1:] & contact[:-1]
    way = np.linalg.norm(np.diff(toe, axis=0), axis=2)
    return float(way[held].max(initial=0.0))


def penetration(points: np.ndarray, ground: np.ndarray) -> float:
    """Deepest point below the ground [m]. points (..., 3), ground (...) height of the ground below each."""
    return float(np.maximum(ground - points[..., 2], 0).max(initial=0.0))


def swing_clearance(toe: np.ndarray, ground: np.ndarray, contact: np.ndarray) -> float:
    """Least height of a toe over the ground [m] at the middle of any swing. ground (F, 2)."""
    least = np.inf
    for foot in range(2):
        edges = np.flatnonzero(np.diff(contact[:, foot].astype(int)))
        for begin, end in zip(edges, edges[1:], strict=False):
            if contact[begin, foot] and end - begin > 4:
                middle = (begin + end) // 2 + 1
                least = min(least, float(toe[middle, foot, 2] - ground[middle, foot]))
    return least


def overreach(hip: np.ndarray, ankle: np.ndarray, max_length: float) -> float:
    """Largest length of a virtual leg beyond max_length [m]."""
    return float(np.maximum(np.linalg.norm(hip - ankle, axis=2) - max_length, 0).max(initial=0.0))


def flight_residual(acceleration: np.ndarray, phase: np.ndarray) -> float:
    """Mean |a - g| over the frames of flight [m/s^2]; 0 without any."""
    flying = phase == phases.FLIGHT
    g = np.array([0.0, 0.0, -cost.GRAVITY])
    return float(np.linalg.norm(acceleration[flying] - g, axis=1).mean()) if flying.any() else 0.0


def by_phase(values: np.ndarray, phase: np.ndarray) -> dict[str, dict[str, float]]:
    """Mean, peak and share of the frames, per phase and over all."""
    report = {"all": {"mean": float(values.mean()), "peak": float(values.max()), "share": 1.0}}
    for name, code in PHASES.items():
        part = values[phase == code]
        if len(part):
            report[name] = {"mean": float(part.mean()), "peak": float(part.max()), "share": len(part) / len(values)}
    return report


def physics_cost(com, acceleration, point_of_support, contact) -> np.ndarray:
    """The physics cost (F,) from a recording's own arrays (paper, section 2.4): what the recorded one must equal."""
    out = np.empty(len(com))
    for f in range(len(com)):
        w = acceleration[f] + np.array([0.0, 0.0, cost.GRAVITY])
        out[f] = cost.physics_cost(
            com[f, 0], com[f, 1], com[f, 2], w[0], w[1], w[2], np.nan_to_num(point_of_support[f]), contact[f]
        )
    return out
