"""Orientation of the body (paper, section 2.5): heading from the feet; pitch and roll from the gait and the curve.

Roll swings with the com: the body leans over the leg that carries it, and into turns with the lateral acceleration. Pitch
nods twice a stride with the vertical acceleration. All of it reads the committed curve, so it is a function of time.
"""

from math import atan2, cos, sin

from motion.jit import jit

GRAVITY = 9.81


@jit
def pitch_and_roll(b, yaw, acceleration):
    """(pitch, roll) [rad] of the body from the com's acceleration (3,); pitch is positive nose down."""
    c, s = cos(yaw), sin(yaw)
    forward = c * acceleration[0] + s * acceleration[1]
    left = c * acceleration[1] - s * acceleration[0]
    up = min(max(acceleration[2] / GRAVITY, -1.0), 1.0)
    nod = b.pitch_amplitude * (min(max(forward / 2.0, -1.0), 1.0) - 0.5 * up)
    sway = b.roll_amplitude * min(max(left / 1.5, -1.0), 1.0)
    return nod, -sway - b.lean_gain * atan2(left, 2 * GRAVITY)


@jit
def quaternion(yaw, pitch, roll):
    """wxyz of R = Rz(yaw) Ry(pitch) Rx(roll), body to world."""
    cy, sy = cos(0.5 * yaw), sin(0.5 * yaw)
    cp, sp = cos(0.5 * pitch), sin(0.5 * pitch)
    cr, sr = cos(0.5 * roll), sin(0.5 * roll)
    return (
        cy * cp * cr + sy * sp * sr,
        cy * cp * sr - sy * sp * cr,
        cy * sp * cr + sy * cp * sr,
        sy * cp * cr - cy * sp * sr,
    )
