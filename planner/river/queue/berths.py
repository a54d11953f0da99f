"""Where those who cross together begin and end: apart, on the land behind the start and around the goal.

Both lie in an order in which nobody's way leads through another's place. Whoever begins nearest to where the water is entered
goes first: shortest ways only come nearer to it, so they keep off all who begin farther away, if these are twice as far apart
as bodies need to be. Who goes first also comes to rest farthest from the water.
"""

from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from planner.planner import fault_of_place
from planner.river.crossing import GOAL, Country
from planner.river.grid import SPACING
from planner.river.land import Ways, land_for
from planner.river.route import path_over_land
from planner.round.reservations import STRAY
from planner.stepping.strides import along
from worlds.errors import InputError
from worlds.world import World

Place = tuple[float, float]
SPREAD = (2.0, 1.4, 1.1)
"""Distances between places that are tried, in what two bodies need; below twice that, ways are looked at one by one."""
MARGIN = 0.03
"""Kept beyond what two bodies need between a place and another's way [m]."""


def room(character: Character) -> float:
    """Of a body that sways as it walks [m]."""
    biped = character.biped
    return float(biped.body.radius + STRAY * biped.gait.step_width)


def _by_distance(ways: Ways, of: np.ndarray) -> np.ndarray:
    """Places on the land to which ways lead (N, 2), the least of `of` (rows, columns) [m] first; infinite: none."""
    rows, columns = np.nonzero(np.isfinite(ways.distance) & np.isfinite(of))
    near = np.argsort(of[rows, columns], kind="stable")
    return (np.column_stack([columns[near], rows[near]]) + 0.5) * SPACING


class Cast(NamedTuple):
    """Those who look for places."""

    world: World
    kinds: list[Character]
    characters: int  # how many

    @property
    def apart(self) -> float:
        """What two bodies need between them [m]."""
        return 2 * max(room(kind) for kind in self.kinds)

    @property
    def largest(self) -> Character:
        """The one that needs the most room."""
        return max(self.kinds, key=lambda kind: float(kind.biped.body.radius))


def _cast(world: World, characters: list[Character]) -> Cast:
    return Cast(world, list({id(one.biped): one for one in characters}.values()), len(characters))


class Taken:
    """Places that are taken, with the ways that lead to them from where everyone is bound for."""

    def __init__(self, cast: Cast, back: Ways | None, spread: float) -> None:
        self.cast, self.back, self.spread = cast, back, spread
        self.places, self.lines, self.lengths = np.zeros((0, 2)), list[np.ndarray](), list[float]()

    def _way(self, place: Place) -> np.ndarray:
        """Points (N, 2) of the way there, close together."""
        if self.back is None or self.spread >= SPREAD[0]:
            return np.zeros((0, 2))
        line = self.back.polyline(self.cast.world, *place)
        return along(line, np.arange(0.0, np.hypot(*np.diff(line, axis=0).T).sum(), MARGIN))[0]

    def take(self, place: Place) -> bool:
        """Takes a place, if it is far from the others, and neither it nor another place lies in the way of whom goes before."""
        x, y = place
        if (np.hypot(*(self.places - place).T) < self.spread * self.cast.apart).any():
            return False
        line, length = self._way(place), self.back.lengths([self.back.land.cell(x, y)])[0] if self.back else 0.0
        for k, other in enumerate(self.places):
            way, who = (self.lines[k], place) if self.lengths[k] <= length else (line, other)
            if len(way) and np.hypot(*(way - who).T).min() < self.cast.apart + MARGIN:
                return False
        self.places = np.vstack([self.places, place])
        self.lines.append(line)
        self.lengths.append(length)
        return True


def _places(cast: Cast, first: Place, heading: float, cells: np.ndarray, back: Ways | None = None) -> np.ndarray:
    """(C, 2): the first place, then the first of cells (N, 2) that lie apart and where each can stand. Raises InputError.

    back: ways from where all of them are bound for.
    """
    most = 1
    for spread in SPREAD:
        taken = Taken(cast, back, spread)
        taken.take(first)
        for x, y in cells.tolist():
            if len(taken.places) == cast.characters:
                return taken.places
            if not any(fault_of_place(cast.world, kind, (x, y, heading)) for kind in cast.kinds):
                taken.take((x, y))
        most = max(most, len(taken.places))
    if most == cast.characters:
        return taken.places
    raise InputError(
        f"{cast.world.name}: {cast.characters} characters: only {most} can stand apart around ({first[0]:g}, {first[1]:g}); "
        "use fewer --characters, or a level with more room"
    )


def _entry(world: World, character: Character) -> Place:
    """Where the first one enters the water, or the goal where there is none on its way. Raises NoWay."""
    goal = world.goal or world.start
    country = Country(world, character)
    then = path_over_land(country, world.start, goal)[1]
    x, y = goal if then.spot == GOAL else country.spots.place[then.spot, :2].tolist()
    return x, y


def starts(world: World, characters: list[Character]) -> np.ndarray:
    """(C, 3) x, y, heading: the first at the world's start, the others behind it. Raises InputError, NoWay."""
    found = np.array([world.start], np.float64)
    if len(characters) > 1:
        cast = _cast(world, characters)
        land, entry = land_for(world, cast.largest), _entry(world, characters[0])
        ways, back = land.ways_from(*world.start), land.ways_from(*entry)
        cells = np.zeros((0, 2))
        if ways is not None and back is not None:
            mine = back.lengths([land.cell(*world.start)])[0]
            cells = _by_distance(ways, np.where(back.distance >= mine, ways.distance, np.inf))
        found = _places(cast, world.start, world.start_heading, cells, back)
        if back is not None:
            found = found[np.argsort(back.lengths([land.cell(*place) for place in found.tolist()]), kind="stable")]
    return np.column_stack([found, np.full(len(found), world.start_heading)])


def ends(world: World, characters: list[Character], goal: Place, came: Place) -> np.ndarray:
    """(C, 2) places to come to rest, around the goal: the farther from where they came, the earlier. Raises InputError."""
    if len(characters) == 1:
        return np.array([goal], np.float64)
    cast, way = _cast(world, characters), np.subtract(goal, came)
    ways = land_for(world, cast.largest).ways_from(*goal)
    cells = np.zeros((0, 2)) if ways is None else _by_distance(ways, ways.distance)
    found = _places(cast, goal, float(np.arctan2(way[1], way[0])), cells)
    return found[np.argsort(-(found @ way), kind="stable")]
