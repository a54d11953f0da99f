"""What routes are looked for on, by one kind of character, and the search of one of them: A* over spots (planner.river.search).

On land a character walks, so land is one move from where it stands to any bank spot or to the goal, as long as the shortest
way; over water it steps from spot to spot.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from motion.characters.character import Character
from planner.planner import NoWay
from planner.river import search
from planner.river.land import Ways, land_for
from planner.river.search import State
from planner.river.spots import Spots
from planner.stepping.beside import Place
from worlds.errors import InputError
from worlds.world import World

START, GOAL = -1, -2
MOST_BANKS = 2000
"""Places along the banks among which the narrowest gap is looked for."""
MOST_WORK = 2e8
"""Places on banks times cells of land: shortest ways from all to all take 0.1 microseconds for each."""


class Country:
    """What the routes of one kind of character to some goals are looked for on: spots, land, and how far it is over it."""

    def __init__(self, world: World, character: Character, goals: list[Place]) -> None:
        """Raises InputError for a world too large, or with too many places."""
        self.world, self.character, self.goals = world, character, goals
        self.spots, self.land = Spots.of(world, character), land_for(world, character)
        self.banks = np.flatnonzero(self.spots.rock < 0)
        cells = self.land.free.size
        if len(self.banks) * cells > MOST_WORK:
            raise InputError(
                f"{world.name}: {len(self.banks)} places on banks times {cells} cells of land; {MOST_WORK:.2g} at most: a "
                "way is found over shorter rivers, or in a smaller world"
            )
        places = [*self.spots.place[self.banks, :2].tolist(), *goals]
        self.cells = [self.land.cell(x, y) for x, y in places]
        self._ways: dict[int, Ways | None] = {}

    @cached_property
    def lengths(self) -> np.ndarray:
        """(B, B + G) metres over land from each bank spot to each, and to the goals; infinite where no way leads."""
        found = np.full((len(self.banks), len(self.cells)), np.inf)
        for k, spot in enumerate(self.banks):
            ways = self.land.ways_from(*self.spots.place[spot, :2].tolist())
            if ways is not None:
                found[k] = ways.lengths(self.cells)
        return found

    def ways_from(self, spot: int) -> Ways | None:
        """Ways over land from a bank spot that lies on a route: they take the memory of all cells."""
        if spot not in self._ways:
            self._ways[spot] = self.land.ways_from(*self.spots.place[spot, :2].tolist())
        return self._ways[spot]


@dataclass
class Crossing:
    """What a search works on: one character that is to cross a world."""

    country: Country
    source: Place  # the walker's middle
    on_spot: int  # spot it stands on, START on land
    foot: int  # the foot that stands foremost
    goal: Place

    def __post_init__(self) -> None:
        self.world, self.character = self.country.world, self.country.character
        self.spots, self.land = self.country.spots, self.country.land
        self._ways = self.land.ways_from(*self.source)

    def ways_from(self, spot: int) -> Ways | None:
        """Ways over land from a bank spot, or from the start."""
        return self._ways if spot == START else self.country.ways_from(spot)

    def _walks(self) -> np.ndarray:
        """(K + 1, K + 1) seconds over land between bank spots; the last row is the start, the last column the goal."""
        k, banks, goal = len(self.spots.rock), self.country.banks, self.country.goals.index(self.goal)
        to = [*range(len(banks)), len(banks) + goal]
        metres = np.full((k + 1, k + 1), np.inf)
        metres[np.ix_(banks, np.append(banks, k))] = self.country.lengths[:, to]
        if self._ways is not None:
            metres[k, [*banks, k]] = self._ways.lengths(self.country.cells)[to]
        return metres * float(search.slowest_pace(self.character.biped))

    def run(self) -> list[State]:
        """States from first to goal. Raises NoWay."""
        place = np.vstack([self.spots.place, [(*self.source, 0.0), (*self.goal, 0.0)]])
        k = len(self.spots.rock)
        spots = search.Spots(place, self.spots.rock, self._walks())
        states, reached = search.find(self.character.biped, spots, self.on_spot if self.on_spot >= 0 else k, self.foot)
        if not len(states):
            raise self._no_way(set(np.flatnonzero(reached[:-2]).tolist()))
        name = {k: START, k + 1: GOAL}
        return [State(name.get(s, s), -1 if p == k else p, f, a) for s, p, f, a in states.tolist()]

    def _no_way(self, reached: set[int]) -> NoWay:
        """Names the narrowest gap between what was reached and what was not."""
        reach, name = self.character.biped.reach, self.character.name
        spots, rocks = self.spots.place, self.spots.rock
        here, rest = sorted(reached), [j for j in range(len(rocks)) if j not in reached]
        same = rocks[here][:, None] == rocks[rest][None, :] if here and rest else np.zeros((len(here), len(rest)), bool)
        found = _nearest(spots[here], spots[rest], same)
        if found is None or np.isinf(found[2]):
            return self._no_crossing()
        i, j, distance = found
        a, z = here[i], rest[j]
        gap = {
            "from": self.called(a), "to": self.called(z), "distance": distance,
            "rise": float(spots[z, 2] - spots[a, 2]), "reach": float(reach.max_leap),
        }  # fmt: skip
        return NoWay(
            f"{self.world.name}: no way across for the {name}: the gap from {gap['from']} to {gap['to']} is "
            f"{gap['distance']:.2f} m (rise {gap['rise']:+.2f} m); the {name} steps {reach.max_step:.2f} m, leaps "
            f"{reach.max_leap:.2f} m, climbs {reach.max_rise:.2f} m",
            gap,
        )

    def _no_crossing(self) -> NoWay:
        """No step leads over the water at all: names where it is narrowest."""
        reach, name, banks = self.character.biped.reach, self.character.name, self.spots.banks
        banks, ways = banks[:: max(len(banks) // MOST_BANKS, 1)], self.ways_from(START)
        cells = [self.land.cell(*place[:2]) for place in banks]
        mine = np.isfinite(ways.lengths(cells)) if ways else np.zeros(len(banks), bool)
        found = _nearest(banks[mine], banks[~mine], np.zeros((mine.sum(), (~mine).sum()), bool))
        if found is None:
            return NoWay(f"{self.world.name}: no way over land for the {name} to the goal: trees, slopes or the border bar it")
        a, z = banks[mine][found[0]], banks[~mine][found[1]]
        gap = {
            "from": _bank(a),
            "to": _bank(z),
            "distance": found[2],
            "rise": float(z[2] - a[2]),
            "reach": float(reach.max_leap),
        }
        return NoWay(
            f"{self.world.name}: no way across for the {name}: the water is {found[2]:.2f} m wide from {gap['from']} to "
            f"{gap['to']}, where it is narrowest, with no rock in reach; the {name} leaps {reach.max_leap:.2f} m",
            gap,
        )

    def called(self, spot: int) -> str:
        """A spot in words."""
        x, y = self.spots.place[spot, :2]
        rock = self.spots.rock[spot]
        return f"rock {rock} at ({x:.2f}, {y:.2f})" if rock >= 0 else _bank(self.spots.place[spot])


def _bank(place: np.ndarray) -> str:
    return f"the bank at ({place[0]:.2f}, {place[1]:.2f})"


def _nearest(here: np.ndarray, there: np.ndarray, never: np.ndarray) -> tuple[int, int, float] | None:
    """Which of these places (N, 3) and those (M, 3) are nearest to each other, and how far [m], but for some pairs (N, M)."""
    if not len(here) or not len(there):
        return None
    d = np.hypot(here[:, None, 0] - there[None, :, 0], here[:, None, 1] - there[None, :, 1])
    d[never] = np.inf
    i, j = np.unravel_index(int(d.argmin()), d.shape)
    return int(i), int(j), float(d[i, j])
