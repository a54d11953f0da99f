"""The steps that may be taken instead of the wished one: other turns and lengths, steps aside and back, and standing."""

from math import cos, hypot, sin
from typing import NamedTuple

from motion.characters.dimensions import Dimensions
from planner.round.reservations import lag
from planner.round.round import UNHURRIED, Me, Round, biped_of
from planner.stepping import timing
from planner.stepping.beside import beside, middle_beside
from planner.stepping.steering import MARGIN
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
    """Who plans among others: its last footprint, and when and where its body will be as that one lands."""

    c: int
    number: int  # of the step
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
    course: float  # where it wishes to go [rad]
    goes: bool  # somewhere: it claims a right of way


class Candidate(NamedTuple):
    """A step that may be taken."""

    x: float  # middle
    y: float
    heading: float
    foot_x: float
    foot_y: float
    time: float  # it takes [s]


@jit_borrowing
def walker_of(round: Round, me: Me, course: float, goes: bool) -> Walker:
    """Me among others, on a wished course [rad]."""
    biped, older, newer = biped_of(round, me), me.feet.older, me.feet.newer
    x, y = middle_beside(biped, newer)
    rest_x, rest_y = 0.5 * (older.x + newer.x), 0.5 * (older.y + newer.y)
    margin = min(biped.body.radius + MARGIN, queries.clearance(round.world, x, y))
    stride = biped.gait.preferred_step
    full = stride / timing.step_timing(biped, stride, 0.0, 0.0, False)[0]
    contact, overlap = newer.contact_time, older.contact_time + older.stance_time - newer.contact_time
    return Walker(
        me.c, me.number, 1 - newer.side, newer.x, newer.y, x, y, newer.heading, rest_x, rest_y, contact, contact + lag(biped),
        overlap, margin, full, me.hindered, course, goes,
    )  # fmt: skip


@jit_borrowing
def pace(hindered: int) -> float:
    """Longest step time [pendulum times] of one whom others kept from getting on for so many steps."""
    return timing.HURRIED if hindered > 0 else UNHURRIED


@jit_borrowing
def candidate_to(biped: Dimensions, walker: Walker, x: float, y: float, heading: float) -> Candidate:
    """The step to a middle, timed as on level ground: rises only make it later."""
    fx, fy = beside(biped, walker.side, (x, y), heading)
    length, turn = hypot(fx - walker.foot_x, fy - walker.foot_y), abs(heading - walker.heading)
    time, _ = timing.step_timing(biped, length, 0.0, turn, False, pace(walker.hindered))
    return Candidate(x, y, heading, fx, fy, max(time, timing.least_step_time(biped, walker.overlap)))


@jit_borrowing
def candidate(biped: Dimensions, walker: Walker, wished: Candidate, k: int) -> Candidate:
    """Candidate k: lengths times turns, the wish's own turn first (0 is the wish), then steps to the side and back."""
    stride, most = biped.gait.preferred_step, biped.reach.max_turn
    turn = wished.heading - walker.heading
    length = hypot(wished.x - walker.x, wished.y - walker.y)
    if k < KINDS * LENGTHS:
        if k % KINDS:
            turn = (k % KINDS - 1 - TURNS) * most / TURNS
            length = stride * max(1 - 0.5 * abs(turn) / most, 0.3)
        length *= (1.0, 0.55, 0.25, 0.0)[k // KINDS]
        heading = walker.heading + turn
        return candidate_to(biped, walker, walker.x + length * cos(heading), walker.y + length * sin(heading), heading)
    ahead, across = ASIDE_AND_BACK[k - KINDS * LENGTHS]
    ahead, across = ahead * SMALL * stride, across * SMALL * stride * (1 - 2 * walker.side)
    c, s = cos(walker.heading), sin(walker.heading)
    if ahead < 0:
        behind = min(2 * ((walker.rest_x - walker.foot_x) * c + (walker.rest_y - walker.foot_y) * s), 0.0)
        ahead = max(ahead + behind, -APART * stride)
    x, y = walker.x + ahead * c - across * s, walker.y + ahead * s + across * c
    return candidate_to(biped, walker, x, y, walker.heading)
