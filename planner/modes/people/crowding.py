"""Ways that weigh crowding: fields to areas, in which it takes longer to walk where many are.

One walks the slower the more are around: by a share f(d) = 1 - exp(-1.913 (1 / d - 1 / 5.4)) of the free speed at d people per
square metre (Weidmann 1993). The field of an area solves the eikonal equation |grad u| F f(d) = 1 anew every few seconds
(planner.stepping.field; the dynamic potential of Hughes 2002, and the quickest path of Kretz 2009), so u is the time, in metres
at free speed, that the way takes as things are: people walk around a jam, and out where that is soonest.
"""

from typing import NamedTuple

import numpy as np

from motion.characters.dimensions import Dimensions
from planner.modes.people.areas import cells_inside
from planner.stepping.field import FINEST, MOST_CELLS, MOST_IN_ALL, lay_out, sweep
from worlds.errors import InputError
from worlds.world import World

SMOOTH = 0.8
"""How far one is felt by those who measure density: standard deviation of a Gaussian [m]."""
SLOWEST = 0.15
"""Least share of the speed that a crowd leaves: a jam, too, moves on."""


class Grid(NamedTuple):
    """Cells of a world, and what it takes to cross each of them when nobody is there."""

    cell: float  # edge [m]
    slowness: np.ndarray  # (rows, columns) 1 / F; inf: nobody can be there
    area: np.ndarray  # (A, rows, columns) bool: cells of the areas


def grid_of(world: World, biped: Dimensions, polygons: list[np.ndarray]) -> Grid:
    """The grid of a world for areas (each (P, 2) [m]). Raises InputError where it is too large for so many."""
    cell = max(FINEST, float(np.sqrt(world.size[0] * world.size[1] / MOST_CELLS)))
    rows, columns = (max(int(np.ceil(world.size[k] / cell)), 1) for k in (1, 0))
    if rows * columns * len(polygons) > MOST_IN_ALL:
        raise InputError(
            f"{world.name}: {len(polygons)} areas in a world so large: their ways take too much memory; give fewer"
        )
    slowness = np.empty((rows, columns))
    lay_out(biped, world.arrays, cell, slowness)
    return Grid(cell, slowness, np.array([cells_inside(one, (rows, columns), cell) for one in polygons]))


def density(grid: Grid, places: np.ndarray) -> np.ndarray:
    """(rows, columns) people per square metre around each cell, of those at places (N, 2) [m]."""
    rows, columns = grid.slowness.shape
    count = np.zeros((rows, columns))
    i, j = (np.clip((places[:, k] / grid.cell).astype(int), 0, (rows, columns)[1 - k] - 1) for k in (1, 0))
    np.add.at(count, (i, j), 1.0)
    reach = int(np.ceil(3 * SMOOTH / grid.cell))
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) * grid.cell / SMOOTH) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        count = _blurred(count, kernel, axis)
    return count / grid.cell**2


def _blurred(values: np.ndarray, kernel: np.ndarray, axis: int) -> np.ndarray:
    reach = len(kernel) // 2
    padded = np.pad(values, [(reach, reach) if axis == k else (0, 0) for k in (0, 1)])
    found = np.zeros_like(values)
    for k, share in enumerate(kernel):
        found += share * (padded[k : k + len(values)] if axis == 0 else padded[:, k : k + values.shape[1]])
    return found


def share_of_speed(density: np.ndarray) -> np.ndarray:
    """Share of the free speed at so many people per square metre (Weidmann 1993), at least SLOWEST."""
    share = 1 - np.exp(-1.913 * (1 / np.maximum(density, 0.05) - 1 / 5.4))
    return np.maximum(share, SLOWEST)


def weigh(grid: Grid, places: np.ndarray, fields: np.ndarray) -> None:
    """Fills fields (A, rows, columns) with the ways to all areas, where people are at places (N, 2) [m]."""
    slowness = grid.slowness / share_of_speed(density(grid, places)) if len(places) else grid.slowness
    for k, area in enumerate(grid.area):
        fields[k] = np.where(area, 0, np.inf)
        sweep(slowness, grid.cell, fields[k])
