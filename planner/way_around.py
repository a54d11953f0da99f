"""Which way to go where the wished one runs into someone.

It is the heading that comes nearest to a place LOOK ahead on the wished way when one goes as far as it is free (Moussaid,
Helbing & Theraulaz 2011), and that has on its left those who come the other way: so streams part into lanes before they meet.
"""

from math import cos, inf, pi, sin

from motion.jit import jit_borrowing
from planner.foresight import soonest
from planner.wander import free_way

LEFT = 0.3
"""Cost of a radian to the left: who meet head-on pass on the right."""
LOOK, FAN = 5.0, 6
"""How far one looks for a way around, in preferred steps, and for headings to either side, over a right angle."""
KEEP_RIGHT, WIDE, AGAINST = 1.0, 3.0, -0.5
"""Weight of having those who come against one on the left; how far to the right they count, in distances between bodies; the
cosine between two wishes from which on they are against each other."""


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
def way_around(b, w, r, me, wish, others):
    """The best direction of travel: where it is free far, and near the wished one."""
    wished = wish.heading
    look = LOOK * b.preferred_step
    best, least = wished, inf
    for k in range(-FAN, FAN + 1):
        offset = 0.5 * pi * k / FAN
        vx, vy = me.full * cos(wished + offset), me.full * sin(wished + offset)
        free = min(
            me.full * soonest(others, vx, vy, look / me.full), free_way(w, me.x, me.y, wished + offset, me.margin - 0.01, look)
        )
        off = look * look + free * free - 2 * look * free * cos(offset) + LEFT * look * look * max(offset, 0.0)
        off += KEEP_RIGHT * look * look * min(wrong_side(others, wished, wished + offset, r.reach), 1.0)
        if off < least:
            best, least = wished + offset, off
    return best
