"""Driven by hand: who is told a direction and a pace answers with its next footprint (planner.modes.answering).

A wish stays until another one comes: a direction over the ground, a pace (stand, turn, creep, walk, run), and how far the
direction lies to the left of where the feet point (`aside`: 0 forward, a quarter turn a sidestep, half a turn backward). A leap
is wished once.
"""

from math import pi
from typing import Any

import numpy as np

from motion.characters.character import Character
from planner.modes import reins
from planner.modes.answering import next_step
from planner.modes.reins import PACES, Reins, no_reins
from planner.modes.wander import Wander
from planner.planner import Situation, as_numbers
from planner.round.kernel import Compiled
from worlds.world import World

_PLANNING = Compiled(next_step, no_reins(1))


class Steered:
    """Characters that go where they are told, from moment to moment (sim.stage.commands.Steer). At first they stand.

    starts (C, 3): x, y, heading [m, rad]; without them, the first stands at the world's start and the others where chance finds
    room.
    """

    name = "Steered"
    planning = _PLANNING

    def __init__(self, starts: object = None) -> None:
        self.places = None if starts is None else as_numbers(starts, "starts")

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading."""
        return Wander().starts(world, characters, seed) if self.places is None else self.places

    def prepare(self, situation: Situation) -> Reins:
        """What was told stays told, whatever the world."""
        return no_reins(len(situation.characters)) if situation.before is None else situation.before

    def values(self) -> dict:
        """What it was made with."""
        return {} if self.places is None else {"starts": self.places.tolist()}

    def check_plans(self, plans: Reins, characters: int) -> None:
        """Whether plans from a file are reins. Raises ValueError."""
        angles = np.abs([plans.direction, plans.aside]).max()
        if plans.pace.shape != (characters,) or not 0 <= plans.pace.min() <= plans.pace.max() < len(PACES):
            raise ValueError("plans: a pace that there is not")
        if not angles <= 2 * pi or not 0 <= plans.last.min() <= plans.last.max() < 1e6:
            raise ValueError("plans: a direction or a step that cannot be")

    def tell(self, plans: Reins, who: np.ndarray, *wish: Any) -> None:
        """Tells the characters `who` (K,) direction, pace, aside, leap: one value each, or K. Raises InputError."""
        reins.tell(plans, who, reins.told(plans, who, *wish))

    def news(self, plans: Reins, who: np.ndarray, *wish: Any) -> np.ndarray:
        """(K,) bool: for which of the characters `who` that is something new. Raises InputError."""
        return reins.differing(plans, who, reins.told(plans, who, *wish))

    def by_chance(self, seed: int, ticks: int, characters: int) -> tuple | None:
        """What keys by chance tell everyone after so many ticks: a wish for `tell`; None: nothing. The same at every call."""
        wished = reins.by_chance(seed, ticks, characters)
        return None if wished is None else (wished.direction, [PACES[k] for k in wished.pace], wished.aside, wished.leap)
