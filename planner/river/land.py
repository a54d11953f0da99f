"""Ways over land: a grid of places with room for the body, shortest ways on it, pulled straight and rounded."""

from dataclasses import dataclass
from heapq import heappop, heappush

import numpy as np

from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit
from worlds.world import World

Place = tuple[float, float]
SPACING = 0.4
"""Edge of a cell [m]: smaller finds narrower ways and takes longer."""


@jit
def _dijkstra(free: np.ndarray, row: int, column: int) -> tuple[np.ndarray, np.ndarray]:
    """Shortest ways over free cells (rows, columns) from one cell: lengths in cells and each cell's parent (row, column)."""
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
                if free[k, m] and new < distance[k, m] - 1e-12:
                    distance[k, m] = new
                    parent[k, m, 0], parent[k, m, 1] = i, j
                    heappush(heap, (new, k, m))
    return distance, parent


@jit
def _room(world: WorldArrays, rows: int, columns: int, spacing: float) -> np.ndarray:
    """Room (rows, columns) [m] around the middle of each cell: to trees, water, the border and rocks."""
    room = np.empty((rows, columns))
    for i in range(rows):
        for j in range(columns):
            x, y = (j + 0.5) * spacing, (i + 0.5) * spacing
            room[i, j] = queries.clearance(world, x, y)
            for k in range(len(world.rocks)):
                rock = world.rocks[k]
                edge = ((x - rock[0]) ** 2 + (y - rock[1]) ** 2) ** 0.5 - rock[2]
                room[i, j] = min(room[i, j], edge)
    return room


@dataclass
class Land:
    """Where a character can walk: free (rows, columns) bool, cell centres SPACING apart."""

    free: np.ndarray
    margin: float

    @classmethod
    def of(cls, world: World, margin: float) -> "Land":
        """Cells with at least `margin` [m] around."""
        rows, columns = (max(int(world.size[k] / SPACING), 1) for k in (1, 0))
        return cls(_room(world.arrays, rows, columns, SPACING) >= margin, margin)

    def cell(self, x: float, y: float) -> tuple[int, int] | None:
        """The free cell nearest to a point, none within 1.5 m."""
        rows, columns = np.nonzero(self.free)
        if not len(rows):
            return None
        d = np.hypot((columns + 0.5) * SPACING - x, (rows + 0.5) * SPACING - y)
        k = int(d.argmin())
        return (int(rows[k]), int(columns[k])) if d[k] <= 1.5 else None

    def ways_from(self, x: float, y: float) -> "Ways | None":
        """Shortest ways from a point to everywhere (Dijkstra), none where there is no land."""
        source = self.cell(x, y)
        if source is None:
            return None
        distance, parent = _dijkstra(self.free, source[0], source[1])
        return Ways(self, (x, y), distance * SPACING, parent)


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
        return _rounded(_pulled(self.land, points))


def _clear(land: Land, a: Place, b: Place) -> bool:
    count = max(int(np.hypot(b[0] - a[0], b[1] - a[1]) / (0.25 * SPACING)), 1)
    s = np.linspace(0, 1, count + 1)[1:-1]
    columns = ((a[0] + s * (b[0] - a[0])) / SPACING).astype(int).clip(0, land.free.shape[1] - 1)
    rows = ((a[1] + s * (b[1] - a[1])) / SPACING).astype(int).clip(0, land.free.shape[0] - 1)
    near_ends = np.minimum(s, 1 - s) * np.hypot(b[0] - a[0], b[1] - a[1]) < 1.5 * SPACING
    return bool((land.free[rows, columns] | near_ends).all())


def _pulled(land: Land, points: list) -> list:
    kept, i = [points[0]], 0
    while i < len(points) - 1:
        j = len(points) - 1
        while j > i + 1 and not _clear(land, points[i], points[j]):
            j -= 1
        kept.append(points[j])
        i = j
    return kept


def _rounded(points: list) -> np.ndarray:
    """Corners cut twice (Chaikin), the ends kept."""
    line = np.array(points, np.float64)
    for _ in range(2):
        if len(line) > 2:
            a, b = line[:-1], line[1:]
            cut = np.stack([0.75 * a + 0.25 * b, 0.25 * a + 0.75 * b], axis=1).reshape(-1, 2)
            line = np.vstack([line[:1], cut[1:-1], line[-1:]])
    return line
