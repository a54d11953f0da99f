"""Level files: a world with a start and, where it is to be crossed, a goal."""

import tomllib
from pathlib import Path

from worlds import ground, reading
from worlds.contents import checks
from worlds.errors import InputError
from worlds.ground import Finite, Goal, Ground, Part, Point
from worlds.world import World

LEVELS = Path(__file__).parent / "levels"


class _Start(Part):
    position: Point
    heading_deg: Finite = 0.0


class _Level(Ground):
    start: _Start
    goal: Goal | None = None


def level_names(with_goal: bool | None = None) -> list[str]:
    """Names of the levels that ship; only those with a goal, or only those without one, told without building them."""
    names = reading.names_in(LEVELS)
    if with_goal is None:
        return names
    return [n for n in names if ("goal" in tomllib.loads((LEVELS / f"{n}.toml").read_text("utf-8"))) == with_goal]


def load_level(name_or_path: str | Path) -> World:
    """A shipped level by name, or any level file by path. Raises InputError naming every fault."""
    path = reading.named_file(LEVELS, name_or_path, "level")
    level = reading.read_model(path, _Level, "level", "format, name, [world] and [start]")
    world, faults = ground.build(path, level, level.start.position, level.start.heading_deg, level.goal)
    faults += checks.faults(world)
    if faults:
        raise InputError("\n".join(f"{path}: {fault}" for fault in faults))
    return world
