"""Ways over land: a grid of places with room for the body, shortest ways on it, pulled straight and rounded."""

from dataclasses import dataclass

import numpy as np

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from planner.river.grid import NEAR, SPACING, Grid, dijkstra, empty_grid, lay_out
from planner.stepping.strides import along
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.errors import InputError
from worlds.world import World

Place = tuple[float, float]
MARGIN = 0.08
"""Kept beyond the body's radius [m]."""
MOST_CELLS = 8_000_000
"""Of the grid: a way needs some 30 bytes for each."""


@dataclass
class Land:
    """Where a character can walk."""

    world: World
    grid: Grid
    margin: float

    @classmethod
    def of(cls, world: World, biped: Dimensions, margin: float) -> "Land":
        """Cells with at least `margin` [m] around. Raises InputError for a world too large."""
        rows, columns = (max(int(world.size[k] / SPACING), 1) for k in (1, 0))
        if rows * columns > MOST_CELLS:
            most = f"{MOST_CELLS * SPACING**2:.3g} square metres"
            raise InputError(f"{world.name}: {world.size[0]:g} x {world.size[1]:g} m; a way is found in {most} at most")
        grid = empty_grid(rows, columns)
        lay_out(biped, world.arrays, margin, grid)
        return cls(world, grid, margin)

    @property
    def free(self) -> np.ndarray:
        """(rows, columns) bool."""
        return self.grid.free

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
        distance, parent = dijkstra(self.grid, source[0], source[1])
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
