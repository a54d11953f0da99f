"""Trees as shapes: a few, each of which stands many times, sized, turned and coloured by where it is."""

from typing import NamedTuple

import numpy as np

from sim.view.scenery.meshes import blob, flat_normals, quads
from worlds.queries import terrain_height
from worlds.world import World

LEAVES = np.array([[0.30, 0.47, 0.20], [0.37, 0.53, 0.22], [0.24, 0.41, 0.22], [0.45, 0.54, 0.22]])
VARIANTS = 4
CROWNS = ((0.62, 1.0), (0.85, 0.78), (1.06, 0.5))
"""Height, as a share of the tree's, and size of each crown."""


class Planted(NamedTuple):
    """The trees of a world."""

    rows: np.ndarray  # (T, 12) x, y, z, radius; height, cos, sin of the turn, spread; leaf colour, bark's brightness
    variant: np.ndarray  # (T,) which of the shapes


def planted(world: World) -> Planted:
    """The trees of a world: what is drawn of each depends on its place alone."""
    trees = np.reshape(world.trees, (-1, 3))
    x, y, radius = trees.T
    tall = (2.6 + 5.5 * radius) * (0.85 + 0.35 * _chance(x, y, 0))
    turn, ground = 2 * np.pi * _chance(x, y, 1), [terrain_height(world.arrays, *at) for at in trees[:, :2]]
    spread = (0.75 + 1.6 * radius) * (0.92 + 0.2 * _chance(x, y, 2))
    leaf = LEAVES[(_chance(x, y, 3) * len(LEAVES)).astype(int)] * (0.9 + 0.2 * _chance(x, y, 4))[:, None]
    bark = 0.85 + 0.3 * _chance(x, y, 5)
    rows = np.column_stack([x, y, ground, radius, tall, np.cos(turn), np.sin(turn), spread, leaf, bark]).astype("f4")
    return Planted(rows, (_chance(x, y, 6) * VARIANTS).astype(int))


def _chance(x: np.ndarray, y: np.ndarray, purpose: int) -> np.ndarray:
    """Numbers in [0, 1) that depend on the place alone, so that a tree keeps its looks whatever is planted around it."""
    return np.modf(np.abs(np.sin(12.9898 * x + 78.233 * y + 37.719 * purpose)) * 43758.5453)[0]


def tree(variant: int, fine: bool) -> np.ndarray:
    """(K, 9) triangles of a tapered trunk and three low crowns: offset, normal; height, crown (1) or trunk (0), brightness.

    Offsets of the trunk are in trunk radii and heights of the tree, those of a crown in spreads.
    """
    rng = np.random.default_rng(variant)
    around = np.linspace(0, 2 * np.pi, 8 if fine else 6)
    rings = [(1.25, -0.05), (1.0, 0.05), (0.75, 0.55), (0.3, 0.9)] if fine else [(1.2, -0.05), (0.6, 0.7)]
    trunk = quads(np.array([[(s * np.cos(a), s * np.sin(a), h) for a in around] for s, h in rings])).reshape(-1, 3)
    parts = [np.hstack([trunk, flat_normals(trunk), np.tile((0.0, 0.0, 1.0), (len(trunk), 1))])]
    for share, size in CROWNS:
        centre = (*(0.1 * rng.normal(size=2)), 0.0)
        crown = blob(centre, size * rng.uniform(0.95, 1.05), rng, fine)
        part = np.tile((share, 1.0, 0.85 + 0.25 * share), (len(crown), 1))
        parts.append(np.hstack([crown, flat_normals(crown), part]))
    return np.vstack(parts).astype("f4")
