"""Bones turned by hand over a motion: offsets that come and go around a time, and leave the feet that stand where they are.

A key holds a rotation vector r [rad] in the bone's own frame at a time t_k; it weighs w(t) = smoothstep(1 - |t - t_k| / blend).
Keys of one bone blend to the sum of w r, divided by the sum of w where that is more than one, so that two of them meet halfway
and none is exceeded. The bone's rotation q against its parent becomes q exp(offset / 2).
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from motion.arithmetic.smooth import smoothstep
from motion.pose.bones import Bones
from motion.track.footprints import SIDES, Footprints

LEGS = ("thigh", "shank", "metatarsus", "foot", "toes")
"""Bones that carry a foot: they are let alone while it stands."""
LET_GO = 0.08
"""Seconds after a foot has left, and before it lands, in which keys of its leg come and go."""


class BoneKey(NamedTuple):
    """A rotation that a bone has beyond the motion, at a time."""

    bone: str
    time: float  # [s]
    rotation: tuple[float, float, float]  # rotation vector in the bone's own frame [rad]
    blend: float  # time to come, and to go [s]


def offset_at(keys: Sequence[BoneKey], t: float) -> np.ndarray:
    """The rotation vector (3,) [rad] that keys of one bone make at a time."""
    weights = np.array([smoothstep(1 - abs(t - key.time) / key.blend) for key in keys])
    turned = weights @ np.array([key.rotation for key in keys])
    return np.asarray(turned / max(float(weights.sum()), 1.0))


def free(footprints: Footprints, side: int, t: float) -> float:
    """How far the leg of a side is free of the ground at a time: 0 while it stands, 1 from LET_GO on."""
    mine = footprints.side == side
    contact, left = footprints.contact_time[mine], (footprints.contact_time + footprints.stance_time)[mine]
    if ((contact <= t) & (t <= left)).any():
        return 0.0
    since = (t - left[left < t]).min(initial=np.inf)
    until = (contact[contact > t] - t).min(initial=np.inf)
    return float(smoothstep(min(since, until) / LET_GO))


def turned(bones: Bones, row: int, names: Sequence[str], keys: Sequence[BoneKey], footprints: Footprints, t: float) -> None:
    """Turns the bones, called `names`, of a row in place by the keys, at a time [s]."""
    for name in {key.bone for key in keys} & set(names):
        mine = [key for key in keys if key.bone == name and abs(t - key.time) < key.blend]
        part, _, side = name.rpartition("_")
        share = free(footprints, SIDES.index(side), t) if mine and part in LEGS else 1.0
        if mine and share > 0:
            k = names.index(name)
            bones.rotation_wxyz[row, k] = _after(bones.rotation_wxyz[row, k], share * offset_at(mine, t))


def _after(q: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """The quaternion (4,) q followed by a rotation vector (3,) in its own frame."""
    angle = float(np.linalg.norm(vector))
    if angle == 0.0:
        return q
    w, v = np.cos(0.5 * angle), np.sin(0.5 * angle) / angle * vector
    return np.array([q[0] * w - q[1:] @ v, *(q[0] * v + w * q[1:] + np.cross(q[1:], v))])
