"""What is in view, and how much of it can be seen: culling by bounding spheres, levels of detail by size on screen."""

import numpy as np

FULL, REDUCED, FAR, DISTANT = range(4)
"""Levels of detail of a body: all of it; without small parts, coarser; a dozen flat shapes; a handful."""
PIXELS = (120.0, 50.0, 16.0)
"""Bodies at least this tall on screen are FULL, REDUCED, FAR; smaller ones DISTANT."""


def in_view(view: np.ndarray, centres: np.ndarray, radii: np.ndarray | float) -> np.ndarray:
    """(C,) bool: whether spheres at centres (C, 3) reach into the view (4, 4), world to clip space; never false for one that
    does."""
    planes = np.vstack([view[3] + sign * view[axis] for axis in range(3) for sign in (1, -1)])
    planes /= np.linalg.norm(planes[:, :3], axis=1, keepdims=True)
    return (centres @ planes[:, :3].T + planes[:, 3] >= -np.reshape(radii, (-1, 1))).all(axis=1)


def pixels(view: np.ndarray, centres: np.ndarray, sizes: np.ndarray, height: int) -> np.ndarray:
    """(C,) height on a screen of `height` pixels of things `sizes` (C,) [m] tall at centres (C, 3)."""
    depth = centres @ view[3, :3] + view[3, 3]
    return 0.5 * height * float(np.linalg.norm(view[1, :3])) * sizes / np.maximum(depth, 1e-3)


def level_of(size: np.ndarray) -> np.ndarray:
    """(C,) level of detail of bodies `size` pixels tall."""
    return len(PIXELS) - np.searchsorted(PIXELS[::-1], size, side="right")
