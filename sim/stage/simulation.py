"""The simulation: fixed ticks, one loop (paper, section 4.2), no wall clock.

A tick plans every character whose committed curve would end before the tick does: footprint n, its timing, the window,
step n - 1 committed. Poses are asked for, at any time that is committed; asking changes nothing.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import LEFT, RIGHT, Footprints
from planner.crowd.apart import check_apart
from planner.planner import Planner, Situation, checked_starts
from planner.round.kernel import ROUND
from planner.round.refusals import nothing_refused, raise_refused
from planner.round.reservations import empty_reservations
from planner.round.round import Round
from planner.round.weights import PEOPLE, Weights, table_of_weights
from planner.stepping.beside import beside
from sim.rows import rounds
from sim.rows.crowd import TENTATIVE, Crowd
from sim.rows.posing import THREADS
from sim.stage.cast import TICK_RATE, Cast, Change, kinds_of, table_of
from worlds.compiled.memory import Held
from worlds.compiled.tables import copied, picked
from worlds.world import World


class State(NamedTuple):
    """All that a simulation knows beyond its world, characters, planner and seed: it goes on from here bit by bit."""

    ticks: int
    crowd: Crowd
    plans: Any


class Simulation(Cast):
    """Characters that plan as they go: `planner` says where (planner.planner.Planner).

    Where a `state` is given, it goes on from that; else everyone stands at the planner's starts. Whatever is to be changed
    while it runs is a command (sim.stage.commands), for `apply`.
    """

    def __init__(
        self, world: World, characters: Sequence[Character], planner: Planner, seed: int = 0, tick_rate: int = TICK_RATE,
        state: State | None = None, weights: Weights = PEOPLE,
    ) -> None:  # fmt: skip
        super().__init__(world, characters, seed, tick_rate)
        self.planner, self.weights = planner, weights
        self._placed, self._refused = np.zeros(len(self.characters), np.int64), nothing_refused(len(self.characters))
        if state is None:
            self._begin()
        else:
            self.ticks, self.crowd, plans = state
            self._use(plans)
        self._publish_anew()
        if state is None:
            self._plan()

    def _begin(self) -> None:
        starts = checked_starts(self.planner.starts(self.world, self.characters, self.seed), self.world, self.characters)
        check_apart([one.biped for one in self.characters], starts)
        for c, (x, y, heading) in enumerate(starts.tolist()):
            self.stand_beside(c, (x, y), heading)
        # Footprint 2 is the right foot standing on: plans begin at footprint 3, when the left one is the older.
        feet = self.feet()
        swapped = type(feet)(*(column[:, ::-1] for column in feet))
        number = np.full(len(self.characters), 3)
        self._use(self.planner.prepare(Situation(self.world, self.characters, swapped, number, self.seed)))

    def stand_beside(self, c: int, middle: tuple[float, float], heading: float) -> None:
        """Lets character c stand, from now on, with its feet to either side of a place [m, rad]."""
        biped = self.characters[c].biped
        self.stand(c, LEFT, np.array([(*beside(biped, side, middle, heading), heading) for side in (RIGHT, LEFT)]))

    def tick(self) -> None:
        """One tick: whoever runs out of committed motion within it plans a step."""
        super().tick()
        self._plan()

    def _plan(self) -> None:
        """Rounds until nobody runs out of motion. Raises what a planner in Python raised, ValueError for bad wishes."""
        with THREADS:
            rounds.advance_all(rounds.compiled_parts(), self.work.address, self.time + 1e-9, self._placed)
        if self._placed.any():
            self.footprints.add(self.crowd, self._placed)
        self.planner.planning.check()
        raise_refused(self._refused, self.planner.name, self.world.arrays.bounds)

    @property
    def reached_goal(self) -> np.ndarray:
        """(C,) bool: both feet within the goal's radius, or where the planner has found room for it beside others; standing."""
        near, arrived = super().reached_goal, getattr(self.planner, "arrived", None)
        if arrived is None or len(self.characters) == 1:
            return near
        return near | (arrived(self.plans) & self.crowd.standing)

    def situation(self, world: World) -> Situation:
        """What the planner prepares from, in a world."""
        return Situation(world, self.characters, self.feet(), self.crowd.number + 1, self.seed, self.plans)

    def change(self, world: World, plans: Any) -> None:
        """Another state of the same world, and the plans that the planner has made for it: taken together, at once."""
        self.world = world
        self._use(plans)
        self._hold(self._round.value._replace(world=world.arrays))

    def recast(self, c: int, character: Character, plans: Any) -> None:
        """Character c becomes another one, which stands from now on where its feet are, and plans as `plans` say."""
        self.footprints.recast(self.crowd, c)
        feet, number = self.feet(), int(self.crowd.number[c])
        middle = feet.position[c, :, :2].mean(axis=0)
        self.characters[c] = character
        self.kinds, self.crowd.kind[:] = kinds_of(self.characters)
        self.bipeds = table_of(self.kinds)
        self.stand_beside(c, (float(middle[0]), float(middle[1])), float(feet.heading[c, 1]))
        self.crowd.number[c] = number
        self.crowd.intents.aim[c], self.crowd.intents.rank[c], self.crowd.intents.hindered[c] = 0.0, 0.0, 0
        self._use(plans)
        self._publish_anew()
        self._plan()

    def log(self, command: dict) -> None:
        """Remembers what was changed, and when."""
        self.changes.append(Change(self.ticks, command))

    def _use(self, plans: Any) -> None:
        self.plans, self._plans = plans, self.planner.planning.held(plans)

    def _hold(self, round: Round) -> None:
        """From now on, rounds are like this one, with the plans that are in use: `work` is what they work on."""
        planner = self.planner.planning.address(round._replace(plans=self.plans))
        self._round = Held(round._replace(plans=self._plans.address if self._plans else 0), ROUND)
        others = rounds.go_around.address if len(self.characters) > 1 else 0
        work = rounds.Work(self.crowd, self._round.value, self._round.address, planner, others, self._refused)
        self.work = Held(work, rounds.WORK)

    def _publish_anew(self) -> None:
        """Everyone shows what it holds: reservations follow from the rows."""
        reservations = empty_reservations(self.bipeds, self.crowd.kind, self.world.size, getattr(self.planner, "looks", 0.0))
        crowd = self.crowd
        weights = table_of_weights(self.weights, len(self.kinds))
        self._hold(Round(crowd.kind, self.bipeds, self.world.arrays, 0, reservations, crowd.intents, self.seed, weights))
        rounds.publish_all(self.work.address, np.arange(len(self.characters)))

    def tentative(self, character: int) -> Footprints:
        """(K,) the footprints behind the newest that a character has guessed for its last plan; the next one forgets them."""
        real = int(self.crowd.real[character])
        return copied(picked(self.crowd.footprints, (character, slice(real, real + TENTATIVE))))

    @property
    def reservations(self) -> Any:
        """What all have shown to the others."""
        return self._round.value.reservations
