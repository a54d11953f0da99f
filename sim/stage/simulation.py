"""The simulation: fixed ticks, one loop (paper, section 4.2), no wall clock.

A tick plans every character whose committed curve would end before the tick does: footprint n, its timing, the window,
step n - 1 committed. Poses are asked for, at any time that is committed; asking changes nothing.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numba
import numpy as np

from motion.characters.character import Character
from motion.track.footprints import LEFT, RIGHT, Footprints, walker_headings
from planner.crowd.apart import check_apart
from planner.planner import Coming, Moment, Planner, Situation, checked_starts
from planner.round.kernel import ROUND
from planner.round.refusals import nothing_refused, raise_refused
from planner.round.reservations import COMMITTED, empty_reservations
from planner.round.round import Round
from planner.round.weights import PEOPLE, Weights, table_of_weights
from planner.stepping.beside import beside
from sim.rows import rounds
from sim.rows.crowd import TENTATIVE, Crowd
from sim.rows.posing import THREADS
from sim.stage.cast import TICK_RATE, Cast, Change, Site, kinds_of, table_of
from worlds.compiled.memory import Held
from worlds.compiled.tables import copied, picked
from worlds.world import World

AWAY = -1e6
"""Where the rows of those lie who are away [m]: nobody looks there."""


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
        self.planner, self.weights, self.soles = planner, weights, getattr(planner, "lays_soles", False)
        self._placed, self._refused = np.zeros(len(self.characters), np.int64), nothing_refused(len(self.characters))
        if state is None:
            self._begin()
        else:
            self.ticks, self.crowd, plans = state
            self._use(plans)
        self._publish_anew()
        if state is None:
            self._come_and_go()
            self._plan()

    def _begin(self) -> None:
        starts = checked_starts(self.planner.starts(self.world, self.characters, self.seed), self.world, self.characters)
        if not hasattr(self.planner, "come_and_go"):  # else nobody is there yet
            check_apart([one.biped for one in self.characters], starts)
        for c, (x, y, heading) in enumerate(starts.tolist()):
            self.stand_beside(c, (x, y), heading)
        # Footprint 2 is the right foot standing on: plans begin at footprint 3, when the left one is the older.
        feet = self.feet()
        swapped = type(feet)(*(column[:, ::-1] for column in feet))
        number = np.full(len(self.characters), 3)
        self._use(self.planner.prepare(Situation(self.world, self.characters, swapped, number, self.seed)))
        away = np.flatnonzero(~self.present())
        self.footprints.begin_away(away)
        self._put_away(away)

    def stand_beside(self, c: int, middle: tuple[float, float], heading: float) -> None:
        """Lets character c stand, from now on, with its feet to either side of a place [m, rad]."""
        biped = self.characters[c].biped
        self.stand(c, LEFT, np.array([(*beside(biped, side, middle, heading), heading) for side in (RIGHT, LEFT)]))

    def tick(self) -> None:
        """One tick: whoever runs out of committed motion within it plans a step."""
        super().tick()
        if self.ticks % self._every == 0:
            self._come_and_go()
            self._reconsider()
        self._plan()

    def _reconsider(self) -> None:
        """Takes other plans where the planner makes some of itself."""
        reconsider = getattr(self.planner, "reconsider", None)
        plans = None if reconsider is None else reconsider(self.situation(self.world))
        if plans is not None:
            self.change(self.world, plans)

    def _come_and_go(self) -> None:
        """Lets out who goes and lets in who comes, where the planner does such a thing."""
        come_and_go = getattr(self.planner, "come_and_go", None)
        if come_and_go is None:
            return
        rest, between = self.feet().position[:, :, :2].mean(axis=1), self.reservations.path[:, COMMITTED - 2, :2].copy()
        place, standing = self.com()[:, :2].copy(), self.crowd.standing.copy()
        moment = Moment(self.time, self.seed, self.world, self.characters, place, between, rest, standing)
        gone, come = come_and_go(self.plans, moment)
        if len(gone):
            self.footprints.let_go(self.crowd, gone)
            self._put_away(gone)
            self._hide(gone)
        if come:
            self._let_in(come)

    def _put_away(self, rows: np.ndarray) -> None:
        """Rows of those who are away: they stand where they are, at rest for ever, and plan nothing."""
        curve, feet = self.crowd.committed, self.feet()
        for c in rows.tolist():
            places = np.column_stack([feet.position[c, :, :2], walker_headings(feet)[c]])
            number = int(self.crowd.number[c])
            self.stand(c, int(feet.side[c, 1]), places)
            self.crowd.number[c], self.crowd.segments[c] = number, 1
            curve.time[c, 1], curve.control[c, 1] = curve.time[c, 0] + 1.0, curve.control[c, 0]
            curve.support[c, 0, self.crowd.footprints.side[c, :2]] = (0, 1)

    def _hide(self, rows: np.ndarray) -> None:
        """Nobody sees the rows of those who are away, and they are never due."""
        held = self.reservations
        held.due[rows], held.foot[rows, :, 4], held.aim[rows], held.rank[rows] = np.inf, -np.inf, 0.0, 0.0
        along = np.linspace(0.0, self.world.size[1], len(held.due))[rows]  # in many cells: none gets long
        held.path[rows, :, 0], held.claim[rows, 0] = AWAY, AWAY
        held.path[rows, :, 1], held.claim[rows, 1] = along[:, None], along

    def _let_in(self, come: list[Coming]) -> None:
        """Those who come stand in their rows, and the others see them."""
        before = self.com()
        for one in come:
            self.characters[one.row] = one.character
        self.kinds, self.crowd.kind[:] = kinds_of(self.characters)
        self.bipeds = table_of(self.kinds)
        for one in come:
            number = int(self.crowd.number[one.row])
            self.footprints.come(one.row)
            self.stand_beside(one.row, (one.x, one.y), one.heading)
            self.crowd.number[one.row], intents = max(number, 2), self.crowd.intents
            intents.aim[one.row], intents.rank[one.row], intents.hindered[one.row] = 0.0, 0.0, 0
            intents.stood[one.row], intents.since[one.row] = 0, self.time
            self.crowd.paused[one.row] = False
        self._go_on_measuring(np.array([one.row for one in come]), before)
        self._publish_anew()

    def _go_on_measuring(self, rows: np.ndarray, before: np.ndarray) -> None:
        """Rows are elsewhere from now on, which is no way that anybody has gone; before (C, 3): where they were [m]."""
        if self._measured is not None:
            way = np.linalg.norm((before - self._measured)[rows, :2], axis=1)
            self.gone[rows] += way
            self._measured[rows] = self.crowd.committed.control[rows, 0, :3]

    def present(self, time: float | None = None) -> np.ndarray:
        """(C,) bool: who is there at `time` [s], by default now."""
        there = getattr(self.planner, "there", None)
        return super().present(time) if there is None else there(self.plans, self.moment(time))

    def counts(self) -> dict:
        """Who came and went, where people do."""
        counts = getattr(self.planner, "counts", None)
        return {} if counts is None else {"people": counts(self.plans)}

    @property
    def site(self) -> Site | None:
        """All of the world, where people come and go."""
        if not hasattr(self.planner, "there"):
            return None
        size = np.array(self.world.size)
        return Site(np.array([*(0.5 * size), 1.0]), float(0.46 * np.hypot(*size)))

    def _plan(self) -> None:
        """Rounds until nobody runs out of motion. Raises what a planner in Python raised, ValueError for bad wishes."""
        with THREADS:
            threads = numba.get_num_threads()
            rounds.advance_all(rounds.compiled_parts(), self.work.address, self.time + 1e-9, self._placed, threads)
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
        self.stand_beside(c, (float(middle[0]), float(middle[1])), float(walker_headings(feet)[c, 1]))
        self.crowd.number[c] = number
        intents = self.crowd.intents
        intents.aim[c], intents.rank[c], intents.hindered[c], intents.stood[c] = 0.0, 0.0, 0, 0
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
        others = rounds.go_around[self.weights.model].address if len(self.characters) > 1 else 0
        work = rounds.Work(self.crowd, self._round.value, self._round.address, planner, self.soles, others, self._refused)
        self.work = Held(work, rounds.WORK)

    def _publish_anew(self) -> None:
        """Everyone shows what it holds: reservations follow from the rows."""
        reservations = empty_reservations(self.bipeds, self.crowd.kind, self.world.size, getattr(self.planner, "looks", 0.0))
        crowd = self.crowd
        weights = table_of_weights(self.weights, len(self.kinds))
        self._hold(Round(crowd.kind, self.bipeds, self.world.arrays, 0, reservations, crowd.intents, self.seed, weights))
        rounds.publish_all(self.work.address, np.arange(len(self.characters)))
        self._hide(np.flatnonzero(~self.present()))

    def tentative(self, character: int) -> Footprints:
        """(K,) the footprints behind the newest that a character has guessed for its last plan; the next one forgets them."""
        real = int(self.crowd.real[character])
        return copied(picked(self.crowd.footprints, (character, slice(real, real + TENTATIVE))))

    @property
    def reservations(self) -> Any:
        """What all have shown to the others."""
        return self._round.value.reservations
