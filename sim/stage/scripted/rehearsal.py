"""A scene that is edited: its performance follows each edit, and glides where timing is dragged."""

from collections.abc import Sequence

import numpy as np

from motion.characters.character import Character, load_character
from motion.editing.gliding import glide, settle
from motion.motion import Motion
from planner.script.acting import Act, act
from planner.script.scene import Scene
from planner.script.shaping import styled
from planner.script.track import Track as Script
from planner.script.track import completed
from sim.stage.cast import TICK_RATE, Cast
from sim.stage.scripted.performance import Performance, room_for
from worlds.errors import InputError
from worlds.world import World

ANEW = 1 << 20
"""By so much the number of the newest footprint grows with an edit: whoever follows the footprints asks for all of them."""
ROOM = 1.5
"""Rows are made for so many times what is there, so that an edit seldom needs new ones."""


class Rehearsal(Performance):
    """A performance whose scene changes. Tracks may be unfinished: who has no footprints yet stands."""

    def __init__(self, tracks: Sequence[Script], world: World) -> None:
        """Raises InputError where feet cannot do that."""
        self.tracks, self.warnings = list(tracks), list[str]()
        self.solved = self.drawn = self._acts(tracks, world, [], True)
        self._begin(self.solved, world)

    def _begin(self, acts: list[Act], world: World) -> None:
        Cast.__init__(self, world, [one.character for one in acts], 0, TICK_RATE, **room_for(acts, ROOM))
        self.scene = Scene("scene", world, tuple(self.tracks))
        self.show(acts)

    def change(self, tracks: Sequence[Script], world: World, whole: bool = False, released: bool = False) -> None:
        """Takes other tracks: those that differ are solved around where they do, and glide there, or as wholes. Raises
        InputError, and then nothing has changed.

        released: they are what was shown; `acts` are what is solved at once, and what is drawn glides there.
        """
        same = world is self.world
        acts = self._acts(tracks, world, self.solved if same else [], whole)
        self.solved, self.drawn = acts, _gliding(self.drawn, acts) if same and (released or not whole) else acts
        self.tracks = list(tracks)
        if same and [one.character for one in acts] == self.characters and self._has_room(self.drawn):
            self.show(self.drawn)
        else:
            self._begin(self.drawn, world)
        if whole:
            self.acts = self.solved

    def settle(self, seconds: float) -> None:
        """Lets time pass: what glides comes nearer to what is solved."""
        if all(one is goal for one, goal in zip(self.drawn, self.solved, strict=True)):
            return
        released, pairs = self.acts is self.solved, zip(self.drawn, self.solved, strict=True)
        self.drawn = [_shown(goal, settle(one.motion, goal.motion, seconds)) for one, goal in pairs]
        self.show(self.drawn)
        if released:
            self.acts = self.solved

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


def _gliding(shown: list[Act], solved: list[Act]) -> list[Act]:
    """What is shown of acts that are solved anew, after those that were shown."""
    if len(shown) != len(solved):
        return solved
    return [
        _shown(goal, glide(one.motion, goal.motion)) if one.character is goal.character and one.pulls == goal.pulls else goal
        for one, goal in zip(shown, solved, strict=True)
    ]


def _shown(solved: Act, motion: Motion) -> Act:
    """An act whose motion may still be on its way."""
    return solved if motion is solved.motion else solved._replace(motion=motion)


def _performer(track: Script) -> Character:
    return styled(load_character(track.character, track.character_scale), track.style)


def _is_same(before: Script, after: Script) -> bool:
    """Whether the same character carries itself in the same way."""
    names = ("character", "character_scale", "style")
    return all(getattr(before, name) == getattr(after, name) for name in names)
