"""Simulations as people ask for them: a level, a kind of character, how many, wandering, crossing or steered."""

from pathlib import Path

from motion.characters.character import load_character
from planner.modes.people.mix import Mix
from planner.modes.people.visitors import Visiting
from planner.modes.steer import Steered
from planner.modes.wander import Wander
from planner.river.rock_hop import RockHop
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.level import load_level, load_traffic


def make_simulation(level: str | Path, character: str | Path, characters: int, seed: int, river: bool) -> Simulation:
    """So many characters of one kind on a level, each by name or file: crossing to its goal, or wandering.

    Raises InputError, NoWay.
    """
    world = load_level(level)
    if river and world.goal is None:
        raise InputError(f"{level}: has no [goal]; `river` needs one (position, radius)")
    crowd = [load_character(character)] * characters
    return Simulation(world, crowd, RockHop() if river else Wander(), seed)


def make_mixed(level: str | Path, characters: int, seed: int) -> Simulation:
    """So many wanderers on a level, drawn from its populations, by their shares. Raises InputError."""
    mix = Mix(load_traffic(level).population)
    people = [mix.person(seed, (c, 0), mix.choose(seed, (c, 0), [])).character for c in range(characters)]
    return Simulation(load_level(level), people, Wander(), seed)


def make_visited(level: str | Path, most: int, seed: int) -> Simulation:
    """A level that people come into and go out of, at most so many at once. Raises InputError."""
    planner = Visiting(load_traffic(level))
    return Simulation(load_level(level), [planner.mix.characters[0]] * most, planner, seed)


def make_steered(level: str | Path, character: str | Path, characters: int, seed: int) -> Simulation:
    """So many characters of one kind on a level, who go where they are told. Raises InputError."""
    return Simulation(load_level(level), [load_character(character)] * characters, Steered(), seed)
