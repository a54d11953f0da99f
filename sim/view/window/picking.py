"""From a click to a place on the ground, and from a place to a command."""

import numpy as np

from sim.stage.command import Command
from sim.stage.commands import PlantTree, PutRock, Remove, SetGoal
from worlds.queries import border_clearance, terrain_height
from worlds.world import World

FAR = 150.0
AIM = 0.012
"""Tangent of the angle by which a click may miss a character."""


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


def command_for(world: World, tool: str, x: float, y: float) -> Command | None:
    """What a click with a tool held means: g goal, t tree, k rock, x away with the nearest; None where nothing is there."""
    if tool == "g":
        return SetGoal(x, y)
    if tool == "t":
        return PlantTree(x, y)
    if tool == "k":
        return PutRock(x, y)
    return _removal(world, x, y)


def _removal(world: World, x: float, y: float) -> Remove | None:
    """Away with the tree or rock nearest to the place, within a metre."""
    best, what, index = 1.0, "", -1
    for name, things in (("tree", world.trees), ("rock", world.rocks)):
        if len(things):
            d = np.hypot(things[:, 0] - x, things[:, 1] - y) - things[:, 2]
            if d.min() < best:
                best, what, index = float(d.min()), name, int(d.argmin())
    return Remove(what, index) if index >= 0 else None
