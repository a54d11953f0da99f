"""`wander`, `steer`, `river` and `crowd`: from the start, or from a saved state."""

from collections.abc import Callable
from functools import partial
from typing import Any

from sim.cli import agreeing
from sim.cli.show import show
from sim.stage.cast import Cast
from sim.stage.commands import steer_by_chance
from sim.stage.simulation import Simulation
from sim.view.window.choosing import maker
from worlds.level import level_names, visited_names


def walk(options: Any) -> int:
    """Wandering, going where the keys say, crossing to a goal, or coming and going."""
    chosen = maker(options.command, options.characters, getattr(options, "mixed", False))

    def make(level: str = options.level, character: str | None = options.character, seed: int = options.seed) -> Cast:
        return chosen(level, character, seed)

    return show(options, make, _names(options.command), partial(agreeing.run, options), options.restore, _hands(options))


def _names(command: str) -> list[str]:
    """The levels that a command can go on to."""
    return visited_names() if command == "crowd" else level_names(with_goal=command == "river")


def _hands(options: Any) -> tuple[Callable[[Cast], None], ...]:
    """Who presses the keys of a run that has no window: chance, by the run's seed."""
    return (_pressed_by_chance,) if options.command == "steer" else ()


def _pressed_by_chance(sim: Cast) -> None:
    """Keys by chance, for everyone, after a tick."""
    if isinstance(sim, Simulation):
        steer_by_chance(sim)
