"""Bodies of a crowd: ellipses that turn, as deep and as wide as the character, and when two of them touch.

An ellipse of half axes (a, b), a along the unit vector f, extends k(n) = sqrt((a f.n)^2 + (b f x n)^2) in a direction n (its
support function). Two touch at rest where the line between their middles is as long as their radii along it, r = a b / sqrt((b
f.n)^2 + (a f x n)^2): exact for two that face alike, and within a few per cent otherwise (the contact distance of Chraibi,
Seyfried & Schadschneider 2010, generalized centrifugal force model).
"""

from math import atan2, cos, hypot, inf, sin, sqrt
from typing import NamedTuple

from worlds.compiled.jit import jit_borrowing

Place = tuple[float, float]
SPREAD, PACE = 4, 0.15
"""Where two bodies lie deepest in each other is looked for in so many directions to either side of the line between their
middles, so far from each other [rad]."""


@jit_borrowing
def extent(half: tuple[float, float], face: tuple[float, float], nx: float, ny: float) -> float:
    """How far an ellipse of half axes `half` [m] that faces `face` extends in the direction of a unit vector [m]."""
    ahead, aside = half[0] * (face[0] * nx + face[1] * ny), half[1] * (face[0] * ny - face[1] * nx)
    return sqrt(ahead * ahead + aside * aside)


@jit_borrowing
def radius(half: tuple[float, float], face: tuple[float, float], nx: float, ny: float) -> float:
    """Radius of that ellipse in the direction of a unit vector [m]."""
    along, across = half[1] * (face[0] * nx + face[1] * ny), half[0] * (face[0] * ny - face[1] * nx)
    return half[0] * half[1] / sqrt(along * along + across * across)


@jit_borrowing
def way_to_touch(px: float, py: float, dx: float, dy: float, deep: float, wide: float) -> float:
    """How far one can go in the direction of a unit vector d before one touches another at p [m]; inf: one passes it by.

    deep and wide: the extents of both together along d and across it. Negative: they touch already.
    """
    along, aside = px * dx + py * dy, abs(px * dy - py * dx)
    if along <= 0 or aside >= wide:
        return inf
    return along - deep * sqrt(1 - (aside / wide) ** 2)


@jit_borrowing
def gap_between(
    half: tuple[float, float], face: tuple[float, float], half2: tuple[float, float], face2: tuple[float, float],
    px: float, py: float,
) -> float:  # fmt: skip
    """The gap between two ellipses whose middles are p apart, on the line between the middles [m]; negative: they overlap."""
    far = hypot(px, py)
    if far == 0:
        return -half[0] - half2[0]
    return far - radius(half, face, px / far, py / far) - radius(half2, face2, px / far, py / far)


class Press(NamedTuple):
    """How two ellipses touch."""

    deep: float  # how far one must move at least until they only touch [m]; negative: that they are apart by at least so much
    x: float  # from the first to the second, where they lie deepest in each other, or are nearest: a unit vector
    y: float


@jit_borrowing
def press_between(half: Place, face: Place, half2: Place, face2: Place, px: float, py: float) -> Press:
    """How two ellipses touch whose middles are p apart [m].

    Convex bodies are as far apart, or as deep in each other, as the most that is between their support lines over all
    directions. For bodies that just touch it lies near the line between the middles: it is looked for in steps about that, and
    then by a parabola.
    """
    apart, course, best, k = (px, py), atan2(py, px), -inf, 0
    for i in range(-SPREAD, SPREAD + 1):
        gap = _gap_along(half, face, half2, face2, apart, course + i * PACE)
        if gap > best:
            best, k = gap, i
    before = _gap_along(half, face, half2, face2, apart, course + (k - 1) * PACE)
    after = _gap_along(half, face, half2, face2, apart, course + (k + 1) * PACE)
    bend = 2 * best - before - after
    course += PACE * (k + (0.5 * (after - before) / bend if bend > 0 else 0.0))
    return Press(-_gap_along(half, face, half2, face2, apart, course), cos(course), sin(course))


@jit_borrowing
def _gap_along(half: Place, face: Place, half2: Place, face2: Place, apart: Place, course: float) -> float:
    """What is between the support lines of two ellipses across a course [m]."""
    nx, ny = cos(course), sin(course)
    return apart[0] * nx + apart[1] * ny - extent(half, face, nx, ny) - extent(half2, face2, nx, ny)
