"""Polygons: which points lie in them, and where their borders are nearest [m]."""

import numpy as np


def inside(polygon: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(N,) bool: which points (N, 2) lie in a polygon (P, 2), by how often a ray to the right crosses its edges."""
    ax, ay = polygon.T
    bx, by = np.roll(polygon, -1, axis=0).T
    x, y = points[:, :1], points[:, 1:]
    across = (ay > y) != (by > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        at = ax + (y - ay) / (by - ay) * (bx - ax)
    return (across & (x < at)).sum(axis=1) % 2 == 1


def nearest(polygon: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(N, 2) the places on the border of a polygon (P, 2) that are nearest to points (N, 2)."""
    a, edge = polygon, np.roll(polygon, -1, axis=0) - polygon
    off = points[:, None] - a
    share = np.clip((off * edge).sum(axis=2) / np.maximum((edge * edge).sum(axis=1), 1e-12), 0, 1)
    places = a + share[..., None] * edge
    k = np.linalg.norm(places - points[:, None], axis=2).argmin(axis=1)
    return places[np.arange(len(points)), k]
