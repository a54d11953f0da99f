"""What planners ask of a world at a point: kernels that look into one grid cell."""

from math import atan2, cos, floor, hypot, sin

import numpy as np

from worlds.arrays import CELL, FLAT, HEIGHTMAP, HILLS, REACH, SPIRAL_STAIRS, STAIRS, WorldArrays
from worlds.compiled.jit import jit, jit_borrowing

TAU = 6.283185307179586
SURELY = 1 + 1e-9
"""Squares that differ by more than this ratio do so however numbers are rounded: most distances need no root."""


@jit_borrowing
def terrain_height(world: WorldArrays, x: float, y: float) -> float:
    """Height of the bare ground [m]. Beyond the border the terrain goes on."""
    p = world.terrain
    if world.terrain_kind == FLAT:
        return 0.0
    if world.terrain_kind == HILLS:
        k = TAU / p[1]
        broad = sin(k * x + p[2]) * cos(0.8 * k * y + p[3])
        return p[0] * (broad + 0.35 * sin(2.1 * k * y + 1.3 * k * x + p[4]))
    if world.terrain_kind == STAIRS:
        return p[1] * min(max(floor((x - p[0]) / p[2]) + 1, 0.0), p[3])
    if world.terrain_kind == SPIRAL_STAIRS:
        return _spiral_height(p, x, y)
    if world.terrain_kind == HEIGHTMAP:
        return _map_height(world.heights, x / p[0], y / p[0])
    return 0.0


@jit_borrowing
def _spiral_height(p: np.ndarray, x: float, y: float) -> float:
    """Treads turn counter-clockwise about (p0, p1) between the radii p2 and p3, each p4 higher, p5 of them to a turn."""
    dx, dy = x - p[0], y - p[1]
    r = hypot(dx, dy)
    if r < p[2] or r > p[3]:
        return 0.0
    angle = _angle(dy, dx)
    return p[4] * min(floor(angle / TAU * p[5]), p[5] - 1)


@jit_borrowing
def _angle(dy: float, dx: float) -> float:
    from_axis = atan2(dy, dx)
    return from_axis if from_axis >= 0 else from_axis + TAU


@jit_borrowing
def _map_height(heights: np.ndarray, column: float, row: float) -> float:
    """Bilinear in a heightmap, constant beyond its edge."""
    rows, columns = heights.shape
    column = min(max(column, 0.0), columns - 1.0)
    row = min(max(row, 0.0), rows - 1.0)
    i, j = max(min(int(row), rows - 2), 0), max(min(int(column), columns - 2), 0)
    u, v = column - j, row - i
    k, m = min(i + 1, rows - 1), min(j + 1, columns - 1)
    return (1 - v) * ((1 - u) * heights[i, j] + u * heights[i, m]) + v * ((1 - u) * heights[k, j] + u * heights[k, m])


@jit_borrowing
def cell_of(world: WorldArrays, x: float, y: float) -> int:
    """Grid cell of a point; points outside belong to the nearest one."""
    rows = (len(world.tree_start) - 1) // world.columns
    row = min(max(int(floor(y / CELL)), 0), rows - 1)
    column = min(max(int(floor(x / CELL)), 0), world.columns - 1)
    return row * world.columns + column


@jit_borrowing
def border_clearance(world: WorldArrays, x: float, y: float) -> float:
    """Distance to the border [m], negative outside."""
    return min(x - world.bounds[0], y - world.bounds[1], world.bounds[2] - x, world.bounds[3] - y)


@jit_borrowing
def tree_clearance(world: WorldArrays, x: float, y: float) -> float:
    """Distance to the nearest trunk's surface [m], negative inside, at most REACH."""
    cell, nearest = cell_of(world, x, y), REACH
    for k in range(world.tree_start[cell], world.tree_start[cell + 1]):
        tree = world.trees[world.tree_index[k]]
        dx, dy, reach = x - tree[0], y - tree[1], nearest + tree[2]
        if dx * dx + dy * dy < SURELY * reach * reach or reach < 0:
            nearest = min(nearest, hypot(dx, dy) - tree[2])
    return nearest


@jit_borrowing
def _off_piece(piece: np.ndarray, x: float, y: float, most: float) -> float:
    """Distance to a piece (5,) of a river or a wall, a line and half a width around it, at most `most` [m]; inside negative."""
    dx, dy = piece[2] - piece[0], piece[3] - piece[1]
    length2 = max(dx * dx + dy * dy, 1e-12)
    s = min(max(((x - piece[0]) * dx + (y - piece[1]) * dy) / length2, 0.0), 1.0)
    px, py, reach = x - piece[0] - s * dx, y - piece[1] - s * dy, most + piece[4]
    return min(most, hypot(px, py) - piece[4]) if px * px + py * py < SURELY * reach * reach or reach < 0 else most


@jit_borrowing
def water_clearance(world: WorldArrays, x: float, y: float) -> float:
    """Distance to the nearest water's edge [m], negative in the water, at most REACH. Rocks do not count."""
    cell, nearest = cell_of(world, x, y), REACH
    for k in range(world.bank_start[cell], world.bank_start[cell + 1]):
        nearest = _off_piece(world.banks[world.bank_index[k]], x, y, nearest)
    return nearest


@jit_borrowing
def wall_clearance(world: WorldArrays, x: float, y: float) -> float:
    """Distance to the nearest wall's surface [m], negative inside, at most REACH."""
    cell, nearest = cell_of(world, x, y), REACH
    for k in range(world.wall_start[cell], world.wall_start[cell + 1]):
        nearest = _off_piece(world.walls[world.wall_index[k]], x, y, nearest)
    return nearest


@jit_borrowing
def clearance(world: WorldArrays, x: float, y: float) -> float:
    """Distance to the nearest tree, wall, water or border [m], negative inside one, at most REACH."""
    solid = min(tree_clearance(world, x, y), wall_clearance(world, x, y))
    return min(border_clearance(world, x, y), solid, water_clearance(world, x, y))


@jit_borrowing
def rock_under(world: WorldArrays, x: float, y: float, margin: float) -> int:
    """Index of the highest rock on which a point lies at least `margin` [m] from the edge, -1 for none."""
    cell, found = cell_of(world, x, y), -1
    for k in range(world.rock_start[cell], world.rock_start[cell + 1]):
        i = world.rock_index[k]
        inside = hypot(x - world.rocks[i, 0], y - world.rocks[i, 1]) <= world.rocks[i, 2] - margin
        if inside and (found < 0 or world.rocks[i, 3] > world.rocks[found, 3]):
            found = i
    return found


@jit_borrowing
def ground_height(world: WorldArrays, x: float, y: float) -> float:
    """Height of what one would step on [m]: the terrain or a rock's top."""
    rock = rock_under(world, x, y, 0.0)
    height = terrain_height(world, x, y)
    return max(height, world.rocks[rock, 3]) if rock >= 0 else height


@jit
def ground_heights(world: WorldArrays, points: np.ndarray) -> np.ndarray:
    """ground_height (N,) below points (N, 3)."""
    out = np.empty(len(points))
    for i in range(len(points)):
        out[i] = ground_height(world, points[i, 0], points[i, 1])
    return out


@jit_borrowing
def in_water(world: WorldArrays, x: float, y: float) -> bool:
    """Whether a point lies in water and on no rock."""
    return water_clearance(world, x, y) < 0 and rock_under(world, x, y, 0.0) < 0


@jit_borrowing
def survey(world: WorldArrays, xy: np.ndarray, found: np.ndarray) -> None:
    """Fills found (N, 4): height of the ground, clearance to water, to trees, and to walls [m], at xy (N, 2)."""
    for i in range(len(xy)):
        x, y = xy[i, 0], xy[i, 1]
        found[i, 0], found[i, 1] = terrain_height(world, x, y), water_clearance(world, x, y)
        found[i, 2], found[i, 3] = tree_clearance(world, x, y), wall_clearance(world, x, y)
