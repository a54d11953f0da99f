"""The point nearest to a wish within half-planes and a disc: a linear program in two dimensions, line by line (de Berg et al.,
Computational Geometry, chapter 4; van den Berg, Guy, Lin & Manocha 2011, as RVO2 does it).

A half-plane is a row of four numbers: a point of its border, and the border's unit vector, to the left of which it lies.
"""

from math import hypot, sqrt

import numpy as np

from worlds.compiled.jit import jit_borrowing

PARALLEL = 1e-5
"""Borders whose sine is no more than this are parallel."""
Place = tuple[float, float]


@jit_borrowing
def _breach(plane: np.ndarray, x: float, y: float) -> float:
    """How far a point lies outside a half-plane; negative: inside."""
    return plane[2] * (plane[1] - y) - plane[3] * (plane[0] - x)


@jit_borrowing
def _on_border(planes: np.ndarray, k: int, radius: float, wish: Place, far: bool) -> tuple[bool, float, float]:
    """The best point on border k within the disc and the half-planes before it; false: there is none."""
    px, py, dx, dy = planes[k, 0], planes[k, 1], planes[k, 2], planes[k, 3]
    along = px * dx + py * dy
    square = along * along + radius * radius - px * px - py * py
    if square < 0:
        return False, 0.0, 0.0
    low, high = -along - sqrt(square), -along + sqrt(square)
    for i in range(k):
        sine, out = dx * planes[i, 3] - dy * planes[i, 2], _breach(planes[i], px, py)
        if abs(sine) <= PARALLEL:
            if out > 0:
                return False, 0.0, 0.0
        elif sine > 0:
            high = min(high, -out / sine)
        else:
            low = max(low, -out / sine)
        if low > high:
            return False, 0.0, 0.0
    toward = wish[0] * dx + wish[1] * dy
    t = (high if toward > 0 else low) if far else min(max(toward - along, low), high)
    return True, px + t * dx, py + t * dy


@jit_borrowing
def _nearest(planes: np.ndarray, radius: float, wish: Place, far: bool) -> tuple[int, float, float]:
    """The point of the disc about the origin and of all K half-planes (K, 4) that is nearest to the wish, or furthest in its
    direction, a unit vector; and K, or the first half-plane that leaves none, and the point of those before it."""
    size = 1.0 if far else max(hypot(wish[0], wish[1]) / radius, 1.0)
    x, y = wish[0] * (radius if far else 1 / size), wish[1] * (radius if far else 1 / size)
    for k in range(len(planes)):
        if _breach(planes[k], x, y) > 0:
            found, u, v = _on_border(planes, k, radius, wish, far)
            if not found:
                return k, x, y
            x, y = u, v
    return len(planes), x, y


@jit_borrowing
def _least_breach(planes: np.ndarray, first: int, radius: float, at: Place, room: np.ndarray) -> Place:
    """The point of the disc that lies least far outside of the half-plane that it is furthest outside of (a program in three
    dimensions); `first` and `at`: what `_nearest` has found; room (K, 4) is to work in."""
    (x, y), least = at, 0.0
    for k in range(first, len(planes)):
        if _breach(planes[k], x, y) > least:
            px, py, dx, dy = planes[k, 0], planes[k, 1], planes[k, 2], planes[k, 3]
            count = 0
            for j in range(k):  # where this one is no worse than the one before it
                ex, ey = planes[j, 2], planes[j, 3]
                sine, apart = dx * ey - dy * ex, hypot(ex - dx, ey - dy)
                if abs(sine) > PARALLEL:
                    t = -_breach(planes[j], px, py) / sine
                    room[count, 0], room[count, 1] = px + t * dx, py + t * dy
                elif dx * ex + dy * ey > 0:
                    continue
                else:
                    room[count, 0], room[count, 1] = 0.5 * (px + planes[j, 0]), 0.5 * (py + planes[j, 1])
                room[count, 2], room[count, 3] = (ex - dx) / apart, (ey - dy) / apart
                count += 1
            done, u, v = _nearest(room[:count], radius, (-dy, dx), True)
            if done == count:  # else numbers are rounded, and it stays
                x, y = u, v
            least = _breach(planes[k], x, y)
    return x, y


@jit_borrowing
def best(planes: np.ndarray, radius: float, wish: Place, room: np.ndarray) -> Place:
    """The point of a disc about the origin and of half-planes (K, 4) that is nearest to a wish; where there is none, that of
    the disc which lies least far outside of the half-plane that it is furthest outside of. room (K, 4) is to work in."""
    k, x, y = _nearest(planes, radius, wish, False)
    return (x, y) if k == len(planes) else _least_breach(planes, k, radius, (x, y), room)
