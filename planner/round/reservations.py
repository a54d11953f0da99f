"""What characters hold of the ground and of time, as the others see it.

A footprint holds its sole for its stance: a capsule, as long and as wide as the foot. The newest two hold theirs until further
notice, since their owner may stand on them as long as it likes; so whoever finds no room can stay where it is, and what all
hold together never conflicts. The body holds an ellipse, facing where its feet do, that moves along its path: straight from the
middle of one pair of feet to the next, then it rests there.

Characters lie in a grid by the place where they rest; it is sorted anew (by counting) when a tick plans.
"""

from math import floor, hypot, inf
from typing import Any, NamedTuple

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from motion.characters.dimensions import Dimensions
from planner.round.soles import Sole, soles, soles_apart
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.tables import Integers, Numbers, Pairs

FEET = 3
"""Footprints that may still be on the ground when a step planned now lands."""
COMMITTED, TENTATIVE = 3, 3
"""Points of a path: up to the rest, and beyond it."""
LAG = 0.12
"""How much later than a foot lands the body comes to the middle between the feet, in pendulum times: as measured."""
AHEAD, STRAY = 0.2, 0.2
"""How far the com strays from its path, along it in radii of the body and across it in step widths: more keeps bodies apart in
a throng, less lets them through a gap."""
ROOM = 0.68
"""The same for discs, in step widths."""
STRIDES = 6.0
"""How far one looks for others, in preferred steps beyond two bodies' radii."""


class Reservations(NamedTuple):
    """Of C characters; metres and seconds, world frame. Fixed size: nothing grows."""

    due: np.ndarray  # (C,) when the character must have planned its next footprint
    foot: np.ndarray  # (C, FEET, 5) x, y, unit vector of the heading, until when the sole is held [s]
    path: np.ndarray  # (C, COMMITTED + TENTATIVE, 3) x, y of the body's middle, when it is there [s]
    aim: np.ndarray  # (C, 2) unit vector of the course that it would take if nobody were there; 0, 0 where it stays
    rank: np.ndarray  # (C,) how many steps others have kept it, or one whose claim it is in the way of, from getting on
    since: np.ndarray  # (C,) since when it has been about where it is [s]
    face: np.ndarray  # (C, 2) unit vector in which the body faces at rest
    claim: np.ndarray  # (C, 2) where the body would rest next if nobody of lower rank were there [m]
    sole: np.ndarray  # (C, 2) half the length of the line in the middle of a sole, and the radius around it [m]
    room: np.ndarray  # (C,) radius of a disc with all of the body, however it turns and strays [m]: for those who cross in file
    half: np.ndarray  # (C, 2) half the body's depth and width, and how far the com strays from its path [m]
    reach: float  # how far one looks for others, at most the edge of a cell
    edge: float  # of a grid cell
    columns: int
    cell: np.ndarray  # (C,) in which the character rests
    start: np.ndarray  # (cells + 1,) where the characters of a cell begin in `order`
    order: np.ndarray  # (C,) characters by cell


class Intents(NamedTuple):
    """What C characters have decided, and the others do not see yet; a planner writes the row of its own character only."""

    aim: Pairs  # (C, 2) as Reservations
    ahead: Pairs  # (C, 2) unit vector to where its way leads some steps on, of those whose planner tells; 0, 0: of the others
    claim: Pairs  # (C, 2) as Reservations
    rank: Numbers  # (C,) as Reservations
    since: Numbers  # (C,) as Reservations
    about: Pairs  # (C, 2) where it has been since then [m]
    hindered: Integers  # (C,) steps that others kept from getting on
    stood: Integers  # (C,) how often, of late, others left it nothing but to stand


def empty_reservations(bipeds: Any, kind: np.ndarray, size: tuple[float, float], looks: float = 0.0) -> Reservations:
    """Nothing held yet, by characters of these kinds (C,), rows of `bipeds`, in a world of this size [m].

    looks: at least so far they look for others [m].
    """
    c = len(kind)
    reach = max(float((2 * bipeds["body"]["radius"] + STRIDES * bipeds["gait"]["preferred_step"]).max()), looks)
    edge = max(reach, float(np.sqrt(size[0] * size[1] / (4 * c + 64))))
    columns, rows = (int(extent / edge) + 1 for extent in size)
    return Reservations(
        due=np.zeros(c),
        foot=np.zeros((c, FEET, 5)),
        path=np.zeros((c, COMMITTED + TENTATIVE, 3)),
        aim=np.zeros((c, 2)),
        rank=np.zeros(c),
        since=np.zeros(c),
        face=np.tile([1.0, 0.0], (c, 1)),
        claim=np.zeros((c, 2)),
        sole=soles(bipeds)[kind],
        room=(bipeds["body"]["radius"] + ROOM * bipeds["gait"]["step_width"])[kind],
        half=halves(bipeds)[kind],
        reach=reach,
        edge=edge,
        columns=columns,
        cell=np.zeros(c, np.int64),
        start=np.zeros(columns * rows + 1, np.int64),
        order=np.zeros(c, np.int64),
    )


def body_sizes(bipeds: Any) -> np.ndarray:
    """(K, 2) depth and width of bodies of K kinds, (2,) of one [m]; those that tell none are as wide as twice their radius."""
    body = bipeds["body"]
    return np.stack([np.where(body[name] > 0, body[name], 2 * body["radius"]) for name in ("depth", "width")], axis=-1)


def halves(bipeds: Any) -> np.ndarray:
    """(K, 2) half the depth and the width that bodies of K kinds keep from others [m], the straying of the com included."""
    return 0.5 * body_sizes(bipeds) + np.stack([AHEAD * bipeds["body"]["radius"], STRAY * bipeds["gait"]["step_width"]], axis=1)


@jit_borrowing
def strays(biped: Dimensions) -> tuple[float, float]:
    """How far the com strays from its path, along it and across it [m]: the room that a body keeps beyond its size."""
    return AHEAD * biped.body.radius, STRAY * biped.gait.step_width


@jit_borrowing
def lag(biped: Dimensions) -> float:
    """How much later than a foot lands the body comes to the middle of the two [s]."""
    return LAG * pendulum_time(biped.timing.hip_height)


@jit_borrowing
def sort_into_cells(held: Reservations) -> None:
    """Puts every character into the cell in which it rests; ones outside the world go to the nearest cell."""
    rows = (len(held.start) - 1) // held.columns
    held.start[:] = 0
    for c in range(len(held.cell)):
        column = min(max(int(floor(held.path[c, COMMITTED - 1, 0] / held.edge)), 0), held.columns - 1)
        row = min(max(int(floor(held.path[c, COMMITTED - 1, 1] / held.edge)), 0), rows - 1)
        held.cell[c] = row * held.columns + column
        held.start[held.cell[c] + 1] += 1
    for k in range(1, len(held.start)):
        held.start[k] += held.start[k - 1]
    for c in range(len(held.cell) - 1, -1, -1):
        held.start[held.cell[c] + 1] -= 1
        held.order[held.start[held.cell[c] + 1]] = c
    for k in range(1, len(held.start) - 1):
        held.start[k] = held.start[k + 1]
    held.start[-1] = len(held.cell)


@jit_borrowing
def neighbours(held: Reservations, c: int, reach: float, near: np.ndarray) -> int:
    """Fills `near` with the characters that rest within `reach` [m] of where c does; returns how many, -1: too many."""
    rows, count = (len(held.start) - 1) // held.columns, 0
    x, y = held.path[c, COMMITTED - 1, 0], held.path[c, COMMITTED - 1, 1]
    row, column = held.cell[c] // held.columns, held.cell[c] % held.columns
    for i in range(max(row - 1, 0), min(row + 2, rows)):
        first, last = i * held.columns + max(column - 1, 0), i * held.columns + min(column + 1, held.columns - 1)
        for k in range(held.start[first], held.start[last + 1]):
            j = held.order[k]
            dx, dy = held.path[j, COMMITTED - 1, 0] - x, held.path[j, COMMITTED - 1, 1] - y
            if j != c and dx * dx + dy * dy < reach * reach:
                if count == len(near):
                    return -1
                near[count] = j
                count += 1
    return count


@jit_borrowing
def foot_is_free(held: Reservations, j: int, sole: Sole, margin: float, time: float) -> bool:
    """Whether a sole that is set down at `time` for good keeps `margin` [m] off what j's feet hold."""
    half, radius = held.sole[j, 0], held.sole[j, 1]
    apart = sole.half + sole.radius + half + radius + margin
    for k in range(FEET):
        foot = held.foot[j, k]
        dx, dy = foot[0] - sole.x, foot[1] - sole.y
        if foot[4] > time and dx * dx + dy * dy < apart * apart:
            if soles_apart(sole, Sole(foot[0], foot[1], foot[2], foot[3], half, radius)) < margin:
                return False
    return True


@jit_borrowing
def place_on_path(held: Reservations, j: int, time: float, last: int) -> tuple[float, float]:
    """(x, y) of j's middle at a time, resting at point `last` of its path from then on."""
    k = 0
    while k < last and held.path[j, k + 1, 2] < time:
        k += 1
    if k == last:
        return held.path[j, last, 0], held.path[j, last, 1]
    span = held.path[j, k + 1, 2] - held.path[j, k, 2]
    s = min(max((time - held.path[j, k, 2]) / span, 0.0), 1.0) if span > 0 else 1.0
    return (
        held.path[j, k, 0] + s * (held.path[j, k + 1, 0] - held.path[j, k, 0]),
        held.path[j, k, 1] + s * (held.path[j, k + 1, 1] - held.path[j, k, 1]),
    )


@jit_borrowing
def line_distance(px: float, py: float, qx: float, qy: float) -> float:
    """Distance of the origin from the line between two points."""
    dx, dy = qx - px, qy - py
    length2 = dx * dx + dy * dy
    s = min(max(-(px * dx + py * dy) / length2, 0.0), 1.0) if length2 > 0 else 0.0
    return hypot(px + s * dx, py + s * dy)


@jit_borrowing
def least_distance(held: Reservations, j: int, x0: float, y0: float, t0: float, x1: float, y1: float, t1: float) -> float:
    """Least distance of a body from j's, from t0 on: it goes straight from x0, y0 at t0 to x1, y1 at t1 and rests there."""
    rest, least, t = COMMITTED - 1, inf, t0
    jx, jy = place_on_path(held, j, t0, rest)
    px, py = jx - x0, jy - y0
    while t < inf:
        until = t1 if t < t1 else inf
        for k in range(COMMITTED):
            if t < held.path[j, k, 2] < until:
                until = held.path[j, k, 2]
        s = min((until - t0) / (t1 - t0), 1.0)
        jx, jy = place_on_path(held, j, until, rest)
        qx, qy = jx - x0 - s * (x1 - x0), jy - y0 - s * (y1 - y0)
        least = min(least, line_distance(px, py, qx, qy))
        px, py, t = qx, qy, until
    return least


@jit
def without_neighbours(held: Reservations, due: np.ndarray) -> np.ndarray:
    """Those of `due` before whom nobody of it within reach comes: first is who is due first, then the lower number.

    They plan at once without seeing each other, so they must be too far apart to come into each other's way.
    """
    waiting, near = np.zeros(len(held.due), np.bool_), np.empty(len(held.due), np.int64)
    for c in due:
        waiting[c] = True
    count, chosen = 0, np.empty_like(due)
    for c in due:
        if _comes_first(held, c, waiting, near[: neighbours(held, c, held.reach, near)]):
            chosen[count] = c
            count += 1
    return chosen[:count]


@jit_borrowing
def _comes_first(held: Reservations, c: int, waiting: np.ndarray, near: np.ndarray) -> bool:
    first = True
    for j in near:
        first &= not (waiting[j] and (held.due[j] < held.due[c] or (held.due[j] == held.due[c] and j < c)))
    return first
