"""Posing what is above the legs: pelvis, chest, head, arms and tail."""

import numpy as np

from motion.arithmetic import rotations
from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.pose import head, limbs, trunk
from motion.pose.pose import Hips, Pose
from motion.track.curve import Track
from motion.track.footprints import LEFT, RIGHT
from motion.track.pelvis import weight_at
from worlds.compiled.jit import jit_borrowing, jit_inline, stack_array

_empty_past = stack_array(trunk.PAST, 3)


@jit_inline
def _leg_angle(biped: Dimensions, pose: Pose, c: int, leg: int, yaw: float) -> float:
    """How far the leg is ahead of its hip [rad]."""
    x, y = pose.ankle[c, leg, 0] - pose.hip[c, leg, 0], pose.ankle[c, leg, 1] - pose.hip[c, leg, 1]
    return np.arctan((np.cos(yaw) * x + np.sin(yaw) * y) / biped.leg.nominal_length)


@jit_inline
def _turn(array: np.ndarray, c: int, rotation: rotations.Quaternion) -> None:
    for i in range(4):
        array[c, i] = rotation[i]


@jit_borrowing
def _pose_arms(
    biped: Dimensions, chest: rotations.Axes, angles: tuple[float, float], gait: tuple[float, float], pose: Pose, c: int
) -> None:
    """Arms against the legs, whose angles they are given; gait: pace, and how much they balance."""
    for side in range(2):
        joints = limbs.arm(biped, chest, 1 - 2 * side, angles[1 - side], gait[0], gait[1])
        for axis in range(3):
            pose.shoulder[c, side, axis] = pose.com[c, axis] + joints[0][axis]
            pose.elbow[c, side, axis] = pose.com[c, axis] + joints[1][axis]
            pose.hand[c, side, axis] = pose.com[c, axis] + joints[2][axis]


@jit_borrowing
def _pose_head(biped: Dimensions, headings: Triple, angles: Triple, thrust: Triple, pose: Pose, c: int) -> None:
    """Neck and head, for the headings of body, chest and look, and the body's pitch, its roll and how far the look is down.

    thrust: how far the head is from its middle place [m].
    """
    body, loose, (yaw, chest, look), (pitch, roll, down) = biped.body, 1 - biped.body.head_steady, headings, angles
    _turn(pose.head_rotation_wxyz, c, rotations.quaternion(look, loose * pitch + down, loose * roll))
    neck = rotations.turned(chest, pitch, roll, body.neck_forward, 0.0, body.neck_up)
    forward, up = body.head_forward - body.neck_forward, body.head_up - body.neck_up
    above = rotations.turned(0.5 * (yaw + look), loose * pitch + 0.5 * down, loose * roll, forward, 0.0, up)
    for axis in range(3):
        pose.neck[c, axis] = pose.com[c, axis] + neck[axis]
        pose.head[c, axis] = pose.neck[c, axis] + above[axis] + thrust[axis]


@jit_inline
def pose_body(biped: Dimensions, track: Track, hips: Hips, t: float, pose: Pose, c: int) -> None:
    """Everything above the legs."""
    body, past, yaw = biped.body, _empty_past(), hips.yaw
    trunk.past_of(biped, track.curve, t, past)
    pitch, roll = trunk.pitch_and_roll(biped, past, yaw, weight_at(track.footprints, t))
    breath, aside = trunk.idle_life(biped, past, t)
    pitch += breath
    angles = (_leg_angle(biped, pose, c, LEFT, yaw), _leg_angle(biped, pose, c, RIGHT, yaw))
    apart = np.tanh(angles[0] - angles[1])
    chest = yaw + body.chest_turn * apart
    _turn(pose.body_rotation_wxyz, c, rotations.quaternion(yaw, pitch, roll))
    _turn(pose.pelvis_rotation_wxyz, c, rotations.quaternion(yaw + hips.turn, 0.4 * pitch, hips.roll))
    _turn(pose.chest_rotation_wxyz, c, rotations.quaternion(chest, pitch, roll))
    pace = trunk.pace(biped, past, yaw)
    look = head.looks(biped, track.footprints, yaw, pace, t)
    thrust = head.thrust(biped, track, pose.com[c], t)
    _pose_head(biped, (yaw, chest, look.heading + aside), (pitch, roll, look.down), thrust, pose, c)
    _pose_arms(biped, rotations.axes(chest, pitch, roll), angles, (pace, head.on_rocks(track.footprints, t)), pose, c)
    limbs.lay_tail(biped, track.footprints, past, pose.com[c], (yaw, pitch, roll), t, pose.tail[c])
