"""Characters in a world at a time: what the live simulation and a scripted performance share, and the view reads."""

from collections.abc import Sequence

import numpy as np

from motion.characters.biped import BIPED, Biped
from motion.pose.pose import Pose, empty_pose
from motion.track.footprints import Track
from planner.stepping import placing
from sim.rows import crowd as crowds
from sim.rows.footprint_log import FootprintLog
from worlds.compiled.jit import start_threads
from worlds.queries import rock_under
from worlds.world import World

TICK_RATE = 60


class Cast:
    """Characters, standing at first. A subclass lets them move: `tick`."""

    def __init__(self, world: World, characters: Sequence[Biped], seed: int, tick_rate: int, **capacity: int) -> None:
        start_threads()
        self.world, self.characters = world, list(characters)
        self.seed, self.tick_rate, self.ticks = int(seed), tick_rate, 0
        self.bipeds, kind = _biped_table(self.characters)
        self.crowd = crowds.empty_crowd(kind, **capacity)
        self.footprints = FootprintLog()

    @property
    def time(self) -> float:
        """Simulated time [s]: ticks times dt."""
        return self.ticks / self.tick_rate

    def tick(self) -> None:
        """One tick of time."""
        self.ticks += 1

    @property
    def over(self) -> bool:
        """Whether nothing more will happen."""
        return False

    def moment(self, time: float | None) -> float:
        """The time [s] that is shown for `time`, by default now."""
        return self.time if time is None else float(time)

    def snapshot(self, time: float | None = None, rows: np.ndarray | None = None) -> Pose:
        """Pose of the characters `rows`, by default all, at `time` [s], by default now.

        Any time within the last steps, up to now, is exact; asking changes nothing.
        """
        rows = np.arange(len(self.characters)) if rows is None else rows
        pose = empty_pose(len(rows))
        crowds.pose_all(self.crowd, self.bipeds, self.moment(time), rows, pose)
        return pose

    def com(self, time: float | None = None) -> np.ndarray:
        """Centres of mass (C, 3) of all characters at `time` [s], by default now, without posing them."""
        com = np.empty((len(self.characters), 3))
        crowds.com_all(self.crowd, self.moment(time), com)
        return com

    def set_world(self, world: World) -> None:
        """Another state of the same world."""
        self.world = world

    def standing_on(self) -> np.ndarray:
        """(C, 2, 5): side, x, y, heading, rock of each character's last two footprints."""
        c, rows = self.crowd, np.arange(len(self.characters))
        picks = [(rows, c.real - 2), (rows, c.real - 1)]
        return np.stack([np.column_stack([c.side[p], c.position[p][:, :2], c.heading[p], c.rock[p]]) for p in picks], axis=1)

    @property
    def reached_goal(self) -> np.ndarray:
        """(C,) bool: both feet within the goal's radius and a step of it, standing."""
        if self.world.goal is None:
            return np.zeros(len(self.characters), bool)
        feet = self.standing_on()[:, :, 1:3]
        near = np.linalg.norm(feet - np.array(self.world.goal), axis=2).max(axis=1)
        return (near <= self.world.goal_radius + self.bipeds["step_width"][self.crowd.kind]) & self.crowd.standing

    def track(self, character: int) -> Track:
        """The character's recent footprints, the newest last."""
        return crowds.copied_track(self.crowd, character, int(self.crowd.real[character]))

    def curve(self, character: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Committed curve over the last steps: time (m + 1,), control (m + 1, 6), support (m, 2)."""
        m, c = int(self.crowd.curve_count[character]), self.crowd
        return (
            c.curve_time[character, : m + 1].copy(),
            c.control[character, : m + 1].copy(),
            c.support[character, :m].copy(),
        )

    def stand(self, c: int, side: int, places: np.ndarray) -> None:
        """Lets character c stand on places (2, 3) x, y, heading, the second with foot `side`."""
        w, b = self.world.arrays, self.bipeds[self.crowd.kind[c]]
        positions, normals, rocks = np.zeros((2, 3)), np.zeros((2, 3)), np.zeros(2, np.int64)
        for i, (x, y, heading) in enumerate(places):
            rocks[i] = rock_under(w, x, y, placing.EDGE)
            positions[i, 2], *normals[i] = placing.lay_sole(b, w, x, y, heading, rocks[i])
            positions[i, :2] = x, y
        crowds.stand(self.crowd, self.bipeds, c, 0.0, side, positions, places[:, 2].copy(), normals, rocks)


def _biped_table(characters: list[Biped]) -> tuple[np.recarray, np.ndarray]:
    """One record per kind of character, and each character's row in it."""
    names = sorted({character.name for character in characters})
    table = np.zeros(len(names), BIPED).view(np.recarray)
    for character in characters:
        table[names.index(character.name)] = character.record
    return table, np.array([names.index(character.name) for character in characters])
