"""What level and scene files share: the ground and what stands on it, as checked data and as a World."""

import math
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

from worlds.contents.heightmap import read_heightmap
from worlds.contents.scatter import Scatter, scattered
from worlds.errors import InputError
from worlds.world import River, Wall, World

Finite = Annotated[float, Field(ge=-1e5, le=1e5, allow_inf_nan=False, strict=True)]
"""A coordinate [m] or an angle: strict, for text and truth are no numbers."""
Length = Annotated[float, Field(ge=1e-4, le=10_000, allow_inf_nan=False, strict=True)]
Point = tuple[Finite, Finite]


def _whole(value: Any) -> Any:
    """True is no number of a format, though it equals 1."""
    if type(value) is not int:
        raise ValueError("a whole number is needed")
    return value


Format = Annotated[Literal[1], BeforeValidator(_whole)]


class Part(BaseModel):
    """A table of a file: nothing but its keys, and never changed."""

    model_config = ConfigDict(extra="forbid", strict=False, frozen=True)


class _Hills(Part):
    amplitude: Annotated[float, Field(ge=0, le=100, strict=True)] = 1.0
    wavelength: Length = 25.0
    phases: tuple[Finite, Finite, Finite] = (0.3, 1.1, 2.0)


class _Stairs(Part):
    position: Finite = 5.0  # x of the first riser
    rise: Length = 0.17
    run: Length = 0.3
    count: Annotated[int, Field(ge=1, le=10_000, strict=True)] = 20


class _SpiralStairs(Part):
    centre: Point
    inner_radius: Length = 1.0
    outer_radius: Length = 3.0
    rise: Length = 0.17
    steps_per_turn: Annotated[int, Field(ge=3, le=1000, strict=True)] = 24


class _Heightmap(Part):
    file: str
    spacing: Length = 0.5  # metres between pixels
    height: Length = 5.0  # metres of the full 16-bit range


class WorldTable(Part):
    size: tuple[Length, Length]
    terrain: Literal["flat", "hills", "stairs", "spiral_stairs", "heightmap"] = "flat"
    hills: _Hills | None = None
    stairs: _Stairs | None = None
    spiral_stairs: _SpiralStairs | None = None
    heightmap: _Heightmap | None = None


class _Tree(Part):
    position: Point
    radius: Length


class _River(Part):
    points: Annotated[list[Point], Field(min_length=2)]
    width: Length


class _Wall(Part):
    points: Annotated[list[Point], Field(min_length=2)]
    thickness: Annotated[float, Field(ge=1e-3, le=10_000, allow_inf_nan=False, strict=True)] = 0.2


class _Rock(Part):
    position: Point
    radius: Length
    height: Annotated[float, Field(ge=0, le=100, allow_inf_nan=False, strict=True)] = 0.2


class Goal(Part):
    """The place that is to be reached."""

    position: Point
    radius: Length = 1.0


class Ground(Part):
    """The tables of a file that make a world."""

    format: Format
    name: Annotated[str, Field(min_length=1)]
    world: WorldTable
    tree: list[_Tree] = []
    river: list[_River] = []
    wall: list[_Wall] = []
    rock: list[_Rock] = []
    scatter: Scatter | None = None


def build(
    path: Path, ground: Ground, start: tuple[float, float], heading_deg: float, goal: Goal | None = None
) -> tuple[World, list[str]]:
    """The world of a checked file, and the faults that only building it can find. Raises InputError."""
    try:
        return _built(path, ground, start, heading_deg, goal)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def _built(
    path: Path, ground: Ground, start: tuple[float, float], heading_deg: float, goal: Goal | None
) -> tuple[World, list[str]]:
    parameters, heights, faults = _terrain(path, ground.world)
    world = World(
        name=ground.name,
        size=ground.world.size,
        terrain=ground.world.terrain if not faults else "flat",
        terrain_parameters=parameters,
        heights=heights,
        trees=np.array([(*t.position, t.radius) for t in ground.tree], np.float64).reshape(-1, 3),
        rivers=tuple(River(np.array(r.points), r.width) for r in ground.river),
        walls=tuple(Wall(np.array(w.points), w.thickness) for w in ground.wall),
        rocks=np.array([(*r.position, r.radius, r.height) for r in ground.rock], np.float64).reshape(-1, 4),
        start=start,
        start_heading=math.radians(heading_deg),
        goal=goal.position if goal else None,
        goal_radius=goal.radius if goal else 1.0,
    )
    return (scattered(world, ground.scatter) if ground.scatter else world), faults


def _terrain(path: Path, world: WorldTable) -> tuple[tuple[float, ...], np.ndarray, list[str]]:
    """Kernel parameters (see worlds.queries), heights of a heightmap, faults."""
    flat = np.zeros((1, 1))
    if world.terrain == "hills":
        hills = world.hills or _Hills()
        return (hills.amplitude, hills.wavelength, *hills.phases), flat, []
    if world.terrain == "stairs":
        stairs = world.stairs or _Stairs()
        return (stairs.position, stairs.rise, stairs.run, stairs.count), flat, []
    if world.terrain == "spiral_stairs":
        spiral = world.spiral_stairs or _SpiralStairs(centre=(world.size[0] / 2, world.size[1] / 2))
        radii = (spiral.inner_radius, spiral.outer_radius)
        return (*spiral.centre, *radii, spiral.rise, spiral.steps_per_turn), flat, []
    if world.terrain == "heightmap":
        if world.heightmap is None:
            return (), flat, ["world.heightmap: is missing; terrain = 'heightmap' needs file, spacing, height"]
        heights, fault = read_heightmap(path.parent / world.heightmap.file)
        if fault:
            return (), flat, [f"world.heightmap.file: {fault}"]
        return (world.heightmap.spacing,), heights * world.heightmap.height, []
    return (), flat, []
