"""From a click to a place on the ground, and from a place to another world."""

import numpy as np

from worlds.queries import border_clearance, terrain_height, tree_clearance, water_clearance
from worlds.world import World

FAR = 150.0
TREE, ROCK, ROCK_HEIGHT = 0.3, 0.5, 0.15
"""Radius of a planted tree, radius and height of a rock that is put [m]."""
AIM = 0.012
"""Tangent of the angle by which a click may miss a character."""
ROOM = 0.7
"""A tree or rock is not put this near to a foot [m]."""


def ground_point(world: World, origin: np.ndarray, direction: np.ndarray) -> tuple[float, float] | None:
    """Where a ray meets the terrain within the world, by marching and halving; None for none."""

    def above(t: float) -> float:
        p = origin + t * direction
        return float(p[2] - terrain_height(world.arrays, p[0], p[1]))

    near = 0.0
    for t in np.linspace(0, FAR, 600)[1:]:
        if above(t) < 0:
            far = float(t)
            for _ in range(30):
                middle = 0.5 * (near + far)
                near, far = (middle, far) if above(middle) > 0 else (near, middle)
            x, y, _ = origin + near * direction
            return (float(x), float(y)) if border_clearance(world.arrays, x, y) > 0 else None
        near = float(t)
    return None


def character_at(com: np.ndarray, size: float, origin: np.ndarray, direction: np.ndarray) -> int | None:
    """The nearest character, com (C, 3), that a ray meets: within `size` [m], or AIM of its distance if that is more."""
    along = (com - origin) @ direction
    off = np.linalg.norm(com - origin - along[:, None] * direction, axis=1)
    met = np.flatnonzero((along > 0) & (off < np.maximum(size, AIM * along)))
    return int(met[along[met].argmin()]) if len(met) else None


def edited(world: World, tool: str, x: float, y: float, feet: np.ndarray) -> tuple[World, str]:
    """The world after an edit, and what to tell; the same world where the edit is refused. feet (K, 2)."""
    w = world.arrays
    if tool == "g":
        if tree_clearance(w, x, y) < 0.3 or water_clearance(w, x, y) < 0.3:
            return world, "a goal needs dry ground away from trees"
        return world.with_goal(x, y), f"goal at ({x:.1f}, {y:.1f})"
    if tool in "tk":
        near = float(np.hypot(*(feet - (x, y)).T).min()) if len(feet) else np.inf
        if near < ROOM:
            return world, "too near to a foot"
        if tool == "t":
            return world.with_tree(x, y, TREE), f"tree planted at ({x:.1f}, {y:.1f})"
        return world.with_rock(x, y, ROCK, ROCK_HEIGHT), f"rock put at ({x:.1f}, {y:.1f})"
    return _removed(world, x, y)


def _removed(world: World, x: float, y: float) -> tuple[World, str]:
    """Without the tree or rock nearest to the place, within a metre."""
    best, what, index = 1.0, "", -1
    for name, things in (("tree", world.trees), ("rock", world.rocks)):
        if len(things):
            d = np.hypot(things[:, 0] - x, things[:, 1] - y) - things[:, 2]
            if d.min() < best:
                best, what, index = float(d.min()), name, int(d.argmin())
    if index < 0:
        return world, "nothing to remove there"
    return (world.without_tree if what == "tree" else world.without_rock)(index), f"{what} removed"
