"""The pose at any time, from the curve and the footprints alone: nothing is integrated, nothing drifts."""

from typing import Any, NamedTuple

import numpy as np

from motion.characters.dimensions import Dimensions, empty_bipeds
from motion.com import cost
from motion.pose.body import pose_body
from motion.pose.feet import pose_leg
from motion.pose.knees import Legs, keep_apart
from motion.pose.pose import Hips, Pose, empty_pose
from motion.track import foot, heading, phases
from motion.track.curve import Curve, Track, evaluate
from motion.track.footprints import LEFT, Footprints
from motion.track.leg import nominal_at
from motion.track.pelvis import pelvis_at
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.parts import Part, call, handle
from worlds.compiled.tables import empty


@jit_inline
def _comfort_cost(biped: Dimensions, footprints: Footprints, n: int, t: float, pose: Pose, c: int, leg: int) -> float:
    """Of a leg that footprint n carries (paper, section 2.4)."""
    x, y = pose.hip[c, leg, 0] - pose.ankle[c, leg, 0], pose.hip[c, leg, 1] - pose.ankle[c, leg, 1]
    z = pose.hip[c, leg, 2] - pose.ankle[c, leg, 2]
    nominal = nominal_at(biped, footprints, n, foot.stance_share(footprints, n, t))
    return biped.leg.comfort_weight * (np.sqrt(x * x + y * y + z * z) - nominal) ** 2


class Posed(NamedTuple):
    """Who is posed, and when."""

    bipeds: Any  # recarray of Dimensions
    kind: int  # which of them it is
    track: Track
    time: float  # [s]
    row: int  # of the pose


lend_pose, _open_pose, _, _ = handle(empty_pose(1))
lend_posed, _open_posed, _, _ = handle(Posed(empty_bipeds(1), 0, Track(empty(Footprints, 1), empty(Curve, 1)), 0.0, 0))


@Part
def pose_one(posed_at: int, pose_at: int) -> None:
    """Fills a row of the Pose lent at `pose_at` with the Posed lent at `posed_at`."""
    pose, (bipeds, kind, track, t, c) = _open_pose(pose_at), _open_posed(posed_at)
    biped = bipeds[kind]
    com, acceleration, footprints = pose.com[c], pose.com_acceleration[c], track.footprints
    evaluate(track.curve, t, com, pose.com_velocity[c], acceleration)
    left, right = phases.support_at(footprints, 0, t)
    yaw = heading.body_heading(biped, footprints, t)
    pose.phase[c] = phases.phase_of(left, right)
    turn, roll = pelvis_at(biped, footprints, t)
    hips = Hips(yaw, turn, roll)
    pose.comfort_cost[c] = 0.0
    for leg in range(2):  # a loop, so that the compiler makes the leg once
        n = left if leg == LEFT else right
        pose_leg(biped, track, n, leg, hips, t, pose, c)
        if n >= 0:
            pose.comfort_cost[c] += _comfort_cost(biped, footprints, n, t, pose, c, leg)
    keep_apart(biped, yaw, Legs(pose.hip[c], pose.knee[c], pose.hock[c], pose.ankle[c]))
    pose_body(biped, track, hips, t, pose, c)
    pose.physics_cost[c] = cost.physics_cost(com, acceleration, pose.point_of_support[c], pose.contact[c])


def pose_into(biped: Dimensions, track: Track, time: float, pose: Pose) -> None:
    """Fills row 0 of `pose` with a character at a time [s] of its track."""
    bipeds = empty_bipeds(1)
    bipeds[0] = biped
    _call(pose_one.address, Posed(bipeds, 0, track, time, 0), pose)


@jit_borrowing
def _call(part: int, posed: Posed, pose: Pose) -> None:
    call(part, lend_posed(posed), lend_pose(pose))
