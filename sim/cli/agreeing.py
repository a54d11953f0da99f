"""Options that say two things: refused, or said, before anything is compiled. None is ignored in silence."""

from pathlib import Path
from typing import Any

from motion.characters.character import load_character
from sim.stage.simulation import Simulation
from worlds.compiled.telling import tell
from worlds.errors import InputError
from worlds.level import load_level, load_traffic

COMMANDS = {"RockHop": "river", "Steered": "steer", "Visiting": "crowd"}
"""Which command a saved state belongs to, by its planner; all others: `wander`."""


def scene(options: Any) -> None:
    """What cannot be asked of a scene. Raises InputError."""
    if options.characters > 1:
        raise InputError(f"--characters {options.characters}: a scene is played by one character")
    if "seed" in options.given:
        tell(f"--seed {options.seed}: there is no chance in a scene; it makes no difference")


def run(options: Any) -> None:
    """Names of levels and characters. Raises InputError; a saved state brings its own."""
    if not options.restore or "level" in options.given:
        load_level(options.level)
    if not options.restore or "character" in options.given:
        load_character(options.character)
    if options.command == "crowd" and not options.restore and not load_traffic(options.level).source:
        raise InputError(f"{options.level}: nobody comes in; `crowd` needs a [[source]] and an [[exit]] with areas")
    if getattr(options, "mixed", False) and (options.restore or "character" in options.given):
        raise InputError("--mixed: the level's populations say who walks; leave --character and --restore out")


def restored(options: Any, sim: Simulation) -> None:
    """Whether a saved state is of what is asked for. Raises InputError naming every difference."""
    saved = {
        "level": sim.first_world.name,
        "character": ", ".join(sorted({one.name for one in sim.characters})),
        "characters": len(sim.characters),
        "seed": sim.seed,
    }
    asked = {name: getattr(options, name) for name in options.given}
    if "level" in asked:
        asked["level"] = load_level(asked["level"]).name
    if "character" in asked:
        asked["character"] = load_character(asked["character"]).name
    faults = [
        f"{'the level' if name == 'level' else f'--{name}'} is {value}, but {options.restore} is of {saved[name]}; leave it out"
        for name, value in sorted(asked.items())
        if value != saved[name]
    ]
    other = COMMANDS.get(sim.planner.name, "wander")
    if options.command != other:
        faults.append(f"{options.restore} is a state of `{other}`: footfall {other} --restore {Path(options.restore).name}")
    if faults:
        raise InputError("\n".join(faults))
