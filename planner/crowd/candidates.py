"""The steps that may be taken instead of the wished one: other turns and lengths, steps aside and back, and standing."""

from math import cos, hypot, sin
from typing import NamedTuple

from planner import plan
from planner.crowd import reservations
from planner.stepping import timing
from planner.wander import MARGIN
from worlds import queries
from worlds.compiled.jit import jit_borrowing

SMALL = 0.4
"""Side steps and steps back, in preferred steps."""
TURNS, LENGTHS = 3, 4
KINDS = 2 * TURNS + 2
ASIDE_AND_BACK = ((0.0, 1.0), (1.0, 1.0), (-1.0, 0.0), (-1.0, 1.0), (-0.5, 0.0), (0.0, 0.5), (-0.5, 0.5), (0.0, 0.0))
"""Ahead, and to the side of the foot that moves, in small steps; back from where that foot is, so that the body goes back too,
whatever the stance. The last stands."""
APART = 0.7
"""The feet part no farther by a step back, in preferred steps."""
CANDIDATES = KINDS * LENGTHS + len(ASIDE_AND_BACK) - 1
"""How many there are, and the number of standing."""
CLOSING = KINDS * (LENGTHS - 1) + TURNS + 1
"""The candidate that sets the foot beside the other."""


class Walker(NamedTuple):
    """Who plans: its last footprint, and when and where its body will be as that one lands."""

    c: int
    side: int  # of the foot to be placed
    foot_x: float  # the last footprint
    foot_y: float
    x: float  # middle, beside it
    y: float
    heading: float
    rest_x: float  # where the body rests: between the last two footprints
    rest_y: float
    time: float  # contact of the last footprint [s]
    there: float  # when the body comes to rest beside it [s]
    overlap: float  # of the last two stances [s]
    margin: float  # kept from trees [m]
    full: float  # speed when nothing hinders [m/s]
    hindered: int  # steps that did not get on
    way: float  # where it wishes to go [rad]
    goes: bool  # somewhere: it claims a right of way


class Step(NamedTuple):
    """A step that may be taken."""

    x: float  # middle
    y: float
    heading: float
    foot_x: float
    foot_y: float
    time: float  # it takes [s]


@jit_borrowing
def walker(b, w, c, side, position, heading, contact_time, overlap, hindered, way, goes):
    x, y = plan.middle_of(b, side[1], position[1, 0], position[1, 1], heading[1])
    rest_x, rest_y = 0.5 * (position[0, 0] + position[1, 0]), 0.5 * (position[0, 1] + position[1, 1])
    margin = min(b.body_radius + MARGIN, queries.clearance(w, x, y))
    full = b.preferred_step / timing.step_timing(b, b.preferred_step, 0.0, 0.0, False)[0]
    return Walker(
        c, 1 - side[1], position[1, 0], position[1, 1], x, y, heading[1], rest_x, rest_y, contact_time,
        contact_time + reservations.lag(b), overlap, margin, full, hindered, way, goes,
    )  # fmt: skip


@jit_borrowing
def pace(hindered):
    """Longest step time [pendulum times] of one whom others kept from getting on for so many steps."""
    return timing.HURRIED if hindered > 0 else timing.LONGEST_STEP


@jit_borrowing
def step_to(b, me, x, y, heading):
    """The step to a middle, timed as on level ground: rises only make it later."""
    fx, fy = plan.beside(b, me.side, x, y, heading)
    time, _ = timing.step_timing(
        b, hypot(fx - me.foot_x, fy - me.foot_y), 0.0, abs(heading - me.heading), False, pace(me.hindered)
    )
    return Step(x, y, heading, fx, fy, max(time, timing.least_step_time(b, me.overlap)))


@jit_borrowing
def candidate(b, me, wish, k):
    """Candidate k: lengths times turns, the wish's own turn first (0 is the wish), then steps to the side and back."""
    turn = wish.heading - me.heading
    length = hypot(wish.x - me.x, wish.y - me.y)
    if k < KINDS * LENGTHS:
        if k % KINDS:
            turn = (k % KINDS - 1 - TURNS) * b.max_turn / TURNS
            length = b.preferred_step * max(1 - 0.5 * abs(turn) / b.max_turn, 0.3)
        length *= (1.0, 0.55, 0.25, 0.0)[k // KINDS]
        heading = me.heading + turn
        return step_to(b, me, me.x + length * cos(heading), me.y + length * sin(heading), heading)
    ahead, across = ASIDE_AND_BACK[k - KINDS * LENGTHS]
    ahead, across = ahead * SMALL * b.preferred_step, across * SMALL * b.preferred_step * (1 - 2 * me.side)
    c, s = cos(me.heading), sin(me.heading)
    if ahead < 0:
        behind = min(2 * ((me.rest_x - me.foot_x) * c + (me.rest_y - me.foot_y) * s), 0.0)
        ahead = max(ahead + behind, -APART * b.preferred_step)
    return step_to(b, me, me.x + ahead * c - across * s, me.y + ahead * s + across * c, me.heading)
