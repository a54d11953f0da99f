"""The bones of a biped by name, and where they are at one time: the root's place, and each bone's rotation against its parent.

A named `stretch` tells how many times its length a bone reaches. Bones are rigid but for that: legs give up to 2 % near full
extension, and more where a footprint is out of reach. The neck of who bobs its head has two links.
"""

from typing import Annotated, NamedTuple

import numpy as np

from motion.pose.limbs import TAIL
from worlds.compiled.tables import Column, Vectors

PAIRED = ("upper_arm", "forearm", "hand", "thigh", "shank", "metatarsus", "foot", "toes", "wing")
BONES = (
    "root", "body", "pelvis", "spine", "chest", "neck", "neck_2", "head",
    *(f"{bone}_{side}" for bone in PAIRED for side in ("left", "right")),
    *(f"tail_{k + 1}" for k in range(TAIL)),
)  # fmt: skip
"""All that a biped can have, parents before children; a character without a tail has none of its bones."""
INDEX = {name: k for k, name in enumerate(BONES)}
_PARENTS = {
    "root": "", "body": "root", "pelvis": "root", "spine": "root", "chest": "spine",
    "neck": "chest", "neck_2": "neck", "head": "neck_2",
    "upper_arm": "chest", "forearm": "upper_arm", "hand": "forearm", "thigh": "root", "shank": "thigh", "metatarsus": "shank",
    "foot": "metatarsus", "toes": "foot", "wing": "chest", "tail_1": "body",
} | {f"tail_{k + 1}": f"tail_{k}" for k in range(1, TAIL)}  # fmt: skip
"""The root follows the com and turns with the feet alone, so the hips do; the body nods and leans, pelvis and chest turn."""


class Bones(NamedTuple):
    """C characters at one time: the B bones of their skeleton (motion.motion.bones_of).

    Kernels fill all of BONES, those that a character lacks stay as at rest.
    """

    root: Vectors  # (C, 3) place of the root: the com [m]
    rotation_wxyz: Annotated[np.ndarray, Column(shape=(len(BONES), 4))]  # (C, B, 4) against the parent
    stretch: Annotated[np.ndarray, Column(shape=(len(BONES),), fill=1.0)]  # (C, B) times the rest length


class Placed(NamedTuple):
    """C characters at one time in the world, of the bones that a skeleton has."""

    head: np.ndarray  # (C, B, 3) where each bone begins [m]
    tip: np.ndarray  # (C, B, 3) where it ends
    rotation_wxyz: np.ndarray  # (C, B, 4) to the world


def parent_of(name: str) -> str:
    """The bone that a bone hangs on, by name; "" of the root."""
    if name in _PARENTS:
        return _PARENTS[name]
    bone, _, side = name.rpartition("_")
    above = _PARENTS[bone]
    return f"{above}_{side}" if above in PAIRED else above
