"""The world of a level or scene as its file draws it, before anything is compiled: to look at while one waits."""

from pathlib import Path

from pydantic import ConfigDict

from planner.script.scene import SCENES
from worlds import ground, reading
from worlds.errors import InputError
from worlds.ground import Goal, Ground
from worlds.level import LEVELS
from worlds.world import World


class _Sketch(Ground):
    """What there is to see of a file; all else is let be."""

    model_config = ConfigDict(extra="ignore", strict=False, frozen=True)
    goal: Goal | None = None


def sketched(name: str | None) -> World | None:
    """The world of a level or scene, by name or file; None where it cannot be read. What is scattered beside water is left out.

    Nothing is checked: whoever loads it says what is wrong.
    """
    try:
        path = next(one for one in _places(name or "") if one.is_file())
        sheet = reading.checked(path, reading.read_toml(path, "level", "[world]"), _Sketch)
        if sheet.river or sheet.wall:  # finding room beside these is compiled
            sheet = sheet.model_copy(update={"scatter": None})
        world, faults = ground.build(path, sheet, (0.0, 0.0), 0.0, sheet.goal)
        return None if faults else world
    except (InputError, OSError, ValueError, StopIteration):
        return None


def _places(name: str) -> tuple[Path, ...]:
    return LEVELS / f"{name}.toml", SCENES / f"{name}.toml", Path(name)
