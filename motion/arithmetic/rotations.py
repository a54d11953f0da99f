"""Rotations from a body to the world: by angles, by axes, and as unit quaternions wxyz.

The angles are those of R = Rz(yaw) Ry(pitch) Rx(roll); a body's axes are forward, left and up. A positive pitch is nose down.
"""

from math import sqrt

import numpy as np

from motion.arithmetic.functions import turn
from motion.arithmetic.triples import Triple
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some

Quaternion = tuple[Some, Some, Some, Some]
Axes = tuple[Triple, Triple, Triple]
"""Forward, left and up, unit vectors in the world."""


@jit_inline
def quaternion(yaw: Some, pitch: Some, roll: Some) -> Quaternion:
    """wxyz of a body turned by these angles [rad]."""
    (cy, sy), (cp, sp), (cr, sr) = turn(0.5 * yaw), turn(0.5 * pitch), turn(0.5 * roll)
    return (
        cy * cp * cr + sy * sp * sr,
        cy * cp * sr - sy * sp * cr,
        cy * sp * cr + sy * cp * sr,
        sy * cp * cr - cy * sp * sr,
    )


@jit_inline
def axes(yaw: Some, pitch: Some, roll: Some) -> Axes:
    """The axes of a body turned by these angles [rad]."""
    (cy, sy), (cp, sp), (cr, sr) = turn(yaw), turn(pitch), turn(roll)
    return (
        (cy * cp, sy * cp, -sp),
        (cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr),
        (cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr),
    )


@jit_inline
def along(body: Axes, forward: Some, left: Some, up: Some) -> Triple:
    """The vector (forward, left, up) of a body with these axes, in the world."""
    f, s, u = body
    return (
        forward * f[0] + left * s[0] + up * u[0],
        forward * f[1] + left * s[1] + up * u[1],
        forward * f[2] + left * s[2] + up * u[2],
    )


@jit_inline
def turned(yaw: Some, pitch: Some, roll: Some, forward: Some, left: Some, up: Some) -> Triple:
    """The vector (forward, left, up) of a body turned by these angles [rad], in the world."""
    return along(axes(yaw, pitch, roll), forward, left, up)


@jit_inline
def product(p: Quaternion, q: Quaternion) -> Quaternion:
    """The rotation q, and then p."""
    return (
        p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
        p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
        p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
        p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0],
    )


@jit_inline
def inverse(q: Quaternion) -> Quaternion:
    """The rotation back."""
    return q[0], -q[1], -q[2], -q[3]


@jit_borrowing
def of_axes(body: Axes) -> Quaternion:
    """wxyz of a body with these axes; the largest of the four is found first, so that nothing is divided by little."""
    f, s, u = body
    trace = f[0] + s[1] + u[2]
    if trace > 0:
        w = 2 * sqrt(1 + trace)
        return 0.25 * w, (s[2] - u[1]) / w, (u[0] - f[2]) / w, (f[1] - s[0]) / w
    if f[0] >= s[1] and f[0] >= u[2]:
        x = 2 * sqrt(1 + f[0] - s[1] - u[2])
        return (s[2] - u[1]) / x, 0.25 * x, (f[1] + s[0]) / x, (u[0] + f[2]) / x
    if s[1] >= u[2]:
        y = 2 * sqrt(1 - f[0] + s[1] - u[2])
        return (u[0] - f[2]) / y, (f[1] + s[0]) / y, 0.25 * y, (s[2] + u[1]) / y
    z = 2 * sqrt(1 - f[0] - s[1] + u[2])
    return (f[1] - s[0]) / z, (u[0] + f[2]) / z, (s[2] + u[1]) / z, 0.25 * z


def axes_of(wxyz: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Forward, left and up (..., 3) of quaternions (..., 4)."""
    w, x, y, z = np.moveaxis(np.asarray(wxyz), -1, 0)
    forward = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], axis=-1)
    left = np.stack([2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)], axis=-1)
    up = np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], axis=-1)
    return forward, left, up


def yaw_of(wxyz: np.ndarray) -> np.ndarray:
    """Heading (...) [rad] of the forward axis of quaternions (..., 4)."""
    forward = axes_of(wxyz)[0]
    return np.arctan2(forward[..., 1], forward[..., 0])
