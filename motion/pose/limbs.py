"""Arms that swing against the legs, a tail that lags behind the body, a neck's links: functions of the pose and the past."""

from math import cos, exp, log, sin, tanh

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.arithmetic.rotations import Axes, along, turned
from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.pose import trunk
from motion.track import heading
from motion.track.footprints import Footprints
from worlds.compiled.jit import jit_borrowing

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
def arm(
    biped: Dimensions, chest: Axes, side: int, leg_angle: float, pace: float, balance: float
) -> tuple[Triple, Triple, Triple]:
    """(shoulder, elbow, hand), from the com, of the arm on `side` (1 left, -1 right).

    leg_angle [rad] of the other side's leg, forward of the hip; pace as trunk.pace; balance: 1 on rocks, where
    arms are held out; chest: its axes.
    """
    body = biped.body
    shoulder = (body.shoulder_forward, side * body.shoulder_side, body.shoulder_up)
    if body.upper_arm + body.forearm == 0:
        there = along(chest, shoulder[0], shoulder[1], shoulder[2])
        return there, there, there
    swing = body.arm_swing * leg_angle * (1 - LESS_SWING * balance)
    running = 0.5 + 0.5 * tanh(4 * (pace - 0.7))
    forward = BENDS_WITHIN * log(1 + exp(swing / BENDS_WITHIN))  # as max(swing, 0), but smooth
    bend = body.elbow_bend + running * RUNNERS_BEND + BENDS * forward
    out, inward = OUTWARD + running * ELBOWS_OUT + BALANCES * balance, BALANCES * balance - RUNNERS_INWARD * running
    elbow = (
        shoulder[0] + body.upper_arm * sin(swing) * cos(out),
        shoulder[1] + body.upper_arm * side * sin(out),
        shoulder[2] - body.upper_arm * cos(out) * cos(swing),
    )
    hand = (
        elbow[0] + body.forearm * sin(swing + bend) * cos(inward),
        elbow[1] + body.forearm * side * sin(inward),
        elbow[2] - body.forearm * cos(swing + bend) * cos(inward),
    )
    return (
        along(chest, shoulder[0], shoulder[1], shoulder[2]),
        along(chest, elbow[0], elbow[1], elbow[2]),
        along(chest, hand[0], hand[1], hand[2]),
    )


@jit_borrowing
def lay_tail(
    biped: Dimensions, footprints: Footprints, past: np.ndarray, com: np.ndarray, angles: Triple, t: float, tail: np.ndarray
) -> None:
    """Fills tail (TAIL + 1, 3), root first, world: piece k follows what the body did k + 1 delays ago.

    angles: the body's yaw, pitch and roll [rad].
    """
    body, (yaw, pitch, roll) = biped.body, angles
    x, y, z = turned(yaw, pitch, roll, body.tail_forward, 0.0, body.tail_up)
    tail[0, 0], tail[0, 1], tail[0, 2] = com[0] + x, com[1] + y, com[2] + z
    if body.tail_length == 0:
        for k in range(1, TAIL + 1):
            tail[k, 0], tail[k, 1], tail[k, 2] = tail[0, 0], tail[0, 1], tail[0, 2]
        return
    piece, step = body.tail_length / TAIL, trunk.delay(biped)
    for k in range(TAIL):
        then = heading.body_heading(biped, footprints, t - (k + 1) * step)
        ax, ay, az = trunk.trend(biped, past, k)
        left = cos(then) * ay - sin(then) * ax
        share = body.tail_sway * (k + 1) / TAIL
        bend = yaw + body.tail_sway * (then - yaw) + WHIP * share * MOST_WHIP * tanh(left / (2.0 * MOST_WHIP))
        rise = body.tail_rise - 0.5 * pitch - FLAP * share * tanh(az / GRAVITY)
        tail[k + 1, 0] = tail[k, 0] - piece * cos(rise) * cos(bend)
        tail[k + 1, 1] = tail[k, 1] - piece * cos(rise) * sin(bend)
        tail[k + 1, 2] = tail[k, 2] + piece * sin(rise)
