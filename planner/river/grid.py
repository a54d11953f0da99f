"""A grid of land: which cells have room for a body, and from which to which the ground can be walked; shortest ways over it."""

from heapq import heappop, heappush
from typing import NamedTuple

import numpy as np

from motion.characters.dimensions import Dimensions
from planner.stepping.footing import is_steep
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit, jit_borrowing

SPACING = 0.4
"""Edge of a cell [m]: smaller finds narrower ways and takes longer."""

NEAR = 1.5
"""A point belongs to the free cell nearest to it, within this distance [m]."""


class Grid(NamedTuple):
    """Cells of land, their middles SPACING apart."""

    free: np.ndarray  # (rows, columns) bool: there is room
    onward: np.ndarray  # (rows, columns) bits, one for each of the cells around: whether one can walk there (may_go)


def empty_grid(rows: int, columns: int) -> Grid:
    """Nothing is laid out yet."""
    return Grid(np.empty((rows, columns), np.bool_), np.empty((rows, columns), np.int16))


@jit_borrowing
def bit_of(down: int, right: int) -> int:
    """The bit of the cell so many rows and columns further, each -1 to 1."""
    return 1 << ((down + 1) * 3 + right + 1)


@jit_borrowing
def may_go(grid: Grid, i: int, j: int, k: int, m: int) -> bool:
    """Whether one can walk from the free cell (i, j) to the cell (k, m) beside it."""
    return grid.free[k, m] and grid.onward[i, j] & bit_of(k - i, m - j) != 0


@jit
def lay_out(biped: Dimensions, world: WorldArrays, margin: float, grid: Grid) -> None:
    """Fills the grid: there is `margin` [m] around a free cell's middle, and the ground neither rises nor falls too much."""
    free, height = grid.free, np.empty(grid.free.shape)
    rows, columns = free.shape
    for i in range(rows):
        for j in range(columns):
            x, y = (j + 0.5) * SPACING, (i + 0.5) * SPACING
            free[i, j] = queries.clearance(world, x, y) >= margin and not is_steep(biped, world, x, y)
            height[i, j] = queries.terrain_height(world, x, y)
    for rock in world.rocks:
        reach = rock[2] + margin
        for i in range(max(int((rock[1] - reach) / SPACING), 0), min(int((rock[1] + reach) / SPACING) + 1, rows)):
            for j in range(max(int((rock[0] - reach) / SPACING), 0), min(int((rock[0] + reach) / SPACING) + 1, columns)):
                x, y = (j + 0.5) * SPACING, (i + 0.5) * SPACING
                if ((x - rock[0]) ** 2 + (y - rock[1]) ** 2) ** 0.5 - rock[2] < margin:
                    free[i, j] = False
    for i in range(rows):
        for j in range(columns):
            bits = 0
            for k in range(max(i - 1, 0), min(i + 2, rows)):
                for m in range(max(j - 1, 0), min(j + 2, columns)):
                    if free[i, j] and free[k, m] and _can_rise(biped, world, height, (i, j), (k, m)):
                        bits |= bit_of(k - i, m - j)
            grid.onward[i, j] = bits


@jit
def _can_rise(biped: Dimensions, world: WorldArrays, height: np.ndarray, a: tuple[int, int], z: tuple[int, int]) -> bool:
    """Whether the ground rises or falls from cell a to cell z by no more than a step does, or than two short steps do."""
    low, high, reach = height[a[0], a[1]], height[z[0], z[1]], biped.reach
    if -reach.max_drop <= high - low <= reach.max_rise:
        return True
    x, y = 0.5 * (a[1] + z[1] + 1) * SPACING, 0.5 * (a[0] + z[0] + 1) * SPACING
    between = queries.terrain_height(world, x, y)
    first, second = between - low, high - between
    return -reach.max_drop <= min(first, second) and max(first, second) <= reach.max_rise


@jit
def dijkstra(grid: Grid, row: int, column: int) -> tuple[np.ndarray, np.ndarray]:
    """Shortest ways over free cells (rows, columns) from one cell: lengths in cells and each cell's parent (row, column)."""
    rows, columns = grid.free.shape
    distance = np.full((rows, columns), np.inf)
    parent = np.full((rows, columns, 2), -1)
    distance[row, column] = 0.0
    heap = [(0.0, row, column)]
    while heap:
        d, i, j = heappop(heap)
        if d > distance[i, j]:
            continue
        for k in range(max(i - 1, 0), min(i + 2, rows)):
            for m in range(max(j - 1, 0), min(j + 2, columns)):
                new = d + ((k - i) ** 2 + (m - j) ** 2) ** 0.5
                if new < distance[k, m] - 1e-12 and may_go(grid, i, j, k, m):
                    distance[k, m] = new
                    parent[k, m, 0], parent[k, m, 1] = i, j
                    heappush(heap, (new, k, m))
    return distance, parent
