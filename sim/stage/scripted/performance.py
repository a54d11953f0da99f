"""A scripted scene: all footprints are known, so whole curves are optimised at once, and time only shows them."""

from typing import Any

import numpy as np

from motion.characters.character import Character, load_character
from motion.com import newton
from motion.motion import Motion
from motion.pose.bones import Bones
from motion.pose.pose import Pose
from motion.track.curve import Curve, Track
from planner.script.acting import Act, act
from planner.script.manners import carried
from planner.script.meeting import trodden
from planner.script.review import review, warned
from planner.script.scene import Scene
from planner.script.shaping import styled
from planner.script.track import SHAPES, footprints_of
from planner.script.turned import BoneKey, turned
from sim.rows.footprint_log import Walked, as_arrays
from sim.stage.cast import TICK_RATE, Cast
from worlds.compiled.tables import picked


class Performance(Cast):
    """Characters that do what a scene says, one to a track, and then stand."""

    def __init__(
        self, scene: Scene, character: Character | None = None, tick_rate: int = TICK_RATE,
        effort: newton.Effort = newton.SCENE,
    ) -> None:  # fmt: skip
        """character: who does it, the scene's own by default. Raises InputError where feet cannot do that.

        `warnings` tells what will be ugly.
        """
        who = [
            styled(character or load_character(track.character, track.character_scale), track.style) for track in scene.tracks
        ]
        names = [scene.name if k == 0 else f"{scene.name}: track.{k}" for k in range(len(who))]
        self.warnings = [
            said
            for track, each, name in zip(scene.tracks, who, names, strict=True)
            for said in review(footprints_of(track, each), each, scene.world.arrays, name)
        ]
        acts = [act(track, each, scene.world, name, effort) for track, each, name in zip(scene.tracks, who, names, strict=True)]
        self.warnings += warned(trodden(acts), scene.name)
        super().__init__(scene.world, who, 0, tick_rate, **room_for(acts, 1.0))
        self.scene = scene
        self.show(acts)

    def show(self, acts: list[Act]) -> None:
        """Puts acts into the crowd's rows, one to a row; the log takes their footprints as if they had just been placed."""
        self.acts, row, kept, steps = acts, self.crowd, [], 0
        for c, one in enumerate(acts):
            footprints, curve = _until(one, self.end)
            n = len(footprints.side)
            for column, values in zip(row.footprints, footprints, strict=True):
                column[c, :n] = values
            for column, values in zip(row.committed, curve, strict=True):
                column[c, : len(values)] = values
            row.segments[c], row.number[c], row.real[c], row.standing[c] = len(curve.time) - 1, n - 1, n, True
            steps += int((~footprints.stands[2:]).sum())
            kept.append(as_arrays(Walked(np.full(n - 2, c), np.zeros(n - 2, np.int64), picked(footprints, slice(0, n - 2)))))
        joined = {key: np.concatenate([each[key] for each in kept]) for key in kept[0]}
        self.footprints.take(steps, [0] * len(acts), joined)

    def pose_into(self, pose: Pose, time: float, rows: np.ndarray) -> None:
        """As a cast does; whose steps have manners of their own then is posed with these, one by one."""
        super().pose_into(pose, time, rows)
        for i, c in enumerate(rows):
            kind = self.crowd.kind[c]
            held = carried(self.bipeds[kind], self.acts[int(c)].spells, time) if self.acts[int(c)].spells else None
            if held is not None:
                before = self.bipeds[kind].copy()
                self.bipeds[kind] = held
                super().pose_into(Pose(*(column[i : i + 1] for column in pose)), time, rows[i : i + 1])
                self.bipeds[kind] = before

    def shapes(self, character: int) -> dict[str, Any]:
        """Style, stretches, pulls, keys, support and segments of a track."""
        return self.acts[character].track.model_dump(mode="json", include=SHAPES, exclude_defaults=True)

    def hand_keys(self, character: int) -> tuple[BoneKey, ...]:
        """The hand keys of a track."""
        return self.acts[character].keys

    def shaped(self, bones: Bones, rows: np.ndarray, time: float) -> Bones:
        """The bones with the hand keys of their tracks."""
        for i, c in enumerate(rows):
            one = self.acts[int(c)]
            if one.keys:
                turned(bones, i, self.skeleton(int(c)).names, one.keys, one.motion.footprints, time)
        return bones

    @property
    def motion(self) -> Motion:
        """That of the first track."""
        return self.acts[0].motion

    @property
    def end(self) -> float:
        """When the script ends [s]."""
        return max(one.end for one in self.acts)

    @property
    def over(self) -> bool:
        """Whether the script has ended."""
        return self.time >= self.end

    def moment(self, time: float | None) -> float:
        """The time [s] that is shown for `time`, by default now; before the beginning and after the end it stands."""
        return min(max(super().moment(time), 0.0), self.end - 1e-9)


def _until(one: Act, end: float) -> Track:
    """An act's footprints and curve, which stands on until the scene's end where its own comes before."""
    footprints, curve = one.motion.footprints, one.motion.curve
    if one.end >= end:
        return Track(footprints, curve)
    stance = footprints.stance_time.copy()
    stance[-2:] += end - one.end
    rest = Curve(*(np.concatenate([column, column[-1:]]) for column in curve))
    rest.time[-1], rest.support[-2] = end, curve.support[-2]
    return Track(footprints._replace(stance_time=stance), rest)


def room_for(acts: list[Act], share: float) -> dict[str, int]:
    """Rows and segments for acts, and so many times as many."""
    rows = max(len(one.motion.footprints.side) for one in acts)
    return {"rows": int(share * rows), "segments": int(share * max(len(one.motion.curve.time) for one in acts)) + 1}
