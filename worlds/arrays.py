"""A world as the arrays that kernels read, with a uniform grid over it.

A grid cell lists whatever lies within REACH of it, so that a question at a point looks into one cell only.
"""

from typing import NamedTuple

import numpy as np

CELL = 2.0
"""Edge of a grid cell [m]: smaller looks at fewer things per question and takes more memory."""
REACH = 3.0
"""Clearances are exact up to this distance [m] and capped at it."""

FLAT, HILLS, STAIRS, SPIRAL_STAIRS, HEIGHTMAP = range(5)


class WorldArrays(NamedTuple):
    """World frame, metres. Lists of the grid: item indices of cell k are index[start[k]:start[k + 1]]."""

    bounds: np.ndarray  # (4,) xmin, ymin, xmax, ymax
    terrain_kind: int  # FLAT ...
    terrain: np.ndarray  # (8,) parameters, see worlds.ground
    heights: np.ndarray  # (ny, nx) of a heightmap, row 0 at y = 0; (1, 1) otherwise
    trees: np.ndarray  # (T, 3) x, y, radius
    banks: np.ndarray  # (S, 5) river pieces: x0, y0, x1, y1, half width
    rocks: np.ndarray  # (R, 4) x, y, radius, height of the top in the world
    columns: int
    tree_start: np.ndarray
    tree_index: np.ndarray
    bank_start: np.ndarray
    bank_index: np.ndarray
    rock_start: np.ndarray
    rock_index: np.ndarray
    walls: np.ndarray  # (W, 5) pieces of walls: x0, y0, x1, y1, half thickness
    wall_start: np.ndarray
    wall_index: np.ndarray


def no_world() -> WorldArrays:
    """A metre of flat ground with nothing on it."""
    shape = grid_shape((1.0, 1.0))
    none = bucket(np.zeros((0, 4)), shape)
    return WorldArrays(
        np.array([0.0, 0.0, 1.0, 1.0]), FLAT, np.zeros(8), np.zeros((1, 1)), np.zeros((0, 3)), np.zeros((0, 5)),
        np.zeros((0, 4)), shape[1], *none, *none, *none, np.zeros((0, 5)), *none,
    )  # fmt: skip


def grid_shape(size: tuple[float, float]) -> tuple[int, int]:
    """Rows and columns of the grid over a world of this size."""
    return int(np.ceil(size[1] / CELL)) + 1, int(np.ceil(size[0] / CELL)) + 1


def _span(boxes: np.ndarray, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """First cells (K, 2: column, row) of boxes, and how many there are along each axis: none for boxes outside."""
    most = np.array([shape[1], shape[0]])
    low = np.floor(boxes[:, :2] / CELL).clip(0, most).astype(np.int64)
    high = np.floor(boxes[:, 2:] / CELL).clip(-1, most - 1).astype(np.int64)
    return low, np.maximum(high - low + 1, 0)


def cells_of(boxes: np.ndarray, shape: tuple[int, int]) -> np.ndarray:
    """How many cells each box (K, 4) meets."""
    return _span(boxes, shape)[1].prod(axis=1)


def bucket(boxes: np.ndarray, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Lists of the items whose box (K, 4: xmin, ymin, xmax, ymax) meets each cell: (start, index)."""
    low, extent = _span(boxes, shape)
    count = extent.prod(axis=1)
    item = np.repeat(np.arange(len(boxes)), count)
    k = np.arange(len(item)) - np.repeat(np.cumsum(count) - count, count)
    cell = (low[item, 1] + k // extent[item, 0]) * shape[1] + low[item, 0] + k % extent[item, 0]
    start = np.concatenate([[0], np.cumsum(np.bincount(cell, minlength=shape[0] * shape[1]))]).astype(np.int64)
    return start, item[np.argsort(cell, kind="stable")].astype(np.int64)


def boxes_of_discs(discs: np.ndarray, reach: float) -> np.ndarray:
    """Boxes (K, 4) around discs (K, 3+): x, y, radius, grown by reach."""
    grown = discs[:, 2:3] + reach
    return np.hstack([discs[:, :2] - grown, discs[:, :2] + grown])


def boxes_of_pieces(pieces: np.ndarray, reach: float) -> np.ndarray:
    """Boxes (S, 4) around pieces (S, 5) of rivers or walls: x0, y0, x1, y1, half width, grown by reach."""
    grown = pieces[:, 4:5] + reach
    ends = pieces[:, :4].reshape(-1, 2, 2)
    return np.hstack([ends.min(axis=1) - grown, ends.max(axis=1) + grown])
