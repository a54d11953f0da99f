"""The world around as meshes: ground, rocks, water and trees as they are drawn, each one list of triangles."""

from typing import NamedTuple

import numpy as np

from sim.view.scenery import meshes
from sim.view.scenery.trees import planted, tree
from worlds.world import World

WATER, BARK = (0.20, 0.42, 0.50), (0.40, 0.29, 0.20)
TREES = 2000
"""No more than so many trees, those nearest to the middle of what is exported."""


class Shape(NamedTuple):
    """A mesh in world axes, metres."""

    position: np.ndarray  # (V, 3)
    normal: np.ndarray  # (V, 3)
    colour: np.ndarray  # (V, 3) red, green, blue in 0..1
    triangles: np.ndarray  # (T, 3)


def scenery_of(world: World, middle: np.ndarray, cells: int = 150, trees: int = TREES) -> dict[str, Shape]:
    """What there is of a world, by name; middle (2,) [m]: around which trees are kept; cells: of the ground, either way."""
    ground = meshes.GROUNDS[world.terrain](world) if world.terrain in meshes.GROUNDS else meshes.ground(world, cells)
    found = {"ground": _shape(*ground), "rocks": _triangles(meshes.rocks(world)), "trees": _forest(world, middle, trees)}
    water = _triangles(meshes.water(world))
    found["water"] = water._replace(
        normal=np.broadcast_to((0.0, 0.0, 1.0), water.normal.shape), colour=np.broadcast_to(WATER, water.colour.shape)
    )  # fmt: skip
    return {name: shape for name, shape in found.items() if len(shape.triangles)}


def _shape(vertices: np.ndarray, triangles: np.ndarray) -> Shape:
    """From the view's rows (V, 9): place, normal, colour."""
    rows = vertices.astype(float)
    length = np.linalg.norm(rows[:, 3:6], axis=1, keepdims=True)
    normal = np.where(length > 1e-9, rows[:, 3:6] / np.maximum(length, 1e-12), (0.0, 0.0, 1.0))
    return Shape(rows[:, :3], normal, np.clip(rows[:, 6:9], 0, 1), np.asarray(triangles, np.int64))


def _triangles(vertices: np.ndarray) -> Shape:
    return _shape(vertices, np.arange(len(vertices)).reshape(-1, 3))


def _forest(world: World, middle: np.ndarray, most: int) -> Shape:
    """All trees as one mesh, in their coarser shapes, as the view's shader places them."""
    rows, variant = planted(world)
    near = np.argsort(np.linalg.norm(rows[:, :2] - middle, axis=1), kind="stable")[:most]
    parts = [_tree(tree(int(variant[k]), False).astype(float), rows[k].astype(float)) for k in np.sort(near)]
    return _triangles(np.concatenate(parts) if parts else np.zeros((0, 9)))


def _tree(shape: np.ndarray, row: np.ndarray) -> np.ndarray:
    """(V, 9) a tree's vertices in the world: shape as `tree`, row as `Planted` has it."""
    crown = shape[:, 7:8] > 0.5
    radius, tall, c, s, spread = row[3:8]
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    size = np.where(crown, spread, (radius, radius, tall))
    place = row[:3] + (size * shape[:, :3]) @ turn.T + shape[:, 6:7] * (0, 0, tall)
    colour = np.where(crown, row[8:11], row[11] * np.array(BARK)) * shape[:, 8:9]
    return np.hstack([place, shape[:, 3:6] @ turn.T, colour])
