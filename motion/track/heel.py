"""The heel of a standing foot rises further where the leg to it would be too long: on steep ground, and in tight turns.

The ball B stays, and the ankle A turns about it in the foot's own plane until its distance from the hip H is the length T that
the leg may have. With a = A - B, of length r, and h, of length m, what of H - B lies in that plane, |H - A|^2 = T^2 says

    cos(psi) = (|H - B|^2 + r^2 - T^2) / (2 r m)

for the angle psi between them. The heel rises, it never sinks: of both solutions the one on whose way the heel goes up.
"""

from math import acos, atan2, cos, exp, hypot, sin

from motion.arithmetic.triples import Triple, dot, minus, norm, plus, times, unit
from worlds.compiled.jit import jit_borrowing, jit_inline

BEYOND, AT_MOST = 1.004, 1.008
"""Shares of its full length beyond which a standing leg draws its heel up, and beyond which it never is while that can rise."""
HIGHEST = 0.7
"""The heel rises by no more than this for it [rad]."""


@jit_borrowing
def _rise(ankle: Triple, hip: Triple, forward: Triple, up: Triple, length: float) -> float:
    """How far the heel rises [rad] so that ankle and hip, both from the ball, are so far apart [m]; 0 where that is no rise."""
    ax, ay, hx, hy = dot(ankle, forward), dot(ankle, up), dot(hip, forward), dot(hip, up)
    r, m = hypot(ax, ay), hypot(hx, hy)
    cosine = (dot(hip, hip) + r * r - length * length) / max(2 * r * m, 1e-9)
    between = acos(min(max(cosine, -1.0), 1.0))
    return min(max(atan2(ay, ax) - atan2(hy, hx) - between, 0.0), HIGHEST)


@jit_inline
def _turned(point: Triple, forward: Triple, up: Triple, rise: float) -> Triple:
    """A point of the foot, from the ball, once the heel has risen [rad]."""
    x, y = dot(point, forward), dot(point, up)
    return plus(times(cos(rise) * x + sin(rise) * y, forward), times(cos(rise) * y - sin(rise) * x, up))


@jit_borrowing
def kept_in_reach(ball: Triple, heel: Triple, ankle: Triple, hip: Triple, full: float) -> tuple[Triple, Triple]:
    """(heel, ankle) of a foot whose ball is on the ground, the heel raised until its leg is no longer than `full` [m]."""
    to_heel, to_ankle, to_hip = minus(heel, ball), minus(ankle, ball), minus(hip, ball)
    length, soft = norm(minus(to_hip, to_ankle)), (AT_MOST - BEYOND) * full
    if length <= BEYOND * full:
        return heel, ankle
    forward = unit(times(-1.0, to_heel))
    up = unit(minus(to_ankle, times(dot(to_ankle, forward), forward)))
    allowed = BEYOND * full + soft * (1 - exp((BEYOND * full - length) / soft))
    rise = _rise(to_ankle, to_hip, forward, up, allowed)
    return plus(ball, _turned(to_heel, forward, up, rise)), plus(ball, _turned(to_ankle, forward, up, rise))
