"""The planner of walkers: everyone goes to its own places, one after the other, around whatever stands in the way."""

import numpy as np

from motion.characters.biped import Biped
from planner import plan
from worlds.world import World


class WalkTo:
    """Characters that walk to places, and stay at the last or begin `again`.

    starts (C, 3): x, y, heading [m, rad]. stops (C, P, 2): the places in turn [m]. near [m]: how close is close enough on the
    way; whoever was pushed past a place, with a free way to the next one, has reached it too. The last place is reached more
    closely, unless others stand on it. Ways are straight but for what lies near: a maze needs stops along its way.
    """

    def __init__(self, starts, stops, again: bool = False, near: float = 0.5) -> None:
        self.places, self.stops = np.array(starts, np.float64), np.array(stops, np.float64)
        self.again, self.near = again, near
        count, places = self.stops.shape[0], self.stops.shape[1] if self.stops.ndim == 3 else 0
        if not places or self.stops.shape[2] != 2 or self.places.shape != (count, 3):
            raise ValueError(f"starts {self.places.shape}, stops {self.stops.shape}: (C, 3) and (C, P, 2), P > 0, are needed")

    def starts(self, world: World, characters: list[Biped], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading."""
        if len(characters) != len(self.places):
            raise ValueError(f"{len(self.places)} starts for {len(characters)} characters: one for each is needed")
        return self.places

    def prepare(self, world: World, characters: list[Biped], standing: np.ndarray, begin: np.ndarray, seed: int):
        """Plans for all; a stop that was reached stays reached."""
        plans = plan.plans_of(plan.WALK, len(characters), 1, 1)
        plans.again[:], plans.near[:] = self.again, self.near
        return plans._replace(start=self.places[:, :2].copy(), stops=self.stops)
