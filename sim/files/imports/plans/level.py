"""The level of a plan: its lines as walls in a world with a margin around, and a start where there is most room."""

import numpy as np

from sim.files.imports.plans.lines import Plan
from worlds.contents.polygons import inside
from worlds.queries import survey
from worlds.world import Wall, World

MARGIN = 1.0
"""Around the plan [m]."""
LOOKS = 60
"""Places along an edge at which room for the start is looked for."""


def world_of(plan: Plan, name: str, thickness: float) -> World:
    """The world of a plan, moved so that it begins at MARGIN. Raises InputError for what no world can be."""
    low, high = _extent(plan)
    moved = tuple(Wall(line - low + MARGIN, thickness) for line in plan.lines)
    size = high - low + 2 * MARGIN
    world = World(name, (float(size[0]), float(size[1])), walls=moved)
    x, y = _start(world, [moved[k].points for k in plan.walkable])
    return World(name, world.size, walls=moved, start=(x, y))


def _extent(plan: Plan) -> tuple[np.ndarray, np.ndarray]:
    points = np.concatenate(plan.lines)
    return points.min(axis=0), points.max(axis=0)


def _start(world: World, walkable: list[np.ndarray]) -> tuple[float, float]:
    """The place that is furthest from walls, where people may walk, if the plan tells."""
    sides = [(np.arange(LOOKS) + 0.5) / LOOKS * world.size[k] for k in (0, 1)]
    places = np.stack(np.meshgrid(*sides), axis=2).reshape(-1, 2)
    found = np.empty((len(places), 4))
    survey(world.arrays, np.ascontiguousarray(places), found)
    room = found[:, 3].copy()
    if walkable:
        room[~np.any([inside(ring[:-1], places) for ring in walkable], axis=0)] = -np.inf
    x, y = places[int(np.argmax(room))].tolist()
    return round(x, 2), round(y, 2)


def text_of(world: World, source: str, moved: np.ndarray) -> str:
    """The level as TOML; source: where the plan is from, moved (2,): how far from there to here [m]."""
    lines = [
        f"# Walls of {source}, moved by [{moved[0]:g}, {moved[1]:g}] m.",
        "format = 1",
        f"name = {_quoted(world.name)}",
        "[world]",
        f"size = [{world.size[0]:.3f}, {world.size[1]:.3f}]",
        'terrain = "flat"',
        "[start]",
        f"position = [{world.start[0]:.2f}, {world.start[1]:.2f}]",
    ]
    for wall in world.walls:
        points = ", ".join(f"[{x:.3f}, {y:.3f}]" for x, y in wall.points.tolist())
        lines += ["[[wall]]", f"points = [{points}]", f"thickness = {wall.thickness:g}"]
    return "\n".join(lines) + "\n"


def moved_by(plan: Plan) -> np.ndarray:
    """(2,) from the plan's frame to the level's [m]."""
    return MARGIN - _extent(plan)[0]


def _quoted(text: str) -> str:
    return '"' + "".join(c for c in text if c.isprintable()).replace("\\", "/").replace('"', "'") + '"'
