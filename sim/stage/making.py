"""Simulations as people ask for them: a level, a kind of character, how many, wandering, crossing or steered."""

from pathlib import Path

from motion.characters.character import load_character
from planner.modes.steer import Steered
from planner.modes.wander import Wander
from planner.river.rock_hop import RockHop
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.level import load_level


def make_simulation(level: str | Path, character: str | Path, characters: int, seed: int, river: bool) -> Simulation:
    """So many characters of one kind on a level, each by name or file: crossing to its goal, or wandering.

    Raises InputError, NoWay.
    """
    world = load_level(level)
    if river and world.goal is None:
        raise InputError(f"{level}: has no [goal]; `river` needs one (position, radius)")
    crowd = [load_character(character)] * characters
    return Simulation(world, crowd, RockHop() if river else Wander(), seed)


def make_steered(level: str | Path, character: str | Path, characters: int, seed: int) -> Simulation:
    """So many characters of one kind on a level, who go where they are told. Raises InputError."""
    return Simulation(load_level(level), [load_character(character)] * characters, Steered(), seed)
