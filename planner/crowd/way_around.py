"""Which way to go where the wished one runs into someone.

It is the heading that comes nearest to a place LOOK ahead on the wished way when one goes as far as it is free (Moussaid,
Helbing & Theraulaz 2011), and that has on its left those who come the other way: so streams part into lanes before they meet.
Nobody goes around those of its own way who are held up: one queues behind them.
"""

from math import atan2, cos, inf, pi, sin

from planner.crowd.foresight import AGAINST, time_to_collision
from planner.wander import MARGIN, free_way
from worlds import queries
from worlds.compiled.jit import jit_borrowing

LEFT = 0.3
"""Cost of a radian to the left: who meet head-on pass on the right."""
LOOK, FAN = 5.0, 6
"""How far one looks for a way around, in preferred steps, and for headings to either side, over a right angle."""
KEEP_RIGHT, WIDE = 1.0, 3.0
"""Weight of having those who come against one on the left; how far to the right they count, in distances between bodies."""
NARROW, NARROW_AHEAD, SLANTS = 5.0, 7, 2
"""Places narrower than this, in distances between bodies, are passed on the right; looked for so many steps ahead, straight
across the way and at so many slants of 30 degrees to either side."""
LEAST_WAY = 0.3
"""A way around is free of trees for this share of a preferred step: no lane leads into a wall."""
QUEUES = 0.5
"""The cosine between two wishes from which on one queues behind who is held up, instead of going around."""


@jit_borrowing
def keep_right(b, w, r, c, near, x, y, way):
    """The way [rad] of character c, from its middle at x, y, to the right half of the narrowest place ahead.

    It is the way that was given where nobody comes against it. So lanes are agreed on before the place is full.
    """
    ux, uy, comes = cos(way), sin(way), False
    for j in near:
        comes |= r.aim[j, 0] * ux + r.aim[j, 1] * uy < AGAINST
    if not comes:
        return way
    margin = min(b.body_radius + MARGIN, queries.clearance(w, x, y)) - 0.01
    return way + _to_the_right(w, x, y, way, margin, r.room[c], b.preferred_step)


@jit_borrowing
def _to_the_right(w, x, y, way, margin, room, stride):
    """The turn [rad] from the way to the right half of the narrowest place ahead, `room` [m] off its middle; 0: it leads there.

    How wide a place is, is measured through points of the way, also aslant: a way may lead through a gap at an angle.
    """
    least, turn = 2 * NARROW * room, 0.0
    for i in range(NARROW_AHEAD):
        px, py = x + i * stride * cos(way), y + i * stride * sin(way)
        if queries.clearance(w, px, py) < margin:
            break
        for k in range(-SLANTS, SLANTS + 1):
            across = pi / 6 * k - 0.5 * pi
            right = free_way(w, px, py, way + across, margin, 2 * NARROW * room)
            left = free_way(w, px, py, way + across + pi, margin, 2 * NARROW * room)
            if right + left < least:
                least, aside = right + left, max(0.5 * (right - left) + room, 0.0)
                turn = atan2(aside * sin(across), max(i, 1) * stride + aside * cos(across))
    return turn


@jit_borrowing
def wrong_side(others, wished, way, sight):
    """How much going `way` [rad] leaves those who come against the wished one on the right, not the left: lanes form early."""
    wx, wy, ux, uy, total = cos(wished), sin(wished), cos(way), sin(way), 0.0
    for o in others:
        along, left = o[0] * ux + o[1] * uy, ux * o[1] - uy * o[0]
        if o[5] * wx + o[6] * wy < AGAINST and 0 < along < sight and -WIDE * o[4] < left < o[4]:
            total += (1 - along / sight) * min((o[4] - left) / o[4], 1.0)
    return total


@jit_borrowing
def _free_of_others(me, others, wished, way, look):
    """How far one can go that way [rad] at full speed, at most `look` [m]; those held up on the wished way are no obstacles."""
    ux, uy, vx, vy, free = cos(wished), sin(wished), me.full * cos(way), me.full * sin(way), look
    for o in others:
        if o[2] < inf and not (o[8] > 0 and o[5] * ux + o[6] * uy > QUEUES):
            free = min(free, me.full * time_to_collision(o[0], o[1], o[2] - vx, o[3] - vy, o[4]))
    return free


@jit_borrowing
def way_around(b, w, r, me, others):
    """The best direction of travel: where it is free far, and near the wished one."""
    wished = me.way
    look = LOOK * b.preferred_step
    best, least = wished, inf
    for k in range(-FAN, FAN + 1):
        offset = 0.5 * pi * k / FAN
        free = free_way(w, me.x, me.y, wished + offset, me.margin - 0.01, look)
        if k != 0 and free < LEAST_WAY * b.preferred_step:
            continue
        free = min(free, _free_of_others(me, others, wished, wished + offset, look))
        off = look * look + free * free - 2 * look * free * cos(offset) + LEFT * look * look * max(offset, 0.0)
        off += KEEP_RIGHT * look * look * min(wrong_side(others, wished, wished + offset, r.reach), 1.0)
        if off < least:
            best, least = wished + offset, off
    return best
