"""Level files: TOML, checked as a whole, every fault of a file in one report."""

import math
import tomllib
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from worlds import checks
from worlds.errors import InputError
from worlds.heightmap import read_heightmap
from worlds.scatter import Scatter, scattered
from worlds.world import River, World

LEVELS = Path(__file__).parent / "levels"
LARGEST_FILE = 2_000_000
"""Bytes: a level file is written by a person; anything larger is something else."""

Finite = Annotated[float, Field(allow_inf_nan=False)]
Length = Annotated[float, Field(gt=0, le=10_000, allow_inf_nan=False)]
Point = tuple[Finite, Finite]


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=False)


class _Hills(_Part):
    amplitude: Annotated[float, Field(ge=0, le=100)] = 1.0
    wavelength: Length = 25.0
    phases: tuple[Finite, Finite, Finite] = (0.3, 1.1, 2.0)


class _Stairs(_Part):
    position: Finite = 5.0  # x of the first riser
    rise: Length = 0.17
    run: Length = 0.3
    count: Annotated[int, Field(ge=1, le=10_000)] = 20


class _SpiralStairs(_Part):
    centre: Point
    inner_radius: Length = 1.0
    outer_radius: Length = 3.0
    rise: Length = 0.17
    steps_per_turn: Annotated[int, Field(ge=3, le=1000)] = 24


class _Heightmap(_Part):
    file: str
    spacing: Length = 0.5  # metres between pixels
    height: Length = 5.0  # metres of the full 16-bit range


class _World(_Part):
    size: tuple[Length, Length]
    terrain: Literal["flat", "hills", "stairs", "spiral_stairs", "heightmap"] = "flat"
    hills: _Hills | None = None
    stairs: _Stairs | None = None
    spiral_stairs: _SpiralStairs | None = None
    heightmap: _Heightmap | None = None


class _Start(_Part):
    position: Point
    heading_deg: Finite = 0.0


class _Goal(_Part):
    position: Point
    radius: Length = 1.0


class _Tree(_Part):
    position: Point
    radius: Length


class _River(_Part):
    points: Annotated[list[Point], Field(min_length=2)]
    width: Length


class _Rock(_Part):
    position: Point
    radius: Length
    height: Annotated[float, Field(ge=0, le=100, allow_inf_nan=False)] = 0.2


class _Level(_Part):
    format: Literal[1]
    name: Annotated[str, Field(min_length=1)]
    world: _World
    start: _Start
    goal: _Goal | None = None
    tree: list[_Tree] = []
    river: list[_River] = []
    rock: list[_Rock] = []
    scatter: Scatter | None = None


def level_names() -> list[str]:
    """Names of the levels that ship."""
    return sorted(path.stem for path in LEVELS.glob("*.toml"))


def load_level(name_or_path: str | Path) -> World:
    """A shipped level by name, or any level file by path. Raises InputError naming every fault."""
    path = LEVELS / f"{name_or_path}.toml"
    if not path.is_file():
        path = Path(name_or_path)
    level = _parse(path, _read(path))
    world, faults = _build(path, level)
    faults += checks.faults(world)
    if faults:
        raise InputError("\n".join(f"{path}: {fault}" for fault in faults))
    return world


def _read(path: Path) -> dict:
    if path.is_dir():
        raise InputError(f"{path}: is a folder; a level is a TOML file")
    if not path.exists():
        raise InputError(f"{path}: no such level; there are {', '.join(level_names())}, or give a .toml file")
    if path.stat().st_size > LARGEST_FILE:
        raise InputError(f"{path}: {path.stat().st_size} bytes; a level file has at most {LARGEST_FILE}")
    try:
        values = tomllib.loads(path.read_bytes().decode("utf-8"))
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise InputError(f"{path}: is not a TOML text file: {error}") from None
    if not values:
        raise InputError(f"{path}: is empty; a level needs format, name, [world] and [start]")
    return values


def _parse(path: Path, values: dict) -> _Level:
    try:
        return _Level.model_validate(values)
    except ValidationError as error:
        raise InputError("\n".join(f"{path}: {_fault(one)}" for one in error.errors())) from None


def _fault(one) -> str:
    key = ".".join(str(part) for part in one["loc"])
    if one["type"] == "extra_forbidden":
        return f"{key}: unknown key"
    if one["type"] == "missing":
        return f"{key}: is missing"
    value = repr(one["input"])
    return f"{key} = {value if len(value) < 60 else value[:57] + '...'}: {one['msg']}"


def _build(path: Path, level: _Level) -> tuple[World, list[str]]:
    parameters, heights, faults = _terrain(path, level.world)
    world = World(
        name=level.name,
        size=level.world.size,
        terrain=level.world.terrain if not faults else "flat",
        terrain_parameters=parameters,
        heights=heights,
        trees=np.array([(*t.position, t.radius) for t in level.tree], np.float64).reshape(-1, 3),
        rivers=tuple(River(np.array(r.points), r.width) for r in level.river),
        rocks=np.array([(*r.position, r.radius, r.height) for r in level.rock], np.float64).reshape(-1, 4),
        start=level.start.position,
        start_heading=math.radians(level.start.heading_deg),
        goal=level.goal.position if level.goal else None,
        goal_radius=level.goal.radius if level.goal else 1.0,
    )
    return (scattered(world, level.scatter) if level.scatter else world), faults


def _terrain(path: Path, world: _World) -> tuple[tuple[float, ...], np.ndarray, list[str]]:
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
