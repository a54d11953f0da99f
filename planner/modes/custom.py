"""A planner of one's own, from one function: `next_step(round, me) -> Wish`."""

from collections.abc import Callable
from typing import Any

import numpy as np

from motion.characters.character import Character
from planner.modes.wander import Wander
from planner.planner import Situation, as_numbers
from planner.round.kernel import Compiled, Interpreted, Planning
from planner.round.round import Me, Round, Wish
from worlds.world import World


class Custom:
    """Everyone steps as a function says: in plain Python, or with `compiled` as a kernel, which takes a microsecond.

    The function must not depend on anything but its arguments and constants: it remembers nothing (a planner with a memory is
    a class, whose `prepare` returns it). A compiled one calls nothing but kernels and mathematics. starts (C, 3): x, y, heading
    [m, rad]; without them everyone starts as wanderers do. Saved states know no function: `restore(path, planner)`.
    """

    name = "Custom"

    def __init__(self, next_step: Callable[[Round, Me], Wish], starts: object = None, compiled: bool = False) -> None:
        self.planning: Planning = Compiled(next_step) if compiled else Interpreted(next_step)
        self.places = None if starts is None else as_numbers(starts, "starts")

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading."""
        return Wander().starts(world, characters, seed) if self.places is None else self.places

    def prepare(self, situation: Situation) -> Any:
        """Nothing is prepared."""

    def values(self) -> dict:
        """A function is no plain value."""
        return {}
