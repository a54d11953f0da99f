"""The pose at any time, from the curve and the footprints alone: nothing is integrated, nothing drifts."""

import numpy as np

from motion.characters.dimensions import Dimensions
from motion.com import cost
from motion.pose.body import pose_body
from motion.pose.feet import pose_leg
from motion.pose.pose import Pose
from motion.track import heading, phases
from motion.track.curve import Track, evaluate
from motion.track.footprints import LEFT, RIGHT, Footprints
from worlds.compiled.jit import jit_borrowing, jit_inline


@jit_inline
def _comfort_cost(biped: Dimensions, footprints: Footprints, n: int, pose: Pose, c: int, leg: int) -> float:
    """Of a leg that footprint n carries (paper, section 2.4)."""
    x, y = pose.hip[c, leg, 0] - pose.ankle[c, leg, 0], pose.hip[c, leg, 1] - pose.ankle[c, leg, 1]
    z = pose.hip[c, leg, 2] - pose.ankle[c, leg, 2]
    return biped.leg.comfort_weight * (np.sqrt(x * x + y * y + z * z) - footprints.nominal_length[n]) ** 2


@jit_borrowing
def pose_kernel(biped: Dimensions, track: Track, t: float, pose: Pose, c: int) -> None:
    """Fills row c of `pose` with a character at time t [s] of its track."""
    com, acceleration, footprints = pose.com[c], pose.com_acceleration[c], track.footprints
    evaluate(track.curve, t, com, pose.com_velocity[c], acceleration)
    left, right = phases.support_at(footprints, 0, t)
    yaw = heading.body_heading(biped, footprints, t)
    pose.phase[c] = phases.phase_of(left, right)
    swung_left = pose_leg(biped, footprints, left, LEFT, yaw, t, pose, c)
    swung_right = pose_leg(biped, footprints, right, RIGHT, yaw, t, pose, c)
    pose_body(biped, track, yaw, (swung_left, swung_right), t, pose, c)
    pose.physics_cost[c] = cost.physics_cost(com, acceleration, pose.point_of_support[c], pose.contact[c])
    pose.comfort_cost[c] = 0.0
    if left >= 0:
        pose.comfort_cost[c] += _comfort_cost(biped, footprints, left, pose, c, LEFT)
    if right >= 0:
        pose.comfort_cost[c] += _comfort_cost(biped, footprints, right, pose, c, RIGHT)
