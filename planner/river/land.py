"""Ways over land: a grid of places with room for the body, shortest ways on it, pulled straight and rounded."""

from dataclasses import dataclass
from heapq import heappop, heappush
from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from planner.stepping.footing import is_steep
from planner.stepping.strides import along
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit
from worlds.errors import InputError
from worlds.world import World

Place = tuple[float, float]
NEAR = 1.5
"""A point belongs to the free cell nearest to it, within this distance [m]."""
MARGIN = 0.08
"""Kept beyond the body's radius [m]."""
SPACING = 0.4
"""Edge of a cell [m]: smaller finds narrower ways and takes longer."""


MOST_CELLS = 8_000_000
"""Of the grid: a way needs some 30 bytes for each."""


@jit
def _can_rise(world: WorldArrays, land: "Ground", a: tuple[int, int], z: tuple[int, int]) -> bool:
    """Whether the ground rises or falls from cell a to cell z by no more than a step does, or than two short steps do."""
    low, high = land.height[a[0], a[1]], land.height[z[0], z[1]]
    if -land.max_drop <= high - low <= land.max_rise:
        return True
    x, y = 0.5 * (a[1] + z[1] + 1) * SPACING, 0.5 * (a[0] + z[0] + 1) * SPACING
    between = queries.terrain_height(world, x, y)
    first, second = between - low, high - between
    return -land.max_drop <= min(first, second) and max(first, second) <= land.max_rise


@jit
def _dijkstra(world: WorldArrays, land: "Ground", row: int, column: int) -> tuple[np.ndarray, np.ndarray]:
    """Shortest ways over free cells (rows, columns) from one cell: lengths in cells and each cell's parent (row, column)."""
    free = land.free
    rows, columns = free.shape
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
                if free[k, m] and new < distance[k, m] - 1e-12 and _can_rise(world, land, (i, j), (k, m)):
                    distance[k, m] = new
                    parent[k, m, 0], parent[k, m, 1] = i, j
                    heappush(heap, (new, k, m))
    return distance, parent


@jit
def _lay_out(biped: Dimensions, world: WorldArrays, margin: float, free: np.ndarray, height: np.ndarray) -> None:
    """Fills free (rows, columns), whether there is `margin` [m] around a cell's middle, and the height of the ground."""
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


class Ground(NamedTuple):
    """What ways are found on."""

    free: np.ndarray  # (rows, columns) bool, cell centres SPACING apart
    height: np.ndarray  # (rows, columns) [m]
    max_rise: float  # from cell to cell [m]
    max_drop: float


@dataclass
class Land:
    """Where a character can walk."""

    world: World
    ground: Ground
    margin: float

    @classmethod
    def of(cls, world: World, biped: Dimensions, margin: float) -> "Land":
        """Cells with at least `margin` [m] around. Raises InputError for a world too large."""
        rows, columns = (max(int(world.size[k] / SPACING), 1) for k in (1, 0))
        if rows * columns > MOST_CELLS:
            most = f"{MOST_CELLS * SPACING**2:.3g} square metres"
            raise InputError(f"{world.name}: {world.size[0]:g} x {world.size[1]:g} m; a way is found in {most} at most")
        free, height = np.empty((rows, columns), np.bool_), np.empty((rows, columns))
        _lay_out(biped, world.arrays, margin, free, height)
        return cls(world, Ground(free, height, float(biped.reach.max_rise), float(biped.reach.max_drop)), margin)

    @property
    def free(self) -> np.ndarray:
        """(rows, columns) bool."""
        return self.ground.free

    def cell(self, x: float, y: float) -> tuple[int, int] | None:
        """The free cell nearest to a point, none within NEAR."""
        reach = int(NEAR / SPACING) + 1
        top, left = max(int(y / SPACING) - reach, 0), max(int(x / SPACING) - reach, 0)
        rows, columns = np.nonzero(self.free[top : top + 2 * reach + 2, left : left + 2 * reach + 2])
        if not len(rows):
            return None
        d = np.hypot((columns + left + 0.5) * SPACING - x, (rows + top + 0.5) * SPACING - y)
        k = int(d.argmin())
        return (int(rows[k]) + top, int(columns[k]) + left) if d[k] <= NEAR else None

    def ways_from(self, x: float, y: float) -> "Ways | None":
        """Shortest ways from a point to everywhere (Dijkstra), none where there is no land."""
        source = self.cell(x, y)
        if source is None:
            return None
        distance, parent = _dijkstra(self.world.arrays, self.ground, source[0], source[1])
        return Ways(self, (x, y), distance * SPACING, parent)


def land_for(world: World, character: Character) -> Land:
    """Where a character can walk. Raises InputError for a world too large."""
    return Land.of(world, character.biped, float(character.biped.body.radius) + MARGIN)


@dataclass
class Ways:
    """Shortest ways from one point."""

    land: Land
    source: tuple[float, float]
    distance: np.ndarray
    parent: np.ndarray

    def lengths(self, cells: list) -> np.ndarray:
        """Metres to each of these cells of the land, infinite where no way leads or there is none."""
        return np.array([self.distance[cell] if cell else np.inf for cell in cells])

    def polyline(self, world: World, x: float, y: float) -> np.ndarray:
        """The way to a point, (P, 2): pulled straight where the line is clear, then rounded."""
        cell = self.land.cell(x, y)
        cells = []
        while cell is not None and cell[0] >= 0:
            cells.append(((cell[1] + 0.5) * SPACING, (cell[0] + 0.5) * SPACING))
            cell = (int(self.parent[cell][0]), int(self.parent[cell][1]))
        points = [self.source, *reversed(cells[:-1] if len(cells) > 1 else []), (x, y)]
        pulled = np.array(_pulled(self.land, points, world.arrays), np.float64)
        rounded = _rounded(pulled)
        return rounded if _is_clear(self.land, rounded, world.arrays) else pulled


def _is_clear(land: Land, line: np.ndarray, world: WorldArrays) -> bool:
    """Whether a polyline (P, 2) keeps the margin to trees and walls, but for its ends: they are where they are."""
    whole = np.hypot(*np.diff(line, axis=0).T).sum()
    at = np.arange(0.0, whole, 0.25 * SPACING)
    xy, _ = along(line, at)
    found = np.empty((len(xy), 4))
    queries.survey(world, np.ascontiguousarray(xy), found)
    near_ends = np.minimum(at, whole - at) < 1.5 * SPACING
    return bool((near_ends | (found[:, 2:].min(axis=1) >= land.margin)).all())


def _clear(land: Land, a: Place, b: Place, world: WorldArrays) -> bool:
    count = max(int(np.hypot(b[0] - a[0], b[1] - a[1]) / (0.25 * SPACING)), 1)
    s = np.linspace(0, 1, count + 1)[1:-1]
    columns = ((a[0] + s * (b[0] - a[0])) / SPACING).astype(int).clip(0, land.free.shape[1] - 1)
    rows = ((a[1] + s * (b[1] - a[1])) / SPACING).astype(int).clip(0, land.free.shape[0] - 1)
    near_ends = np.minimum(s, 1 - s) * np.hypot(b[0] - a[0], b[1] - a[1]) < 1.5 * SPACING
    free = bool((land.free[rows, columns] | near_ends).all())
    return free and _is_clear(land, np.array([a, b]), world)


def _pulled(land: Land, points: list, world: WorldArrays) -> list:
    kept, i = [points[0]], 0
    while i < len(points) - 1:
        j = len(points) - 1
        while j > i + 1 and not _clear(land, points[i], points[j], world):
            j -= 1
        kept.append(points[j])
        i = j
    return kept


def _rounded(line: np.ndarray) -> np.ndarray:
    """Corners cut twice (Chaikin), the ends kept."""
    for _ in range(2):
        if len(line) > 2:
            a, b = line[:-1], line[1:]
            cut = np.stack([0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b], axis=1).reshape(-1, 2)
            line = np.vstack([line[:1], cut[1:-1], line[-1:]])
    return line
