"""The one rule for the side: each keeps those who come against it on its left.

So streams part into lanes. Where anyone comes, one makes for the right half of the narrowest place ahead, before it is full,
or waits, if it is too narrow for two sides and others are nearer to it; where none is narrow, one turns to the right, the more
the more come: people evade to one side (Moussaid et al. 2009), and long before they meet (Xu, Chraibi & Seyfried 2021). Where
all come against each other in one place that makes a roundabout.
"""

from math import atan2, ceil, cos, hypot, inf, pi, sin
from typing import Any, NamedTuple

from motion.characters.dimensions import Dimensions
from planner.crowd.walker import Walker
from planner.round.reservations import COMMITTED, Reservations
from planner.round.round import Round
from planner.stepping.beside import Place
from planner.stepping.steering import free_way
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit_borrowing

AGAINST = -0.5
"""The cosine between two wishes from which on they are against each other."""
WIDE, MOST = 2.0, 2.5
"""How far to the right those who come against one count, in widths of two bodies, and how many at most."""
SIGHT, SPREAD = 14.0, 0.6
"""How many preferred steps ahead one sees that somebody comes, and how far to the side, in how far ahead."""
MANY = 6.0
"""So many who come turn one all the way to the right that the table of weights tells (around)."""
QUARTER, EARLY = 0.2, 3
"""How far off the middle of a narrow place one passes it, in its width, and how many steps before it one is there."""
NARROW, AHEAD, SLANTS = 5.0, 14, 2
"""Places narrower than this, in widths of two bodies, are passed on the right; looked for so many steps ahead, straight across
the course and at so many slants of 30 degrees to either side."""
ABREAST, WAITS = 2.7, 8.0
"""Places narrower than this, in widths of a body, have no two sides: one way is gone through them at a time. Who waits for the
others stays so many widths away."""


class Passage(NamedTuple):
    """How one passes the narrowest place ahead, where others come through it."""

    course: float  # to its right half [rad]
    left: float  # how far left of that half one is, in widths of a body; less further off
    far: float  # how far ahead that place is [m]; inf: none is narrow
    x: float  # its middle [m]
    y: float
    wide: float  # [m]


@jit_borrowing
def straight_on(course: float, far: float) -> Passage:
    """As if nobody came."""
    return Passage(course, 0.0, far, 0.0, 0.0, inf)


@jit_borrowing
def _cells_around(held: Reservations, c: int, sight: float) -> tuple[int, int, int, int]:
    """Of the grid within `sight` [m] of character c: the first row, the one behind the last, the first column, the last one."""
    rows, cells = (len(held.start) - 1) // held.columns, int(ceil(sight / held.edge))
    row, column = held.cell[c] // held.columns, held.cell[c] % held.columns
    return max(row - cells, 0), min(row + cells + 1, rows), max(column - cells, 0), min(column + cells, held.columns - 1)


@jit_borrowing
def _coming(held: Reservations, c: int, course: float, aim: Place, beyond: float, sight: float) -> float:
    """How many between `beyond` and `sight` [m] ahead on a course [rad] come against the aim of character c; those further away
    count less, down to 0 at `sight`."""
    ux, uy, total = cos(course), sin(course), 0.0
    x, y, wide = held.path[c, COMMITTED - 1, 0], held.path[c, COMMITTED - 1, 1], WIDE * 2 * held.half[c, 1]
    top, bottom, first, last = _cells_around(held, c, sight)
    for i in range(top, bottom):
        for k in range(held.start[i * held.columns + first], held.start[i * held.columns + last + 1]):
            j = held.order[k]
            if held.aim[j, 0] * aim[0] + held.aim[j, 1] * aim[1] < AGAINST:
                dx, dy = held.path[j, COMMITTED - 1, 0] - x, held.path[j, COMMITTED - 1, 1] - y
                ahead, left = dx * ux + dy * uy, ux * dy - uy * dx
                if beyond < ahead < sight and abs(left) < wide + SPREAD * ahead:
                    total += 1 - ahead / sight
    return total


@jit_borrowing
def keep_right(round: Round, c: int, middle: Place, course: float) -> Passage:
    """How character c, whose middle is there, keeps to the right half of the narrowest place ahead on its course [rad]; where
    none is narrow, to the right of those who come. It needs not to where nobody comes against it.
    """
    held, biped, (x, y) = round.reservations, round.bipeds[round.kind[c]], middle
    sight, aim = SIGHT * biped.gait.preferred_step, (round.intents.aim[c, 0], round.intents.aim[c, 1])
    coming = _coming(held, c, course, aim, 0.0, sight)
    if coming == 0:
        return straight_on(course, 0.0)
    margin = min(biped.body.radius, queries.clearance(round.world, x, y)) - 0.01
    passage = _to_the_right(biped, round.world, middle, course, margin, held.half[c, 1])
    if passage.far == inf:
        right, far = course - round.weights[round.kind[c]].around * min(coming / MANY, 1.0), EARLY * biped.gait.preferred_step
        is_free = free_way(biped, round.world, x, y, right, margin, far) >= far
        return straight_on(right if is_free else course, inf)
    if passage.far > 0 and _coming(held, c, course, aim, passage.far, sight) == 0:
        return straight_on(course, 0.0)
    return passage if passage.wide >= ABREAST * 2 * held.half[c, 1] else _one_way(held, c, aim, course, passage)


@jit_borrowing
def _one_way(held: Reservations, c: int, aim: Place, course: float, passage: Passage) -> Passage:
    """How one passes a place that is gone through one way at a time: that of those who are nearest to it. The others wait.

    So streams take turns in bursts, and nobody waits where those who come out need room.
    """
    mine = hypot(held.path[c, COMMITTED - 1, 0] - passage.x, held.path[c, COMMITTED - 1, 1] - passage.y)
    ours, theirs = mine, inf
    top, bottom, first, last = _cells_around(held, c, 2 * mine)
    for i in range(top, bottom):
        for k in range(held.start[i * held.columns + first], held.start[i * held.columns + last + 1]):
            j = held.order[k]
            along = held.aim[j, 0] * aim[0] + held.aim[j, 1] * aim[1]
            far = hypot(held.path[j, COMMITTED - 1, 0] - passage.x, held.path[j, COMMITTED - 1, 1] - passage.y)
            if along < AGAINST:
                theirs = min(theirs, far)
            elif along > -AGAINST:
                ours = min(ours, far)
    if ours <= theirs:
        return straight_on(course, passage.far)
    near = 1 - mine / (WAITS * 2 * held.half[c, 1])
    return Passage(passage.course, min(max(2 * MOST * near, 0.0), MOST), passage.far, passage.x, passage.y, passage.wide)


@jit_borrowing
def _to_the_right(
    biped: Dimensions, world: WorldArrays, middle: Place, course: float, margin: float, half: float
) -> Passage:  # fmt: skip
    """How one passes the narrowest place ahead: on the given course where that leads to its right half.

    How wide a place is, is measured through points of the course, also aslant: it may lead through a gap at an angle.
    """
    least, turn, left, far, stride = 4 * NARROW * half, 0.0, 0.0, inf, biped.gait.preferred_step
    mx, my = middle
    for i in range(AHEAD):
        px, py = middle[0] + i * stride * cos(course), middle[1] + i * stride * sin(course)
        if queries.clearance(world, px, py) < margin:
            far = min(far, i * stride)  # a way that ends is not open
            break
        for k in range(-SLANTS, SLANTS + 1):
            across = pi / 6 * k - 0.5 * pi
            right = free_way(biped, world, px, py, course + across, margin, 4 * NARROW * half)
            free_left = free_way(biped, world, px, py, course + across + pi, margin, 4 * NARROW * half)
            if right + free_left < least:
                least, off = right + free_left, 0.5 * (right - free_left)
                aside = off + max(half, QUARTER * least)
                turn = atan2(max(aside, 0.0) * sin(across), max(i - EARLY, 1) * stride + max(aside, 0.0) * cos(across))
                far, left = i * stride, (off + half) / (2 * half) * (1 - i / AHEAD)
                mx, my = px + off * cos(course + across), py + off * sin(course + across)
    return Passage(course + turn, min(max(left, 0.0), MOST), far, mx, my, least + 2 * margin)


@jit_borrowing
def meets(walker: Walker, others: Any, sight: float) -> bool:
    """Whether anyone within `sight` [m] who is ahead on my course comes against me."""
    ux, uy = cos(walker.course), sin(walker.course)
    for i in range(len(others)):
        other = others[i]
        if other.along < AGAINST and other.x * ux + other.y * uy > 0 and hypot(other.x, other.y) < sight:
            return True
    return False


@jit_borrowing
def on_the_right(walker: Walker, others: Any, aim: Place, sight: float) -> float:
    """How many come against me whom I would leave on the right, not on the left; those further away count less, at most MOST.

    None beyond `sight` [m], and none who is on the left of my aim, where my way leads: around a wall whoever stands behind it
    lies to the right of my course.
    """
    ux, uy, total = cos(walker.course), sin(walker.course), 0.0
    for i in range(len(others)):
        other = others[i]
        if other.along < AGAINST:
            ahead, left = other.x * ux + other.y * uy, ux * other.y - uy * other.x
            left = max(left, aim[0] * other.y - aim[1] * other.x)
            room = walker.wide + other.wide
            if 0 < ahead < sight and -WIDE * room < left < room:
                total += (1 - ahead / sight) * min((room - left) / room, 1.0)
    return min(total, MOST)


@jit_borrowing
def wrong_side(walker: Walker, right: float, vx: float, vy: float) -> float:
    """What a velocity costs one who has so many `right` of it who should be left (on_the_right): steps to the right mend it.

    Where there is more than one, one is in their lane: it costs to go on in it, and pays to go back.
    """
    ux, uy = cos(walker.course), sin(walker.course)
    ahead, rightward = (vx * ux + vy * uy) / walker.full, (vx * uy - vy * ux) / walker.full
    return max(right - 1, 0.0) * ahead - right * rightward
