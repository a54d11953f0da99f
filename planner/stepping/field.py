"""Ways around walls, water, trees and rocks too high to step on: how far it is to a goal from everywhere, one field for all.

The distance u solves the eikonal equation |grad u| F = 1 with u = 0 at the goal, by Godunov's upwind scheme, as in fast
marching (Sethian 1996), swept in four orders until nothing changes (Zhao 2005). F, the share of the speed, falls beside walls,
so that ways keep off them. One goes down the field: along - grad u.
"""

from copy import deepcopy
from math import atan2, inf, sqrt

import numpy as np

from motion.characters.dimensions import Dimensions
from planner.stepping.footing import beside_rocks, is_footing, is_steep
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit, jit_borrowing
from worlds.world import World

FINEST = 0.2
"""Edge of a cell [m], where the world is not too large."""
MOST_CELLS = 1_000_000
"""Of a field; in larger worlds cells are larger."""
MOST_IN_ALL = 40_000_000
"""Cells of all fields of a run: to goals beyond, ways are straight."""
CLUMSY = 0.2
"""F where no sole fits, as on a rock that lies half in a slope: one may step over it."""
TOGETHER = 2.0
"""Goals that lie in the same square of this edge [m] share a field."""
SLIM = 0.1
"""Cells are open whose middle has so much [m] less around it than the body needs: their corners may have more."""
SLOW, CALM = 0.5, 0.12
"""Least F, beside a wall, and how far from there [m] it is 1."""
BARS = "water, walls, trees, slopes or rocks bar it"
"""What may be in the way where none leads."""
NEAR = 1
"""So many cells around a place are looked at for the way from it: it may lie in one that is closed."""
AROUND = 1.6
"""So many cells around a goal are open, whatever lies there."""


@jit
def lay_out(biped: Dimensions, world: WorldArrays, cell: float, slowness: np.ndarray) -> None:
    """Fills slowness (rows, columns), 1 / F of each cell; inf: nobody can be there."""
    rows, columns = slowness.shape
    for i in range(rows):
        for j in range(columns):
            x, y = (j + 0.5) * cell, (i + 0.5) * cell
            room = min(queries.clearance(world, x, y) - biped.body.radius + SLIM, beside_rocks(biped, world, x, y, CALM))
            blocked = room < 0 or is_steep(biped, world, x, y)
            share = min(max(room / CALM, SLOW), 1.0) if is_footing(biped, world, x, y) else CLUMSY
            slowness[i, j] = inf if blocked else 1 / share


@jit
def spread(slowness: np.ndarray, cell: float, x: float, y: float, field: np.ndarray) -> None:
    """Fills field (rows, columns) with the distance to x, y [m], where F = 1; inf: there is no way."""
    rows, columns = field.shape
    field[:] = inf
    reach = int(AROUND) + 1
    column, row = int(x / cell), int(y / cell)
    for i in range(max(row - reach, 0), min(row + reach + 1, rows)):
        for j in range(max(column - reach, 0), min(column + reach + 1, columns)):
            far = sqrt(((j + 0.5) * cell - x) ** 2 + ((i + 0.5) * cell - y) ** 2)
            if far <= AROUND * cell:
                field[i, j] = far
    sweep(slowness, cell, field)


@jit
def sweep(slowness: np.ndarray, cell: float, field: np.ndarray) -> None:
    """Spreads what is known of a field (rows, columns) to all of it; it is inf where nothing is known yet."""
    rows, columns = field.shape
    changed = True
    while changed:
        changed = False
        for order in range(4):
            for a in range(rows):
                i = a if order < 2 else rows - 1 - a
                for b in range(columns):
                    j = b if order % 2 == 0 else columns - 1 - b
                    new = _upwind(slowness[i, j] * cell, field, i, j)
                    if new < field[i, j] * (1 - 1e-6) - 1e-4:
                        field[i, j] = new
                        changed = True


@jit_borrowing
def _upwind(step: float, field: np.ndarray, i: int, j: int) -> float:
    """u of a cell from its neighbours: (u - a)^2 + (u - b)^2 = step^2 with a, b the least of either axis."""
    rows, columns = field.shape
    a = min(field[i - 1, j] if i > 0 else inf, field[i + 1, j] if i < rows - 1 else inf)
    b = min(field[i, j - 1] if j > 0 else inf, field[i, j + 1] if j < columns - 1 else inf)
    if step == inf or min(a, b) == inf:
        return inf
    if abs(a - b) >= step:
        return min(a, b) + step
    return 0.5 * (a + b + sqrt(2 * step * step - (a - b) ** 2))


@jit_borrowing
def _slope(field: np.ndarray, i: int, j: int, down: int, right: int) -> float:
    """Upwind difference of a cell along an axis, per cell: toward the lower neighbour; 0 in a valley, or where no way is."""
    rows, columns = field.shape
    here = field[i, j]
    before = field[i - down, j - right] if i - down >= 0 and j - right >= 0 else inf
    after = field[i + down, j + right] if i + down < rows and j + right < columns else inf
    if here == inf or (before >= here and after >= here):
        return 0.0
    return here - before if before < after else after - here


@jit_borrowing
def course_down(field: np.ndarray, cell: float, x: float, y: float, otherwise: float) -> float:
    """The course [rad] down a field (rows, columns) at a place [m], the cells around it weighed by nearness."""
    rows, columns = field.shape
    u, v = x / cell - 0.5, y / cell - 0.5
    j, i = min(max(int(u), 0), columns - 1), min(max(int(v), 0), rows - 1)
    gx = gy = 0.0
    for k in range(i, min(i + 2, rows)):
        for m in range(j, min(j + 2, columns)):
            if field[k, m] < inf:
                share = max(1 - abs(v - k), 0.0) * max(1 - abs(u - m), 0.0)
                dx, dy = _slope(field, k, m, 0, 1), _slope(field, k, m, 1, 0)
                steep = sqrt(dx * dx + dy * dy)
                if steep > 0:
                    gx, gy = gx + share * dx / steep, gy + share * dy / steep
    return atan2(-gy, -gx) if gx != 0 or gy != 0 else otherwise


def for_all(bipeds: list[Dimensions]) -> Dimensions:
    """Whose ways are ways for all of them: as wide as the widest, and steps as high as the one that steps lowest."""
    widest = deepcopy(max(bipeds, key=lambda one: float(one.body.radius)))
    widest.reach.max_rise = min(float(one.reach.max_rise) for one in bipeds)
    return widest


def ways_from(fields: np.ndarray, cell: float, which: np.ndarray, places: np.ndarray) -> np.ndarray:
    """How long the ways from places (N, 2) are, in metres at free speed, inf where none leads: (..., N) as `which` has it.

    which: of fields (G, rows, columns) of such cells [m], one for each place (N,), or several for all (A, 1).
    """
    rows, columns = fields.shape[1:]
    i, j = (np.clip((places[:, k] / cell).astype(int), 0, (rows, columns)[1 - k] - 1) for k in (1, 0))
    around = range(-NEAR, NEAR + 1)
    near = ((np.clip(i + a, 0, rows - 1), np.clip(j + b, 0, columns - 1)) for a in around for b in around)
    return np.min([fields[which, a, b] for a, b in near], axis=0)


def fields_to(world: World, biped: Dimensions, goals: np.ndarray) -> tuple[np.ndarray, float, np.ndarray]:
    """Fields (G, rows, columns) of the goals (N, 2) [m], the edge of their cells [m], and which each goal has (N,), -1: none.

    None where nothing is in anyone's way. Deterministic: goals that lie together share the field of the first of them.
    """
    which, none = np.full(len(goals), -1, np.int64), np.zeros((0, 1, 1), np.float32)
    if world.terrain == "flat" and not any(map(len, (world.walls, world.trees, world.rivers, world.rocks))):
        return none, FINEST, which
    area = world.size[0] * world.size[1]
    cell = max(FINEST, float(np.sqrt(area / MOST_CELLS)))
    rows, columns = (max(int(np.ceil(world.size[k] / cell)), 1) for k in (1, 0))
    squares = np.floor(goals / TOGETHER).astype(np.int64)
    _, first, inverse = np.unique(squares, axis=0, return_index=True, return_inverse=True)
    kept = min(len(first), MOST_IN_ALL // (rows * columns))
    slowness, fields = np.empty((rows, columns)), np.empty((kept, rows, columns), np.float32)
    lay_out(biped, world.arrays, cell, slowness)
    for k in range(kept):
        spread(slowness, cell, float(goals[first[k], 0]), float(goals[first[k], 1]), fields[k])
    inverse = inverse.reshape(-1)
    which[inverse < kept] = inverse[inverse < kept]
    return fields, cell, which
