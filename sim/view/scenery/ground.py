"""The terrain in tiles: those in view are drawn, coarser afar, with skirts that close the cracks between them.

A processor that draws spends most of its time on triangles smaller than a few pixels, of which a fine grid has many.
"""

from functools import cache

import moderngl
import numpy as np

from sim.view.graphics import detail
from sim.view.graphics.mesh import Mesh
from sim.view.scenery.meshes import quads

TILE = 8
"""Cells along a side of a tile."""
STRIDES = (8, 4, 2, 1)
"""Every so manieth row and column of the grid is drawn, the coarsest first."""
COARSE_PIXELS = 12.0
"""Cells narrower than this on screen are always put together; wider ones where that shows as little as OFF says."""
OFF_PIXELS, OFF_COLOUR, OFF_NORMAL = 0.7, 0.012, 0.03
"""How far a coarser tile may be off: in height on screen, in colour, in its normals."""
DROP = 0.5
"""How far skirts hang down [m]."""


Sides = tuple[bool, ...]
"""Below, right, above, left: which of them have a skirt."""


class Ground:
    """Draws a grid of vertices (R, C, 9), position, normal and colour; rows go along +y, columns along +x."""

    def __init__(self, ctx: moderngl.Context, layout: tuple, grid: np.ndarray) -> None:
        rows, columns = grid.shape[:2]
        hanging = grid.copy()
        hanging[..., 2] -= DROP
        self._mesh = Mesh(ctx, layout, np.concatenate([grid.reshape(-1, 9), hanging.reshape(-1, 9)]), np.zeros(3))
        self._below, self._columns = rows * columns, columns
        down, across = range(0, rows - 1, TILE), range(0, columns - 1, TILE)
        corners, self._shape = [(r, c) for r in down for c in across], (len(down), len(across))
        self._tiles = [(r, c, min(r + TILE, rows - 1) - r, min(c + TILE, columns - 1) - c) for r, c in corners]
        low, high = np.empty((len(corners), 3)), np.empty((len(corners), 3))
        self._off = np.empty((len(corners), len(STRIDES), 2))
        for some in _alike(self._tiles):
            _, _, h, w = self._tiles[some[0]]
            tiles = np.stack([grid[r : r + h + 1, c : c + w + 1] for r, c, _, _ in (self._tiles[k] for k in some)])
            low[some], high[some] = tiles[..., :3].min(axis=(1, 2)), tiles[..., :3].max(axis=(1, 2))
            for level, stride in enumerate(STRIDES):
                self._off[some, level] = _off(tiles, stride)
        self._middle = 0.5 * (low + high)
        self._radius = 0.5 * np.linalg.norm(high - low, axis=1) + DROP
        self._cell = float(max(np.abs(grid[0, 1] - grid[0, 0])[0], np.abs(grid[1, 0] - grid[0, 0])[1]))
        self._shown, self._made = b"", dict[tuple[int, int, Sides], np.ndarray]()

    def cull(self, view: np.ndarray, eye: np.ndarray, height: int) -> None:
        """Chooses what is drawn into a view (4, 4) from the eye (3,), of `height` pixels."""
        seen = detail.in_view(view, self._middle, self._radius)
        away = np.maximum(np.linalg.norm(self._middle - eye, axis=1) - self._radius, 0.1)
        scale = 0.5 * height * float(np.linalg.norm(view[1, :3])) / away  # pixels of a metre
        fits = self._off[:, :, 1] <= 1.0
        fits &= self._off[:, :, 0] * scale[:, None] <= OFF_PIXELS
        fits |= scale[:, None] * self._cell * np.array(STRIDES) <= COARSE_PIXELS
        level = np.argmax(fits, axis=1)  # the coarsest that fits; the finest always does
        level[~seen] = -1
        if level.tobytes() != self._shown:
            self._shown, sides = level.tobytes(), _sides(level.reshape(self._shape)).reshape(-1, 4).tolist()
            corners = [self._corners(k, STRIDES[level[k]], tuple(sides[k])) for k in np.flatnonzero(seen).tolist()]
            self._mesh.choose(np.concatenate([np.zeros(0, "i4"), *corners]))

    def _corners(self, k: int, stride: int, sides: Sides) -> np.ndarray:
        key = k, stride, sides
        if key not in self._made:
            r, c, high, wide = self._tiles[k]
            local = _pattern(high, wide, stride, sides)
            index = (r + local[:, 0]) * self._columns + c + local[:, 1]
            self._made[key] = (index + self._below * local[:, 2]).astype("i4")
        return self._made[key]

    def draw(self, program: moderngl.Program) -> None:
        """Draws the tiles chosen last."""
        self._mesh.draw(program)

    def release(self) -> None:
        """Gives everything back."""
        self._mesh.release()


def _alike(tiles: list[tuple[int, int, int, int]]) -> list[list[int]]:
    """Numbers of the tiles of each size."""
    sizes = sorted({tile[2:] for tile in tiles})
    return [[k for k, tile in enumerate(tiles) if tile[2:] == size] for size in sizes]


def _off(tiles: np.ndarray, stride: int) -> np.ndarray:
    """(N, 2) how far tiles (N, R, C, 9) drawn with a stride are off: in height [m], in shares of what else is allowed."""
    kept = [np.unique(np.append(np.arange(0, n - 1, stride), n - 1)) for n in tiles.shape[1:3]]
    down, across = (_blend(n, some) for n, some in zip(tiles.shape[1:3], kept, strict=True))
    drawn = np.einsum("ra,nabk->nrbk", down, tiles[:, kept[0]][:, :, kept[1]])
    off = np.abs(np.einsum("cb,nrbk->nrck", across, drawn) - tiles).max(axis=(1, 2))
    return np.column_stack([off[:, 2], np.maximum(off[:, 3:6].max(axis=1) / OFF_NORMAL, off[:, 6:].max(axis=1) / OFF_COLOUR)])


def _blend(count: int, kept: np.ndarray) -> np.ndarray:
    """(count, K) weights of the kept ones in what lies straight between them."""
    return np.array([np.interp(np.arange(count), kept, one) for one in np.eye(len(kept))]).T


def _sides(level: np.ndarray) -> np.ndarray:
    """(R, C, 4) bool: where the tile below, to the right, above, to the left is drawn otherwise, so that a skirt is needed."""
    around = np.pad(level, 1, mode="edge")
    beside = np.stack([around[:-2, 1:-1], around[1:-1, 2:], around[2:, 1:-1], around[1:-1, :-2]], axis=2)
    return (beside >= 0) & (beside != level[..., None])


@cache
def _pattern(high: int, wide: int, stride: int, sides: Sides) -> np.ndarray:
    """(K, 3) corners of the triangles of a tile of so many cells, with skirts on some sides: row, column, whether it hangs."""
    rows, columns = (np.unique(np.append(np.arange(0, cells, stride), cells)) for cells in (high, wide))
    grid = np.stack([*np.meshgrid(rows, columns, indexing="ij"), np.zeros((len(rows), len(columns)), int)], axis=-1)
    rims = [grid[0], grid[:, -1], grid[-1, ::-1], grid[::-1, 0]]  # counter-clockwise, as seen from above
    rims = [rim for rim, hangs in zip(rims, sides, strict=True) if hangs]
    skirts = [quads(np.stack([rim + np.array([0, 0, 1]), rim])).reshape(-1, 3) for rim in rims]
    return np.concatenate([quads(grid).reshape(-1, 3), *skirts])
