"""The body above the legs (paper, section 2.5): trunk and pelvis, as functions of time.

Everything reads the committed curve and the footprints. The body follows `trend`, the second difference of the com over a DELAY
(the acceleration under a triangle of that width): it lags as flesh does. The trunk leans over the leg that carries it (Winter
1995), into turns with the lateral trend, forward with speed, and nods with the vertical one. The pelvis turns with the legs and
drops toward the swinging one (motion.track.pelvis); the chest turns against it. The head: motion.pose.head.
"""

from math import atan2, cos, exp, sin, sqrt, tanh

import numpy as np

from motion.arithmetic.gravity import GRAVITY, pendulum_time
from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.track.curve import Curve, position_at
from worlds.compiled.jit import jit_borrowing

DELAY = 0.3
"""Width of the smoothing, in pendulum times of the nominal leg: more is calmer, and later."""
PAST = 9
"""Moments of the past that are looked at: enough for a tail of TAIL pieces, each a DELAY later."""
RECENT = 3
"""Those that the trunk follows."""
STANDS_BELOW = 0.06
"""Speed [m/s] below which one stands, about."""
BREATH, BREATHS = 0.012, 0.5
"""How far the chest pitches as one breathes [rad], and how fast, per pendulum time [rad]: a person some 15 times a minute."""
LOOKS_AROUND, LOOKS = 0.9, 0.21
"""How far one looks aside who stands [rad], and how fast, per pendulum time [rad]."""


@jit_borrowing
def delay(biped: Dimensions) -> float:
    """Seconds between the moments of the past."""
    return DELAY * pendulum_time(biped.leg.nominal_length)


@jit_borrowing
def past_of(biped: Dimensions, curve: Curve, t: float, past: np.ndarray) -> None:
    """Fills past (PAST, 3) with the com now and in the last moments; before the beginning it stood there.

    Only a tail looks further back than RECENT moments.
    """
    step = delay(biped)
    for k in range(PAST if biped.body.tail_length > 0 else RECENT):
        position_at(curve, max(t - k * step, curve.time[0]), past[k])


@jit_borrowing
def trend(biped: Dimensions, past: np.ndarray, k: int) -> Triple:
    """Smoothed acceleration (x, y, z) [m/s^2] about k + 1 delays ago."""
    step = delay(biped)
    scale = 1 / (step * step)
    return (
        scale * (past[k, 0] - 2 * past[k + 1, 0] + past[k + 2, 0]),
        scale * (past[k, 1] - 2 * past[k + 1, 1] + past[k + 2, 1]),
        scale * (past[k, 2] - 2 * past[k + 1, 2] + past[k + 2, 2]),
    )


@jit_borrowing
def speed_ahead(biped: Dimensions, past: np.ndarray, yaw: float) -> float:
    """Smoothed speed along the heading [m/s]."""
    return (cos(yaw) * (past[0, 0] - past[2, 0]) + sin(yaw) * (past[0, 1] - past[2, 1])) / (2 * delay(biped))


@jit_borrowing
def pace(biped: Dimensions, past: np.ndarray, yaw: float) -> float:
    """Speed along the heading as a share of sqrt(g h): about 0.45 walking, 1 at a run."""
    return speed_ahead(biped, past, yaw) / sqrt(GRAVITY * biped.timing.hip_height)


@jit_borrowing
def pitch_and_roll(biped: Dimensions, past: np.ndarray, yaw: float, weight: float) -> tuple[float, float]:
    """(pitch, roll) [rad] of the trunk; pitch is positive nose down. weight: over which leg it leans (pelvis.weight_at)."""
    body, c, s = biped.body, cos(yaw), sin(yaw)
    x, y, z = trend(biped, past, 0)
    forward, left, up = c * x + s * y, c * y - s * x, tanh(z / GRAVITY)
    nod = body.pitch_amplitude * (tanh(forward / 2.0) - 0.5 * up)
    lean = body.lean_speed * 1.5 * tanh(pace(biped, past, yaw) / 1.5)
    return nod + lean, -body.roll_amplitude * weight - body.lean_gain * atan2(left, 2 * GRAVITY)


@jit_borrowing
def idleness(biped: Dimensions, past: np.ndarray) -> float:
    """1 for who stands, 0 walking, smooth between: by the speed of the last moments."""
    x, y, z = past[0, 0] - past[2, 0], past[0, 1] - past[2, 1], past[0, 2] - past[2, 2]
    speed = sqrt(x * x + y * y + z * z) / (2 * delay(biped))
    return exp(-((speed / STANDS_BELOW) ** 2))


@jit_borrowing
def idle_life(biped: Dimensions, past: np.ndarray, t: float) -> tuple[float, float]:
    """(breath, gaze aside) [rad] of who stands, a function of time: the chest rises and falls, the eyes look around.

    Where one stands tells when, so that a crowd does not breathe in step.
    """
    still = idleness(biped, past)
    if still < 1e-6:
        return 0.0, 0.0
    unit = pendulum_time(biped.leg.nominal_length)
    u, own = t / unit, 7.0 * past[0, 0] + 5.0 * past[0, 1]
    slow = 0.6 * sin(LOOKS * u + own) + 0.4 * sin(1.83 * LOOKS * u + 2.1 * own)
    return still * BREATH * sin(BREATHS * u + own), still * LOOKS_AROUND * slow * slow * slow
