"""Who plans among others: its last footprint, and when and where its body will be as that one lands."""

from math import cos, hypot, sin
from typing import NamedTuple

from motion.arithmetic.gravity import pendulum_time
from planner.crowd.bodies import extent
from planner.round.reservations import lag, strays
from planner.round.round import Me, Round, biped_of
from planner.stepping import timing
from planner.stepping.beside import middle_beside
from planner.stepping.footing import needs_care
from worlds import queries
from worlds.compiled.jit import jit_borrowing, jit_inline

SQUEEZE, PRESSED = 0.9, 20
"""Who was left nothing but to stand so often in a row gives up this share of the room that its own body keeps, ahead and aside;
less before. So an arch before a door gives way, as it does where people push. Aside there is less of it than ahead."""

NEAREST = 0.95
"""Who is nearer to a tree, wall or border than half its width, as bodies sway, comes no nearer than this share of it."""
CROWDED = 48
"""Where more others than this are in reach, one looks for those who are nearer."""
STAYS = 0.2
"""Who is no further than so many preferred steps from where it was is still there: it shuffles."""
LONGER = 10.0
"""Who has been where it is for so many swings longer than another has the right of way over it, though they go the same way:
people merge before a door like the teeth of a zipper."""


class Walker(NamedTuple):
    """Me among others; metres and seconds."""

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
    margin: float  # kept from trees and walls [m]
    full: float  # speed when nothing hinders [m/s]
    calm: bool  # it arrives, turns on the spot or has a wall before it: it wishes for no more than this velocity
    wish_x: float  # [m/s]
    wish_y: float
    hindered: int  # steps that did not get on
    course: float  # where it wishes to go [rad]
    face_x: float  # where the body faces at rest: unit vector
    face_y: float
    deep: float  # half axes of the body [m]
    wide: float
    press_deep: float  # how far it presses into the room that bodies keep, ahead and aside [m]
    press_wide: float
    room: float  # from its middle to the nearest tree, wall, water or border [m]
    careful: bool  # the ground around the last footprint needs to be looked at


@jit_borrowing
def _margin(half: float, room: float) -> float:
    """What a step keeps from trees, walls and borders [m] where there is so much room: a centimetre less, but not each time."""
    return min(half, room, max(room - 0.01, NEAREST * half)) - 1e-9


@jit_borrowing
def walker_of(round: Round, me: Me, course: float) -> Walker:
    """Me among others, on a wished course [rad]."""
    biped, older, newer, held = biped_of(round, me), me.feet.older, me.feet.newer, round.reservations
    x, y = middle_beside(biped, newer)
    rest_x, rest_y = 0.5 * (older.x + newer.x), 0.5 * (older.y + newer.y)
    half = 0.5 * biped.body.width if biped.body.width > 0 else biped.body.radius
    room, careful = queries.clearance(round.world, x, y), needs_care(biped, round.world, newer.x, newer.y)
    stride, facing = biped.gait.preferred_step, 0.5 * (older.heading + newer.heading)
    full = stride / timing.step_timing(biped, stride, 0.0, 0.0, False)[0]
    contact, overlap = newer.contact_time, older.contact_time + older.stance_time - newer.contact_time
    deep, wide = held.half[me.c, 0], held.half[me.c, 1]
    ahead, aside = strays(biped)
    press = SQUEEZE * min(round.intents.stood[me.c] / PRESSED, 1.0)
    return Walker(
        me.c, 1 - newer.side, newer.x, newer.y, x, y, newer.heading, rest_x, rest_y, contact, contact + lag(biped), overlap,
        _margin(half, room), full, False, 0.0, 0.0, me.hindered, course, cos(facing), sin(facing), deep, wide, press * ahead,
        press * aside, room, careful,
    )  # fmt: skip


@jit_inline
def squeeze(w: Walker, dx: float, dy: float) -> float:
    """How far it presses into the room that bodies keep, in the direction of a unit vector [m]."""
    return extent((w.press_deep, w.press_wide), (w.face_x, w.face_y), dx, dy) if w.press_deep > 0 else 0.0


@jit_borrowing
def calmed(w: Walker, wish_x: float, wish_y: float) -> Walker:
    """The same, who wishes for no more than that velocity [m/s]."""
    return Walker(
        w.c, w.side, w.foot_x, w.foot_y, w.x, w.y, w.heading, w.rest_x, w.rest_y, w.time, w.there, w.overlap, w.margin, w.full,
        True, wish_x, wish_y, w.hindered, w.course, w.face_x, w.face_y, w.deep, w.wide, w.press_deep, w.press_wide,
        w.room, w.careful,
    )  # fmt: skip


@jit_borrowing
def look_where(round: Round, me: Me, waits: bool) -> None:
    """Notes since when I am about where I am; who does not wait to go on, but stands as it wishes, is there anew each time."""
    intents, c, older, newer = round.intents, me.c, me.feet.older, me.feet.newer
    x, y, stride = 0.5 * (older.x + newer.x), 0.5 * (older.y + newer.y), round.bipeds[round.kind[c]].gait.preferred_step
    if not waits or hypot(x - intents.about[c, 0], y - intents.about[c, 1]) > STAYS * stride:
        intents.about[c, 0], intents.about[c, 1], intents.since[c] = x, y, newer.contact_time


@jit_borrowing
def longer(round: Round, c: int) -> float:
    """Those who have been where they are since before that time [s] have been there for longer than character c."""
    return round.intents.since[c] - LONGER * pendulum_time(round.bipeds[round.kind[c]].timing.hip_height)
