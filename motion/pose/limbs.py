"""Arms that swing against the legs, a tail that lags behind the body, a neck's links: functions of the pose and the past."""

import numpy as np

from motion.arithmetic.functions import exponential, levelled, logarithm, turn
from motion.arithmetic.gravity import GRAVITY
from motion.arithmetic.rotations import Axes, along
from motion.arithmetic.triples import Triple, plus
from motion.characters.dimensions import Dimensions
from motion.pose import trunk
from motion.track import heading
from motion.track.curve import Track
from worlds.compiled.across import any_of
from worlds.compiled.beside.places import put
from worlds.compiled.jit import jit_borrowing
from worlds.compiled.lanes import Some

TAIL = 6
"""Pieces of a tail."""
RUNNERS_BEND = 1.15
"""Further bend of the elbows at a run [rad]."""
OUTWARD, ELBOWS_OUT = 0.12, 0.25
"""Arms hang this far outward, a runner's further [rad]."""
BENDS, BENDS_WITHIN = 0.55, 0.15
"""Bend of the elbow per swing forward; how gradually it begins [rad]."""
BALANCES, LESS_SWING = 0.55, 0.5
"""How far arms are held out on rocks [rad], and the share by which they swing less."""
RUNNERS_INWARD = 0.12
"""How far a runner's hands point inward, in forearms: clear of the hips."""
NECK_LINKS = 1.45
"""Length of a bobbing neck's two links together, in the distance that they bridge at rest."""
WHIP, FLAP, MOST_WHIP = 0.22, 0.16, 1.5
"""How far the tail swings per sway: sideways with 2 m/s^2, and up at most, three quarters of that with g of acceleration [rad];
how far sideways at most, in the first."""


@jit_borrowing
def neck_links(biped: Dimensions) -> tuple[Triple, Triple]:
    """The neck at rest, from its base to the head, in two links [m]: of one length, bent forward, if the head bobs."""
    body = biped.body
    x, z = 0.5 * (body.head_forward - body.neck_forward), 0.5 * (body.head_up - body.neck_up)
    if body.head_bob == 0:
        return (x, 0.0, z), (x, 0.0, z)
    bulge = (NECK_LINKS * NECK_LINKS - 1) ** 0.5
    return (x + bulge * z, 0.0, z - bulge * x), (x - bulge * z, 0.0, z + bulge * x)


@jit_borrowing
def arm(biped: Dimensions, chest: Axes, side: int, leg_angle: Some, gait: tuple[Some, Some]) -> tuple[Triple, Triple, Triple]:
    """(shoulder, elbow, hand), from the com, of the arm on `side` (1 left, -1 right).

    leg_angle [rad] of the other side's leg, forward of the hip; gait: pace as trunk.pace, and balance, 1 on rocks, where
    arms are held out; chest: its axes.
    """
    body, (pace, balance) = biped.body, gait
    shoulder = (body.shoulder_forward, side * body.shoulder_side, body.shoulder_up)
    there = along(chest, shoulder[0], shoulder[1], shoulder[2])
    if not any_of(body.upper_arm + body.forearm > 0.0):
        return there, there, there
    swing = body.arm_swing * leg_angle * (1 - LESS_SWING * balance)
    running = 0.5 + 0.5 * levelled(4 * (pace - 0.7))
    forward = BENDS_WITHIN * logarithm(1 + exponential(swing / BENDS_WITHIN))  # as max(swing, 0), but smooth
    bend = body.elbow_bend + running * RUNNERS_BEND + BENDS * forward
    out, inward = OUTWARD + running * ELBOWS_OUT + BALANCES * balance, BALANCES * balance - RUNNERS_INWARD * running
    elbow = plus(shoulder, _link(body.upper_arm, side, turn(swing), turn(out)))
    hand = plus(elbow, _link(body.forearm, side, turn(swing + bend), turn(inward)))
    return there, along(chest, elbow[0], elbow[1], elbow[2]), along(chest, hand[0], hand[1], hand[2])


@jit_borrowing
def _link(length: Some, side: int, swing: tuple[Some, Some], out: tuple[Some, Some]) -> Triple:
    """The way along a link that has swung forward and outward by angles of these cosines and sines, of a body."""
    return length * swing[1] * out[0], length * side * out[1], -length * out[0] * swing[0]


@jit_borrowing
def lay_tail(
    biped: Dimensions, track: Track, past: trunk.Past, root: Triple, angles: tuple[Some, Some], t: Some, tail: np.ndarray,
    rows: Some,
) -> None:  # fmt: skip
    """Fills tail (K, TAIL + 1, 3) of the rows, root first, world: piece k follows what the body did k + 1 delays ago.

    root: where it begins; angles: the body's yaw and pitch [rad].
    """
    body, (yaw, pitch), place = biped.body, angles, root
    put(tail, rows, (0,), place)
    step, moving = trunk.delay(biped), any_of(body.tail_length > 0.0)
    for k in range(TAIL):
        if moving:
            place = plus(place, _piece(biped, track, past, (yaw, pitch), t - (k + 1) * step, (k + 1) / TAIL))
            past = trunk.Past(past.before, past.long_before, trunk.place_before(biped, track.curve, t, k + 3))
        put(tail, rows, (k + 1,), place)


@jit_borrowing
def _piece(biped: Dimensions, track: Track, past: trunk.Past, angles: tuple[Some, Some], then: Some, along: float) -> Triple:
    """The way along a piece of the tail, that share along it, which follows what the body did then."""
    body, (yaw, pitch) = biped.body, angles
    length, headed = body.tail_length / TAIL, heading.body_heading(biped, track.footprints, then)
    x, y, z = trunk.trend(biped, past)
    c, s = turn(headed)
    share = body.tail_sway * along
    bend = yaw + body.tail_sway * (headed - yaw) + WHIP * share * MOST_WHIP * levelled((c * y - s * x) / (2.0 * MOST_WHIP))
    (c, s), (d, e) = turn(bend), turn(body.tail_rise - 0.5 * pitch - FLAP * share * levelled(z / GRAVITY))
    return -length * d * c, -length * d * s, length * e
