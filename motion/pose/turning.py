"""From a pose to the rotations of its bones, and back to places: closed forms, no search.

The pose's joints say where each bone points; what they leave open, its turn about itself, follows from the leg's plane, the
foot's sole, or the bone that it hangs on. So the places that follow from the bones are the pose's own, to rounding.
"""

from math import asin, atan2

import numpy as np

from motion.arithmetic import rotations
from motion.arithmetic.rotations import Axes, Quaternion
from motion.arithmetic.triples import Triple, cross, dot, minus, norm, plus, times, unit
from motion.characters.dimensions import Dimensions
from motion.pose.bones import BONES, INDEX, Bones
from motion.pose.limbs import FLAP, TAIL, neck_links
from motion.pose.pose import Pose, point_of
from worlds.compiled.jit import jit, jit_borrowing, jit_inline

ROOT, BODY, PELVIS, SPINE = (INDEX[name] for name in ("root", "body", "pelvis", "spine"))
NECK, NECK_2, HEAD = (INDEX[name] for name in ("neck", "neck_2", "head"))
ARM, FOREARM, THIGH, SHANK = (INDEX[f"{name}_left"] for name in ("upper_arm", "forearm", "thigh", "shank"))
METATARSUS, FOOT, TOES, TAIL_ROOT = (INDEX[name] for name in ("metatarsus_left", "foot_left", "toes_left", "tail_1"))
WING = INDEX["wing_left"]
SPREAD, RAISED, HARDLY = 1.0, 0.5, 0.035
"""How far wings open outward and rise at most [rad], and the cube of the fall, as the tail tells it, at which they are half
open: at a third of g."""


@jit_inline
def _place(array: np.ndarray, c: int) -> Triple:
    return array[c, 0], array[c, 1], array[c, 2]


@jit_inline
def _rotation(array: np.ndarray, c: int) -> Quaternion:
    return array[c, 0], array[c, 1], array[c, 2], array[c, 3]


@jit_inline
def _elevation(up: float) -> float:
    """How far [rad] a unit vector with that upward part points up, also where rounding made it longer."""
    return asin(min(max(up, -1.0), 1.0))


@jit_inline
def _turn(bones: Bones, c: int, bone: int, parent: Quaternion, world: Quaternion) -> Quaternion:
    """Sets a bone's rotation so that it is `world` under a parent of that rotation; returns it."""
    q = rotations.product(rotations.inverse(parent), world)
    for k in range(4):
        bones.rotation_wxyz[c, bone, k] = q[k]
    return world


@jit_inline
def _hanging(down: Triple, left: Triple) -> Axes:
    """Axes of a bone that hangs along `down`, its left as near to `left` as that allows."""
    up = unit(times(-1.0, down))
    aside = unit(minus(left, times(dot(left, up), up)))
    return cross(aside, up), aside, up


@jit_inline
def _link(bones: Bones, c: int, bone: int, parent: Quaternion, way: Triple, left: Triple, length: float) -> Quaternion:
    """A bone of that length that hangs along `way` to its end; returns its rotation."""
    bones.stretch[c, bone] = norm(way) / length
    return _turn(bones, c, bone, parent, rotations.of_axes(_hanging(way, left)))


@jit_borrowing
def _leg(biped: Dimensions, pose: Pose, c: int, side: int, root: Quaternion, bones: Bones) -> None:
    """Thigh to toes: the leg's plane holds hip, knee and ankle; the sole's ends and the ankle give the foot's axes."""
    hip, knee, hock = point_of(pose.hip, c, side), point_of(pose.knee, c, side), point_of(pose.hock, c, side)
    ankle, ball = point_of(pose.ankle, c, side), point_of(pose.ball, c, side)
    left = unit(cross(minus(knee, hip), minus(ankle, hip)))
    above = _link(bones, c, THIGH + side, root, minus(knee, hip), left, biped.leg.thigh)
    above = _link(bones, c, SHANK + side, above, minus(hock, knee), left, biped.leg.shank)
    if biped.leg.metatarsus > 0:
        above = _link(bones, c, METATARSUS + side, above, minus(ankle, hock), left, biped.leg.metatarsus)
    forward = unit(minus(ball, point_of(pose.heel, c, side)))
    behind = times(biped.foot.ankle_forward - biped.foot.ball_forward, forward)
    up = unit(minus(minus(ankle, ball), behind))
    aside = cross(up, forward)
    above = _turn(bones, c, FOOT + side, above, rotations.of_axes((forward, aside, up)))
    forward = unit(minus(point_of(pose.toe, c, side), ball))
    _turn(bones, c, TOES + side, above, rotations.of_axes((forward, aside, cross(forward, aside))))


@jit_borrowing
def _arm(biped: Dimensions, pose: Pose, c: int, side: int, chest: Quaternion, bones: Bones) -> None:
    shoulder, elbow, hand = point_of(pose.shoulder, c, side), point_of(pose.elbow, c, side), point_of(pose.hand, c, side)
    left = _axis_left(chest)
    above = _link(bones, c, ARM + side, chest, minus(elbow, shoulder), left, biped.body.upper_arm)
    _link(bones, c, FOREARM + side, above, minus(hand, elbow), left, biped.body.forearm)


@jit_inline
def _axis_left(q: Quaternion) -> Triple:
    """The left axis of a rotation."""
    w, x, y, z = q
    return 2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)


@jit_inline
def _carried(q: Quaternion, v: Triple) -> Triple:
    """The vector v of a body turned by q, in the world."""
    w, x, y, z = q
    t = times(2.0, cross((x, y, z), v))
    turn = cross((x, y, z), t)
    return v[0] + w * t[0] + turn[0], v[1] + w * t[1] + turn[1], v[2] + w * t[2] + turn[2]


@jit_borrowing
def _neck(biped: Dimensions, pose: Pose, c: int, chest: Quaternion, bones: Bones) -> None:
    """The neck points to the head, turned from the head's own axes by as little as that takes; or it bends in two links."""
    head, (lower, upper) = _rotation(pose.head_rotation_wxyz, c), neck_links(biped)
    way, rest = minus(_place(pose.head, c), _place(pose.neck, c)), plus(lower, upper)
    if biped.body.head_bob > 0:
        above = _bent_neck(bones, c, chest, way, (lower, upper))
    elif norm(rest) > 0:
        begin, end = unit(_carried(head, rest)), unit(way)
        axis, share = cross(begin, end), 1 + dot(begin, end)
        scale = 1 / max((share * share + dot(axis, axis)) ** 0.5, 1e-12)
        least = (scale * share, scale * axis[0], scale * axis[1], scale * axis[2])
        above = _turn(bones, c, NECK, chest, rotations.product(least, head))
        bones.stretch[c, NECK] = norm(way) / norm(rest)
    else:
        above = _turn(bones, c, NECK, chest, head)
    _turn(bones, c, HEAD, above, head)


@jit_inline
def _bent_neck(bones: Bones, c: int, chest: Quaternion, way: Triple, rest: tuple[Triple, Triple]) -> Quaternion:
    """Two links of one length, those of `rest`, that bulge forward between the neck's base and the head, at `way` from it."""
    link, half, left = norm(rest[0]), times(0.5, way), _axis_left(chest)
    aside = unit(minus(left, times(dot(left, way) / max(dot(way, way), 1e-12), way)))
    bulge = times(max(link * link - dot(half, half), 0.0) ** 0.5, unit(cross(aside, way)))
    first, second = plus(half, bulge), minus(half, bulge)
    bones.stretch[c, NECK], bones.stretch[c, NECK_2] = norm(first) / link, norm(second) / link
    above = _turn(bones, c, NECK, chest, _turned_to(rest[0], first, aside))
    return _turn(bones, c, NECK_2, above, _turned_to(rest[1], second, aside))


@jit_inline
def _turned_to(rest: Triple, way: Triple, left: Triple) -> Quaternion:
    """Rotation of a bone that points along `rest` at rest, in the plane of up and ahead, and along `way`, its left there."""
    at_rest = rotations.of_axes(_hanging(unit(rest), (0.0, 1.0, 0.0)))
    return rotations.product(rotations.of_axes(_hanging(unit(way), left)), rotations.inverse(at_rest))


@jit_borrowing
def _tail(pose: Pose, c: int, body: Quaternion, bones: Bones) -> None:
    above = body
    for k in range(TAIL):
        x, y, z = pose.tail[c, k, 0] - pose.tail[c, k + 1, 0], pose.tail[c, k, 1] - pose.tail[c, k + 1, 1], 0.0
        z = pose.tail[c, k, 2] - pose.tail[c, k + 1, 2]
        forward = unit((x, y, z))
        world = rotations.quaternion(atan2(forward[1], forward[0]), -_elevation(forward[2]), 0.0)
        above = _turn(bones, c, TAIL_ROOT + k, above, world)


@jit_borrowing
def _wings(biped: Dimensions, pose: Pose, c: int, chest: Quaternion, bones: Bones) -> None:
    """Wings open where the body falls, as in a hop, and fold on the ground.

    How it falls the tail says (limbs.lay_tail): bones follow from a pose alone, as a recording has it, and a pose of one moment
    knows no past.
    """
    body, forward, falls = biped.body, _carried(_rotation(pose.body_rotation_wxyz, c), (1.0, 0.0, 0.0)), 0.0
    rest = body.tail_rise + 0.5 * _elevation(forward[2])
    for k in range(TAIL):
        piece, most = body.tail_length / TAIL, FLAP * body.tail_sway * (k + 1) / TAIL
        rise = _elevation((pose.tail[c, k + 1, 2] - pose.tail[c, k, 2]) / piece)
        falls += (rise - rest) / max(most, 1e-6) / TAIL
    falls = max(falls, 0.0)
    open_ = falls**3 / (falls**3 + HARDLY)
    for side, sign in ((0, -1.0), (1, 1.0)):
        spread = rotations.quaternion(sign * SPREAD * open_, RAISED * open_, 0.0)
        _turn(bones, c, WING + side, chest, rotations.product(chest, spread))


@jit_borrowing
def fill_bones(biped: Dimensions, pose: Pose, c: int, bones: Bones) -> None:
    """Fills row c of `bones` from row c of a pose of that biped."""
    for bone in range(len(BONES)):
        bones.stretch[c, bone], bones.rotation_wxyz[c, bone, 0] = 1.0, 1.0
        for k in range(1, 4):
            bones.rotation_wxyz[c, bone, k] = 0.0
    for k in range(3):
        bones.root[c, k] = pose.com[c, k]
    nothing = (1.0, 0.0, 0.0, 0.0)
    across = minus(point_of(pose.hip, c, 0), point_of(pose.hip, c, 1))
    roll = _elevation(across[2] / norm(across))
    root = _turn(bones, c, ROOT, nothing, rotations.quaternion(atan2(-across[0], across[1]), 0.0, roll))
    body = _turn(bones, c, BODY, root, _rotation(pose.body_rotation_wxyz, c))
    _turn(bones, c, PELVIS, root, _rotation(pose.pelvis_rotation_wxyz, c))
    chest = _turn(bones, c, SPINE, root, _rotation(pose.chest_rotation_wxyz, c))
    _neck(biped, pose, c, chest, bones)
    for side in range(2):
        _leg(biped, pose, c, side, root, bones)
        if biped.body.upper_arm > 0 and biped.body.forearm > 0:
            _arm(biped, pose, c, side, chest, bones)
    if biped.body.tail_length > 0:
        _tail(pose, c, body, bones)
        _wings(biped, pose, c, chest, bones)


@jit_borrowing
def fill_all_bones(biped: Dimensions, pose: Pose, bones: Bones) -> None:
    """Bones of all rows of a pose, all of one kind."""
    for c in range(len(pose.phase)):
        fill_bones(biped, pose, c, bones)


@jit
def lay_bones(bones: Bones, parent: np.ndarray, offset: np.ndarray, tip: np.ndarray, out: tuple) -> None:
    """Fills out, a motion.pose.bones.Placed, with where the bones of a skeleton, and no others, are: see there."""
    head, end, world = out
    for c in range(len(bones.root)):
        for b in range(len(parent)):
            local, above = bones.rotation_wxyz[c, b], parent[b]
            q = (local[0], local[1], local[2], local[3])
            if above < 0:
                place = (bones.root[c, 0], bones.root[c, 1], bones.root[c, 2])
            else:
                over = (world[c, above, 0], world[c, above, 1], world[c, above, 2], world[c, above, 3])
                q, s = rotations.product(over, q), bones.stretch[c, above]
                way = _carried(over, (s * offset[b, 0], s * offset[b, 1], s * offset[b, 2]))
                place = (head[c, above, 0] + way[0], head[c, above, 1] + way[1], head[c, above, 2] + way[2])
            s = bones.stretch[c, b]
            way = _carried(q, (s * tip[b, 0], s * tip[b, 1], s * tip[b, 2]))
            for k in range(3):
                head[c, b, k], end[c, b, k] = place[k], place[k] + way[k]
            for k in range(4):
                world[c, b, k] = q[k]
