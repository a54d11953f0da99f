"""What characters hold of the ground and of time, as the others see it.

A footprint holds its disc for its stance. The newest two hold theirs until further notice, since their owner may stand on
them as long as it likes; so whoever finds no room can stay where it is, and what all hold together never conflicts. The body
holds a disc that moves along its way: straight from the middle of one pair of feet to the next, then it rests there. Beyond
the rest lie the tentative middles: they hold nothing, but tell where the character means to go.

Characters lie in a grid by the place where they rest; it is sorted anew (by counting) when a tick plans.
"""

from math import floor, hypot, inf
from typing import NamedTuple

import numpy as np

from planner.stepping import timing
from worlds.compiled.jit import jit, jit_borrowing

FEET = 3
"""Footprints that may still be on the ground when a step planned now lands."""
COMMITTED, TENTATIVE = 3, 3
"""Points of a way: up to the rest, and beyond it."""
LAG = 0.12
"""How much later than a foot lands the body comes to the middle between the feet, in pendulum times: as measured."""
STRAY = 0.68
"""How far the com strays from its way, in step widths: more keeps bodies apart in a throng, less lets them through a gap."""
STRIDES = 6.0
"""How far one looks for others, in preferred steps beyond two bodies' radii."""


class Reservations(NamedTuple):
    """Of C characters; metres and seconds, world frame. Fixed size: nothing grows."""

    due: np.ndarray  # (C,) when the character must have planned its next footprint
    foot: np.ndarray  # (C, FEET, 3) x, y, until when the disc is held
    way: np.ndarray  # (C, COMMITTED + TENTATIVE, 3) x, y of the body's middle, when it is there
    aim: np.ndarray  # (C, 2) unit vector of the way that it would go if nobody were there; 0, 0 where it stays
    claim: np.ndarray  # (C, 3) velocity it would take if nobody of lower rank were there [m/s], its rank (right_of_way)
    foot_radius: np.ndarray  # (C,) half the sole's diagonal
    room: np.ndarray  # (C,) the body's radius, and how far the com strays from its way [m]
    reach: float  # how far one looks for others, at most the edge of a cell
    edge: float  # of a grid cell
    columns: int
    cell: np.ndarray  # (C,) in which the character rests
    start: np.ndarray  # (cells + 1,) where the characters of a cell begin in `order`
    order: np.ndarray  # (C,) characters by cell


def empty_reservations(bipeds: np.recarray, kind: np.ndarray, size: tuple[float, float]) -> Reservations:
    """Nothing held yet, by characters of these kinds (C,) in a world of this size [m]."""
    c = len(kind)
    reach = float((2 * bipeds["body_radius"] + STRIDES * bipeds["preferred_step"]).max())
    edge = max(reach, float(np.sqrt(size[0] * size[1] / (4 * c + 64))))
    columns, rows = (int(extent / edge) + 1 for extent in size)
    return Reservations(
        due=np.zeros(c),
        foot=np.zeros((c, FEET, 3)),
        way=np.zeros((c, COMMITTED + TENTATIVE, 3)),
        aim=np.zeros((c, 2)),
        claim=np.zeros((c, 3)),
        foot_radius=0.5 * np.hypot(bipeds["foot_length"], bipeds["foot_width"])[kind],
        room=(bipeds["body_radius"] + STRAY * bipeds["step_width"])[kind],
        reach=reach,
        edge=edge,
        columns=columns,
        cell=np.zeros(c, np.int64),
        start=np.zeros(columns * rows + 1, np.int64),
        order=np.zeros(c, np.int64),
    )


@jit_borrowing
def lag(b):
    """How much later than a foot lands the body comes to the middle of the two [s]."""
    return LAG * timing.pendulum_time(b)


@jit_borrowing
def sort_into_cells(r):
    """Puts every character into the cell in which it rests; ones outside the world go to the nearest cell."""
    rows = (len(r.start) - 1) // r.columns
    r.start[:] = 0
    for c in range(len(r.cell)):
        column = min(max(int(floor(r.way[c, COMMITTED - 1, 0] / r.edge)), 0), r.columns - 1)
        row = min(max(int(floor(r.way[c, COMMITTED - 1, 1] / r.edge)), 0), rows - 1)
        r.cell[c] = row * r.columns + column
        r.start[r.cell[c] + 1] += 1
    for k in range(1, len(r.start)):
        r.start[k] += r.start[k - 1]
    for c in range(len(r.cell) - 1, -1, -1):
        r.start[r.cell[c] + 1] -= 1
        r.order[r.start[r.cell[c] + 1]] = c
    for k in range(1, len(r.start) - 1):
        r.start[k] = r.start[k + 1]
    r.start[-1] = len(r.cell)


@jit_borrowing
def neighbours(r, c, reach, near):
    """Fills `near` with the characters that rest within `reach` [m] of where c does; returns how many, -1: too many."""
    rows, count = (len(r.start) - 1) // r.columns, 0
    x, y = r.way[c, COMMITTED - 1, 0], r.way[c, COMMITTED - 1, 1]
    row, column = r.cell[c] // r.columns, r.cell[c] % r.columns
    for i in range(max(row - 1, 0), min(row + 2, rows)):
        first, last = i * r.columns + max(column - 1, 0), i * r.columns + min(column + 1, r.columns - 1)
        for k in range(r.start[first], r.start[last + 1]):
            j = r.order[k]
            dx, dy = r.way[j, COMMITTED - 1, 0] - x, r.way[j, COMMITTED - 1, 1] - y
            if j != c and dx * dx + dy * dy < reach * reach:
                if count == len(near):
                    return -1
                near[count] = j
                count += 1
    return count


@jit_borrowing
def foot_is_free(r, j, x, y, radius, time):
    """Whether a sole's disc at x, y, set down at `time` for good, keeps off what j's feet hold."""
    apart = radius + r.foot_radius[j]
    for k in range(FEET):
        dx, dy = r.foot[j, k, 0] - x, r.foot[j, k, 1] - y
        if r.foot[j, k, 2] > time and dx * dx + dy * dy < apart * apart:
            return False
    return True


@jit_borrowing
def place_on_way(r, j, time, last):
    """(x, y) of j's middle at a time, resting at point `last` of its way from then on."""
    k = 0
    while k < last and r.way[j, k + 1, 2] < time:
        k += 1
    if k == last:
        return r.way[j, last, 0], r.way[j, last, 1]
    span = r.way[j, k + 1, 2] - r.way[j, k, 2]
    s = min(max((time - r.way[j, k, 2]) / span, 0.0), 1.0) if span > 0 else 1.0
    return (
        r.way[j, k, 0] + s * (r.way[j, k + 1, 0] - r.way[j, k, 0]),
        r.way[j, k, 1] + s * (r.way[j, k + 1, 1] - r.way[j, k, 1]),
    )


@jit_borrowing
def _nearest(px, py, qx, qy):
    """Distance of the origin from the line between two points."""
    dx, dy = qx - px, qy - py
    length2 = dx * dx + dy * dy
    s = min(max(-(px * dx + py * dy) / length2, 0.0), 1.0) if length2 > 0 else 0.0
    return hypot(px + s * dx, py + s * dy)


@jit_borrowing
def least_distance(r, j, x0, y0, t0, x1, y1, t1):
    """Least distance of a body from j's, from t0 on: it goes straight from x0, y0 at t0 to x1, y1 at t1 and rests there."""
    rest, least, t = COMMITTED - 1, inf, t0
    jx, jy = place_on_way(r, j, t0, rest)
    px, py = jx - x0, jy - y0
    while t < inf:
        until = t1 if t < t1 else inf
        for k in range(COMMITTED):
            if t < r.way[j, k, 2] < until:
                until = r.way[j, k, 2]
        s = min((until - t0) / (t1 - t0), 1.0)
        jx, jy = place_on_way(r, j, until, rest)
        qx, qy = jx - x0 - s * (x1 - x0), jy - y0 - s * (y1 - y0)
        least = min(least, _nearest(px, py, qx, qy))
        px, py, t = qx, qy, until
    return least


@jit
def without_neighbours(r, due):
    """Those of `due` before whom nobody of it within reach comes: first is who is due first, then the lower number.

    They plan at once without seeing each other, so they must be too far apart to come into each other's way.
    """
    waiting, near = np.zeros(len(r.due), np.bool_), np.empty(len(r.due), np.int64)
    for c in due:
        waiting[c] = True
    count, chosen = 0, np.empty_like(due)
    for c in due:
        if _comes_first(r, c, waiting, near[: neighbours(r, c, r.reach, near)]):
            chosen[count] = c
            count += 1
    return chosen[:count]


@jit_borrowing
def _comes_first(r, c, waiting, near):
    first = True
    for j in near:
        first &= not (waiting[j] and (r.due[j] < r.due[c] or (r.due[j] == r.due[c] and j < c)))
    return first
