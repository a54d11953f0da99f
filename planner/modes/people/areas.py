"""Areas: polygons that people come from, wait in and go out by [m]."""

import numpy as np

from planner.stepping import random
from worlds.contents.polygons import inside

TRIES = 24
"""Places tried for one who comes; where none is free it comes later."""


def cells_inside(polygon: np.ndarray, shape: tuple[int, int], cell: float) -> np.ndarray:
    """(rows, columns) bool: cells of a grid whose middles lie in a polygon; at least the one in its middle."""
    row, column = np.indices(shape)
    middles = (np.stack([column.ravel(), row.ravel()], axis=1) + 0.5) * cell
    found = inside(polygon, middles).reshape(shape)
    x, y = polygon.mean(axis=0)
    found[min(int(y / cell), shape[0] - 1), min(int(x / cell), shape[1] - 1)] = True
    return found


def places_in(polygon: np.ndarray, seed: int, who: tuple[int, int], purpose: int, margin: float) -> np.ndarray:
    """(K, 2) up to TRIES places in a polygon by chance, no nearer to its border than `margin` [m] where it is wide enough.

    who: two numbers of whom they are for, purpose: the first of two of chance's purposes.
    """
    low, high = polygon.min(axis=0), polygon.max(axis=0)
    chance = np.array(
        [[random.uniform(seed, who[0], TRIES * who[1] + k, purpose + axis) for axis in (0, 1)] for k in range(TRIES)]
    )
    slim = np.minimum(margin, 0.45 * (high - low))
    places = low + slim + chance * (high - low - 2 * slim)
    return places[inside(polygon, places)]
