"""Characters in a world at a time: what the live simulation and a scripted performance share, and the view reads."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.characters.dimensions import empty_bipeds
from motion.motion import bones_of
from motion.pose.bones import Bones
from motion.pose.pose import Pose, empty_pose
from motion.pose.posing import pose_some
from motion.pose.skeleton import Skeleton, skeleton_of
from motion.track.curve import Curve
from motion.track.footprints import Footprints
from planner.script.turned import BoneKey
from sim.rows import crowd as crowds
from sim.rows import posing
from sim.rows.footprint_log import FootprintLog, Walked
from sim.stage import asked
from worlds.compiled.jit import start_threads
from worlds.compiled.memory import Held
from worlds.compiled.tables import copied, picked
from worlds.errors import InputError
from worlds.world import World

TICK_RATE = 60
MEASURED = 6
"""Ways are measured so often in a simulated second."""


class Site(NamedTuple):
    """What a picture of all that happens shows."""

    middle: np.ndarray  # (3,) [m]
    radius: float  # [m]


class Change(NamedTuple):
    """Something that was changed while time went on, as recordings and saved states hold it."""

    tick: int  # after which it was done
    command: dict  # sim.stage.commands, as plain values


class Cast:
    """Characters, standing at first. A subclass lets them move: `tick`."""

    soles = False
    """Whether the headings of steps are those of soles, to the letter; else the walker's, and toes point outward."""

    def __init__(self, world: World, characters: Sequence[Character], seed: int, tick_rate: int, **capacity: int) -> None:
        asked.check_cast(world, characters, seed, tick_rate)
        start_threads()
        self.world, self.characters = world, list(characters)
        self.seed, self.tick_rate, self.ticks = int(seed), int(tick_rate), 0
        self.kinds, kind = kinds_of(self.characters)
        self.bipeds = table_of(self.kinds)
        self.crowd = crowds.empty_crowd(kind, **capacity)
        self.footprints = FootprintLog(len(self.characters))
        self.changes: list[Change] = []
        self.gone = np.zeros(len(self.characters))
        """How far each has gone up to the last time that it was measured [m]; saved and restored."""
        self._measured: np.ndarray | None = None
        self._shown: Held[posing.Shown] | None = None
        self.first_world, self.first_characters = world, list(characters)

    @property
    def time(self) -> float:
        """Simulated time [s]: ticks times dt."""
        return self.ticks / self.tick_rate

    def tick(self) -> None:
        """One tick of time."""
        if self._measured is None or self.ticks % self._every == 0:
            self.measure()
        self.ticks += 1

    @property
    def _every(self) -> int:
        """So many ticks lie between two measurements: a sixth of a second."""
        return max(self.tick_rate // MEASURED, 1)

    def measure(self) -> None:
        """Adds the way of the bodies since it was last measured: a state is saved as if it were measured in any case."""
        com = self.com()
        if self._measured is None:  # at the beginning, or after a restart: where they were when it was last measured
            self._measured = self.com((self.ticks - self.ticks % self._every) / self.tick_rate)
        if self.ticks % self._every == 0:
            self.gone, self._measured = self.gone + self._way(com), com

    def _way(self, com: np.ndarray) -> np.ndarray:
        """(C,) from where they were measured to these centres of mass (C, 3), over the ground [m]."""
        return np.linalg.norm((com - self._measured)[:, :2], axis=1)

    @property
    def distance(self) -> np.ndarray:
        """(C,) how far each has gone over the ground, from the beginning [m]."""
        if self._measured is None:
            self.measure()
        return self.gone + self._way(self.com())

    @property
    def over(self) -> bool:
        """Whether nothing more will happen."""
        return False

    def moment(self, time: float | None) -> float:
        """The time [s] that is shown for `time`, by default now."""
        return self.time if time is None else asked.moment(time)

    def snapshot(self, time: float | None = None, rows: np.ndarray | None = None) -> Pose:
        """Pose of the characters `rows`, by default all, at `time` [s], by default now.

        Any time within the last steps, up to now, is exact; asking changes nothing.
        """
        rows = np.arange(len(self.characters)) if rows is None else asked.rows_of(rows, len(self.characters))
        pose = empty_pose(len(rows))
        self.pose_into(pose, self.moment(time), rows)
        return pose

    def pose_into(self, pose: Pose, time: float, rows: np.ndarray) -> None:
        """Fills `pose`, of K rows, with the characters `rows` (K,) at `time` [s]."""
        rows = asked.rows_of(rows, len(self.characters))
        if len(pose.phase) < len(rows):
            raise InputError(f"a pose of {len(pose.phase)} rows: {len(rows)} are needed")
        with posing.THREADS:
            posing.pose_rows(pose_some.address, self._shown_at(), asked.moment(time), rows, pose)

    def com(self, time: float | None = None) -> np.ndarray:
        """Centres of mass (C, 3) of all characters at `time` [s], by default now, without posing them."""
        com = np.empty((len(self.characters), 3))
        posing.com_all(self._shown_at(), self.moment(time), com)
        return com

    @property
    def site(self) -> Site | None:
        """Where everything happens, for those who look at all of it; None where one follows a character instead."""
        return None

    def present(self, time: float | None = None) -> np.ndarray:
        """(C,) bool: who is there at `time` [s], by default now; the others are not to be seen."""
        return np.ones(len(self.characters), bool)

    def counts(self) -> dict:
        """What the run's summary tells beyond what all runs have."""
        return {}

    def skeleton(self, character: int) -> Skeleton:
        """The bones of a character at rest."""
        return skeleton_of(self.characters[asked.whole("character", character, 0, len(self.characters) - 1)])

    def bones(self, character: int, time: float | None = None) -> Bones:
        """The bones of a character at `time` [s], by default now: one row, in the order of its skeleton."""
        skeleton = self.skeleton(character)
        bones = bones_of(self.characters[character], self.snapshot(time, np.array([character])), skeleton)
        return self.shaped(bones, np.array([character]), self.moment(time))

    def shaped(self, bones: Bones, rows: np.ndarray, time: float) -> Bones:
        """The bones of characters `rows` (C,), all of one kind, at `time` [s], with what is turned by hand."""
        return bones

    def shapes(self, character: int) -> dict[str, Any]:
        """What a scene says of a character beside its footprints, as a track's file has it: what is not as usual."""
        return {}

    def hand_keys(self, character: int) -> Sequence[BoneKey]:
        """The keys by which bones of a character are turned by hand."""
        return ()

    def _shown_at(self) -> int:
        """Where kernels find what is seen."""
        held = self._shown
        if held is None or held.value.crowd is not self.crowd or held.value.bipeds is not self.bipeds:
            held = self._shown = Held(posing.Shown(self.crowd, self.bipeds), posing.SHOWN)
        return held.address

    @property
    def kind(self) -> np.ndarray:
        """(C,) which of the `kinds` each character is."""
        return self.crowd.kind.copy()

    def leg(self, character: int) -> float:
        """Nominal leg length of a character [m]: the unit in which it is drawn."""
        return float(self.bipeds["leg"]["nominal_length"][self.crowd.kind[character]])

    def feet(self) -> Footprints:
        """(C, 2) the last two footprints of each character, the older first."""
        last = self.crowd.real[:, None] - np.array([[2, 1]])
        return picked(self.crowd.footprints, (np.arange(len(self.characters))[:, None], last))

    @property
    def reached_goal(self) -> np.ndarray:
        """(C,) bool: both feet within the goal's radius and a step of it, standing."""
        if self.world.goal is None:
            return np.zeros(len(self.characters), bool)
        near = np.linalg.norm(self.feet().position[:, :, :2] - np.array(self.world.goal), axis=2).max(axis=1)
        return (near <= self.world.goal_radius + self.bipeds["gait"]["step_width"][self.crowd.kind]) & self.crowd.standing

    def track(self, character: int) -> Footprints:
        """The character's recent footprints, the newest last."""
        return copied(picked(self.crowd.footprints, (character, slice(0, int(self.crowd.real[character])))))

    def curve(self, character: int) -> Curve:
        """The committed curve over the last steps."""
        return copied(picked(self.crowd.committed, (character, slice(0, int(self.crowd.segments[character]) + 1))))

    def effort_of(self, character: int) -> tuple[float, int]:
        """(E, iterations) of the last window that was solved for a character."""
        cost, iterations = self.crowd.window_cost[character]
        return float(cost), int(iterations)

    @property
    def steps_planned(self) -> np.ndarray:
        """(C,) number of each character's newest footprint: it grows by one with every plan."""
        return self.crowd.number.copy()

    def placed_since(self, seen: np.ndarray) -> Walked | None:
        """The footprints placed since `steps_planned` was that; None where some are forgotten: ask for `walked`."""
        return self.footprints.placed_since(self.crowd, seen)

    def walked(self) -> Walked:
        """The footprints that are known: the latest, or all where they are kept."""
        return self.footprints.walked(self.crowd)

    def keep_footprints(self, most: int | None = None) -> None:
        """From now on no footprint is forgotten, or, beyond so many of all characters together, only the oldest."""
        self.footprints.keep(self.crowd, most)

    def tentative(self, character: int) -> Footprints:
        """(K,) the footprints behind the newest that a character has guessed for its last plan; none where all are known."""
        return picked(self.crowd.footprints, (character, slice(0, 0)))

    def rows_walked(self) -> Walked:
        """As `walked`, but a foot that stands on is a row of its own, which tells when the others left."""
        return self.footprints.rows(self.crowd)

    def stand(self, c: int, side: int, places: np.ndarray) -> None:
        """Lets character c stand, from now on, on places (2, 3) x, y, heading, the second with foot `side`."""
        asked.whole("character", c, 0, len(self.characters) - 1)
        checked = asked.check_places(side, places)
        crowds.stand(self.crowd, self.bipeds, self.world.arrays, c, side, checked, self.time, self.soles)


def kinds_of(characters: Sequence[Character]) -> tuple[list[Character], np.ndarray]:
    """The different ones of these characters, by what they are and not by name alone, and which of them each one is."""
    kinds: dict[tuple, int] = {}
    found: list[Character] = []
    for character in characters:
        key = (character.name, character.biped.tobytes(), character.look)  # type: ignore[attr-defined]
        if key not in kinds:
            kinds[key] = len(found)
            found.append(character)
    order = sorted(range(len(found)), key=lambda k: found[k].name)
    rank = {k: place for place, k in enumerate(order)}
    which = [rank[kinds[(c.name, c.biped.tobytes(), c.look)]] for c in characters]  # type: ignore[attr-defined]
    return [found[k] for k in order], np.array(which, np.int64)


def table_of(kinds: list[Character]) -> np.recarray:
    """The dimensions of each kind, for kernels."""
    table = empty_bipeds(len(kinds))
    for k, kind in enumerate(kinds):
        table[k] = kind.biped
    return table
