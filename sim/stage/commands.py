"""Everything that changes a running simulation: commands, each applied whole at a tick, or not at all, and logged.

    apply(sim, PlantTree(3.0, 4.0, 0.3))

A command checks all that it needs before it changes anything, so one that is refused (InputError, NoWay) leaves no trace. What
was done stands in `sim.changes`, in recordings and in saved states; `replay` does it again, in another run, to the same bit.
"""

import math
from collections.abc import Iterable
from dataclasses import asdict, dataclass, fields
from typing import Any, ClassVar

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import Step
from sim.stage.cast import Change
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.queries import border_clearance, clearance, tree_clearance, water_clearance
from worlds.reading import nearest
from worlds.world import World

ROOM = 0.7
"""A tree or rock is not put this near to a foot [m]."""
DRY = 0.3
"""A goal is this far from trees and water [m]."""


@dataclass(frozen=True)
class Command:
    """A change of a running simulation."""

    name: ClassVar[str]

    def apply(self, sim: Simulation) -> None:
        """Does it, or raises InputError or NoWay and does nothing."""
        raise NotImplementedError

    def as_plain(self) -> dict:
        """The command as plain JSON values."""
        return {"command": self.name, **asdict(self)}


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
    """Raises InputError where a thing would stand on a foot."""
    _place(sim.world, x, y, what)
    if not (math.isfinite(radius) and 0 < radius <= 1000):
        raise InputError(f"{what}: radius = {radius!r}: more than 0, at most 1000 m is allowed")
    feet = sim.feet().position[:, :, :2].reshape(-1, 2)
    if float(np.hypot(*(feet - (x, y)).T).min()) < ROOM:
        raise InputError(f"{what} at ({x:.2f}, {y:.2f}): too near to a foot; {ROOM:g} m away is near enough")


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
        arrays = sim.world.arrays
        if tree_clearance(arrays, self.x, self.y) < DRY or water_clearance(arrays, self.x, self.y) < DRY:
            raise InputError(f"goal at ({self.x:.2f}, {self.y:.2f}): needs dry ground {DRY:g} m away from trees and water")


@dataclass(frozen=True)
class Pause(Command):
    """One character takes no further step, or goes on."""

    character: int
    paused: bool = True
    name: ClassVar[str] = "pause"

    def apply(self, sim: Simulation) -> None:
        """Pauses it, or lets it go on."""
        _row(sim, self.character)
        sim.crowd.paused[self.character] = self.paused


@dataclass(frozen=True)
class Recast(Command):
    """One character becomes another one, standing where its feet are."""

    character: int
    dimensions: dict  # of the new one: Character.to_dict
    look: dict
    name: ClassVar[str] = "recast"

    @classmethod
    def to(cls, character: int, new: Character) -> "Recast":
        """The command for a character at hand."""
        return cls(character, new.to_dict(), new.look.model_dump(mode="json"))

    def apply(self, sim: Simulation) -> None:
        """Changes it where there is room for the new body."""
        _row(sim, self.character)
        new = Character.from_dict(self.dimensions, self.look)
        x, y = sim.feet().position[self.character, :, :2].mean(axis=0)
        if clearance(sim.world.arrays, x, y) < new.biped.body.radius:
            raise InputError(f"{new.name}: no room for its body at ({x:.2f}, {y:.2f}), where character {self.character} stands")
        characters = [new if c == self.character else one for c, one in enumerate(sim.characters)]
        plans = sim.planner.prepare(sim.situation(sim.world)._replace(characters=characters))
        sim.recast(self.character, new, plans)


@dataclass(frozen=True)
class Give(Command):
    """Steps for one character of a planner that is fed (planner.modes.external)."""

    character: int
    steps: tuple[Step, ...]
    name: ClassVar[str] = "give"

    def apply(self, sim: Simulation) -> None:
        """Adds them behind those that it has."""
        _row(sim, self.character)
        give = getattr(sim.planner, "give", None)
        if give is None:
            raise InputError(f"give: the planner {sim.planner.name} takes no footprints; planner.modes.external.External does")
        number = int(sim.crowd.number[self.character]) + 1
        give(sim.plans, self.character, list(self.steps), number, sim.world)

    def as_plain(self) -> dict:
        """The command as plain JSON values: what is automatic is left out."""
        steps = [{k: v for k, v in step._asdict().items() if v == v} for step in self.steps]
        return {"command": self.name, "character": self.character, "steps": steps}


COMMANDS: dict[str, type[Command]] = {kind.name: kind for kind in (PlantTree, PutRock, Remove, SetGoal, Pause, Recast, Give)}


def _row(sim: Simulation, character: int) -> None:
    if not 0 <= character < len(sim.characters):
        raise InputError(f"character {character}: there are {len(sim.characters)}, counted from 0")


def apply(sim: Simulation, command: Command) -> None:
    """Does a command now, between two ticks, and logs it. Raises InputError, NoWay; then nothing has changed."""
    command.apply(sim)
    sim.log(command.as_plain())


def from_plain(plain: dict) -> Command:
    """The command that `as_plain` described. Raises InputError."""
    values: dict[str, Any] = dict(plain)
    kind = COMMANDS.get(str(values.pop("command", None)))
    if kind is None or set(values) - {field.name for field in fields(kind)}:
        raise InputError(f"{plain!r}: is no command; there are {', '.join(COMMANDS)}")
    if kind is Give:
        values["steps"] = tuple(Step(**step) for step in values["steps"])
    return kind(**values)


def replay(sim: Simulation, changes: Iterable[Change], ticks: int) -> None:
    """Lets a run tick until so many ticks, changing it as another one was changed."""
    pending = list(changes)
    while True:
        while pending and pending[0].tick <= sim.ticks:
            apply(sim, from_plain(pending.pop(0).command))
        if sim.ticks >= ticks:
            return
        sim.tick()
