"""The pose at any time, from the curve and the footprints alone: nothing is integrated, nothing drifts.

WIDE characters are posed at once, side by side; one alone is as many times the same.
"""

from typing import Any, NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.arithmetic.triples import Triple, minus, pick
from motion.characters.dimensions import DIMENSIONS, Dimensions, empty_bipeds
from motion.com.cost import physics_model
from motion.pose.body import Upper, pose_body
from motion.pose.feet import Leg, pose_leg
from motion.pose.knees import Shank, keep_apart
from motion.pose.pose import Hips, Pose, empty_pose
from motion.track import phases
from motion.track.curve import Curve, Track, state_at
from motion.track.footprints import LEFT, RIGHT, Footprints
from motion.track.heading import body_heading
from motion.track.pelvis import pelvis_at
from worlds.compiled.beside.places import counted, each_of, put
from worlds.compiled.beside.records import records_beside
from worlds.compiled.beside.rows import side_by_side
from worlds.compiled.jit import jit_borrowing
from worlds.compiled.lanes import Some, choose
from worlds.compiled.parts import Part, call_three, handle
from worlds.compiled.tables import empty, picked

_beside, _empty_beside = records_beside(DIMENSIONS)


class Posed(NamedTuple):
    """Who is posed, and when."""

    bipeds: Any  # recarray of Dimensions
    kind: np.ndarray  # (C,) which of them each character is
    footprints: Footprints  # (C, N)
    real: np.ndarray  # (C,) how many of its footprints are there
    curve: Curve  # (C, M + 1)
    segments: np.ndarray  # (C,) how many of its segments
    time: float  # [s]
    rows: np.ndarray  # (K,) the characters that the rows of the pose are of


def _nobody() -> Posed:
    none = np.zeros(1, np.int64)
    return Posed(empty_bipeds(1), none, empty(Footprints, 1, 1), none, empty(Curve, 1, 1), none, 0.0, none)


lend_pose, _open_pose, _, _ = handle(empty_pose(1))
lend_posed, _open_posed, _, _ = handle(_nobody())


def _pose_some(posed_at: int, pose_at: int, first: int) -> None:
    """Fills WIDE rows, or what is left, from `first` on, of the Pose lent at `pose_at` with the Posed lent at `posed_at`."""
    posed, pose = _open_posed(posed_at), _open_pose(pose_at)
    rows = counted(first, len(posed.rows))
    c = each_of(posed.rows, rows, ())
    biped = _beside(posed.bipeds, each_of(posed.kind, c, ()), _empty_beside())
    footprints = side_by_side(posed.footprints, c, each_of(posed.real, c, ()))
    curve = side_by_side(posed.curve, c, each_of(posed.segments, c, ()) + 1)
    _pose(biped, Track(footprints, curve), posed.time, pose, rows)


pose_some = Part(_pose_some, 3)


@jit_borrowing
def _pose(biped: Dimensions, track: Track, t: float, pose: Pose, rows: Some) -> None:
    com, velocity, acceleration = state_at(track.curve, t)
    put(pose.com, rows, (), com)
    put(pose.com_velocity, rows, (), velocity)
    put(pose.com_acceleration, rows, (), acceleration)
    turn, roll = pelvis_at(biped, track.footprints, t)
    hips = Hips(body_heading(biped, track.footprints, t), turn, roll)
    left, right = pose_leg(biped, track, LEFT, com, hips, t), pose_leg(biped, track, RIGHT, com, hips, t)
    ways = (minus(left.foot.ankle, left.hip), minus(right.foot.ankle, right.hip))
    one, other = keep_apart(biped, hips.yaw, _shank(left), _shank(right))
    _put_leg(pose, rows, LEFT, left, one)
    _put_leg(pose, rows, RIGHT, right, other)
    _put_upper(pose, rows, pose_body(biped, track, hips, com, ways, t, pose.tail, rows))
    _put_costs(pose, rows, com, acceleration, left, right)


@jit_borrowing
def _shank(leg: Leg) -> Shank:
    return Shank(leg.hip, leg.knee, leg.hock, leg.foot.ankle)


@jit_borrowing
def _put_costs(pose: Pose, rows: Some, com: Triple, acceleration: Triple, left: Leg, right: Leg) -> None:
    """Phase and costs (paper, section 2.4)."""
    on, off = left.stands, right.stands
    single = choose(on, phases.LEFT_STANCE, choose(off, phases.RIGHT_STANCE, phases.FLIGHT))
    put(pose.phase, rows, (), choose(on & off, phases.DOUBLE_STANCE, single))
    w = (acceleration[0], acceleration[1], acceleration[2] + GRAVITY)
    put(pose.physics_cost, rows, (), physics_model(com, w, left.support, right.support, on, off, 1.0).size)
    put(pose.comfort_cost, rows, (), left.comfort + right.comfort)


@jit_borrowing
def _put_leg(pose: Pose, rows: Some, side: int, leg: Leg, shank: Shank) -> None:
    put(pose.hip, rows, (side,), shank.hip)
    put(pose.knee, rows, (side,), shank.knee)
    put(pose.hock, rows, (side,), shank.hock)
    put(pose.ankle, rows, (side,), shank.ankle)
    put(pose.heel, rows, (side,), leg.foot.heel)
    put(pose.ball, rows, (side,), leg.foot.ball)
    put(pose.toe, rows, (side,), leg.foot.toe)
    put(pose.contact, rows, (side,), leg.stands)
    put(pose.point_of_support, rows, (side,), pick(leg.stands, leg.support, (np.nan, np.nan, np.nan)))


@jit_borrowing
def _put_upper(pose: Pose, rows: Some, upper: Upper) -> None:
    put(pose.body_rotation_wxyz, rows, (), upper.body)
    put(pose.pelvis_rotation_wxyz, rows, (), upper.pelvis)
    put(pose.chest_rotation_wxyz, rows, (), upper.chest)
    put(pose.head_rotation_wxyz, rows, (), upper.gaze)
    put(pose.neck, rows, (), upper.neck)
    put(pose.head, rows, (), upper.head)
    for side in range(2):
        shoulder, elbow, hand = upper.arms[side]
        put(pose.shoulder, rows, (side,), shoulder)
        put(pose.elbow, rows, (side,), elbow)
        put(pose.hand, rows, (side,), hand)


def pose_into(biped: Dimensions, track: Track, time: float, pose: Pose) -> None:
    """Fills row 0 of `pose` with a character at a time [s] of its track."""
    bipeds, zero = empty_bipeds(1), np.zeros(1, np.int64)
    bipeds[0] = biped
    footprints, curve = picked(track.footprints, None), picked(track.curve, None)
    real, segments = np.array([len(track.footprints.side)]), np.array([len(track.curve.time) - 1])
    _call(pose_some.address, Posed(bipeds, zero, footprints, real, curve, segments, time, zero), pose)


@jit_borrowing
def _call(part: int, posed: Posed, pose: Pose) -> None:
    call_three(part, lend_posed(posed), lend_pose(pose), 0)
