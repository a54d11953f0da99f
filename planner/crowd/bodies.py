"""Bodies of a crowd: ellipses that turn, as deep and as wide as the character, and when two of them touch.

An ellipse of half axes (a, b), a along the unit vector f, extends k(n) = sqrt((a f.n)^2 + (b f x n)^2) in a direction n (its
support function). Two touch at rest where the line between their middles is as long as their radii along it, r = a b / sqrt((b
f.n)^2 + (a f x n)^2): exact for two that face alike, and within a few per cent otherwise (the contact distance of Chraibi,
Seyfried & Schadschneider 2010, generalized centrifugal force model).
"""

from math import hypot, inf, sqrt

from worlds.compiled.jit import jit_borrowing


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
