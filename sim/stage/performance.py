"""A scripted scene: all footprints are known, so whole curves are optimised at once, and time only shows them."""

from collections.abc import Sequence
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
from planner.script.track import SHAPES, completed, footprints_of
from planner.script.track import Track as Script
from planner.script.turned import BoneKey, turned
from sim.rows.footprint_log import Walked, as_arrays
from sim.stage.cast import TICK_RATE, Cast
from worlds.compiled.tables import picked
from worlds.errors import InputError
from worlds.world import World

ANEW = 1 << 20
"""By so much the number of the newest footprint grows with an edit: whoever follows the footprints asks for all of them."""
ROOM = 1.5
"""Rows are made for so many times what is there, so that an edit seldom needs new ones."""


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


class Rehearsal(Performance):
    """A performance whose scene changes. Tracks may be unfinished: who has no footprints yet stands."""

    def __init__(self, tracks: Sequence[Script], world: World) -> None:
        """Raises InputError where feet cannot do that."""
        self.tracks, self.warnings = list(tracks), list[str]()
        self._begin(self._acts(tracks, world, [], True), world)

    def _begin(self, acts: list[Act], world: World) -> None:
        Cast.__init__(self, world, [one.character for one in acts], 0, TICK_RATE, **room_for(acts, ROOM))
        self.scene = Scene("scene", world, tuple(self.tracks))
        self.show(acts)

    def change(self, tracks: Sequence[Script], world: World, whole: bool = False) -> None:
        """Takes other tracks: those that differ are solved around where they do, or as wholes. Raises InputError, and then
        nothing has changed."""
        same = world is self.world and not whole
        acts = self._acts(tracks, world, self.acts if world is self.world else [], whole)
        self.tracks = list(tracks)
        kinds = [one.character for one in acts]
        if not same and world is not self.world or kinds != self.characters or not self._has_room(acts):
            self._begin(acts, world)
        else:
            self.show(acts)

    def _acts(self, tracks: Sequence[Script], world: World, last: list[Act], whole: bool) -> list[Act]:
        """The acts of tracks; those of tracks that are the same stay."""
        acts = []
        for k, track in enumerate(tracks):
            before = last[k] if k < len(last) else None
            if before is not None and not whole and track is self.tracks[k]:
                acts.append(before)
                continue
            who = before.character if before is not None and _is_same(before.track, track) else _performer(track)
            begun = completed(track, who, (0.5 * world.size[0], 0.5 * world.size[1]))
            acts.append(act(begun, who, world, "the scene" if k == 0 else f"track {k}", last=None if whole else before))
        if not acts:
            raise InputError("a scene without tracks: add a character")
        return acts

    def _has_room(self, acts: list[Act]) -> bool:
        rows, points = self.crowd.footprints.side.shape[1], self.crowd.committed.time.shape[1]
        need = room_for(acts, 1.0)
        return need["rows"] <= rows and need["segments"] < points

    def show(self, acts: list[Act]) -> None:
        """As a performance does; whoever follows the footprints is told to look anew."""
        before = int(self.crowd.number.max(initial=0))
        super().show(acts)
        self.crowd.number[:] = np.maximum(self.crowd.number, before + ANEW)


def _performer(track: Script) -> Character:
    return styled(load_character(track.character, track.character_scale), track.style)


def _is_same(before: Script, after: Script) -> bool:
    """Whether the same character carries itself in the same way."""
    names = ("character", "character_scale", "style")
    return all(getattr(before, name) == getattr(after, name) for name in names)
