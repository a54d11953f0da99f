"""The planner of wanderers: everyone keeps a heading and changes it by chance where something is in the way."""

import numpy as np

from motion.biped import Biped
from planner import plan, random
from planner.wander import MARGIN
from worlds.queries import clearance
from worlds.world import World

TRIES = 400


class Wander:
    """Gives every character the wandering mode. Raises nothing: a world with too little room lets fewer start apart."""

    def starts(self, world: World, characters: list[Biped], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading: the first at the world's start, the others where chance finds room."""
        places = [(*world.start, world.start_heading)]
        for c in range(1, len(characters)):
            places.append(_free_place(world, characters[c], seed, c) or places[0])
        return np.array(places[: len(characters)], np.float64)

    def prepare(self, world: World, characters: list[Biped], standing: np.ndarray, begin: np.ndarray, seed: int):
        """Plans for all; nothing to look up beforehand."""
        return plan.plans_of(plan.WANDER, len(characters), 1)


def _free_place(world: World, character: Biped, seed: int, c: int) -> tuple[float, float, float] | None:
    need = float(character.record.body_radius) + MARGIN
    for k in range(TRIES):
        x = world.size[0] * random.uniform(seed, c, 3 * k, random.PLACE)
        y = world.size[1] * random.uniform(seed, c, 3 * k + 1, random.PLACE)
        if clearance(world.arrays, x, y) > need:
            return x, y, 2 * np.pi * random.uniform(seed, c, 3 * k + 2, random.PLACE)
    return None
