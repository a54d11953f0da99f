"""Arms that swing against the legs, and a tail that lags behind the body: functions of the pose and the past."""

from math import cos, sin

from motion.pose import body
from motion.track import heading
from worlds.compiled.jit import jit_borrowing

TAIL = 6
"""Pieces of a tail."""
RUNNERS_BEND = 1.15
"""Further bend of the elbows at a run [rad]."""
OUTWARD = 0.12
"""Arms hang this far outward [rad]."""
WHIP, FLAP = 0.22, 0.16
"""How far the tail swings sideways and up per sway, with g / 5 and g of acceleration [rad]."""


@jit_borrowing
def arm(b, chest, side, leg_angle, pace):
    """(shoulder, elbow, hand), each (3,) from the com, of the arm on `side` (1 left, -1 right); leg_angle [rad] of the other
    side's leg, forward of the hip; chest: its axes, of motion.pose.body.axes."""
    shoulder = (b.shoulder_forward, side * b.shoulder_side, b.shoulder_up)
    if b.upper_arm + b.forearm == 0:
        there = body.along(chest, shoulder[0], shoulder[1], shoulder[2])
        return there, there, there
    swing = b.arm_swing * leg_angle
    running = min(max(2 * pace - 0.9, 0.0), 1.0)
    bend = b.elbow_bend + running * RUNNERS_BEND + 0.45 * max(swing, 0.0)
    out = side * sin(OUTWARD)
    elbow = (
        shoulder[0] + b.upper_arm * sin(swing),
        shoulder[1] + b.upper_arm * out,
        shoulder[2] - b.upper_arm * cos(OUTWARD) * cos(swing),
    )
    inward = -side * 0.25 * running
    hand = (
        elbow[0] + b.forearm * sin(swing + bend),
        elbow[1] + b.forearm * inward,
        elbow[2] - b.forearm * cos(swing + bend),
    )
    return (
        body.along(chest, shoulder[0], shoulder[1], shoulder[2]),
        body.along(chest, elbow[0], elbow[1], elbow[2]),
        body.along(chest, hand[0], hand[1], hand[2]),
    )


@jit_borrowing
def lay_tail(b, track, past, com, yaw, pitch, roll, t, tail):
    """Fills tail (TAIL + 1, 3), root first, world: piece k follows what the body did k + 1 delays ago."""
    x, y, z = body.turned(yaw, pitch, roll, b.tail_forward, 0.0, b.tail_up)
    tail[0, 0], tail[0, 1], tail[0, 2] = com[0] + x, com[1] + y, com[2] + z
    if b.tail_length == 0:
        for k in range(1, TAIL + 1):
            tail[k, 0], tail[k, 1], tail[k, 2] = tail[0, 0], tail[0, 1], tail[0, 2]
        return
    piece, step = b.tail_length / TAIL, body.delay(b)
    for k in range(TAIL):
        then = heading.body_heading(b, track, t - (k + 1) * step)
        ax, ay, az = body.trend(b, past, k)
        left = cos(then) * ay - sin(then) * ax
        share = b.tail_sway * (k + 1) / TAIL
        bend = yaw + b.tail_sway * (then - yaw) + WHIP * share * min(max(left / 2.0, -1.5), 1.5)
        rise = b.tail_rise - 0.5 * pitch - FLAP * share * min(max(az / body.GRAVITY, -1.0), 1.0)
        tail[k + 1, 0] = tail[k, 0] - piece * cos(rise) * cos(bend)
        tail[k + 1, 1] = tail[k, 1] - piece * cos(rise) * sin(bend)
        tail[k + 1, 2] = tail[k, 2] + piece * sin(rise)
