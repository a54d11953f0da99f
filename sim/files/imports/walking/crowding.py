"""From ways to a crowd that walks: a world around them, and a motion along each."""

from collections.abc import Sequence

import numpy as np

from motion.characters.character import Character
from sim.files.imports.texts import SAID
from sim.files.imports.trajectories.ways import Way
from sim.files.imports.walking.fitting import fit
from sim.files.imports.walking.pace import pace_of
from sim.files.imports.walking.procession import Procession
from sim.stage.cast import TICK_RATE
from worlds.compiled.telling import tell
from worlds.errors import InputError
from worlds.world import Wall, World

MARGIN = 6.0
"""Ground around the ways [m]: who comes into sight walking has come from somewhere."""
THIN = 0.02
"""Walls that show a border [m]: people's feet come as near to it as they did."""
LEAST_RATE, MOST_RATE = 50, 240
"""Ticks per second, at least and at most, where the file's moments decide."""
TOLD = 100
"""After so many people a word is said of how far the fitting is."""


def procession(
    name: str, ways: Sequence[Way], character: Character, borders: Sequence[np.ndarray] = ()
) -> Procession:  # fmt: skip
    """Everybody as a character along its way. Raises InputError naming whoever cannot walk it.

    borders: of where people could walk, each (P, 2) [m]; they are shown as walls.
    """
    world, moved = _placed(name, ways, borders)
    pace, fitted, faults = pace_of(character), [], []
    for k, way in enumerate(moved):
        try:
            fitted.append(fit(way, character, pace, world.arrays))
        except InputError as error:
            faults.append(str(error))
        if (k + 1) % TOLD == 0:
            tell(f"fitted {k + 1} of {len(moved)} ways")
    if faults:
        more = [f"and {len(faults) - SAID} more like these"] if len(faults) > SAID else []
        raise InputError("\n".join(f"{name}: {fault}" for fault in [*faults[:SAID], *more]))
    return Procession(world, fitted, ticks_of(ways))


def ticks_of(ways: Sequence[Way]) -> int:
    """Ticks per second: a multiple of the file's moments per second where there is one, so that each of them is shown."""
    apart = np.concatenate([np.diff(way.time) for way in ways])
    rate = 1.0 / float(np.median(apart)) if len(apart) else TICK_RATE
    if abs(rate - round(rate)) > 1e-3 * rate or TICK_RATE % round(rate) == 0 or rate > MOST_RATE:
        return TICK_RATE
    return round(rate) * -(-LEAST_RATE // round(rate))


def _placed(name: str, ways: Sequence[Way], borders: Sequence[np.ndarray]) -> tuple[World, list[Way]]:
    """A flat world with the ways in it: its corner is MARGIN before the least x and y."""
    places = np.vstack([*(way.place for way in ways), *borders])
    corner = np.floor(places.min(axis=0) - MARGIN)
    size = np.ceil(places.max(axis=0) - corner + MARGIN)
    moved = [Way(way.name, way.time, way.place - corner, way.landed) for way in ways]
    walls = tuple(Wall(border - corner, THIN) for border in borders)
    return World(name, (float(size[0]), float(size[1])), walls=walls), moved
