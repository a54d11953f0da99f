"""Who comes: people drawn from populations by chance, each with a speed, a size and a time of reaction of its own.

Speeds that people prefer are normal, N(1.34, 0.26^2) m/s (Weidmann 1993), here cut at CUT deviations, which keeps the mean; or
they go by age and sex: uniform within the ranges of the IMO (MSC.1/Circ.1533, table 3.4, walking on the flat). Whoever prefers
a speed takes the steps to which its timing (planner.stepping.timing) gives it: shorter and slower ones, or longer and quicker.
"""

from functools import cache
from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from motion.characters.character import Character, load_character
from motion.characters.checks import faults
from motion.characters.dimensions import Dimensions, empty_bipeds
from planner.modes.visiting import speeds_of
from planner.stepping import random
from worlds.contents.traffic import Population
from worlds.errors import InputError

PEOPLE = (1.34, 0.26)
"""Mean and deviation of the speed of people [m/s], where a population of humans tells nothing else."""
CUT = 2.5
"""Nothing further from the mean is drawn, in deviations."""
FINE, FINE_SIZE = 0.05, 0.04
"""Speeds [m/s] and sizes are drawn in steps of this: so that many share a kind of body."""
SHORTEST, STEPS, NEAR = 0.25, 400, 0.02
"""Nobody prefers steps shorter than this share of the character's; so many lengths are looked at; speeds come as near [m/s]."""
Range = tuple[float, float]
AGES: tuple[tuple[float, Range, Range], ...] = (
    (30.0, (0.93, 1.55), (1.11, 1.85)),
    (50.0, (0.71, 1.19), (0.97, 1.62)),
    (np.inf, (0.56, 0.94), (0.84, 1.40)),
)
"""Up to which age, and from which to which speed women and men walk [m/s]."""
POPULATION, SPEED, SIZE, AGE, SEX, REACTION, GROUP = range(200, 207)
"""Purposes of chance (planner.stepping.random)."""


class Person(NamedTuple):
    """One who comes."""

    character: Character
    speed: float  # that it prefers [m/s]
    reaction: float  # sets out so long after it has come [s]
    population: int
    age: float  # years; 0: its population tells none


class Mix:
    """Populations, by their shares. Raises InputError for characters that there are not, or that cannot be so fast."""

    def __init__(self, populations: list[Population]) -> None:
        self.populations = populations or [Population(name="people")]
        self.characters = [load_character(one.character) for one in self.populations]
        for one, character in zip(self.populations, self.characters, strict=True):
            for speed in _extremes(one, character):
                for size in (one.size[0] - CUT * one.size[1], one.size[0] + CUT * one.size[1]):
                    walker(one.character, _stepped(size, FINE_SIZE), _stepped(speed, FINE), one.name)

    def choose(self, seed: int, who: tuple[int, int], of: list[int]) -> int:
        """Which population somebody is of, among those `of` (all, where it is empty)."""
        of = of or list(range(len(self.populations)))
        shares = np.cumsum([self.populations[k].share for k in of])
        return of[int(np.searchsorted(shares, shares[-1] * random.uniform(seed, *who, POPULATION), side="right"))]

    def group(self, seed: int, who: tuple[int, int], population: int) -> int:
        """With how many somebody comes, itself counted."""
        shares = np.cumsum(self.populations[population].groups or [1.0])
        return int(np.searchsorted(shares, shares[-1] * random.uniform(seed, *who, GROUP), side="right")) + 1

    def person(self, seed: int, who: tuple[int, int], population: int) -> Person:
        """Somebody of a population; who: two numbers that are its alone."""
        one, character = self.populations[population], self.characters[population]
        chance = {purpose: random.uniform(seed, *who, purpose) for purpose in range(POPULATION, GROUP)}
        age = 0.0
        if one.ages is not None:
            age, low, high = _age(one.ages, chance[AGE], chance[SEX])
            speed = low + (high - low) * chance[SPEED]
        else:
            speed = _normal(*_law(one, character), chance[SPEED])
        size = _stepped(_normal(*one.size, chance[SIZE]), FINE_SIZE)
        speed = _stepped(speed, FINE)
        reaction = one.reaction[0] + (one.reaction[1] - one.reaction[0]) * chance[REACTION]
        return Person(walker(one.character, size, speed, one.name), speed, reaction, population, age)


def _stepped(value: float, step: float) -> float:
    return round(round(value / step) * step, 6)


def _normal(mean: float, deviation: float, u: float) -> float:
    """A normal number, at most CUT deviations off its mean."""
    normal = NormalDist()
    low = normal.cdf(-CUT)
    return mean + deviation * normal.inv_cdf(low + (1 - 2 * low) * u)


def _law(one: Population, character: Character) -> tuple[float, float]:
    """Mean and deviation of the speed of a population [m/s]: people's for humans, else the character's own speed."""
    if one.speed is not None:
        return one.speed
    return PEOPLE if character.look.plan == "human" else (speed_of(character.biped), 0.0)


def _extremes(one: Population, character: Character) -> tuple[float, float]:
    """The slowest and the fastest of a population [m/s]."""
    if one.ages is not None:
        ranges = [AGES[_row(end)] for begin, end, _ in one.ages] + [AGES[_row(begin)] for begin, end, _ in one.ages]
        return min(row[1][0] for row in ranges), max(row[2][1] for row in ranges)
    mean, deviation = _law(one, character)
    return mean - CUT * deviation, mean + CUT * deviation


def _row(age: float) -> int:
    return next(k for k, row in enumerate(AGES) if age <= row[0])


def _age(ages: list[tuple[float, float, float]], u: float, sex: float) -> tuple[float, float, float]:
    """An age [years], and from which to which speed people of that age walk [m/s]."""
    shares = np.cumsum([0.0, *(share for *_, share in ages)])
    k = min(int(np.searchsorted(shares, shares[-1] * u, side="right")), len(ages)) - 1
    begin, end, share = ages[k]
    age = begin + (end - begin) * (shares[-1] * u - shares[k]) / share
    _, women, men = AGES[_row(age)]
    low, high = women if sex < 0.5 else men
    return float(age), low, high


def speed_of(biped: Dimensions) -> float:
    """The speed [m/s] at which a character walks when nothing hinders: that of its preferred step."""
    step = np.array([float(biped.gait.preferred_step)])
    return float(_speeds(biped, step)[0])


def _speeds(biped: Dimensions, steps: np.ndarray) -> np.ndarray:
    """(K,) speeds [m/s] of steps (K,) [m]."""
    bipeds, speeds = empty_bipeds(1), np.empty_like(steps)
    bipeds[0] = biped
    speeds_of(bipeds, steps, speeds)
    return speeds


@cache
def _sized(file: str, size: float) -> tuple[Character, np.ndarray, np.ndarray]:
    """A character of another size, steps of it (K,) [m], and their speeds (K,) [m/s]."""
    character = load_character(file, size)
    shortest, longest = SHORTEST * character.biped.gait.preferred_step, character.biped.reach.max_step
    steps = np.linspace(float(shortest), float(longest), STEPS)
    return character, steps, np.maximum.accumulate(_speeds(character.biped, steps))


@cache
def walker(file: str, size: float, speed: float, population: str) -> Character:
    """A character, by name or file, of another size that prefers a speed [m/s].

    Raises InputError where its steps would be too long or too short, or there is no such character.
    """
    character, steps, speeds = _sized(file, size)
    biped = character.biped.copy()  # type: ignore[attr-defined]
    biped.gait.preferred_step = np.interp(speed, speeds, steps)
    if not speeds[0] - NEAR <= speed <= speeds[-1] + NEAR or faults(biped):
        raise InputError(
            f"population {population!r}: nobody like the {character.name}, {size:g} times as large, walks at {speed:.2f} m/s; "
            f"{speeds[0]:.2f} to {speeds[-1]:.2f} m/s are allowed, {CUT:g} deviations off the mean"
        )
    return Character(character.name, biped, character.look)
