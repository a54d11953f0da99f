"""A pose: where everything of a character is at one time."""

from typing import Annotated, NamedTuple

import numpy as np

from motion.arithmetic.triples import Triple
from motion.pose.limbs import TAIL
from worlds.compiled.jit import jit_inline
from worlds.compiled.lanes import Some
from worlds.compiled.tables import Column, Integers, Numbers, Quaternions, Vectors, empty

Joints = Annotated[np.ndarray, Column(shape=(2, 3))]
"""A point of either side, left first."""


class Hips(NamedTuple):
    """How the body above the legs is turned [rad]."""

    yaw: Some  # the body's heading
    turn: Some  # of the pelvis against it (motion.track.pelvis)
    roll: Some  # its list


class Pose(NamedTuple):
    """C characters at one time, world frame, SI units; feet in the order LEFT, RIGHT.

    `ankle` is the end of the virtual leg. A three-link leg has its `hock` between knee and ankle; in a two-link leg the
    hock is the ankle. heel and toe are the ends of the sole, ball the point about which it bends.
    """

    com: Vectors  # (C, 3)
    com_velocity: Vectors  # (C, 3)
    com_acceleration: Vectors  # (C, 3)
    body_rotation_wxyz: Quaternions  # (C, 4) body to world; the hips follow its yaw alone
    pelvis_rotation_wxyz: Quaternions  # (C, 4) turned with the legs, dropped toward the swinging one
    chest_rotation_wxyz: Quaternions  # (C, 4) turned against the pelvis
    head_rotation_wxyz: Quaternions  # (C, 4)
    neck: Vectors  # (C, 3) its base
    head: Vectors  # (C, 3)
    shoulder: Joints  # (C, 2, 3) arms; at the shoulder throughout where there are none
    elbow: Joints  # (C, 2, 3)
    hand: Joints  # (C, 2, 3)
    tail: Annotated[np.ndarray, Column(shape=(TAIL + 1, 3))]  # (C, TAIL + 1, 3) root first; all at the root where none is
    hip: Joints  # (C, 2, 3)
    knee: Joints  # (C, 2, 3)
    hock: Joints  # (C, 2, 3)
    ankle: Joints  # (C, 2, 3)
    heel: Joints  # (C, 2, 3)
    ball: Joints  # (C, 2, 3)
    toe: Joints  # (C, 2, 3)
    contact: Annotated[np.ndarray, Column(np.bool_, (2,))]  # (C, 2) bool, by timing
    point_of_support: Joints  # (C, 2, 3); NaN while the foot swings
    phase: Integers  # (C,) motion.track.phases
    physics_cost: Numbers  # (C,) [m/s^2]
    comfort_cost: Numbers  # (C,)


def empty_pose(count: int) -> Pose:
    """A pose of so many characters, all zero."""
    return empty(Pose, count)


@jit_inline
def point_of(array: np.ndarray, c: int, side: int) -> Triple:
    """A point of one side of character c."""
    return array[c, side, 0], array[c, side, 1], array[c, side, 2]
