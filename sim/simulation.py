"""The simulation: fixed ticks, one loop (paper, section 4.2), no wall clock.

A tick plans every character whose committed curve would end before the tick does: footprint n, its timing, the window,
step n - 1 committed. Poses are asked for, at any time that is committed; asking changes nothing.
"""

from collections.abc import Sequence

import numpy as np

from motion import newton
from motion.biped import Biped
from planner import strides
from planner.reservations import empty_reservations
from sim import rounds
from sim.cast import TICK_RATE, Cast
from worlds.world import World


class Simulation(Cast):
    """Characters that plan as they go. `planner` gives plans (planner.wandering.Wander, planner.rock_hop.RockHop, ...)."""

    def __init__(self, world: World, characters: Sequence[Biped], planner, seed: int = 0, tick_rate: int = TICK_RATE) -> None:
        super().__init__(world, characters, seed, tick_rate)
        self.planner, self.effort = planner, newton.LIVE
        self._placed = np.zeros(len(self.characters), np.int64)
        for c, (x, y, heading) in enumerate(planner.starts(world, self.characters, self.seed)):
            b = self.characters[c].record
            self.stand(c, 0, np.array([strides.beside(b, side, (x, y), heading)[1:] for side in (1, 0)]))
        # Footprint 2 is the right foot standing on: plans begin at footprint 3, when the left one is the older.
        begin = np.full(len(self.characters), 3)
        self.plans = planner.prepare(world, self.characters, self.standing_on()[:, ::-1], begin, self.seed)
        self.reservations = empty_reservations(self.bipeds, self.crowd.kind, world.size)
        rounds.publish_all(self.crowd, self.bipeds, self.reservations)
        self._plan()

    def tick(self) -> None:
        """One tick: whoever runs out of committed motion within it plans a step."""
        super().tick()
        self._plan()

    def _plan(self) -> None:
        until = self.time + 1e-9
        rounds.advance_all(
            self.crowd,
            self.bipeds,
            self.world.arrays,
            self.plans,
            self.reservations,
            self.seed,
            until,
            self.effort,
            self._placed,
        )
        if self._placed.any():
            self.footprints.add(self.crowd, self._placed)

    def set_world(self, world: World) -> None:
        """Another state of the same world: every character's next footprint takes it into account."""
        super().set_world(world)
        self.plans = self.planner.prepare(world, self.characters, self.standing_on(), self.crowd.number + 1, self.seed)

    def set_goal(self, x: float, y: float) -> None:
        """Another goal, for planners that have one."""
        self.set_world(self.world.with_goal(x, y))
