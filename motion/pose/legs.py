"""Leg inverse kinematics on the virtual leg (paper, section 2.6).

Two links a, b between hip and ankle at distance d bend in a plane: the knee lies a cos(alpha) along the virtual leg and
a sin(alpha) off it, toward `pole`, with cos(alpha) = (a^2 + d^2 - b^2) / (2 a d). A leg of three links keeps its thigh
parallel to its metatarsus, as birds nearly do, which makes it a leg of two links: thigh + metatarsus, and shank. A foot
always stays on its footprint: a leg that is too short for it stretches, and `measure` counts that as overreach.
"""

from math import exp, sqrt

from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from worlds.compiled.jit import jit_borrowing

SOFT_FROM = 0.99
"""Share of full extension from which on the knee resists: without this its angle changes ever faster and pops."""


@jit_borrowing
def soft_stretch(share: float) -> float:
    """Stretch of the links at d = share of their length: with r = 1 - SOFT_FROM they bend as for SOFT_FROM + r (1 - exp(-x)),
    x = (share - SOFT_FROM) / r, which is never 1; at full extension they are 0.4 % longer."""
    if share <= SOFT_FROM:
        return 1.0
    room = 1 - SOFT_FROM
    return share / (SOFT_FROM + room * (1 - exp((SOFT_FROM - share) / room)))


@jit_borrowing
def _bend(upper: float, lower: float, hip: Triple, ankle: Triple, pole: Triple) -> tuple[Triple, Triple, float]:
    """Unit vectors of the first and second link, and the stretch that they need. pole need not be a unit vector."""
    x, y, z = ankle[0] - hip[0], ankle[1] - hip[1], ankle[2] - hip[2]
    d = max(sqrt(x * x + y * y + z * z), 1e-9)
    u = (x / d, y / d, z / d)
    along = pole[0] * u[0] + pole[1] * u[1] + pole[2] * u[2]
    px, py, pz = pole[0] - along * u[0], pole[1] - along * u[1], pole[2] - along * u[2]
    length = max(sqrt(px * px + py * py + pz * pz), 1e-9)
    stretch = soft_stretch(d / (upper + lower))
    a, b = upper * stretch, lower * stretch
    cosine = min(max((a * a + d * d - b * b) / (2 * a * d), -1.0), 1.0)
    sine = sqrt(1 - cosine * cosine)
    first = (
        cosine * u[0] + sine * px / length,
        cosine * u[1] + sine * py / length,
        cosine * u[2] + sine * pz / length,
    )
    second = ((x - a * first[0]) / b, (y - a * first[1]) / b, (z - a * first[2]) / b)
    return first, second, stretch


@jit_borrowing
def joints(biped: Dimensions, hip: Triple, ankle: Triple, pole: Triple) -> tuple[Triple, Triple]:
    """(knee, hock) of the leg from hip to ankle, the knee toward `pole`; a two-link leg's hock is its ankle."""
    leg = biped.leg
    first, second, stretch = _bend(leg.thigh + leg.metatarsus, leg.shank, hip, ankle, pole)
    thigh, shank = leg.thigh * stretch, leg.shank * stretch
    knee = (hip[0] + thigh * first[0], hip[1] + thigh * first[1], hip[2] + thigh * first[2])
    if leg.metatarsus == 0:
        return knee, ankle
    hock = (knee[0] + shank * second[0], knee[1] + shank * second[1], knee[2] + shank * second[2])
    return knee, hock
