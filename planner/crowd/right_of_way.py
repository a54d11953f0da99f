"""Who gives way to whom, where not all can have what they wish.

Everyone has a rank: the steps that others kept from getting on, and more for having those who come against one on the left,
where they belong. Each claims the step that it would take if nobody of lower rank were there. Those of lower rank expect it to
come at full speed, and so get out of its way; it expects nothing of the kind (right of way; Curtis, Zafar, Gutub & Manocha
2013). Who stands in the way of a claim inherits its rank, less one, and claims the step aside: so a whole queue backs off, and
nobody is pushed back by those whom it pushes (priority inheritance; Okumura, Machida, Defago & Tamura 2022).

A rank grows for as long as one does not get on, and falls step by step when one does: the one of highest rank yields to nobody.
"""

from math import cos, hypot, inf, sin

from planner.crowd.candidates import SMALL
from planner.crowd.foresight import AGAINST, OTHER, is_leader, time_to_collision
from planner.crowd.reservations import COMMITTED
from worlds.compiled.jit import jit_borrowing

BELONGS = 8.0
"""Rank of having all who come against one on the left, in steps that did not get on; on the right, the same less."""
GETS_ON = 0.4
"""A step gets on that covers this share of the wished one."""
FOLLOW = 1.0
"""Who would run into one of the same way before it within this time [s] claims to go slower."""
SOON = 0.5
"""Who would be run into within this time [s], if it stood, is in the way of a claim."""


@jit_borrowing
def rank_of(r, me, near, wished):
    """My own rank, as far as others have published: for a wished direction of travel [rad]."""
    ux, uy, left, count, rest = cos(wished), sin(wished), 0.0, 0, COMMITTED - 1
    for j in near:
        x, y = r.way[j, rest, 0] - me.rest_x, r.way[j, rest, 1] - me.rest_y
        far = hypot(x, y)
        if r.aim[j, 0] * ux + r.aim[j, 1] * uy < AGAINST and far > 0:
            left += (ux * y - uy * x) / far
            count += 1
    return me.hindered + (BELONGS * left / count if count > 0 else 0.0)


@jit_borrowing
def inherited(others, rank):
    """The rank that counts: of the highest claim that one is in the way of, less one, or one's own."""
    most = rank
    for i in range(len(others)):
        o = others[i]
        if o[7] - 1 > most and time_to_collision(o[0], o[1], o[2], o[3], o[4]) < SOON:
            most = o[7] - 1
    return most


@jit_borrowing
def of_higher_rank(others, higher):
    """Copies those who claim with a higher rank; returns how many."""
    count = 0
    for i in range(len(others)):
        if others[i, 7] > -inf:
            for k in range(OTHER):
                higher[count, k] = others[i, k]
            count += 1
    return count


@jit_borrowing
def queueing_speed(me, others):
    """How fast one could go its way behind those before it [m/s]."""
    ux, uy, speed = cos(me.way), sin(me.way), me.full
    for o in others:
        if o[2] < inf and o[5] * ux + o[6] * uy > 0 and o[0] * ux + o[1] * uy > 0 and is_leader(o):
            time = time_to_collision(o[0], o[1], o[2] - me.full * ux, o[3] - me.full * uy, o[4])
            speed = min(speed, me.full * time / FOLLOW)
    return speed


@jit_borrowing
def hindered_after(b, me, wish, step):
    """Steps that did not get on, after this one: back and forth does not get on, nor does a turn on the spot.

    What counts is where the body comes to rest: a foot that is set down where it was gets nobody on.
    """
    wished, along = _gain(me, wish, wish), _gain(me, wish, step)
    if along > GETS_ON * max(wished, SMALL * b.preferred_step):
        return max(me.hindered - 1, 0)
    if step == wish:
        return me.hindered
    return me.hindered + (1 if along >= 0 else 2)


@jit_borrowing
def _gain(me, wish, step):
    """How far a step brings the body on its wished heading [m]."""
    dx, dy = 0.5 * (me.foot_x + step.foot_x) - me.rest_x, 0.5 * (me.foot_y + step.foot_y) - me.rest_y
    return dx * cos(wish.heading) + dy * sin(wish.heading)
