"""The planner of wanderers: everyone keeps a heading and changes it by chance where something is in the way."""

import numpy as np

from motion.characters.biped import Biped
from planner import plan
from planner.stepping import random
from planner.wander import MARGIN
from worlds.errors import InputError
from worlds.queries import clearance
from worlds.world import World

TRIES = 400
APART = 1.4
"""Distance between bodies at the start, in the sum of their radii."""


class Wander:
    """Gives every character the wandering mode. Raises InputError where a world has no room for so many to start apart."""

    def starts(self, world: World, characters: list[Biped], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading: the first at the world's start, the others where chance finds room."""
        room = _Room(world, max(float(character.record.body_radius) for character in characters))
        places = [(*world.start, world.start_heading)]
        for c, character in enumerate(characters):
            if c > 0:
                places.append(room.free_place(character, seed, c))
            room.take(*places[c][:2], float(character.record.body_radius))
        return np.array(places, np.float64)

    def prepare(self, world: World, characters: list[Biped], standing: np.ndarray, begin: np.ndarray, seed: int):
        """Plans for all; nothing to look up beforehand."""
        return plan.plans_of(plan.WANDER, len(characters), 1, 1)


class _Room:
    """Where bodies stand already, by cell of a grid as wide as two of the largest and the room between them."""

    def __init__(self, world: World, largest: float) -> None:
        self.world, self.cell = world, 2 * APART * largest
        self.taken: dict[tuple[int, int], list[tuple[float, float, float]]] = {}

    def take(self, x: float, y: float, radius: float) -> None:
        self.taken.setdefault((int(x / self.cell), int(y / self.cell)), []).append((x, y, radius))

    def free_place(self, character: Biped, seed: int, c: int) -> tuple[float, float, float]:
        """x, y, heading: the first of chance's places that is clear of the world and of those who stand."""
        radius, size = float(character.record.body_radius), self.world.size
        for k in range(TRIES):
            x, y = (size[i] * random.uniform(seed, c, 3 * k + i, random.PLACE) for i in (0, 1))
            if clearance(self.world.arrays, x, y) > radius + MARGIN and self._is_free(x, y, radius):
                return x, y, 2 * np.pi * random.uniform(seed, c, 3 * k + 2, random.PLACE)
        raise InputError(
            f"{self.world.name}: no room for {character.name} number {c + 1} to start apart from the others; "
            "use fewer --characters or a level with more room"
        )

    def _is_free(self, x: float, y: float, radius: float) -> bool:
        i, j = int(x / self.cell), int(y / self.cell)
        near = [body for a in range(i - 1, i + 2) for b in range(j - 1, j + 2) for body in self.taken.get((a, b), [])]
        return all(np.hypot(x - u, y - v) >= APART * (radius + r) for u, v, r in near)
