"""Commands that change the world: everyone's next footprint takes the other world into account."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from sim.stage.command import Command
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.errors.wording import nearest
from worlds.queries import border_clearance, tree_clearance, wall_clearance, water_clearance
from worlds.world import World

ROOM = 0.7
"""A tree or rock is not put this near to a foot [m]."""
BESIDE = 0.05
"""Nor does its side come this near to a sole [m]."""
DRY = 0.3
"""A goal is this far from trees, walls and water [m]."""


class Edit(Command):
    """A command that changes the world alone."""

    def on(self, world: World) -> World:
        """The world after it."""
        raise NotImplementedError

    def check(self, sim: Simulation) -> None:
        """Raises InputError where it cannot be done."""

    def apply(self, sim: Simulation) -> None:
        """Everyone's next footprint takes the other world into account."""
        self.check(sim)
        world = self.on(sim.world)
        sim.change(world, sim.planner.prepare(sim.situation(world)))


def _place(world: World, x: float, y: float, what: str) -> None:
    if not (math.isfinite(x) and math.isfinite(y)) or border_clearance(world.arrays, x, y) < 0:
        size = f"0..{world.size[0]:g} by 0..{world.size[1]:g}"
        raise InputError(f"{what} at ({x:g}, {y:g}): is outside the world; {size} is allowed")


def _room(sim: Simulation, x: float, y: float, radius: float, what: str) -> None:
    """Raises InputError where a thing would stand on a foot, or in a body on its way to its next ones."""
    _place(sim.world, x, y, what)
    if not (math.isfinite(radius) and 0 < radius <= 1000):
        raise InputError(f"{what}: radius = {radius!r}: more than 0, at most 1000 m is allowed")
    feet, there = sim.feet().position[sim.present(), :, :2].reshape(-1, 2), sim.present()
    sole = 0.5 * np.hypot(sim.bipeds["foot"]["length"], sim.bipeds["foot"]["width"])[sim.crowd.kind[there]].repeat(2)
    _keep_off(np.maximum(ROOM, radius + sole + BESIDE), feet, (x, y), f"{what} at ({x:.2f}, {y:.2f}): too near to a foot")
    wide = radius + sim.bipeds["body"]["radius"][sim.crowd.kind[there]] + BESIDE
    _keep_off(wide, sim.com()[there, :2], (x, y), f"{what} at ({x:.2f}, {y:.2f}): too near to a body")


def _keep_off(needed: np.ndarray, places: np.ndarray, there: tuple[float, float], said: str) -> None:
    """Raises InputError where a place (n, 2) is nearer to another than it needs (n,) [m]."""
    if (np.hypot(*(places - there).T) < needed).any():
        raise InputError(f"{said}; {needed.max():.2f} m away or more is allowed")


@dataclass(frozen=True)
class PlantTree(Edit):
    """A tree more, metres."""

    x: float
    y: float
    radius: float = 0.3
    name: ClassVar[str] = "plant tree"

    def on(self, world: World) -> World:
        """The world with that."""
        return world.with_tree(self.x, self.y, self.radius)

    def check(self, sim: Simulation) -> None:
        """It must have room."""
        _room(sim, self.x, self.y, self.radius, "tree")


@dataclass(frozen=True)
class PutRock(Edit):
    """A rock more, metres; height of its flat top above the terrain."""

    x: float
    y: float
    radius: float = 0.5
    height: float = 0.15
    name: ClassVar[str] = "put rock"

    def on(self, world: World) -> World:
        """The world with that."""
        return world.with_rock(self.x, self.y, self.radius, self.height)

    def check(self, sim: Simulation) -> None:
        """It must have room."""
        _room(sim, self.x, self.y, self.radius, "rock")
        if not (math.isfinite(self.height) and 0 <= self.height <= 100):
            raise InputError(f"rock: height = {self.height!r}: 0 to 100 m is allowed")


@dataclass(frozen=True)
class Remove(Edit):
    """A tree or a rock less, by its number in the world."""

    what: str  # tree or rock
    index: int
    name: ClassVar[str] = "remove"

    def on(self, world: World) -> World:
        """The world with that."""
        return (world.without_tree if self.what == "tree" else world.without_rock)(self.index)

    def check(self, sim: Simulation) -> None:
        """It must have room."""
        things = {"tree": sim.world.trees, "rock": sim.world.rocks}
        if self.what not in things:
            raise InputError(f"remove: what = {self.what!r}: tree or rock is allowed{nearest(self.what, things)}")
        if not 0 <= self.index < len(things[self.what]):
            raise InputError(f"remove: {self.what} {self.index}: there are {len(things[self.what])}, counted from 0")


@dataclass(frozen=True)
class SetGoal(Edit):
    """Another goal, metres, for planners that have one."""

    x: float
    y: float
    name: ClassVar[str] = "set goal"

    def on(self, world: World) -> World:
        """The world with that."""
        return world.with_goal(self.x, self.y)

    def check(self, sim: Simulation) -> None:
        """It must have room."""
        _place(sim.world, self.x, self.y, "goal")
        clearances = (clear(sim.world.arrays, self.x, self.y) for clear in (tree_clearance, wall_clearance, water_clearance))
        if min(clearances) < DRY:
            place = f"({self.x:.2f}, {self.y:.2f})"
            raise InputError(f"goal at {place}: needs dry ground {DRY:g} m away from trees, walls and water")
