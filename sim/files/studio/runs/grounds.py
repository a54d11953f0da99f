"""The tables of a scene file that make a world which is there already: the inverse of worlds.ground."""

from pathlib import Path
from typing import Any

from sim.files.studio.places import kept_heightmap
from worlds import reading
from worlds.errors import InputError
from worlds.world import World

KEYS = {
    "hills": ("amplitude", "wavelength"),
    "stairs": ("position", "rise", "run", "count"),
    "spiral_stairs": ("inner_radius", "outer_radius", "rise", "steps_per_turn"),
}
"""Of terrains, in the order of their parameters (worlds.ground)."""
WHOLE = ("count", "steps_per_turn")
LEAST_HEIGHT = 1e-3
"""Of the full range of a heightmap [m]."""


def tables_of(world: World, level: Path | None = None) -> dict[str, Any]:
    """format, name, [world], trees, rivers, walls, rocks and goal, as a file has them, each thing by itself.

    level: the file that the world was read from, by which a heightmap is known; else its heights are kept in a file of our own.
    Raises InputError where that cannot be.
    """
    found: dict[str, Any] = {"format": 1, "name": world.name, "world": _world(world, level)}
    found["tree"] = [{"position": (x, y), "radius": radius} for x, y, radius in world.trees.tolist()]
    found["rock"] = [{"position": (x, y), "radius": r, "height": high} for x, y, r, high in world.rocks.tolist()]
    found["river"] = [{"points": _points(one.points), "width": float(one.width)} for one in world.rivers]
    found["wall"] = [{"points": _points(one.points), "thickness": float(one.thickness)} for one in world.walls]
    if world.goal is not None:
        found["goal"] = {"position": world.goal, "radius": float(world.goal_radius)}
    return found


def _points(points: Any) -> list[tuple[float, float]]:
    return [(float(x), float(y)) for x, y in points]


def _world(world: World, level: Path | None) -> dict[str, Any]:
    """The table [world]."""
    table: dict[str, Any] = {"size": world.size}
    if world.terrain != "flat":
        table |= {"terrain": world.terrain, world.terrain: _terrain(world, level)}
    return table


def _terrain(world: World, level: Path | None) -> dict[str, Any]:
    values = [float(value) for value in world.terrain_parameters]
    if world.terrain == "heightmap":
        return _heightmap(world, level)
    rest, keys = {}, KEYS[world.terrain]
    if world.terrain == "hills":
        rest, values = {"phases": tuple(values[2:])}, values[:2]
    if world.terrain == "spiral_stairs":
        rest, values = {"centre": (values[0], values[1])}, values[2:]
    named = dict(zip(keys, values, strict=True))
    return rest | {key: int(value) if key in WHOLE else value for key, value in named.items()}


def _heightmap(world: World, level: Path | None) -> dict[str, Any]:
    """As the level's file has it; the picture, which lies beside that, by its whole path. Raises InputError.

    Where the file is not known, as of a recording, the heights are written into one of our own.
    """
    if level is None:
        if world.heights.min() < 0:
            raise InputError(f"{world.name}: its ground lies below 0 in places, which no picture of heights has")
        spacing, height = float(world.terrain_parameters[0]), max(float(world.heights.max()), LEAST_HEIGHT)
        return {"file": str(kept_heightmap(world.heights / height)), "spacing": spacing, "height": height}
    table = dict(reading.read_toml(level, "level", "format, name, [world] and [start]")["world"]["heightmap"])
    return table | {"file": str((level.parent / table["file"]).resolve())}
