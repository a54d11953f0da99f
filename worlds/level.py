"""Level files: a world with a start and, where it is to be crossed, a goal."""

import tomllib
from pathlib import Path

from worlds import ground, reading
from worlds.contents import checks
from worlds.contents.traffic import Traffic
from worlds.errors import InputError
from worlds.ground import Finite, Goal, Ground, Part, Point
from worlds.world import World

LEVELS = Path(__file__).parent / "levels"


class _Start(Part):
    position: Point
    heading_deg: Finite = 0.0


class _Level(Ground, Traffic):
    start: _Start
    goal: Goal | None = None


def level_names(with_goal: bool | None = None) -> list[str]:
    """Names of the levels that ship; only those with a goal, or only those without one, told without building them."""
    names = reading.names_in(LEVELS)
    if with_goal is None:
        return names
    return [n for n in names if ("goal" in tomllib.loads((LEVELS / f"{n}.toml").read_text("utf-8"))) == with_goal]


def visited_names() -> list[str]:
    """Names of the levels that ship that people come into and go out of."""
    return [n for n in level_names() if "source" in tomllib.loads((LEVELS / f"{n}.toml").read_text("utf-8"))]


def load_level(name_or_path: str | Path) -> World:
    """A shipped level by name, or any level file by path. Raises InputError naming every fault."""
    path = reading.named_file(LEVELS, name_or_path, "level")
    level = reading.read_model(path, _Level, "level", "format, name, [world] and [start]")
    world, faults = ground.build(path, level, level.start.position, level.start.heading_deg, level.goal)
    faults += checks.faults(world) + faults_of(level) + checks.area_faults(world, level.areas())
    if faults:
        raise InputError("\n".join(f"{path}: {fault}" for fault in faults))
    return world


def load_traffic(name_or_path: str | Path) -> Traffic:
    """Who comes into a level and goes out of it, as far as it says so. Raises InputError naming every fault of its tables."""
    path = reading.named_file(LEVELS, name_or_path, "level")
    level = reading.read_model(path, _Level, "level", "format, name, [world] and [start]")
    return Traffic(**{name: getattr(level, name) for name in Traffic.model_fields})


def faults_of(traffic: Traffic) -> list[str]:
    """What the tables of people get wrong together: names that there are not, or are twice; with key and what is allowed."""
    found = []
    for key in ("population", "waiting", "exit"):
        names = [one.name for one in getattr(traffic, key)]
        found += [f"{key}.{k}.name = {name!r}: is there twice" for k, name in enumerate(names) if name in names[:k]]
    for k, source in enumerate(traffic.source):
        for key, word in (("population", "population"), ("via", "waiting"), ("to", "exit")):
            names = [one.name for one in getattr(traffic, word)]
            found += [
                f"source.{k}.{key}: {name!r} is none of the [[{word}]] tables{reading.nearest(name, names)}"
                for name in getattr(source, key)
                if name not in names
            ]
    if traffic.source and not traffic.exit:
        found.append("source: people come in and cannot go out; give an [[exit]] with name and area")
    return found
