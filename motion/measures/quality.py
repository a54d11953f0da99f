"""How good a motion is, from recorded arrays: F frames of one character, feet in the order LEFT, RIGHT.

Of a sole three points are looked at, in the order HEEL, BALL, TOE: sole (F, 2, 3, 3). While its foot stands, those of them
that are on the ground must not move, however the foot rolls: at first perhaps the heel alone, then all, then ball and toe.
"""

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.com import cost
from motion.track import phases
from motion.track.foot import along_sole, pivot
from motion.track.footprints import Footprints
from worlds.compiled.jit import jit

PHASES = {"left": phases.LEFT_STANCE, "right": phases.RIGHT_STANCE, "double": phases.DOUBLE_STANCE}
PHASES |= {"flight": phases.FLIGHT}
HEEL, BALL, TOE = 0, 1, 2
ON_GROUND = 1e-5
"""A point of the sole less than this [m] higher than the lowest of them is on the ground; a sole that floats has one too."""


def stance_slide(sole: np.ndarray, down: np.ndarray) -> float:
    """Largest way [m] from one frame to the next of a point of the sole that is on the ground (`down`, F, 2, 3) in both."""
    held = down[1:] & down[:-1]
    way = np.linalg.norm(np.diff(sole, axis=0), axis=3)
    return float(way[held].max(initial=0.0))


def footing(time: np.ndarray, contact: np.ndarray, footprints: Footprints) -> np.ndarray:
    """Footprint (F, 2) on which each foot stands, -1 in the air. footprints (K,) of one character, by contact time."""
    out = np.full(contact.shape, -1)
    for foot in range(2):
        own = np.flatnonzero(footprints.side == foot)
        last = np.searchsorted(footprints.contact_time[own], time + phases.SHORTEST_PHASE, side="right") - 1
        if len(own):
            out[:, foot] = np.where(contact[:, foot] & (last >= 0), own[np.maximum(last, 0)], -1)
    return out


def marks(footprints: Footprints, foot_length: float, ball_forward: float) -> np.ndarray:
    """Where heel, ball and toe of each footprint are (K, 3, 3) [m]."""
    out = np.empty((len(footprints.side), 3, 3))
    _lay_marks(footprints, np.array([-0.5 * foot_length, ball_forward, 0.5 * foot_length]), out)
    return out


@jit
def _lay_marks(footprints: Footprints, forward: np.ndarray, out: np.ndarray) -> None:
    for n in range(len(out)):
        for k in range(len(forward)):
            out[n, k, 0], out[n, k, 1], out[n, k, 2] = along_sole(footprints, n, forward[k], 0.0)


@jit
def pivots(max_turn: float, footprints: Footprints) -> np.ndarray:
    """On which footprints (K,) the foot pivots on its ball before it leaves (motion.track.foot); max_turn [rad]."""
    out = np.empty(len(footprints.side), np.bool_)
    for n in range(len(out)):
        out[n] = pivot(max_turn, footprints, n) != 0.0
    return out


def on_ground(sole: np.ndarray, stands: np.ndarray, footprints: Footprints, pivoting: np.ndarray) -> np.ndarray:
    """Which points of the sole carry (F, 2, 3) bool: the lowest over the plane of the footprint `stands` (F, 2).

    Once its heel is up, the ball alone carries a foot that is `pivoting` (K,).
    """
    up, origin = footprints.normal[stands], footprints.position[stands]
    height = np.einsum("fsek,fsk->fse", sole - origin[:, :, None], up)
    carries = (height <= height.min(axis=2, keepdims=True) + ON_GROUND) & (stands >= 0)[:, :, None]
    carries[:, :, 2] &= carries[:, :, 0] | ~pivoting[stands]
    return carries


def skate(sole: np.ndarray, down: np.ndarray, stands: np.ndarray) -> tuple[float, float]:
    """Largest (horizontal, total) displacement [m] of a point on the ground (`down`) from where its stance put it down."""
    horizontal, total = 0.0, 0.0
    for foot, point in np.ndindex(2, 3):
        frames = np.flatnonzero(down[:, foot, point])
        first = frames[np.searchsorted(stands[frames, foot], stands[frames, foot])]
        way = sole[frames, foot, point] - sole[first, foot, point]
        horizontal = max(horizontal, float(np.linalg.norm(way[:, :2], axis=1).max(initial=0.0)))
        total = max(total, float(np.linalg.norm(way, axis=1).max(initial=0.0)))
    return horizontal, total


def footprint_error(sole: np.ndarray, down: np.ndarray, stands: np.ndarray, places: np.ndarray) -> float:
    """Largest distance [m] of a point on the ground from that of its footprint. places: marks (K, 3, 3)."""
    return float(np.linalg.norm(sole - places[stands], axis=3)[down].max(initial=0.0))


def contact_error(time: np.ndarray, contact: np.ndarray, footprints: Footprints) -> int:
    """Most frames in a row in which a foot stands though by its footprints' times it should not, or the other way round."""
    worst = 0
    for foot in range(2):
        own = footprints.side == foot
        begin, end = footprints.contact_time[own], footprints.contact_time[own] + footprints.stance_time[own]
        wrong = np.ones(len(time), bool)
        for slack in (-phases.SHORTEST_PHASE, phases.SHORTEST_PHASE):
            t = time + slack
            due = np.searchsorted(begin, t, side="right") > np.searchsorted(end, t, side="right")
            wrong &= due != contact[:, foot]
        edges = np.flatnonzero(np.diff(np.concatenate([[False], wrong, [False]]).astype(int)))
        worst = max(worst, int((edges[1::2] - edges[::2]).max(initial=0)))
    return worst


def penetration(points: np.ndarray, ground: np.ndarray) -> float:
    """Deepest point below the ground [m]. points (..., 3), ground (...) height of the ground below each."""
    return float(np.maximum(ground - points[..., 2], 0).max(initial=0.0))


def swing_clearance(height: np.ndarray, contact: np.ndarray) -> float | None:
    """Least height over the ground [m] at the middle of any swing; None without any. height (F, 2), contact (F, 2)."""
    least = []
    for foot in range(2):
        edges = np.flatnonzero(np.diff(contact[:, foot].astype(int)))
        begin, end = edges[:-1], edges[1:]
        swings = contact[begin, foot] & (end - begin > 4)
        least += height[((begin + end) // 2 + 1)[swings], foot].tolist()
    return min(least, default=None)


def overreach(hip: np.ndarray, ankle: np.ndarray, max_length: float) -> float:
    """Largest length of a virtual leg beyond max_length [m]."""
    return float(np.maximum(np.linalg.norm(hip - ankle, axis=2) - max_length, 0).max(initial=0.0))


def flight_residual(acceleration: np.ndarray, phase: np.ndarray) -> float:
    """Mean |a - g| over the frames of flight [m/s^2]; 0 without any."""
    flying = phase == phases.FLIGHT
    g = np.array([0.0, 0.0, -GRAVITY])
    return float(np.linalg.norm(acceleration[flying] - g, axis=1).mean()) if flying.any() else 0.0


def by_phase(values: np.ndarray, phase: np.ndarray) -> dict[str, dict[str, float]]:
    """Mean, peak and share of the frames, per phase and over all."""
    report = {"all": {"mean": float(values.mean()), "peak": float(values.max()), "share": 1.0}}
    for name, code in PHASES.items():
        part = values[phase == code]
        if len(part):
            report[name] = {"mean": float(part.mean()), "peak": float(part.max()), "share": len(part) / len(values)}
    return report


def physics_cost(com: np.ndarray, acceleration: np.ndarray, point_of_support: np.ndarray, contact: np.ndarray) -> np.ndarray:
    """The physics cost (F,) from a recording's own arrays (paper, section 2.4): what the recorded one must equal."""
    out = np.empty(len(com))
    support = np.nan_to_num(np.ascontiguousarray(point_of_support))
    _physics_costs(np.ascontiguousarray(com), np.ascontiguousarray(acceleration), support, np.ascontiguousarray(contact), out)
    return out


@jit
def _physics_costs(
    com: np.ndarray, acceleration: np.ndarray, support: np.ndarray, contact: np.ndarray, out: np.ndarray
) -> None:
    for f in range(len(com)):
        out[f] = cost.physics_cost(com[f], acceleration[f], support[f], contact[f])
