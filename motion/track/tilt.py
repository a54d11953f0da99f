"""A standing foot tilts further where the leg to it would be too long, on steep ground and in tight turns: while the hip is
behind it the toes stay up, about the heel, and later the heel rises about the ball.

The pivot P stays, and the ankle A turns about it in the foot's own plane until its distance from the hip H is the length T that
the leg may have. With a = A - P, of length r, and h, of length m, what of H - P lies in that plane, |H - A|^2 = T^2 says

    cos(psi) = (|H - P|^2 + r^2 - T^2) / (2 r m)

for the angle psi between them. The sole's far end rises, it never sinks: of both solutions the one on whose way it goes up.
"""

from typing import NamedTuple

from motion.arithmetic.functions import angle, arc_cosine, exponential, turn
from motion.arithmetic.triples import Triple, dot, minus, norm, plus, times, unit
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, choose, larger, root, smaller

BEYOND, AT_MOST = 1.004, 1.008
"""Shares of its full length beyond which a standing leg tilts its foot, and beyond which it never is while that can tilt."""
STEEPEST = 0.7
"""The foot tilts by no more than this for it [rad]."""


class Tilt(NamedTuple):
    """How a foot tilts about a point that stays, its pivot."""

    pivot: Triple
    forward: Triple  # unit vector along the sole, from its far end to the pivot
    up: Triple  # unit vector off the sole
    by: Some  # [rad], the far end rises; 0: not


@jit_borrowing
def _angle(ankle: Triple, hip: Triple, forward: Triple, up: Triple, length: Some) -> Some:
    """How far the foot tilts [rad] so that ankle and hip, both from the pivot, are so far apart [m]; 0: that is no rise."""
    ax, ay, hx, hy = dot(ankle, forward), dot(ankle, up), dot(hip, forward), dot(hip, up)
    r2, m2 = ax * ax + ay * ay, hx * hx + hy * hy
    cosine = (dot(hip, hip) + r2 - length * length) / larger(2 * root(r2 * m2), 1e-9)
    between = arc_cosine(smaller(larger(cosine, -1.0), 1.0))
    return smaller(larger(angle(ax, ay) - angle(hx, hy) - between, 0.0), STEEPEST)


@jit_borrowing
def tilt_of(pivot: Triple, far: Triple, ankle: Triple, hip: Triple, full: Some) -> Tilt:
    """The tilt about a pivot on the ground, `far` the sole's other end, with which the leg is no longer than `full` [m]."""
    to_far, to_ankle, to_hip = minus(far, pivot), minus(ankle, pivot), minus(hip, pivot)
    length, free, soft = norm(minus(to_hip, to_ankle)), BEYOND * full, (AT_MOST - BEYOND) * full
    forward = unit(times(-1.0, to_far))
    up = unit(minus(to_ankle, times(dot(to_ankle, forward), forward)))
    allowed = free + soft * (1 - exponential((free - length) / soft))
    return Tilt(pivot, forward, up, choose(length > free, _angle(to_ankle, to_hip, forward, up, allowed), 0.0))


@jit_borrowing
def eased(tilt: Tilt, share: Some) -> Tilt:
    """A share of it."""
    return Tilt(tilt.pivot, tilt.forward, tilt.up, share * tilt.by)


@jit_inline
def tilted(tilt: Tilt, point: Triple) -> Triple:
    """Where a point of the foot is once it has tilted."""
    away, (c, s) = minus(point, tilt.pivot), turn(tilt.by)
    x, y = dot(away, tilt.forward), dot(away, tilt.up)
    by = plus(times((c - 1) * x + s * y, tilt.forward), times((c - 1) * y - s * x, tilt.up))
    return plus(point, by)
