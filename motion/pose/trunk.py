"""The body above the legs (paper, section 2.5): trunk and pelvis, as functions of time.

Everything reads the committed curve and the footprints. The body follows `trend`, the second difference of the com over a DELAY
(the acceleration under a triangle of that width): it lags as flesh does. The trunk leans over the leg that carries it (Winter
1995), into turns with the lateral trend, forward with speed, and nods with the vertical one. The pelvis turns with the legs and
drops toward the swinging one (motion.track.pelvis); the chest turns against it. The head: motion.pose.head.
"""

from typing import NamedTuple

from motion.arithmetic.functions import angle, exponential, levelled, turn
from motion.arithmetic.gravity import GRAVITY, pendulum_time
from motion.arithmetic.triples import Triple, minus, norm, times
from motion.characters.dimensions import Dimensions
from motion.track.curve import Curve, place_at
from worlds.compiled.across import any_of
from worlds.compiled.jit import jit_borrowing
from worlds.compiled.lanes import Some, choose, larger, root

DELAY = 0.3
"""Width of the smoothing, in pendulum times of the nominal leg: more is calmer, and later."""
STANDS_BELOW = 0.06
"""Speed [m/s] below which one stands, about."""
BREATH, BREATHS = 0.012, 0.5
"""How far the chest pitches as one breathes [rad], and how fast, per pendulum time [rad]: a person some 15 times a minute."""
LOOKS_AROUND, LOOKS = 0.9, 0.21
"""How far one looks aside who stands [rad], and how fast, per pendulum time [rad]."""


class Past(NamedTuple):
    """Where the com was of late, a delay apart."""

    now: Triple
    before: Triple
    long_before: Triple


@jit_borrowing
def delay(biped: Dimensions) -> Some:
    """Seconds between the moments of the past."""
    return DELAY * pendulum_time(biped.leg.nominal_length)


@jit_borrowing
def place_before(biped: Dimensions, curve: Curve, t: Some, k: int) -> Triple:
    """The com k delays ago; before the beginning it stood there."""
    return place_at(curve, larger(t - k * delay(biped), curve.time[0]))


@jit_borrowing
def past_of(biped: Dimensions, curve: Curve, com: Triple, t: Some) -> Past:
    """Of a com that is there now."""
    return Past(com, place_before(biped, curve, t, 1), place_before(biped, curve, t, 2))


@jit_borrowing
def trend(biped: Dimensions, past: Past) -> Triple:
    """Smoothed acceleration (x, y, z) [m/s^2] about a delay ago."""
    step, (a, b, c) = delay(biped), past
    return times(1 / (step * step), (a[0] - 2 * b[0] + c[0], a[1] - 2 * b[1] + c[1], a[2] - 2 * b[2] + c[2]))


@jit_borrowing
def pace(biped: Dimensions, past: Past, toward: tuple[Some, Some]) -> Some:
    """Smoothed speed as a share of sqrt(g h): about 0.45 walking, 1 at a run; toward: cosine and sine of the heading."""
    way = minus(past.now, past.long_before)
    speed = (toward[0] * way[0] + toward[1] * way[1]) / (2 * delay(biped))
    return speed / root(GRAVITY * biped.timing.hip_height)


@jit_borrowing
def pitch_and_roll(biped: Dimensions, past: Past, toward: tuple[Some, Some], weight: Some) -> tuple[Some, Some]:
    """(pitch, roll) [rad] of the trunk; pitch is positive nose down. weight: over which leg it leans (pelvis.weight_at)."""
    body, (c, s) = biped.body, toward
    x, y, z = trend(biped, past)
    forward, left, up = c * x + s * y, c * y - s * x, levelled(z / GRAVITY)
    nod = body.pitch_amplitude * (levelled(forward / 2.0) - 0.5 * up)
    lean = body.lean_speed * 1.5 * levelled(pace(biped, past, toward) / 1.5)
    return nod + lean, -body.roll_amplitude * weight - body.lean_gain * angle(2 * GRAVITY + 0.0 * left, left)


@jit_borrowing
def idleness(biped: Dimensions, past: Past) -> Some:
    """1 for who stands, 0 walking, smooth between: by the speed of the last moments."""
    share = norm(minus(past.now, past.long_before)) / (2 * delay(biped) * STANDS_BELOW)
    return exponential(-share * share)


@jit_borrowing
def idle_life(biped: Dimensions, past: Past, t: Some) -> tuple[Some, Some]:
    """(breath, gaze aside) [rad] of who stands, a function of time: the chest rises and falls, the eyes look around.

    Where one stands tells when, so that a crowd does not breathe in step.
    """
    still = idleness(biped, past)
    still = choose(still < 1e-6, 0.0, still)
    if not any_of(still > 0.0):
        return still, still
    u, own = t / pendulum_time(biped.leg.nominal_length), 7.0 * past.now[0] + 5.0 * past.now[1]
    (_, a), (_, b), (_, c) = turn(LOOKS * u + own), turn(1.83 * LOOKS * u + 2.1 * own), turn(BREATHS * u + own)
    slow = 0.6 * a + 0.4 * b
    return still * BREATH * c, still * LOOKS_AROUND * slow * slow * slow
