"""What a planner is: the one seam by which footprints are chosen.

A planner says where everyone starts, prepares what its steps need to know of the world, and is then asked, step by step, what a
character wishes to do next: `next_step(round, me) -> Wish`. Rounds ask for real footprints, and for the tentative ones behind
them; they lay them on the ground, time them, make way for others and move the body. Crowds, rounds and saved states know
planners by this file alone.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import LEFT, RIGHT, SIDES, Footprints
from planner.round.kernel import Planning
from planner.round.refusals import TURNED
from planner.stepping.beside import beside, sole_heading
from planner.stepping.footing import FINE, WORDS, why_not_stand
from worlds import queries
from worlds.errors import InputError
from worlds.limits import numbers
from worlds.world import World


class Situation(NamedTuple):
    """Where C characters are when a planner prepares, at the start, and again whenever the world has changed."""

    world: World
    characters: list[Character]  # C of them
    feet: Footprints  # (C, 2) the last two footprints of each
    number: np.ndarray  # (C,) of the step that is planned next
    seed: int
    before: Any = None  # the plans so far; None at the start


class Moment(NamedTuple):
    """What a planner knows that lets people come and go; C rows, of whom some are there."""

    time: float  # [s]
    seed: int
    world: World
    characters: list[Character]  # who is, or was, in each row
    place: np.ndarray  # (C, 2) of the centres of mass [m]
    between: np.ndarray  # (C, 2) between their feet before the last step, where the bodies pass on their way to rest [m]
    rest: np.ndarray  # (C, 2) where the bodies come to rest [m]
    standing: np.ndarray  # (C,) bool


class Coming(NamedTuple):
    """One who comes into a free row, and stands there with its feet to either side of a place."""

    row: int
    character: Character
    x: float  # [m]
    y: float
    heading: float  # [rad]


class Turnover(NamedTuple):
    """Who goes and who comes, at once."""

    gone: np.ndarray  # (K,) rows
    come: list[Coming]


class NoWay(Exception):
    """The task itself cannot be done. `gap` tells what stops it: from, to, distance [m], reach [m], where one is known."""

    def __init__(self, message: str, gap: dict | None = None) -> None:
        super().__init__(message)
        self.gap = gap


class Planner(Protocol):
    """A way of choosing footprints."""

    name: str
    """By which saved states know it."""

    @property
    def planning(self) -> Planning:
        """How next_step is called: planner.round.kernel.Compiled, or Interpreted."""

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y [m], heading [rad] where each character stands at first. Raises InputError."""

    def prepare(self, situation: Situation) -> Any:
        """What steps need to know: None, or a NamedTuple of arrays over characters, which rounds hand to next_step.

        All that the planner remembers lies in it, so it is saved with the crowd. Raises NoWay, and then nothing has changed.
        """

    def values(self) -> dict:
        """What the planner was made with, as plain JSON values: keyword arguments of its class."""

    # A planner whose steps' headings are those of the soles, to the letter, has lays_soles = True; else they are the walker's,
    # whose toes point outward as its character says. One that remembers may have check_plans(plans, characters), which raises
    # ValueError for plans of a file that it has not made: wrong shapes, or numbers that it would index by; arrived(plans),
    # which tells (C,) who has come to where it was to go, where not all fit onto the world's goal; and looks [m], how far its
    # steps ask for others at least.
    # One that changes its mind has reconsider(situation), asked some times a second, which returns other plans, or None.
    # One that lets people come and go has come_and_go(plans, Moment) -> Turnover, asked at times; there(plans, time),
    # which tells (C,) who is there; and counts(plans), a table for the run's summary. Everyone is away at first.


def as_numbers(values: Any, what: str) -> np.ndarray:
    """A copy of them as an array. Raises InputError for what are none, not finite, or of unequal shape."""
    return numbers(values, what).copy()


def checked_starts(starts: Any, world: World, characters: list[Character]) -> np.ndarray:
    """starts, which must be (C, 3) finite x, y, heading of places where the bodies fit and the feet may stand.

    One for each character. Raises InputError.
    """
    places = as_numbers(starts, "starts")
    if places.ndim != 2 or places.shape[1] != 3 or not np.isfinite(places).all():
        raise InputError(f"starts of shape {np.shape(places)}: (C, 3), finite numbers x, y [m], heading [rad], are needed")
    if len(places) != len(characters):
        raise InputError(f"{len(places)} starts for {len(characters)} characters: one for each is needed")
    if np.abs(places[:, 2]).max() > TURNED:
        raise InputError(f"starts: headings up to {np.abs(places[:, 2]).max():g} rad; {TURNED:g} at most is allowed")
    found, near = np.empty((len(places), 4)), _doubtful(world, characters)
    queries.survey(world.arrays, np.ascontiguousarray(places[:, :2]), found)
    for c, (x, y, _) in enumerate(places.tolist()):
        if not (0 <= x <= world.size[0] and 0 <= y <= world.size[1]):
            inside = f"0..{world.size[0]:g} by 0..{world.size[1]:g} is allowed"
            raise InputError(f"starts.{c} at ({x:g}, {y:g}): is outside the world; {inside}")
        if min(x, y, world.size[0] - x, world.size[1] - y, *found[c, 1:].tolist()) < near:
            fault = fault_of_place(world, characters[c], places[c].tolist())
            if fault:
                raise InputError(f"starts.{c} at ({x:g}, {y:g}): {fault}")
    return places


def _doubtful(world: World, characters: list[Character]) -> float:
    """Who starts nearer than this [m] to anything, or to the border, needs to be looked at; on uneven ground everyone does."""
    if world.terrain != "flat" or len(world.rocks):
        return np.inf
    bipeds = {id(character.biped): character.biped for character in characters}.values()
    soles = (0.5 * (np.hypot(b.foot.length, b.foot.width) + b.gait.step_width) for b in bipeds)
    return float(max([*soles, *(b.body.radius for b in bipeds)]))


def fault_of_place(world: World, character: Character, place: Sequence[float]) -> str | None:
    """Why a character cannot stand at a place x, y [m] with a heading [rad]: its body does not fit, or a foot; or None."""
    biped, (x, y, heading) = character.biped, place
    solid = min(queries.tree_clearance(world.arrays, x, y), queries.wall_clearance(world.arrays, x, y))
    room = min(queries.border_clearance(world.arrays, x, y), solid)
    if room < biped.body.radius:
        near = f"{room:.2f} m to the border, a tree or a wall, {biped.body.radius:g} m or more is needed"
        return f"no room for the body of the {character.name}: {near}"
    for side in (LEFT, RIGHT):
        sole = sole_heading(biped, side, heading)
        why = why_not_stand(biped, world.arrays, *beside(biped, side, (x, y), heading), sole)
        if why != FINE:
            return f"the {SIDES[side]} foot of the {character.name} {WORDS[why]}"
    return None


def fault_of_goal(world: World, character: Character) -> str | None:
    """Why a character cannot come to rest at the world's goal, whichever way it faces; None where it can, or there is none."""
    if world.goal is None:
        return None
    way = np.subtract(world.goal, world.start)
    ahead = float(np.arctan2(way[1], way[0]))
    faults = [fault_of_place(world, character, (*world.goal, ahead + turn)) for turn in FACING]
    return faults[0] if all(faults) else None


def check_goal(world: World, character: Character) -> None:
    """Raises InputError where a character cannot come to rest at the world's goal."""
    fault = fault_of_goal(world, character)
    if fault and world.goal is not None:
        raise InputError(f"{world.name}: goal at ({world.goal[0]:g}, {world.goal[1]:g}): {fault}; move the goal")


FACING = tuple(k * np.pi / 4 for k in range(8))
"""Ways to face at a goal that are tried, off the straight way to it."""
