"""Angles of the legs and the distance between them, from recorded joints: F frames, feet in the order LEFT, RIGHT.

    hip    thigh against the body's downward axis in its sagittal plane, forward positive
    knee   between thigh and shank, 0 straight
    hock   between shank and metatarsus, 0 straight; three-link legs only
    ankle  between the last link of the leg and the sole from heel to ball, a right angle when standing

Rates are central differences between evenly spaced frames: a jump of the angular velocity by d shows as d / dt.
"""

import numpy as np

from motion.arithmetic.rotations import axes_of
from worlds.compiled.jit import jit

POP_PERCENTILE = 99.0
"""The peak acceleration is compared with this percentile of its own run: a pop stands far above it."""


def angles(frames: dict[str, np.ndarray], three_links: bool) -> dict[str, np.ndarray]:
    """Angle (F, 2) [rad] of each joint. frames: hip, knee, hock, ankle, heel, ball (F, 2, 3), body_rotation_wxyz (F, 4)."""
    thigh, shank = frames["knee"] - frames["hip"], frames["hock"] - frames["knee"]
    last = frames["ankle"] - frames["hock"] if three_links else shank
    forward, left, up = axes_of(frames["body_rotation_wxyz"])
    out = {"hip": np.arctan2(np.einsum("fsk,fk->fs", thigh, forward), -np.einsum("fsk,fk->fs", thigh, up))}
    out["knee"] = _between(thigh, shank)
    if three_links:
        out["hock"] = _between(shank, last)
    out["ankle"] = _toward(last, frames["ball"] - frames["heel"], left)
    return out


def _toward(u: np.ndarray, v: np.ndarray, left: np.ndarray) -> np.ndarray:
    """Angle [rad] from u (F, 2, 3) to v, seen from the left (F, 3), forward of u: a foot may be stretched beyond straight."""
    return np.arctan2(-np.einsum("fsk,fk->fs", np.cross(u, v), left), np.einsum("fsk,fsk->fs", u, v))


def _between(u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Angle [rad] between vectors (..., 3), exact near 0 and pi too."""
    return np.arctan2(np.linalg.norm(np.cross(u, v), axis=-1), np.einsum("...k,...k->...", u, v))


def rates(angle: np.ndarray, dt: float) -> tuple[np.ndarray, np.ndarray]:
    """(velocity, acceleration) (F - 2, 2) of an angle (F, 2) by central differences, at frames 1 to F - 2."""
    return (angle[2:] - angle[:-2]) / (2 * dt), (angle[2:] - 2 * angle[1:-1] + angle[:-2]) / (dt * dt)


def peaks(angle: np.ndarray, time: np.ndarray) -> dict[str, float]:
    """Range [rad], peaks [rad/s, rad/s^2] and the acceleration's peak over its percentile, of both legs; when it peaks [s]."""
    velocity, acceleration = (np.abs(rate) for rate in rates(angle, _spacing(time)))
    usual = float(np.percentile(acceleration, POP_PERCENTILE)) if acceleration.size else 0.0
    peak = float(acceleration.max(initial=0.0))
    frame = int(acceleration.max(axis=1).argmax()) + 1 if acceleration.size else 0
    return {
        "least": float(angle.min()),
        "most": float(angle.max()),
        "velocity": float(velocity.max(initial=0.0)),
        "acceleration": peak,
        "acceleration_p99": usual,
        "acceleration_ratio": peak / usual if usual > 0 else 1.0,
        "acceleration_time": float(time[frame]),
    }


def _spacing(time: np.ndarray) -> float:
    return float(time[-1] - time[0]) / max(len(time) - 1, 1)


def shank_distance(knee: np.ndarray, hock: np.ndarray, ankle: np.ndarray) -> np.ndarray:
    """Least distance (F,) [m] between the lines of the two legs below the knee. Arguments (F, 2, 3)."""
    out = np.empty(len(knee))
    _shank_distances(np.ascontiguousarray(knee), np.ascontiguousarray(hock), np.ascontiguousarray(ankle), out)
    return out


@jit
def _shank_distances(knee: np.ndarray, hock: np.ndarray, ankle: np.ndarray, out: np.ndarray) -> None:
    for f in range(len(knee)):
        k, h, a = knee[f], hock[f], ankle[f]
        upper = min(segment_distance(k[0], h[0], k[1], h[1]), segment_distance(k[0], h[0], h[1], a[1]))
        lower = min(segment_distance(h[0], a[0], k[1], h[1]), segment_distance(h[0], a[0], h[1], a[1]))
        out[f] = min(upper, lower)


@jit
def segment_distance(p: np.ndarray, q: np.ndarray, r: np.ndarray, s: np.ndarray) -> float:
    """Distance between the segments p q and r s, points (3,), which may be as short as they like.

    |p + x u - r - y v| with u = q - p, v = s - r is least at the x of the lines' nearest points, cut to 0..1, then at the y
    nearest to that point, cut to 0..1, and then at the x nearest to that one.
    """
    uu, uv, vv, uw, vw = 0.0, 0.0, 0.0, 0.0, 0.0
    for k in range(3):
        u, v, w = q[k] - p[k], s[k] - r[k], p[k] - r[k]
        uu, uv, vv, uw, vw = uu + u * u, uv + u * v, vv + v * v, uw + u * w, vw + v * w
    across = uu * vv - uv * uv
    x = min(max((uv * vw - vv * uw) / across, 0.0), 1.0) if across > 1e-12 * uu * vv else 0.0
    y = min(max((uv * x + vw) / vv, 0.0), 1.0) if vv > 0 else 0.0
    x = min(max((uv * y - uw) / uu, 0.0), 1.0) if uu > 0 else 0.0
    square = 0.0
    for k in range(3):
        gap = p[k] + x * (q[k] - p[k]) - r[k] - y * (s[k] - r[k])
        square += gap * gap
    return square**0.5
