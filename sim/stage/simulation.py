"""The simulation: fixed ticks, one loop (paper, section 4.2), no wall clock.

A tick plans every character whose committed curve would end before the tick does: footprint n, its timing, the window,
step n - 1 committed. Poses are asked for, at any time that is committed; asking changes nothing.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from motion.characters.biped import Biped
from motion.com import newton
from planner.crowd.reservations import empty_reservations
from planner.plan import Plans
from planner.stepping import strides
from sim.rows import rounds
from sim.rows.crowd import Crowd
from sim.stage.cast import TICK_RATE, Cast
from worlds.world import World


class State(NamedTuple):
    """All that a simulation knows beyond its world, characters, planner and seed: it goes on from here bit by bit."""

    ticks: int
    crowd: Crowd
    plans: Plans


class Simulation(Cast):
    """Characters that plan as they go. `planner` gives plans (planner.wandering.Wander, planner.river.rock_hop.RockHop, ...).

    Where a `state` is given, it goes on from that; else everyone stands at the planner's starts.
    """

    def __init__(
        self, world: World, characters: Sequence[Biped], planner, seed: int = 0, tick_rate: int = TICK_RATE,
        state: State | None = None,
    ) -> None:  # fmt: skip
        super().__init__(world, characters, seed, tick_rate)
        self.planner, self.effort = planner, newton.LIVE
        self._placed = np.zeros(len(self.characters), np.int64)
        if state is None:
            self._begin()
        else:
            self.ticks, self.crowd, self.plans = state
        self.reservations = empty_reservations(self.bipeds, self.crowd.kind, world.size)
        rounds.publish_all(self.crowd, self.bipeds, self.reservations, np.arange(len(self.characters)))
        if state is None:
            self._plan()

    def _begin(self) -> None:
        world, planner = self.world, self.planner
        for c, (x, y, heading) in enumerate(planner.starts(world, self.characters, self.seed)):
            b = self.characters[c].record
            self.stand(c, 0, np.array([strides.beside(b, side, (x, y), heading)[1:] for side in (1, 0)]))
        # Footprint 2 is the right foot standing on: plans begin at footprint 3, when the left one is the older.
        begin = np.full(len(self.characters), 3)
        self.plans = planner.prepare(world, self.characters, self.standing_on()[:, ::-1], begin, self.seed)

    def tick(self) -> None:
        """One tick: whoever runs out of committed motion within it plans a step."""
        super().tick()
        self._plan()

    def _plan(self) -> None:
        until = self.time + 1e-9
        rounds.advance_all(
            rounds.compiled_parts(), self.crowd, self.bipeds, self.world.arrays, self.plans, self.reservations, self.seed,
            self.effort, until, self._placed,
        )  # fmt: skip
        if self._placed.any():
            self.footprints.add(self.crowd, self._placed)

    def set_world(self, world: World) -> None:
        """Another state of the same world: every character's next footprint takes it into account."""
        super().set_world(world)
        self.plans = self.planner.prepare(world, self.characters, self.standing_on(), self.crowd.number + 1, self.seed)

    def set_goal(self, x: float, y: float) -> None:
        """Another goal, for planners that have one."""
        self.set_world(self.world.with_goal(x, y))
