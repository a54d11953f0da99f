"""The paper as a function: footprints in, motion out.

    motion = solve(footprints, character)
    pose = motion.pose(1.5)

A motion is a function of time: nothing in it is integrated, so any moment can be asked for, in any order.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from motion.com import newton, window
from motion.com.newton import Effort
from motion.com.problem import Layout
from motion.com.standing import above_feet
from motion.com.window import Solved, Span, optimise_track
from motion.pose.bones import INDEX, Bones, Placed
from motion.pose.pose import Pose, empty_pose
from motion.pose.posing import pose_into
from motion.pose.skeleton import Skeleton, skeleton_of
from motion.pose.turning import fill_all_bones, lay_bones
from motion.track.curve import Curve, Track
from motion.track.footprints import Footprints, first
from worlds.compiled.jit import jit
from worlds.compiled.tables import empty

REST = 0.6
"""Seconds of standing after the last contact, where nothing else is said."""


class Pull(NamedTuple):
    """A soft constraint: a spring that pulls the centre of mass, at one time, toward a place."""

    time: float  # [s]
    place: tuple[float, float, float]  # [m], world
    stiffness: float  # [1/s/m]: 30 gives way where it must, 1000 holds


@dataclass(frozen=True)
class Motion:
    """Who walks, on which footprints, along which curve. Before its begin and after its end the character stands."""

    character: Character
    footprints: Footprints  # (n,)
    curve: Curve  # (m + 1,)
    solved: Solved

    @property
    def begin(self) -> float:
        """When it begins [s]: the second footprint's contact."""
        return float(self.curve.time[0])

    @property
    def end(self) -> float:
        """When it ends [s]."""
        return float(self.curve.time[-1])

    def pose(self, time: float) -> Pose:
        """The pose at a time [s], of one row."""
        pose = empty_pose(1)
        at = min(max(float(time), self.begin), self.end - 1e-9)
        pose_into(self.character.biped, Track(self.footprints, self.curve), at, pose)
        return pose

    @cached_property
    def skeleton(self) -> Skeleton:
        """The character's bones at rest."""
        return skeleton_of(self.character)

    def bones(self, time: float) -> Bones:
        """The root's place and the rotation of each bone of the skeleton at a time [s], of one row."""
        return bones_of(self.character, self.pose(time), self.skeleton)


def bones_of(character: Character, pose: Pose, skeleton: Skeleton) -> Bones:
    """The bones of a pose whose rows are all of one character's kind: those of its skeleton, in its order."""
    bones, which = empty(Bones, len(pose.phase)), [INDEX[name] for name in skeleton.names]
    fill_all_bones(character.biped, pose, bones)
    return Bones(bones.root, bones.rotation_wxyz.take(which, axis=1), bones.stretch.take(which, axis=1))


def placed(bones: Bones, skeleton: Skeleton) -> Placed:
    """Where the bones of a skeleton are: heads, tips and rotations in the world."""
    count = (len(bones.root), len(skeleton.parent))
    out = Placed(np.empty((*count, 3)), np.empty((*count, 3)), np.empty((*count, 4)))
    lay_bones(bones, skeleton.parent, skeleton.offset, skeleton.tip, out)
    return out


def solve(
    footprints: Footprints, character: Character, end: float | None = None, layout: Layout = window.SCENE,
    effort: Effort = newton.SCENE, pulls: Sequence[Pull] = (),
) -> Motion:  # fmt: skip
    """The motion over timed footprints, from standing on the first two to standing on the last two (paper, section 2).

    The curve of the centre of mass begins at the contact of the second footprint and lasts until `end` [s], by default REST
    after the last contact; the last two stances must last as long. Layout and effort are the solver's; pulls are soft
    constraints on the centre of mass.
    """
    if len(footprints.side) < 2:
        raise ValueError(f"{len(footprints.side)} footprints: at least two, to stand on, are needed")
    until = float(footprints.contact_time[-1]) + REST if end is None else float(end)
    curve, solved = solve_track(character.biped, footprints, until, springs_of(pulls), layout, effort)
    return Motion(character, footprints, curve, solved)


def springs_of(pulls: Sequence[Pull]) -> np.ndarray:
    """Pulls as rows (P, 5) for kernels: time, place, stiffness."""
    return np.array([(one.time, *one.place, one.stiffness) for one in pulls], np.float64).reshape(-1, 5)


@jit
def solve_track(
    biped: Dimensions, footprints: Footprints, end: float, pull: np.ndarray, layout: Layout, effort: Effort
) -> tuple[Curve, Solved]:
    """The curve of `solve`, for kernels' arguments; pull (P, 5)."""
    state = np.empty((2, 6))
    above_feet(biped, first(footprints, 2), state[0])
    above_feet(biped, footprints, state[1])
    span = Span(footprints.contact_time[1], end, state, np.zeros((2, 3)), pull)
    nothing = Curve(np.zeros(1), np.zeros((1, 6)), np.zeros((1, 2), np.int64))
    return optimise_track(biped, footprints, span, nothing, layout, effort)
