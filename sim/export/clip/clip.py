"""A clip: some characters over evenly spaced moments, as arrays. It is what every exporter of motion reads.

World frame: metres, seconds, right-handed, x forward at heading 0, z up; quaternions wxyz.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from motion.characters.character import Character
from motion.motion import bones_of, placed
from motion.pose.bones import Bones, Placed
from motion.pose.pose import Pose
from motion.pose.skeleton import Skeleton, skeleton_of
from motion.track.footprints import Footprints
from planner.script.turned import BoneKey, turned
from worlds.world import World


@dataclass(frozen=True)
class Actor:
    """One character of a clip of F moments."""

    index: int  # which one it is of its run
    character: Character
    pose: Pose  # (F,)
    footprints: Footprints  # (K,) in the order of their contacts, those of before and after the clip too
    colours: dict[str, np.ndarray]  # of its body, each (1, 3) red, green, blue in 0..1
    time: np.ndarray  # (F,) [s] of the run
    there: np.ndarray  # (F,) bool: before it comes and after it has gone it stands where it came and went
    hand_keys: tuple[BoneKey, ...] = ()

    @property
    def name(self) -> str:
        """What its nodes and files are called: `human_3`."""
        return f"{self.character.name}_{self.index}"

    @cached_property
    def skeleton(self) -> Skeleton:
        """Its bones at rest."""
        return skeleton_of(self.character)

    @cached_property
    def bones(self) -> Bones:
        """(F,) its bones: they follow from the pose and the hand keys, so a recording's are the run's own."""
        bones = bones_of(self.character, self.pose, self.skeleton)
        for k, t in enumerate(self.time if self.hand_keys else ()):
            turned(bones, k, self.skeleton.names, self.hand_keys, self.footprints, float(t))
        return bones

    @cached_property
    def placed(self) -> Placed:
        """(F, B) where the bones are in the world."""
        return placed(self.bones, self.skeleton)


@dataclass(frozen=True)
class Clip:
    """What is exported."""

    name: str  # of the level or scene
    world: World
    time: np.ndarray  # (F,) [s] of the run, 1 / rate apart
    rate: float  # moments per second
    actors: tuple[Actor, ...]
    seed: int = 0  # of chance, which colours what is drawn

    @property
    def elapsed(self) -> np.ndarray:
        """(F,) [s] since the clip began."""
        return np.arange(len(self.time)) / self.rate

    @property
    def seconds(self) -> float:
        """How long it is [s]."""
        return (len(self.time) - 1) / self.rate
