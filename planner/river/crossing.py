"""What routes are looked for on, by one kind of character, and the search of one of them: A* over spots (planner.river.search).

On land a character walks, so land is one move from where it stands to any bank spot or to the goal, as long as the shortest
way; over water it steps from spot to spot.
"""

from dataclasses import dataclass

import numpy as np

from motion.characters.character import Character
from planner.planner import NoWay
from planner.river import moves, search
from planner.river.land import Ways, land_for
from planner.river.search import State
from planner.river.spots import Spots
from planner.stepping.beside import Place
from worlds.world import World

START, GOAL = -1, -2
MOST_BANKS = 2000
"""Places along the banks among which the narrowest gap is looked for."""


class Country:
    """What the routes of one kind of character are looked for on: spots, and land."""

    def __init__(self, world: World, character: Character) -> None:
        """Raises InputError for a world too large, or with too many places."""
        self.world, self.character = world, character
        self.spots, self.land = Spots.of(world, character), land_for(world, character)
        self.cells = [self.land.cell(x, y) if self.spots.rock[k] < 0 else None for k, (x, y, _) in enumerate(self.spots.place)]
        self._ways: dict[int, Ways | None] = {}

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

    def run(self) -> list[State]:
        """States from first to goal. Raises NoWay."""
        place = np.vstack([self.spots.place, [(*self.source, 0.0), (*self.goal, 0.0)]])
        k, cells = len(self.spots.rock), [*self.country.cells, self.land.cell(*self.source), self.land.cell(*self.goal)]
        spots = moves.Spots(place, self.spots.rock, np.array([cell or (-1, -1) for cell in cells]))
        start = self.on_spot if self.on_spot >= 0 else k
        states, reached = search.find(self.character.biped, spots, self.land.grid, start, self.foot)
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
