"""Posing what is above the legs: pelvis, chest, head, arms and tail."""

from typing import NamedTuple

import numpy as np

from motion.arithmetic import rotations
from motion.arithmetic.functions import angle, levelled, turn
from motion.arithmetic.rotations import Axes, Quaternion
from motion.arithmetic.triples import Triple, plus
from motion.characters.dimensions import Dimensions
from motion.pose import head, limbs, trunk
from motion.pose.pose import Hips
from motion.track.curve import Track
from motion.track.pelvis import weight_at
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some


class Upper(NamedTuple):
    """What is above the legs."""

    body: Quaternion
    pelvis: Quaternion
    chest: Quaternion
    gaze: Quaternion  # of the head
    neck: Triple
    head: Triple
    arms: tuple[tuple[Triple, Triple, Triple], tuple[Triple, Triple, Triple]]  # left, right: shoulder, elbow, hand


class Carriage(NamedTuple):
    """How the body is turned [rad]."""

    yaw: Some
    chest: Some  # its heading
    pitch: Some
    roll: Some


@jit_inline
def _leg_angle(biped: Dimensions, way: Triple, toward: tuple[Some, Some]) -> Some:
    """How far a leg is ahead of its hip [rad]; way: from hip to ankle."""
    ahead, nominal = toward[0] * way[0] + toward[1] * way[1], biped.leg.nominal_length
    return angle(nominal, ahead)


@jit_borrowing
def _arms(biped: Dimensions, com: Triple, chest: Axes, legs: tuple[Some, Some], gait: tuple[Some, Some]) -> tuple:
    """Arms against the legs, whose angles they are given, left first; gait: pace, and how much they balance."""
    a, b, c = limbs.arm(biped, chest, 1, legs[1], gait)
    d, e, f = limbs.arm(biped, chest, -1, legs[0], gait)
    return (plus(com, a), plus(com, b), plus(com, c)), (plus(com, d), plus(com, e), plus(com, f))


@jit_borrowing
def _neck_and_head(biped: Dimensions, carriage: Carriage, looks: head.Looks, chest: Axes) -> tuple[Triple, Triple, Quaternion]:
    """(neck from the com, head from the neck, rotation of the head)."""
    body, loose = biped.body, 1 - biped.body.head_steady
    pitch, roll = loose * carriage.pitch, loose * carriage.roll
    forward, up = body.head_forward - body.neck_forward, body.head_up - body.neck_up
    above = rotations.turned(0.5 * (carriage.yaw + looks.heading), pitch + 0.5 * looks.down, roll, forward, 0.0, up)
    gaze = rotations.quaternion(looks.heading, pitch + looks.down, roll)
    return rotations.along(chest, body.neck_forward, 0.0, body.neck_up), above, gaze


@jit_borrowing
def _carriage(biped: Dimensions, track: Track, past: trunk.Past, hips: Hips, apart: Some, t: Some) -> tuple[Carriage, Some]:
    """How the body is turned, and how far the eyes look aside [rad]; apart: between the legs [rad]."""
    pitch, roll = trunk.pitch_and_roll(biped, past, turn(hips.yaw), weight_at(track.footprints, t))
    breath, aside = trunk.idle_life(biped, past, t)
    chest = hips.yaw + biped.body.chest_turn * levelled(apart)
    return Carriage(hips.yaw, chest, pitch + breath, roll), aside


@jit_borrowing
def pose_body(
    biped: Dimensions, track: Track, hips: Hips, com: Triple, legs: tuple[Triple, Triple], t: Some, tail: np.ndarray, rows: Some
) -> Upper:  # fmt: skip
    """Everything above the legs, whose ways from hip to ankle are given; fills the rows of tail (K, TAIL + 1, 3)."""
    body, past, toward = biped.body, trunk.past_of(biped, track.curve, com, t), turn(hips.yaw)
    angles = (_leg_angle(biped, legs[0], toward), _leg_angle(biped, legs[1], toward))
    carriage, aside = _carriage(biped, track, past, hips, angles[0] - angles[1], t)
    yaw, chest, pitch, roll = carriage
    pace, axes = trunk.pace(biped, past, toward), rotations.axes(chest, pitch, roll)
    looks = head.looks(biped, track.footprints, yaw, pace, t)
    neck, above, gaze = _neck_and_head(biped, carriage, head.Looks(looks.heading + aside, looks.down), axes)
    neck, root = plus(com, neck), plus(com, rotations.turned(yaw, pitch, roll, body.tail_forward, 0.0, body.tail_up))
    limbs.lay_tail(biped, track, past, root, (yaw, pitch), t, tail, rows)
    return Upper(
        rotations.quaternion(yaw, pitch, roll),
        rotations.quaternion(yaw + hips.turn, 0.4 * pitch, hips.roll),
        rotations.quaternion(chest, pitch, roll),
        gaze,
        neck,
        plus(plus(neck, above), head.thrust(biped, track, com, t)),
        _arms(biped, com, axes, angles, (pace, head.on_rocks(track.footprints, t))),
    )
