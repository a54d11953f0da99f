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


def no_world() -> WorldArrays:
    """A metre of flat ground with nothing on it."""
    shape = grid_shape((1.0, 1.0))
    none = bucket(np.zeros((0, 4)), shape)
    return WorldArrays(
        np.array([0.0, 0.0, 1.0, 1.0]), FLAT, np.zeros(8), np.zeros((1, 1)), np.zeros((0, 3)), np.zeros((0, 5)),
        np.zeros((0, 4)), shape[1], *none, *none, *none,
    )  # fmt: skip


def grid_shape(size: tuple[float, float]) -> tuple[int, int]:
    """Rows and columns of the grid over a world of this size."""
    return int(np.ceil(size[1] / CELL)) + 1, int(np.ceil(size[0] / CELL)) + 1


def bucket(boxes: np.ndarray, shape: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
    """Lists of the items whose box (K, 4: xmin, ymin, xmax, ymax) meets each cell: (start, index)."""
    rows, columns = shape
    cells: list[list[int]] = [[] for _ in range(rows * columns)]
    low = np.floor(boxes[:, :2] / CELL).astype(int)
    high = np.floor(boxes[:, 2:] / CELL).astype(int)
    for item, ((x0, y0), (x1, y1)) in enumerate(zip(low, high, strict=True)):
        for row in range(max(y0, 0), min(y1, rows - 1) + 1):
            for column in range(max(x0, 0), min(x1, columns - 1) + 1):
                cells[row * columns + column].append(item)
    start = np.concatenate([[0], np.cumsum([len(cell) for cell in cells])]).astype(np.int64)
    return start, np.array([item for cell in cells for item in cell], np.int64)


def boxes_of_discs(discs: np.ndarray, reach: float) -> np.ndarray:
    """Boxes (K, 4) around discs (K, 3+): x, y, radius, grown by reach."""
    grown = discs[:, 2:3] + reach
    return np.hstack([discs[:, :2] - grown, discs[:, :2] + grown])


def boxes_of_banks(banks: np.ndarray, reach: float) -> np.ndarray:
    """Boxes (S, 4) around river pieces, grown by reach."""
    grown = banks[:, 4:5] + reach
    ends = banks[:, :4].reshape(-1, 2, 2)
    return np.hstack([ends.min(axis=1) - grown, ends.max(axis=1) + grown])
