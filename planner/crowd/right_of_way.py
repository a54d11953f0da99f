"""Who gives way to whom, where not all can have what they wish.

Everyone has a rank: the steps that others kept from getting on, and more for having those who come against one on the left,
where they belong. Each claims the step that it would take if nobody of lower rank were there. Those of lower rank expect it to
come at full speed, and so get out of its way; it expects nothing of the kind (right of way; Curtis, Zafar, Gutub & Manocha
2013). Who stands in the way of a claim inherits its rank, less one, and claims the step aside: so a whole queue backs off, and
nobody is pushed back by those whom it pushes (priority inheritance; Okumura, Machida, Defago & Tamura 2022).

A rank grows for as long as one does not get on, and falls step by step when one does: the one of highest rank yields to nobody.
"""

from math import cos, hypot, inf, sin
from typing import Any

import numpy as np

from motion.characters.dimensions import Dimensions
from planner.crowd.candidates import SMALL, Candidate, Walker
from planner.crowd.foresight import AGAINST, is_leader, time_to_collision
from planner.round.reservations import COMMITTED, Reservations
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
def rank_of(held: Reservations, walker: Walker, near: np.ndarray) -> float:
    """My own rank on my course, as far as others have published."""
    ux, uy, left, count, rest = cos(walker.course), sin(walker.course), 0.0, 0, COMMITTED - 1
    for j in near:
        x, y = held.path[j, rest, 0] - walker.rest_x, held.path[j, rest, 1] - walker.rest_y
        far = hypot(x, y)
        if held.aim[j, 0] * ux + held.aim[j, 1] * uy < AGAINST and far > 0:
            left += (ux * y - uy * x) / far
            count += 1
    return walker.hindered + (BELONGS * left / count if count > 0 else 0.0)


@jit_borrowing
def inherited(others: Any, rank: float) -> float:
    """The rank that counts: of the highest claim that one is in the way of, less one, or one's own."""
    most = rank
    for i in range(len(others)):
        other = others[i]
        if other.rank - 1 > most and time_to_collision(other.x, other.y, other.vx, other.vy, other.room) < SOON:
            most = other.rank - 1
    return most


@jit_borrowing
def of_higher_rank(others: Any, higher: Any) -> int:
    """Copies those who claim with a higher rank; returns how many."""
    count = 0
    for i in range(len(others)):
        if others[i].rank > -inf:
            higher[count] = others[i]
            count += 1
    return count


@jit_borrowing
def queueing_speed(walker: Walker, others: Any) -> float:
    """How fast one could go on its course behind those before it [m/s]."""
    full = walker.full
    ux, uy, speed = cos(walker.course), sin(walker.course), full
    for i in range(len(others)):
        other = others[i]
        same = other.vx < inf and other.aim_x * ux + other.aim_y * uy > 0
        if same and other.x * ux + other.y * uy > 0 and is_leader(other):
            time = time_to_collision(other.x, other.y, other.vx - full * ux, other.vy - full * uy, other.room)
            speed = min(speed, full * time / FOLLOW)
    return speed


@jit_borrowing
def hindered_after(biped: Dimensions, walker: Walker, wished: Candidate, taken: Candidate) -> int:
    """Steps that did not get on, after this one: back and forth does not get on, nor does a turn on the spot.

    What counts is where the body comes to rest: a foot that is set down where it was gets nobody on.
    """
    wanted, along = _gain(walker, wished, wished), _gain(walker, wished, taken)
    if along > GETS_ON * max(wanted, SMALL * biped.gait.preferred_step):
        return max(walker.hindered - 1, 0)
    if taken == wished:
        return walker.hindered
    return walker.hindered + (1 if along >= 0 else 2)


@jit_borrowing
def _gain(walker: Walker, wished: Candidate, taken: Candidate) -> float:
    """How far a step brings the body on its wished heading [m]."""
    dx, dy = 0.5 * (walker.foot_x + taken.foot_x) - walker.rest_x, 0.5 * (walker.foot_y + taken.foot_y) - walker.rest_y
    return dx * cos(wished.heading) + dy * sin(wished.heading)
