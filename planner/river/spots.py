"""Where a foot may go when crossing water: spots on rocks and along the banks, and the steps between them."""

from dataclasses import dataclass

import numpy as np

from motion.characters.character import Character
from planner.stepping.random import BANKS, uniform
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.errors import InputError
from worlds.world import World

OFF_ROCKS = 0.1
"""Between a sole on a bank and the side of a rock [m], so that the toe does not strike it when it lifts."""
RING = 8
"""Spots around a rock's middle, where there are few rocks."""
FEW = 120
"""With more rocks than this only their middles are spots: routes need no more, and the search grows with the square."""
MOST = 3500
"""Spots that a search takes: its memory grows with their square."""
LEVEL = 1e-3
"""A rock reaches into a sole where its top is so much higher [m]."""
MOST_BARE = 2500
"""Places on the banks of long rivers from which leaps over open water are looked for: more are thinned out by chance."""
BANK_SPACING = 0.3
"""Between spots along a bank [m]."""


@dataclass
class Spots:
    """K places for the middle of a sole, wholly on one rock or on land."""

    place: np.ndarray  # (K, 3) [m]
    rock: np.ndarray  # (K,) -1 on a bank
    banks: np.ndarray  # (B, 3) those along the water's edge, whether a step leads on from there or not

    @classmethod
    def of(cls, world: World, character: Character) -> "Spots":
        """Spots of all rocks, and of the banks that are within a leap of a rock or of the other bank. Raises InputError."""
        foot, leap = character.biped.foot, float(character.biped.reach.max_leap)
        sole = (0.5 * float(foot.length), 0.5 * float(np.hypot(foot.length, foot.width)))
        rocks = [spot for i, rock in enumerate(world.arrays.rocks) for spot in _on_rock(world, i, rock, sole)]
        banks = _on_banks(world, sole)
        rows = np.array(rocks, np.float64).reshape(-1, 4)
        some = _thinned(banks)
        leads = _near_any(banks, rows, leap)
        leads[some] |= _over_water(world, banks[some], leap)
        edge = banks[leads]
        if len(rows) + len(edge) > MOST:
            raise InputError(
                f"{world.name}: {len(rows)} places on rocks and {len(edge)} on banks; a way is found among {MOST} at most"
            )
        place = np.vstack([rows[:, :3], edge])
        return cls(place, np.concatenate([rows[:, 3], np.full(len(edge), -1)]).astype(int), banks)


def _thinned(banks: np.ndarray) -> np.ndarray:
    """Numbers of at most about MOST_BARE of these places (B, 3), evenly by chance, the same ones each time."""
    if len(banks) <= MOST_BARE:
        return np.arange(len(banks))
    share = MOST_BARE / len(banks)
    return np.flatnonzero(np.array([uniform(0, 0, k, BANKS) < share for k in range(len(banks))], bool))


def _near_any(banks: np.ndarray, rocks: np.ndarray, reach: float) -> np.ndarray:
    """(B,) bool: from which bank spots a step leads onto a rock."""
    near = np.zeros(len(banks), bool)
    for rock in rocks:
        near |= np.hypot(banks[:, 0] - rock[0], banks[:, 1] - rock[1]) <= reach
    return near


def _over_water(world: World, banks: np.ndarray, reach: float) -> np.ndarray:
    """(B,) bool: from which bank spots a leap leads over water to another one."""
    leads = np.zeros(len(banks), bool)
    for i, bank in enumerate(banks):
        d = np.hypot(banks[:, 0] - bank[0], banks[:, 1] - bank[1])
        middles = np.ascontiguousarray(0.5 * (banks[(d <= reach) & (d > 0.5), :2] + bank[:2]))
        leads[i] = (_surveyed(world, middles)[:, 1] < 0).any()
    return leads


def _surveyed(world: World, xy: np.ndarray) -> np.ndarray:
    """(N, 4) height of the ground, distance to water, to trees, and to walls, at xy (N, 2)."""
    found = np.empty((len(xy), 4))
    queries.survey(world.arrays, xy, found)
    return found


def _on_rock(world: World, i: int, rock: np.ndarray, sole: tuple[float, float]) -> list[tuple]:
    """Spots on a rock; sole: half its length, and half its diagonal [m]."""
    x, y, radius, top = rock
    room = radius - sole[1] - 0.01
    if radius < sole[0] + 0.01 or queries.water_clearance(world.arrays, x, y) > 0.3:
        return []
    spots = [(x, y, top, i)]
    if room > 0.05 and len(world.rocks) <= FEW:
        angles = np.arange(RING) * 2 * np.pi / RING
        spots += [(x + room * np.cos(a), y + room * np.sin(a), top, i) for a in angles]
    return [spot for spot in spots if _alone(world.arrays.rocks, i, spot, sole[0]) and _free(world.arrays, spot, sole[1])]


def _alone(rocks: np.ndarray, i: int, spot: tuple, sole: float) -> bool:
    """Whether no higher rock reaches into the sole, and none of the same height is the one that is counted there."""
    off = np.hypot(rocks[:, 0] - spot[0], rocks[:, 1] - spot[1]) - rocks[:, 2]
    higher = rocks[:, 3] > rocks[i, 3] + LEVEL
    twin = (rocks[:i] == rocks[i]).all(axis=1).any()
    return not twin and bool((off[higher] > sole).all())


def _free(world: WorldArrays, spot: tuple, sole: float) -> bool:
    """Whether a sole of that half diagonal keeps off trees, walls and the border, however it is turned."""
    x, y = spot[:2]
    solid = min(queries.tree_clearance(world, x, y), queries.wall_clearance(world, x, y))
    return bool(min(solid, queries.border_clearance(world, x, y)) > sole)


def _on_banks(world: World, sole: tuple[float, float]) -> np.ndarray:
    """(B, 3) places along the water's edge."""
    near, room = sole[0] + 0.06, max(sole[1], 0.3)
    if not len(world.arrays.banks):
        return np.zeros((0, 3))
    x, y = (np.arange(0.5 * BANK_SPACING, extent, BANK_SPACING) for extent in world.size)
    found = [_along_column(world, at, y, near, room) for at in x]
    places = np.vstack(found) if found else np.zeros((0, 3))
    rocks = world.arrays.rocks
    for rock in rocks:
        off = np.hypot(places[:, 0] - rock[0], places[:, 1] - rock[1])
        places = places[off > rock[2] + sole[0] + OFF_ROCKS]
    return places


def _along_column(world: World, x: float, y: np.ndarray, near: float, room: float) -> np.ndarray:
    """The bank's places (K, 3) of one x."""
    xy = np.column_stack([np.full(len(y), x), y])
    height, water, tree, wall = _surveyed(world, xy).T
    border = np.minimum(np.minimum(x, world.size[0] - x), np.minimum(y, world.size[1] - y))
    keep = (near <= water) & (water <= near + 1.5 * BANK_SPACING) & (np.minimum(tree, wall) > room) & (border > room)
    return np.column_stack([xy[keep], height[keep]])
