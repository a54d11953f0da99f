"""A figure: where the bones of some characters of one kind are, under the names by which bodies are drawn."""

from dataclasses import dataclass

import numpy as np

from motion.characters.character import Character
from motion.motion import bones_of, placed
from motion.pose.bones import Bones, Placed
from motion.pose.limbs import TAIL
from motion.pose.pose import Pose
from motion.pose.skeleton import Skeleton, skeleton_of
from motion.track.footprints import SIDES
from sim.view.bodies.clay import Frame


@dataclass(frozen=True)
class Figure:
    """C characters; points (C, 3) [m], points of both sides (C, 2, 3), left first; frames forward, left, up."""

    com: np.ndarray
    neck: np.ndarray
    head: np.ndarray
    tail: np.ndarray  # (C, 7, 3) root first; all at its root where there is none
    hip: np.ndarray
    knee: np.ndarray
    hock: np.ndarray  # the ankle of a leg of two links
    ankle: np.ndarray
    heel: np.ndarray
    ball: np.ndarray
    toe: np.ndarray
    shoulder: np.ndarray  # arms: at the chest where there are none
    elbow: np.ndarray
    hand: np.ndarray
    pelvis_frame: Frame  # about the com
    chest_frame: Frame  # about the com
    head_frame: Frame  # about the middle of the head
    wing_frames: tuple[Frame, ...]  # about where they begin


def figure_of(character: Character, pose: Pose, skeleton: Skeleton | None = None) -> Figure:
    """The figure of a pose whose rows are all of one character's kind."""
    skeleton = skeleton_of(character) if skeleton is None else skeleton
    return figure_of_bones(character, bones_of(character, pose, skeleton), skeleton)


def figure_of_bones(character: Character, bones: Bones, skeleton: Skeleton) -> Figure:
    """The figure of bones, all of one character's kind."""
    return figure_at(placed(bones, skeleton), skeleton, float(character.biped.leg.nominal_length))


def figure_at(at: Placed, skeleton: Skeleton, unit: float) -> Figure:
    """The figure of bones that are there, of a character whose nominal leg is `unit` [m]."""
    index = {name: k for k, name in enumerate(skeleton.names)}

    def heads(bone: str, instead: str) -> np.ndarray:
        """Where the bones of both sides begin; those of another bone where there are none."""
        names = [f"{bone}_{side}" if f"{bone}_{side}" in index else instead.format(side) for side in SIDES]
        return np.stack([at.head[:, index[name]] for name in names], axis=1)

    def tips(bone: str) -> np.ndarray:
        return np.stack([at.tip[:, index[f"{bone}_{side}"]] for side in SIDES], axis=1)

    def frame(bone: str, about: str) -> Frame:
        return Frame(at.head[:, index[about]], at.rotation_wxyz[:, index[bone]], unit)

    tail = [name for name in skeleton.names if name.startswith("tail")]
    points = [at.head[:, index[name]] for name in tail] or [at.head[:, index["body"]]] * TAIL
    points.append(at.tip[:, index[tail[-1]]] if tail else points[0])
    return Figure(
        com=at.head[:, 0], neck=at.head[:, index["neck"]], head=at.head[:, index["head"]], tail=np.stack(points, axis=1),
        hip=heads("thigh", ""), knee=heads("shank", ""), hock=heads("metatarsus", "foot_{}"), ankle=heads("foot", ""),
        heel=tips("foot"), ball=heads("toes", ""), toe=tips("toes"), shoulder=heads("upper_arm", "chest"),
        elbow=heads("forearm", "chest"), hand=heads("hand", "chest"), pelvis_frame=frame("pelvis", "root"),
        chest_frame=frame("spine", "root"), head_frame=frame("head", "head"),
        wing_frames=tuple(frame(f"wing_{side}", f"wing_{side}") for side in SIDES if f"wing_{side}" in index),
    )  # fmt: skip
