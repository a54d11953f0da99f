"""`wander` and `river`: from the start, or from a saved state."""

from typing import Any

from sim.cli import agreeing
from sim.cli.show import show
from sim.stage.making import make_simulation
from sim.stage.simulation import Simulation
from worlds.level import level_names


def walk(options: Any) -> int:
    """Wandering, or crossing to a goal."""
    agreeing.run(options)

    def make(level: str = options.level, character: str = options.character, seed: int = options.seed) -> Simulation:
        return make_simulation(level, character, options.characters, seed, options.command == "river")

    return show(options, make, level_names(with_goal=options.command == "river"), options.restore)
