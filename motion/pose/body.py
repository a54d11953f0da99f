"""The body above the legs (paper, section 2.5): trunk, pelvis, neck and head, as functions of time.

Everything reads the committed curve and the footprints. Accelerations of the curve jump where phases change, so the body
follows `trend`, the second difference of the com over a DELAY (the acceleration under a triangle of that width): it is
continuous, and lags as flesh does. The trunk leans over the leg that carries it, into turns with the lateral trend, forward
with speed, and nods with the vertical one. The pelvis turns with the legs and drops toward the swinging one; the chest
turns against it; the head looks where the feet will go and takes part in the trunk's pitch and roll as little as it likes.
"""

from math import atan2, cos, sin, sqrt

import numpy as np

from motion.track import heading, spline
from worlds.compiled.jit import jit_borrowing

GRAVITY = 9.81
DELAY = 0.3
"""Width of the smoothing, in pendulum times sqrt(l / g): more is calmer, and later."""
PAST = 9
"""Moments of the past that are looked at: enough for a tail of TAIL pieces, each a DELAY later."""
RECENT = 3
"""Those that the trunk follows."""
LOOKS_ASIDE = 1.0
"""Largest turn of the head against the body [rad]."""
HELD = 0.62
"""Share of a step in which a bobbing head stays in place."""


@jit_borrowing
def delay(b):
    """Seconds between the moments of the past."""
    return DELAY * sqrt(b.nominal_length / GRAVITY)


@jit_borrowing
def past_of(b, curve_time, control, t, past):
    """Fills past (PAST, 3) with the com now and in the last moments; before the beginning it stood there.

    Only a tail looks further back than RECENT moments.
    """
    step = delay(b)
    for k in range(PAST if b.tail_length > 0 else RECENT):
        spline.position_at(curve_time, control, max(t - k * step, curve_time[0]), past[k])


@jit_borrowing
def trend(b, past, k):
    """Smoothed acceleration (x, y, z) [m/s^2] about k + 1 delays ago."""
    step = delay(b)
    scale = 1 / (step * step)
    return (
        scale * (past[k, 0] - 2 * past[k + 1, 0] + past[k + 2, 0]),
        scale * (past[k, 1] - 2 * past[k + 1, 1] + past[k + 2, 1]),
        scale * (past[k, 2] - 2 * past[k + 1, 2] + past[k + 2, 2]),
    )


@jit_borrowing
def speed_ahead(b, past, yaw):
    """Smoothed speed along the heading [m/s]."""
    return (cos(yaw) * (past[0, 0] - past[2, 0]) + sin(yaw) * (past[0, 1] - past[2, 1])) / (2 * delay(b))


@jit_borrowing
def pace(b, past, yaw):
    """Speed along the heading as a share of sqrt(g h): about 0.45 walking, 1 at a run."""
    return speed_ahead(b, past, yaw) / sqrt(GRAVITY * b.hip_height)


@jit_borrowing
def pitch_and_roll(b, past, yaw):
    """(pitch, roll) [rad] of the trunk; pitch is positive nose down."""
    c, s = cos(yaw), sin(yaw)
    x, y, z = trend(b, past, 0)
    forward, left, up = c * x + s * y, c * y - s * x, min(max(z / GRAVITY, -1.0), 1.0)
    nod = b.pitch_amplitude * (min(max(forward / 2.0, -1.0), 1.0) - 0.5 * up)
    sway = b.roll_amplitude * min(max(left / 1.5, -1.0), 1.0)
    lean = b.lean_speed * min(max(pace(b, past, yaw), -0.5), 1.5)
    return nod + lean, -sway - b.lean_gain * atan2(left, 2 * GRAVITY)


@jit_borrowing
def head_offset(b, track, past, yaw, t):
    """How far a bobbing head is ahead of its middle place [m]: it stays where it is while the body walks on, then darts."""
    if b.head_bob == 0:
        return 0.0
    i = max(np.searchsorted(track.contact_time, t, side="right") - 1, 0)
    u = min(max((t - track.contact_time[i]) / max(track.step_time[i], 1e-3), 0.0), 1.0)
    rest = 0.5 * HELD
    if u < rest:
        share = -u
    elif u > 1 - rest:
        share = 1 - u
    else:
        x = (u - rest) / (1 - HELD)
        share = HELD * (x * x * (3 - 2 * x) - 0.5)
    return (
        b.head_bob * share * min(max(speed_ahead(b, past, yaw) * track.step_time[i], -0.6 * b.hip_height), 0.6 * b.hip_height)
    )


@jit_borrowing
def gaze(b, track, yaw, t):
    """Heading of the head [rad]: where the feet are going, before the body does."""
    ahead = heading.mean_heading(track, t, 0.4 * heading.window_length(b))
    return yaw + min(max(ahead - yaw, -LOOKS_ASIDE), LOOKS_ASIDE)


@jit_borrowing
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


@jit_borrowing
def axes(yaw, pitch, roll):
    """(forward, left, up), each (3,) in the world, of a body turned by R = Rz(yaw) Ry(pitch) Rx(roll)."""
    return (
        turned(yaw, pitch, roll, 1.0, 0.0, 0.0),
        turned(yaw, pitch, roll, 0.0, 1.0, 0.0),
        turned(yaw, pitch, roll, 0.0, 0.0, 1.0),
    )


@jit_borrowing
def along(axes, forward, left, up):
    """The vector (forward, left, up) of a body with these axes, in the world."""
    f, s, u = axes
    return (
        forward * f[0] + left * s[0] + up * u[0],
        forward * f[1] + left * s[1] + up * u[1],
        forward * f[2] + left * s[2] + up * u[2],
    )


@jit_borrowing
def turned(yaw, pitch, roll, forward, left, up):
    """The vector (forward, left, up) of a body turned by R = Rz(yaw) Ry(pitch) Rx(roll), in the world."""
    y, z = cos(roll) * left - sin(roll) * up, sin(roll) * left + cos(roll) * up
    x, z = cos(pitch) * forward + sin(pitch) * z, cos(pitch) * z - sin(pitch) * forward
    return cos(yaw) * x - sin(yaw) * y, sin(yaw) * x + cos(yaw) * y, z
