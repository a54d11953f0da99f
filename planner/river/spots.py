"""Where a foot may go when crossing water: spots on rocks and along the banks, and the steps between them."""

from dataclasses import dataclass

import numpy as np

from motion.characters.character import Character
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.world import World

OFF_ROCKS = 0.1
"""Between a sole on a bank and the side of a rock [m], so that the toe does not strike it when it lifts."""
RING = 8
"""Spots around a rock's middle."""
BANK_SPACING = 0.3
"""Between spots along a bank [m]."""


@dataclass
class Spots:
    """K places for the middle of a sole, wholly on one rock or on land."""

    place: np.ndarray  # (K, 3) [m]
    rock: np.ndarray  # (K,) -1 on a bank

    @classmethod
    def of(cls, world: World, character: Character) -> "Spots":
        """Spots of all rocks, and of the banks that are within a leap of a rock or of the other bank."""
        sole = 0.5 * float(character.biped.foot.length)
        rocks = [spot for i, rock in enumerate(world.arrays.rocks) for spot in _on_rock(world, i, rock, sole)]
        banks = _on_banks(world, sole, float(character.biped.reach.max_leap))
        rows = np.array(rocks + banks, np.float64).reshape(-1, 4)
        spots = cls(rows[:, :3], rows[:, 3].astype(int))
        return spots._within(float(character.biped.reach.max_leap), world)

    def _within(self, reach: float, world: World) -> "Spots":
        """Without the bank spots from which no step over water leads anywhere."""
        d = np.linalg.norm(self.place[:, None, :2] - self.place[None, :, :2], axis=2)
        bank = self.rock < 0
        keep = ~bank | (d[:, ~bank] <= reach).any(axis=1)
        for i in np.flatnonzero(bank & ~keep):
            for j in np.flatnonzero(bank & (d[i] <= reach) & (d[i] > 0.5)):
                middle = 0.5 * (self.place[i] + self.place[j])
                if queries.water_clearance(world.arrays, middle[0], middle[1]) < 0:
                    keep[i] = True
        return Spots(self.place[keep], self.rock[keep])


def _on_rock(world: World, i: int, rock: np.ndarray, sole: float) -> list[tuple]:
    x, y, radius, top = rock
    room = radius - sole - 0.01
    if room < 0 or queries.water_clearance(world.arrays, x, y) > 0.3:
        return []
    spots = [(x, y, top, i)]
    if room > 0.05:
        angles = np.arange(RING) * 2 * np.pi / RING
        spots += [(x + room * np.cos(a), y + room * np.sin(a), top, i) for a in angles]
    return [spot for spot in spots if _alone(world.arrays.rocks, i, spot, sole)]


def _alone(rocks: np.ndarray, i: int, spot: tuple, sole: float) -> bool:
    """Whether no other rock reaches under the sole or into it."""
    off = np.hypot(rocks[:, 0] - spot[0], rocks[:, 1] - spot[1]) - rocks[:, 2]
    off[i] = np.inf
    return bool(off.min() > sole)


def _on_banks(world: World, sole: float, reach: float) -> list[tuple]:
    arrays, found = world.arrays, []
    near = sole + 0.06
    for x in np.arange(0.5 * BANK_SPACING, world.size[0], BANK_SPACING):
        for y in np.arange(0.5 * BANK_SPACING, world.size[1], BANK_SPACING):
            off = queries.water_clearance(arrays, x, y)
            if near <= off <= near + 1.5 * BANK_SPACING and _dry_and_free(arrays, x, y, sole):
                found.append((x, y, queries.terrain_height(arrays, x, y), -1))
    return found


def _dry_and_free(world: WorldArrays, x: float, y: float, sole: float) -> bool:
    rocks = world.rocks
    clear = not len(rocks) or (np.hypot(rocks[:, 0] - x, rocks[:, 1] - y) > rocks[:, 2] + sole + OFF_ROCKS).all()
    return bool(clear) and queries.tree_clearance(world, x, y) > 0.3 and queries.border_clearance(world, x, y) > 0.3
