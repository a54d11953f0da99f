"""What a well-formed level may still get wrong: things outside, in trees, in water."""

import numpy as np

from worlds.contents.traffic import Corner, corners
from worlds.queries import border_clearance, in_water, tree_clearance, wall_clearance
from worlds.world import World

LEAST_AREA = 0.05
"""Of a source, an exit or a waiting area [m^2]."""


def faults(world: World) -> list[str]:
    """Every fault, each with key, value and what is allowed."""
    found = _place_faults(world, "start", world.start)
    if world.goal is not None:
        found += _place_faults(world, "goal", world.goal)
    for key, discs in (("tree", world.trees), ("rock", world.rocks)):
        for i, (x, y) in enumerate(discs[:, :2]):
            if border_clearance(world.arrays, x, y) < 0:
                found.append(f"{key}.{i}.position = [{x:g}, {y:g}]: {_outside(world)}")
    return found


def area_faults(world: World, areas: dict[str, list[Corner]]) -> list[str]:
    """Areas, by their keys, that are none or lie outside."""
    found = []
    for key, area in areas.items():
        x, y = corners(area).T
        if min(x.min(), y.min(), world.size[0] - x.max(), world.size[1] - y.max()) < 0:
            found.append(f"{key} = {[list(corner) for corner in area]}: {_outside(world)}")
        elif abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1))) < 2 * LEAST_AREA:
            found.append(f"{key} = {[list(corner) for corner in area]}: {LEAST_AREA:g} square metres or more are needed")
    return found


def _outside(world: World) -> str:
    return f"is outside the world; 0..{world.size[0]:g} by 0..{world.size[1]:g} is allowed"


def _place_faults(world: World, key: str, place: tuple[float, float]) -> list[str]:
    said = f"{key}.position = [{place[0]:g}, {place[1]:g}]"
    if border_clearance(world.arrays, *place) < 0:
        return [f"{said}: {_outside(world)}"]
    found = []
    if tree_clearance(world.arrays, *place) <= 0:
        found.append(f"{said}: is inside a tree; move it, or the tree")
    if wall_clearance(world.arrays, *place) <= 0:
        found.append(f"{said}: is inside a wall; move it, or the wall")
    if in_water(world.arrays, *place):
        found.append(f"{said}: is in water; move it to land or onto a rock")
    return found
