"""The simulation: fixed ticks, one loop (paper, section 4.2), no wall clock.

A tick plans every character whose committed curve would end before the tick does: footprint n, its timing, the window,
step n - 1 committed. Poses are asked for, at any time that is committed; asking changes nothing.
"""

from collections.abc import Sequence

import numpy as np

from motion import newton
from motion.biped import BIPED, Biped
from motion.pose import Pose, empty_pose
from motion.track import Track
from planner import placing
from sim import crowd as crowds
from sim.footprint_log import FootprintLog
from worlds.queries import rock_under
from worlds.world import World

TICK_RATE = 60


class Simulation:
    """Characters in a world. `planner` gives plans (planner.wander_plan.Wander, planner.rock_hop.RockHop, ...)."""

    def __init__(self, world: World, characters: Sequence[Biped], planner, seed: int = 0, tick_rate: int = TICK_RATE) -> None:
        self.world, self.characters, self.planner = world, list(characters), planner
        self.seed, self.tick_rate, self.ticks = int(seed), tick_rate, 0
        self.effort = newton.LIVE
        self.bipeds, kind = _biped_table(self.characters)
        self.crowd = crowds.empty_crowd(kind)
        self._placed = np.zeros(len(kind), np.int64)
        self._stand_at(planner.starts(world, self.characters, self.seed))
        self.footprints = FootprintLog()
        # Footprint 2 is the right foot standing on: plans begin at footprint 3, when the left one is the older.
        self.plans = planner.prepare(world, self.characters, self.standing_on()[:, ::-1], np.full(len(kind), 3), self.seed)

    @property
    def time(self) -> float:
        """Simulated time [s]: ticks times dt."""
        return self.ticks / self.tick_rate

    def tick(self) -> None:
        """One tick: whoever runs out of committed motion within it plans a step."""
        self.ticks += 1
        until = self.time + 1e-9
        crowds.advance_all(self.crowd, self.bipeds, self.world.arrays, self.plans, self.seed, until, self.effort, self._placed)
        if self._placed.any():
            self.footprints.add(self.crowd, self._placed)

    def snapshot(self, time: float | None = None) -> Pose:
        """Pose of all characters at `time` [s], by default now; any time within the last steps, up to now, is exact."""
        pose = empty_pose(len(self.characters))
        crowds.pose_all(self.crowd, self.bipeds, self.time if time is None else float(time), pose)
        return pose

    def set_world(self, world: World) -> None:
        """Another state of the same world: every character's next footprint takes it into account."""
        self.world = world
        self.plans = self.planner.prepare(world, self.characters, self.standing_on(), self.crowd.number + 1, self.seed)

    def set_goal(self, x: float, y: float) -> None:
        """Another goal, for planners that have one."""
        self.set_world(self.world.with_goal(x, y))

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
        return Track(*(a.copy() for a in crowds.track_of(self.crowd, character, int(self.crowd.real[character]))))

    def curve(self, character: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Committed curve over the last steps: time (m + 1,), control (m + 1, 6), support (m, 2)."""
        m, c = int(self.crowd.curve_count[character]), self.crowd
        return (
            c.curve_time[character, : m + 1].copy(),
            c.control[character, : m + 1].copy(),
            c.support[character, :m].copy(),
        )

    def _stand_at(self, starts: np.ndarray) -> None:
        """Lets every character stand at (x, y, heading) of starts (C, 3)."""
        w = self.world.arrays
        for c, (x, y, heading) in enumerate(starts):
            b = self.bipeds[self.crowd.kind[c]]
            positions, normals, rocks = np.zeros((2, 3)), np.zeros((2, 3)), np.zeros(2, np.int64)
            for i, across in enumerate((-0.5 * b.step_width, 0.5 * b.step_width)):
                px, py = x - across * np.sin(heading), y + across * np.cos(heading)
                rocks[i] = rock_under(w, px, py, placing.EDGE)
                positions[i, 2], *normals[i] = placing.lay_sole(b, w, px, py, heading, rocks[i])
                positions[i, :2] = px, py
            crowds.stand(self.crowd, self.bipeds, c, 0.0, positions, np.full(2, heading), normals, rocks)


def _biped_table(characters: list[Biped]) -> tuple[np.recarray, np.ndarray]:
    """One record per kind of character, and each character's row in it."""
    names = sorted({character.name for character in characters})
    table = np.zeros(len(names), BIPED).view(np.recarray)
    for character in characters:
        table[names.index(character.name)] = character.record
    return table, np.array([names.index(character.name) for character in characters])
