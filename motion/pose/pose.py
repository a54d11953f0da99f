"""The pose at any time, from the curve and the footprints alone: nothing is integrated, nothing drifts."""

from typing import NamedTuple

import numpy as np

from motion.com import cost
from motion.pose import body, legs, limbs, swing
from motion.track import foot, heading, phases, spline
from worlds.compiled.jit import jit_borrowing, jit_inline, stack_array


class Pose(NamedTuple):
    """C characters at one time, world frame, SI units; feet in the order LEFT, RIGHT.

    `ankle` is the end of the virtual leg. A three-link leg has its `hock` between knee and ankle; in a two-link leg the
    hock is the ankle. heel and toe are the ends of the sole, ball the point about which it bends.
    """

    com: np.ndarray  # (C, 3)
    com_velocity: np.ndarray  # (C, 3)
    com_acceleration: np.ndarray  # (C, 3)
    body_rotation_wxyz: np.ndarray  # (C, 4) body to world; the hips follow its yaw alone
    pelvis_rotation_wxyz: np.ndarray  # (C, 4) turned with the legs, dropped toward the swinging one
    chest_rotation_wxyz: np.ndarray  # (C, 4) turned against the pelvis
    head_rotation_wxyz: np.ndarray  # (C, 4)
    neck: np.ndarray  # (C, 3) its base
    head: np.ndarray  # (C, 3)
    shoulder: np.ndarray  # (C, 2, 3) arms; at the shoulder throughout where there are none
    elbow: np.ndarray  # (C, 2, 3)
    hand: np.ndarray  # (C, 2, 3)
    tail: np.ndarray  # (C, TAIL + 1, 3) root first; all at the root where there is none
    hip: np.ndarray  # (C, 2, 3)
    knee: np.ndarray  # (C, 2, 3)
    hock: np.ndarray  # (C, 2, 3)
    ankle: np.ndarray  # (C, 2, 3)
    heel: np.ndarray  # (C, 2, 3)
    ball: np.ndarray  # (C, 2, 3)
    toe: np.ndarray  # (C, 2, 3)
    contact: np.ndarray  # (C, 2) bool, by timing
    point_of_support: np.ndarray  # (C, 2, 3); NaN while the foot swings
    phase: np.ndarray  # (C,) int64, motion.track.phases
    physics_cost: np.ndarray  # (C,) [m/s^2]
    comfort_cost: np.ndarray  # (C,)


FREE_REACH, FIRM_REACH = 0.93, 0.99
"""Shares of its full length up to which a swinging leg goes freely: in the middle of its swing, and near the ends."""
FREE_ENDS = 0.25
"""Share of the swing, at either end, over which the first gives way to the second."""
KNEE_TURN = 0.25
"""Legs bend half way between body and toes, but turn no farther from the body than this [rad], so that knees keep apart."""
CARRIED_FROM, CARRIED = 4.0, 5.5
"""Swing times, in pendulum times sqrt(l / g), from which on a foot is carried with the body, and from which on wholly."""
CARRIED_ENDS, HANGS = 0.35, (0.3, 0.72)
"""Share of the swing, at either end, over which that sets in; where the ankle hangs, back and down from the hip, in legs."""
VECTORS = ("hip", "knee", "hock", "ankle", "heel", "ball", "toe")
_empty_past = stack_array(body.PAST, 3)
_PAIRS = (*VECTORS, "point_of_support", "shoulder", "elbow", "hand")
_POINTS = ("com", "com_velocity", "com_acceleration", "neck", "head")
_TURNS = ("body_rotation_wxyz", "pelvis_rotation_wxyz", "chest_rotation_wxyz", "head_rotation_wxyz")


def empty_pose(c: int) -> Pose:
    """A pose of c characters, all zero."""
    shapes: dict[str, tuple[int, ...]] = dict.fromkeys(_PAIRS, (c, 2, 3))
    shapes |= dict.fromkeys(_POINTS, (c, 3)) | dict.fromkeys(_TURNS, (c, 4)) | {"tail": (c, limbs.TAIL + 1, 3)}
    kinds = {"contact": ((c, 2), np.bool_), "phase": ((c,), np.int64)}
    return Pose(*(np.zeros(*kinds[name]) if name in kinds else np.zeros(shapes.get(name, (c,))) for name in Pose._fields))


@jit_borrowing
def footprints_at(track, leg, t):
    """(last, next) footprint of foot `leg` at time t: it stands on last, or swings from it to next; -1 for none."""
    last, following = -1, -1
    for i in range(len(track.side)):
        if track.side[i] == leg:
            if track.contact_time[i] <= t:
                last = i
            elif following < 0:
                following = i
    return last, following


@jit_inline
def _set(array, c, leg, point):
    array[c, leg, 0], array[c, leg, 1], array[c, leg, 2] = point


@jit_inline
def _stand(b, track, n, t, pose, c, leg):
    """The foot on footprint n at time t; a foot whose next footprint is not known yet stays where it stands."""
    u = min(max((t - track.contact_time[n]) / track.stance_time[n], 0.0), 1.0)
    pitch = foot.heel_off_angle(b, track.roll[n, 1], u)
    position, yaw, normal = track.position[n], track.heading[n], track.normal[n]
    _set(pose.ball, c, leg, foot.along_sole(position, yaw, normal, b.ball_forward, 0.0))
    _set(pose.toe, c, leg, foot.along_sole(position, yaw, normal, 0.5 * b.foot_length, 0.0))
    x, z = foot.about_ball(b, -0.5 * b.foot_length, 0.0, pitch)
    _set(pose.heel, c, leg, foot.along_sole(position, yaw, normal, x, z))
    _set(pose.ankle, c, leg, foot.stance_ankle(b, track, n, u))
    return yaw


@jit_inline
def _fly(b, track, last, following, t, pose, c, leg):
    """The foot on its way from footprint `last` to `following`."""
    left = track.contact_time[last] + track.stance_time[last]
    s = min(max((t - left) / (track.contact_time[following] - left), 0.0), 1.0)
    ball, yaw, normal, pitch, flex = swing.sole_at(b, track, last, following, s)
    _set(pose.ball, c, leg, ball)
    back = -0.5 * b.foot_length - b.ball_forward
    toe = 0.5 * b.foot_length - b.ball_forward
    _set(pose.heel, c, leg, swing.point_of_foot(b, ball, yaw, normal, back, 0.0, pitch))
    _set(pose.toe, c, leg, swing.point_of_foot(b, ball, yaw, normal, toe, 0.0, pitch - flex))
    ahead = b.ankle_forward - b.ball_forward
    _set(pose.ankle, c, leg, swing.point_of_foot(b, ball, yaw, normal, ahead, b.ankle_height, pitch))
    return s, yaw


@jit_inline
def _carry(b, hip, yaw, swing_time, s, pose, c, leg):
    """Lets a foot that swings for long, as the free one in hops on the other leg, hang behind its hip meanwhile."""
    long = (swing_time / np.sqrt(b.nominal_length / cost.GRAVITY) - CARRIED_FROM) / (CARRIED - CARRIED_FROM)
    if long <= 0:
        return
    share = (1 - swing.fade(long, 1.0)) * (1 - swing.fade(min(s, 1 - s), CARRIED_ENDS))
    back, down = HANGS[0] * b.nominal_length, HANGS[1] * b.nominal_length
    ankle = pose.ankle[c, leg]
    way = (hip[0] - back * np.cos(yaw) - ankle[0], hip[1] - back * np.sin(yaw) - ankle[1], hip[2] - down - ankle[2])
    for array in (pose.ankle, pose.heel, pose.ball, pose.toe):
        for axis in range(3):
            array[c, leg, axis] += share * way[axis]


@jit_borrowing
def _limited(length, free, full):
    """A length that is its own up to `free` and comes smoothly to `full`: free + (full - free) (1 - exp(-x)), x = (length -
    free) / (full - free)."""
    if length <= free:
        return length
    return free + (full - free) * (1 - np.exp((free - length) / (full - free)))


@jit_borrowing
def _leg_length(b, length, s):
    """Length [m] of a leg at share s of its swing whose foot's way would ask for `length`: neither too long nor too bent."""
    calm = 1 - swing.fade(min(s, 1 - s), FREE_ENDS)
    if length < b.min_length:
        return length + calm * (b.min_length - length)
    near = _limited(length, FIRM_REACH * b.max_length, b.max_length)
    return near + calm * (_limited(length, FREE_REACH * b.max_length, b.max_length) - near)


@jit_inline
def _keep_in_reach(b, hip, s, pose, c, leg):
    """Draws a swinging foot along the line to its hip, so that its leg is never longer or more bent than it can be."""
    ankle = pose.ankle[c, leg]
    x, y, z = ankle[0] - hip[0], ankle[1] - hip[1], ankle[2] - hip[2]
    length = max(np.sqrt(x * x + y * y + z * z), 1e-6)
    share = 1 - _leg_length(b, length, s) / length
    for array in (pose.ankle, pose.heel, pose.ball, pose.toe):
        array[c, leg, 0] -= share * x
        array[c, leg, 1] -= share * y
        array[c, leg, 2] -= share * z


@jit_inline
def _pose_leg(b, track, support, leg, yaw, t, pose, c):
    """Poses a leg; returns how far it has swung, 0 standing to 1 in the middle of a swing."""
    n, swung = support[leg], 0.0
    offset = foot.hip_offset(b, leg, yaw)
    hip = (pose.com[c, 0] + offset[0], pose.com[c, 1] + offset[1], pose.com[c, 2] + offset[2])
    _set(pose.hip, c, leg, hip)
    pose.contact[c, leg] = n >= 0
    if n >= 0:
        u = min(max((t - track.contact_time[n]) / track.stance_time[n], 0.0), 1.0)
        _set(pose.point_of_support, c, leg, foot.point_of_support(b, track, n, u))
        toes = _stand(b, track, n, t, pose, c, leg)
    else:
        pose.point_of_support[c, leg] = np.nan
        last, following = footprints_at(track, leg, t)
        if following < 0:
            toes = _stand(b, track, last, t, pose, c, leg)
        elif last < 0:
            toes = _stand(b, track, following, t, pose, c, leg)
        else:
            s, toes = _fly(b, track, last, following, t, pose, c, leg)
            swing_time = track.contact_time[following] - track.contact_time[last] - track.stance_time[last]
            _carry(b, hip, yaw, swing_time, s, pose, c, leg)
            _keep_in_reach(b, hip, s, pose, c, leg)
            swung = swing.bump(s)
    ahead = yaw + KNEE_TURN * np.tanh(0.5 * (toes - yaw) / KNEE_TURN)
    ankle = pose.ankle[c, leg]
    knee, hock = legs.joints(b, hip, (ankle[0], ankle[1], ankle[2]), (np.cos(ahead), np.sin(ahead), 0.0))
    _set(pose.knee, c, leg, knee)
    _set(pose.hock, c, leg, hock)
    return swung


@jit_inline
def _leg_angle(b, pose, c, leg, yaw):
    """How far the leg is ahead of its hip [rad]."""
    x, y = pose.ankle[c, leg, 0] - pose.hip[c, leg, 0], pose.ankle[c, leg, 1] - pose.hip[c, leg, 1]
    return np.arctan((np.cos(yaw) * x + np.sin(yaw) * y) / b.nominal_length)


@jit_inline
def _turn(array, c, rotation):
    for i in range(4):
        array[c, i] = rotation[i]


@jit_inline
def _pose_body(b, track, curve_time, control, yaw, swung, t, pose, c):
    """Everything above the legs; swung (2,) as _pose_leg returns it."""
    past = _empty_past()
    body.past_of(b, curve_time, control, t, past)
    pitch, roll = body.pitch_and_roll(b, past, yaw)
    angles = (_leg_angle(b, pose, c, 0, yaw), _leg_angle(b, pose, c, 1, yaw))
    legs_apart = min(max(angles[0] - angles[1], -1.0), 1.0)
    chest = yaw + b.chest_turn * legs_apart
    look = body.gaze(b, track, yaw, t)
    _turn(pose.body_rotation_wxyz, c, body.quaternion(yaw, pitch, roll))
    drop = b.pelvis_drop * (swung[1] - swung[0])
    _turn(pose.pelvis_rotation_wxyz, c, body.quaternion(yaw - b.pelvis_turn * legs_apart, 0.4 * pitch, 0.4 * roll + drop))
    _turn(pose.chest_rotation_wxyz, c, body.quaternion(chest, pitch, roll))
    loose = 1 - b.head_steady
    _turn(pose.head_rotation_wxyz, c, body.quaternion(look, loose * pitch, loose * roll))
    com, pace = pose.com[c], body.pace(b, past, yaw)
    neck = body.turned(chest, pitch, roll, b.neck_forward, 0.0, b.neck_up)
    bob = body.head_offset(b, track, past, yaw, t)
    above = body.turned(
        0.5 * (yaw + look), loose * pitch, loose * roll, b.head_forward - b.neck_forward + bob, 0.0, b.head_up - b.neck_up
    )
    for axis in range(3):
        pose.neck[c, axis] = com[axis] + neck[axis]
        pose.head[c, axis] = pose.neck[c, axis] + above[axis]
    axes = body.axes(chest, pitch, roll)
    for leg in range(2):
        joints = limbs.arm(b, axes, 1 - 2 * leg, angles[1 - leg], pace)
        for axis in range(3):
            pose.shoulder[c, leg, axis] = com[axis] + joints[0][axis]
            pose.elbow[c, leg, axis] = com[axis] + joints[1][axis]
            pose.hand[c, leg, axis] = com[axis] + joints[2][axis]
    limbs.lay_tail(b, track, past, com, yaw, pitch, roll, t, pose.tail[c])


@jit_borrowing
def pose_kernel(b, track, curve_time, control, t, pose, c):
    """Fills row c of `pose` with the character b at time t [s] of its track and curve ((m + 1,), (m + 1, 6))."""
    com, acceleration = pose.com[c], pose.com_acceleration[c]
    spline.evaluate(curve_time, control, t, com, pose.com_velocity[c], acceleration)
    support = phases.support_at(track.side, track.contact_time, track.stance_time, 0, t)
    yaw = heading.body_heading(b, track, t)
    pose.phase[c] = phases.phase_of(support[0], support[1])
    swung = (0.0, 0.0)
    for leg in range(2):
        swung = (swung[1], _pose_leg(b, track, support, leg, yaw, t, pose, c))
    _pose_body(b, track, curve_time, control, yaw, swung, t, pose, c)
    standing, up = pose.contact[c], acceleration[2] + cost.GRAVITY
    at = pose.point_of_support[c]
    pose.physics_cost[c] = cost.physics_cost(com[0], com[1], com[2], acceleration[0], acceleration[1], up, at, standing)
    pose.comfort_cost[c] = 0.0
    for leg in range(2):
        if standing[leg]:
            x, y = pose.hip[c, leg, 0] - pose.ankle[c, leg, 0], pose.hip[c, leg, 1] - pose.ankle[c, leg, 1]
            z = pose.hip[c, leg, 2] - pose.ankle[c, leg, 2]
            length = np.sqrt(x * x + y * y + z * z)
            pose.comfort_cost[c] += b.comfort_weight * (length - track.nominal_length[support[leg]]) ** 2
