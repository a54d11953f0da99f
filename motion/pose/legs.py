"""Leg inverse kinematics on the virtual leg (paper, section 2.6).

Two links a, b between hip and ankle at distance d bend in a plane: the knee lies a cos(alpha) along the virtual leg and
a sin(alpha) off it, forward, with cos(alpha) = (a^2 + d^2 - b^2) / (2 a d). A leg of three links carries its thigh forward
(Gatesy 1999: birds walk from the knee), and what is below the knee bends backward as two links. A foot always stays on its
footprint: a leg that is too short for it stretches, and `measure` counts that as overreach.
"""

from motion.arithmetic.functions import angle, arc_cosine, exponential, logarithm, turn
from motion.arithmetic.triples import Triple, cross, minus, norm, pick, plus, times, unit
from motion.characters.dimensions import Dimensions
from worlds.compiled.across import any_of, isnt
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, choose, larger, root, smaller

SOFT_FROM = 0.992
"""Share of full extension from which on the knee resists: without this its angle changes ever faster and pops."""
STRAIGHT, FOLDED = 0.985, 0.3
"""Shares of shank and metatarsus that the knee of a leg of three links may be from its ankle, at most and at least."""
SUDDEN = 1.3
"""A triangle that opens does so like a square root, at once: up to this angle [rad] between thigh and leg it begins gently."""
GRADUAL = 0.1
"""How gradually a thigh gives way to a leg that gets long [rad]."""


@jit_borrowing
def soft_stretch(share: Some) -> Some:
    """Stretch of the links at d = share of their length: with r = 1 - SOFT_FROM they bend as for SOFT_FROM + r (1 - exp(-x)),
    x = (share - SOFT_FROM) / r, which is never 1; at full extension they are 0.3 % longer."""
    room = 1 - SOFT_FROM
    return choose(share > SOFT_FROM, share / (SOFT_FROM + room * (1 - exponential((SOFT_FROM - share) / room))), 1.0)


@jit_borrowing
def _bend(upper: Some, lower: Some, hip: Triple, ankle: Triple, forward: Triple) -> tuple[Triple, Some]:
    """Unit vector of the first link, which bends `forward`, and the stretch that both need."""
    d, u = _way(hip, ankle)
    p = _pole(u, forward)
    stretch = soft_stretch(d / (upper + lower))
    a, b = upper * stretch, lower * stretch
    cosine = smaller(larger((a * a + d * d - b * b) / (2 * a * d), -1.0), 1.0)
    return _between(u, p, cosine, root(1 - cosine * cosine)), stretch


@jit_inline
def _way(start: Triple, end: Triple) -> tuple[Some, Triple]:
    """Length and unit vector of the way between two points."""
    way = minus(end, start)
    d = larger(norm(way), 1e-9)
    return d, times(1 / d, way)


@jit_inline
def _pole(u: Triple, forward: Triple) -> Triple:
    """Unit vector across a virtual leg u, in which knees bend: u x left, so forward of a leg that hangs, and below one that is
    kicked up behind, without a jump between."""
    return unit(cross(u, (-forward[1], forward[0], 0.0 * forward[0])))


@jit_inline
def _between(u: Triple, p: Triple, cosine: Some, sine: Some) -> Triple:
    return cosine * u[0] + sine * p[0], cosine * u[1] + sine * p[1], cosine * u[2] + sine * p[2]


@jit_borrowing
def joints(biped: Dimensions, hip: Triple, ankle: Triple, forward: Triple) -> tuple[Triple, Triple]:
    """(knee, hock) of the leg from hip to ankle whose knee bends `forward`, level; a two-link leg's hock is its ankle."""
    three = biped.leg.metatarsus > 0.0
    if not any_of(three):
        return _of_two(biped, hip, ankle, forward)
    knee, hock = _of_three(biped, hip, ankle, forward)
    if any_of(isnt(three)):
        other_knee, other_hock = _of_two(biped, hip, ankle, forward)
        knee, hock = pick(three, knee, other_knee), pick(three, hock, other_hock)
    return knee, hock


@jit_borrowing
def _of_two(biped: Dimensions, hip: Triple, ankle: Triple, forward: Triple) -> tuple[Triple, Triple]:
    first, stretch = _bend(biped.leg.thigh, biped.leg.shank, hip, ankle, forward)
    return plus(hip, times(biped.leg.thigh * stretch, first)), ankle


@jit_borrowing
def _of_three(biped: Dimensions, hip: Triple, ankle: Triple, forward: Triple) -> tuple[Triple, Triple]:
    knee = _knee_of_three(biped, hip, ankle, forward)
    lower, stretch = _bend(biped.leg.shank, biped.leg.metatarsus, knee, ankle, times(-1.0, forward))
    return knee, plus(knee, times(biped.leg.shank * stretch, lower))


@jit_borrowing
def _knee_of_three(biped: Dimensions, hip: Triple, ankle: Triple, forward: Triple) -> Triple:
    """Knee of a leg of three links, whose thigh is carried forward and hardly swings.

    With psi the angle in the leg's plane from the virtual leg to straight down, the thigh is femur - femur_swing * psi before
    straight down, so femur + (1 - femur_swing) psi before the virtual leg; less where shank and metatarsus would not reach:
    cos = (a^2 + d^2 - r^2) / (2 a d) with a the thigh, d the virtual leg, r what they reach.
    """
    leg, (d, u) = biped.leg, _way(hip, ankle)
    p = _pole(u, forward)
    wished = leg.femur + (1 - leg.femur_swing) * angle(-u[2], -p[2])
    most = _thigh_angle(leg.thigh, d, STRAIGHT * (leg.shank + leg.metatarsus))
    least = _gently(_thigh_angle(leg.thigh, d, FOLDED * (leg.shank + leg.metatarsus)))
    c, s = turn(least + _above_zero(most - _above_zero(most - wished) - least))
    return plus(hip, times(leg.thigh, _between(u, p, c, s)))


@jit_inline
def _gently(angle: Some) -> Some:
    """An angle, its own from SUDDEN on; below, with x = angle / SUDDEN, SUDDEN x^4 (2.5 - 1.5 x^2), smooth in x^2 at both."""
    square = angle * angle / (SUDDEN * SUDDEN)
    return choose(square < 1.0, SUDDEN * square * square * (2.5 - 1.5 * square), angle)


@jit_inline
def _above_zero(x: Some) -> Some:
    """max(x, 0), but smooth over GRADUAL."""
    return GRADUAL * logarithm(1 + exponential(-abs(x) / GRADUAL)) + larger(x, 0.0)


@jit_borrowing
def _thigh_angle(thigh: Some, d: Some, rest: Some) -> Some:
    """Angle [rad] between a thigh and the virtual leg of length d whose knee is `rest` from the ankle."""
    return arc_cosine(smaller(larger((thigh * thigh + d * d - rest * rest) / (2 * thigh * d), -1.0), 1.0))
