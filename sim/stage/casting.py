"""Commands that change characters: they stand, become others, take the steps that they are given, or go where they are told."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import Step, walker_headings
from planner.crowd.apart import what_overlaps
from sim.stage.command import Command, check_character
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.queries import clearance

NEAR = 10.0
"""Nobody's body reaches so far [m]."""


@dataclass(frozen=True)
class Pause(Command):
    """One character takes no further step, or goes on."""

    character: int
    paused: bool = True
    name: ClassVar[str] = "pause"

    def apply(self, sim: Simulation) -> None:
        """Pauses it, or lets it go on."""
        check_character(sim, self.character)
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
        check_character(sim, self.character)
        if not sim.present()[self.character]:
            raise InputError(f"character {self.character} is not there; it comes as its level says")
        new = Character.from_dict(self.dimensions, self.look)
        x, y = sim.feet().position[self.character, :, :2].mean(axis=0)
        if clearance(sim.world.arrays, x, y) < new.biped.body.radius:
            raise InputError(f"{new.name}: no room for its body at ({x:.2f}, {y:.2f}), where character {self.character} stands")
        self._check_neighbours(sim, new)
        characters = [new if c == self.character else one for c, one in enumerate(sim.characters)]
        plans = sim.planner.prepare(sim.situation(sim.world)._replace(characters=characters))
        sim.recast(self.character, new, plans)

    def _check_neighbours(self, sim: Simulation, new: Character) -> None:
        """Raises InputError where a body that is larger than before reaches into somebody beside it."""
        feet, before, now = sim.feet(), sim.characters[self.character].biped, new.biped
        rests = np.column_stack([feet.position[:, :, :2].mean(axis=1), walker_headings(feet)[:, 1]])
        mine = rests[self.character]
        near = (np.hypot(*(rests[:, :2] - mine[:2]).T) < NEAR) & sim.present()
        for c in np.flatnonzero(near):
            if c == self.character or what_overlaps(before, mine, sim.characters[c].biped, rests[c]):
                continue
            if what_overlaps(now, mine, sim.characters[c].biped, rests[c]):
                where = f"at ({mine[0]:.2f}, {mine[1]:.2f})"
                raise InputError(f"{new.name}: no room {where}, where character {self.character} stands, beside character {c}")


@dataclass(frozen=True)
class Give(Command):
    """Steps for one character of a planner that is fed (planner.modes.external)."""

    character: int
    steps: tuple[Step, ...]
    name: ClassVar[str] = "give"

    def apply(self, sim: Simulation) -> None:
        """Adds them behind those that it has."""
        check_character(sim, self.character)
        give = getattr(sim.planner, "give", None)
        if give is None:
            raise InputError(f"give: the planner {sim.planner.name} takes no footprints; planner.modes.external.External does")
        number = int(sim.crowd.number[self.character]) + 1
        give(sim.plans, self.character, list(self.steps), number, sim.world)

    def as_plain(self) -> dict:
        """The command as plain JSON values: what is automatic is left out."""
        steps = [{k: v for k, v in step._asdict().items() if v == v} for step in self.steps]
        return {"command": self.name, "character": self.character, "steps": steps}


@dataclass(frozen=True)
class Steer(Command):
    """Characters of the planner that is steered (planner.modes.steer) are told where to go, and how: one wish, or one each.

    direction [rad], over the ground; pace: stand, turn (on the spot, toward the direction), creep, walk, run; aside [rad]: how
    far the direction lies to the left of where the feet are to point; leap: the next step is one.
    """

    characters: tuple[int, ...]
    direction: tuple[float, ...] = (0.0,)
    pace: tuple[str, ...] = ("walk",)
    aside: tuple[float, ...] = (0.0,)
    leap: tuple[bool, ...] = (False,)
    name: ClassVar[str] = "steer"

    @classmethod
    def of(cls, characters: Any, direction: Any, pace: Any, aside: Any = 0.0, leap: Any = False) -> "Steer":
        """The command for values, lists or arrays at hand."""
        return cls(characters, direction, pace, aside, leap)

    def apply(self, sim: Simulation) -> None:
        """Tells them; each one's next footprint answers."""
        for character in self.characters:
            check_character(sim, character)
        tell = getattr(sim.planner, "tell", None)
        if tell is None:
            raise InputError(f"steer: the planner {sim.planner.name} decides for itself; planner.modes.steer.Steered is told")
        tell(sim.plans, np.array(self.characters, np.int64), *self.wish)

    @property
    def wish(self) -> tuple:
        """What it tells, without whom."""
        return self.direction, self.pace, self.aside, self.leap
