"""Footprints: what motion is made from (paper, section 2.1). This file alone makes, places, copies and forgets their rows.

A footprint has five animator's degrees of freedom: x, y, heading, stance time and step time. `Footprints` are rows of them as
they are walked: laid on the ground and timed. A `Step` is how planners, files and programs ask for the next one. A new column
is one line of `Footprints`, and a line where it is known.
"""

from math import nan
from typing import Annotated, Any, NamedTuple

import numpy as np

from worlds.compiled.jit import jit_borrowing
from worlds.compiled.lanes import Some, root
from worlds.compiled.tables import Column, Indices, Integers, Numbers, Pairs, Truths, Vectors, copy_row, part

LEFT, RIGHT = 0, 1
SIDES = ("left", "right")
"""Feet by their numbers: everywhere, all of the left foot comes first."""


class Step(NamedTuple):
    """The step to the next footprint, as it is asked for; world frame, SI units. What is NaN is automatic."""

    side: int  # LEFT or RIGHT
    x: float  # middle of the sole [m]
    y: float
    heading: float  # counter-clockwise from +x, unwrapped: neighbours differ by the turn [rad]
    time: float = nan  # from the contact of the footprint that it leaves to that of its own [s]
    stance_time: float = nan  # of the footprint that it leaves [s]
    stands: float = 0.0  # the foot does not move but stands on where it is, for so long [s]; 0: it moves
    crouch: float = 1.0  # share of the nominal leg over it
    facing: float = 0.0  # how far the body turns away from the feet over it [rad]


STEP = np.dtype([(name, np.int64 if name == "side" else np.float64) for name in Step._fields])
"""A Step in an array of them."""


Share = Annotated[np.ndarray, Column(fill=1.0)]
"""1 where nothing else is said."""


class Footprints(NamedTuple):
    """n footprints in the order of their contacts; world frame, SI units.

    Footprint i stands over [contact, contact + stance]; contact[i + 1] = contact[i] + step_time[i]. Standing still is a
    footprint coincident with the same foot's last one, whose stance ends exactly at the new contact.
    """

    side: Integers  # (n,) LEFT or RIGHT
    position: Vectors  # (n, 3) middle of the sole [m]
    heading: Numbers  # (n,) counter-clockwise from +x, unwrapped [rad]
    normal: Annotated[np.ndarray, Column(shape=(3,), fill=(0.0, 0.0, 1.0))]  # (n, 3) unit normal of the sole
    rock: Indices  # (n,) the rock it lies on, -1 on land
    stands: Truths  # (n,) bool: the foot has not moved, it only stands on
    contact_time: Numbers  # (n,) [s]
    stance_time: Numbers  # (n,) [s]
    step_time: Numbers  # (n,) until the next footfall [s]
    roll: Pairs  # (n, 2) where on the sole the support begins and ends: 0 heel, 1 toe, 0.5 the middle
    nominal_length: Numbers  # (n,) comfortable virtual leg over it [m]: less is crouched
    facing: Numbers  # (n,) how far the body turns away from the feet over it [rad]
    toe_out: Numbers  # (n,) how far the sole points to the left of where its walker headed, part of the heading [rad]
    lift: Numbers  # (n,) height of the swing that arrives here above the line between its ends [m]
    hold: Numbers  # (n,) share of that swing, at either end, in which the foot goes only up or down
    strike: Numbers  # (n,) how far the toes are up when it lands on its heel; the heel, below 0 [rad]
    bow: Share  # (n,) share of the way around the other foot that that swing takes
    gravity: Share  # (n,) share of gravity that the motion reckons with from its contact to the next
    comfort: Share  # (n,) share of the comfort weight there
    bounce: Share  # (n,) how far the leg over it gives under the load and bends as it pushes off, in its own way of doing so


class Foot(NamedTuple):
    """Where and when a foot was set down: what planning the next footprint asks of the last two."""

    side: int
    x: float
    y: float
    heading: float  # of the walker: the sole's without its toe-out [rad]
    contact_time: float
    stance_time: float


class Feet(NamedTuple):
    """The last two footprints, the older first."""

    older: Foot
    newer: Foot


@jit_borrowing
def step_onto(side: int, x: float, y: float, heading: float) -> Step:
    """A step with nothing asked for but where it lands (the compiler knows no defaults)."""
    return Step(side, x, y, heading, nan, nan, 0.0, 1.0, 0.0)


@jit_borrowing
def stand_for(foot: Foot, seconds: float) -> Step:
    """A foot that stands on where it is, for so long [s]."""
    return Step(foot.side, foot.x, foot.y, foot.heading, nan, nan, seconds, 1.0, 0.0)


@jit_borrowing
def step_in(record: Any) -> Step:
    """The Step in an array's record of STEP."""
    return Step(
        record.side, record.x, record.y, record.heading, record.time, record.stance_time, record.stands, record.crouch,
        record.facing,
    )  # fmt: skip


@jit_borrowing
def outward(side: int, toe_out: float) -> float:
    """How far a sole on that side points to the left, whose toes point outward by toe_out [rad]."""
    return toe_out if side == LEFT else -toe_out


@jit_borrowing
def walker_heading(footprints: Footprints, n: Some) -> Some:
    """Where the walker headed who set footprint n [rad]."""
    return footprints.heading[n] - footprints.toe_out[n]


def walker_headings(footprints: Footprints) -> np.ndarray:
    """walker_heading of each footprint, in whatever shape of rows they come [rad]."""
    return np.asarray(footprints.heading - footprints.toe_out)


@jit_borrowing
def _foot(footprints: Footprints, n: int) -> Foot:
    return Foot(
        footprints.side[n], footprints.position[n, 0], footprints.position[n, 1], walker_heading(footprints, n),
        footprints.contact_time[n], footprints.stance_time[n],
    )  # fmt: skip


@jit_borrowing
def feet_before(footprints: Footprints, n: int) -> Feet:
    """The two footprints before row n."""
    return Feet(_foot(footprints, n - 2), _foot(footprints, n - 1))


@jit_borrowing
def first(footprints: Footprints, n: int) -> Footprints:
    """The first n footprints."""
    return part(footprints, 0, n)


@jit_borrowing
def place(footprints: Footprints, n: int, step: Step, out: float, ground: tuple[float, float, float, float], rock: int) -> None:
    """Puts the footprint of a step at row n, its sole turned left by `out` [rad], on the ground: its height [m] and normal.

    It is neither timed nor rolling yet.
    """
    footprints.side[n] = step.side
    footprints.position[n, 0], footprints.position[n, 1], footprints.position[n, 2] = step.x, step.y, ground[0]
    footprints.normal[n, 0], footprints.normal[n, 1], footprints.normal[n, 2] = ground[1], ground[2], ground[3]
    footprints.heading[n], footprints.toe_out[n] = step.heading + out, out
    footprints.rock[n], footprints.stands[n] = rock, False


@jit_borrowing
def stand_on(footprints: Footprints, n: int) -> None:
    """The foot of row n - 2 stands on as row n: the same place, neither timed nor rolling yet."""
    copy_row(footprints, n - 2, n)
    footprints.stands[n] = True


@jit_borrowing
def forget_oldest(footprints: Footprints, count: int) -> None:
    """The first of `count` footprints is forgotten, the others move up."""
    for n in range(count - 1):
        copy_row(footprints, n + 1, n)


@jit_borrowing
def step_length(footprints: Footprints, n: Some) -> Some:
    """Horizontal length of the step to footprint n [m]."""
    p, q = footprints.position[n - 1], footprints.position[n]
    x, y = q[0] - p[0], q[1] - p[1]
    return root(x * x + y * y)


@jit_borrowing
def rise(footprints: Footprints, n: Some) -> Some:
    """How much higher footprint n lies than the one before [m]."""
    return footprints.position[n, 2] - footprints.position[n - 1, 2]


@jit_borrowing
def out_of_plane(footprints: Footprints, n: Some) -> Some:
    """How much higher footprint n lies than the plane through it along its sole passes the one before [m]: a tread's height,
    and nothing on a slope, however steep."""
    p, q, normal = footprints.position[n - 1], footprints.position[n], footprints.normal[n]
    return (q[0] - p[0]) * normal[0] + (q[1] - p[1]) * normal[1] + (q[2] - p[2]) * normal[2]
