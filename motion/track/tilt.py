"""A standing foot tilts further where the leg to it would be too long, on steep ground and in tight turns: while the hip is
behind it the toes stay up, about the heel, and later the heel rises about the ball.

The pivot P stays, and the ankle A turns about it in the foot's own plane until its distance from the hip H is the length T that
the leg may have. With a = A - P, of length r, and h, of length m, what of H - P lies in that plane, |H - A|^2 = T^2 says

    cos(psi) = (|H - P|^2 + r^2 - T^2) / (2 r m)

for the angle psi between them. The sole's far end rises, it never sinks: of both solutions the one on whose way it goes up.
"""

from math import acos, atan2, cos, exp, hypot, sin
from typing import NamedTuple

from motion.arithmetic.triples import Triple, dot, minus, norm, plus, times, unit
from worlds.compiled.jit import jit_borrowing, jit_inline

BEYOND, AT_MOST = 1.004, 1.008
"""Shares of its full length beyond which a standing leg tilts its foot, and beyond which it never is while that can tilt."""
STEEPEST = 0.7
"""The foot tilts by no more than this for it [rad]."""


class Tilt(NamedTuple):
    """How a foot tilts about a point that stays, its pivot; one that does not (by = 0) has no axes."""

    pivot: Triple
    forward: Triple  # unit vector along the sole, from its far end to the pivot
    up: Triple  # unit vector off the sole
    by: float  # [rad], the far end rises; 0: not


@jit_borrowing
def _angle(ankle: Triple, hip: Triple, forward: Triple, up: Triple, length: float) -> float:
    """How far the foot tilts [rad] so that ankle and hip, both from the pivot, are so far apart [m]; 0: that is no rise."""
    ax, ay, hx, hy = dot(ankle, forward), dot(ankle, up), dot(hip, forward), dot(hip, up)
    r, m = hypot(ax, ay), hypot(hx, hy)
    cosine = (dot(hip, hip) + r * r - length * length) / max(2 * r * m, 1e-9)
    between = acos(min(max(cosine, -1.0), 1.0))
    return min(max(atan2(ay, ax) - atan2(hy, hx) - between, 0.0), STEEPEST)


@jit_borrowing
def tilt_of(pivot: Triple, far: Triple, ankle: Triple, hip: Triple, full: float) -> Tilt:
    """The tilt about a pivot on the ground, `far` the sole's other end, with which the leg is no longer than `full` [m]."""
    to_far, to_ankle, to_hip = minus(far, pivot), minus(ankle, pivot), minus(hip, pivot)
    length, soft = norm(minus(to_hip, to_ankle)), (AT_MOST - BEYOND) * full
    if length <= BEYOND * full:
        return Tilt(pivot, to_far, to_ankle, 0.0)
    forward = unit(times(-1.0, to_far))
    up = unit(minus(to_ankle, times(dot(to_ankle, forward), forward)))
    allowed = BEYOND * full + soft * (1 - exp((BEYOND * full - length) / soft))
    return Tilt(pivot, forward, up, _angle(to_ankle, to_hip, forward, up, allowed))


@jit_borrowing
def eased(tilt: Tilt, share: float) -> Tilt:
    """A share of it."""
    return Tilt(tilt.pivot, tilt.forward, tilt.up, share * tilt.by)


@jit_inline
def tilted(tilt: Tilt, point: Triple) -> Triple:
    """Where a point of the foot is once it has tilted."""
    away, c, s = minus(point, tilt.pivot), cos(tilt.by), sin(tilt.by)
    x, y = dot(away, tilt.forward), dot(away, tilt.up)
    return plus(tilt.pivot, plus(times(c * x + s * y, tilt.forward), times(c * y - s * x, tilt.up)))
