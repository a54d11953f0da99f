"""Rock hopping: A* over (spot, spot before, foot), from the start over land and rocks to the goal (paper, section 4).

On land a character walks, so land is one move from where it stands to any bank spot or to the goal, as long as the shortest
way; over water it steps from spot to spot. The state holds the spot before, so that turns count exactly. The heuristic is
the straight distance at the fastest speed any move has, so the first route found costs least.
"""

from dataclasses import dataclass

import numpy as np

from motion.characters.biped import Biped
from planner import plan
from planner.river import search
from planner.river.land import Land
from planner.river.spots import Spots
from planner.stepping import strides
from worlds.world import World

START, GOAL = -1, -2
MARGIN = 0.08


class NoWay(Exception):
    """The task itself cannot be done. `gap` tells what stops it: from, to, distance [m], reach [m], where one is known."""

    def __init__(self, message: str, gap: dict | None = None) -> None:
        super().__init__(message)
        self.gap = gap


@dataclass
class _Search:
    world: World
    biped: Biped
    source: tuple[float, float]  # the walker's middle
    on_spot: int  # spot it stands on, START on land
    foot: int  # the foot that stands foremost

    def __post_init__(self) -> None:
        b = self.biped.record
        self.spots = Spots.of(self.world, self.biped)
        self.land = Land.of(self.world, float(b.body_radius) + MARGIN)
        self.offset = self.spots.place[None, :, :] - self.spots.place[:, None, :]
        self.distance = np.hypot(self.offset[:, :, 0], self.offset[:, :, 1])
        self.ways: dict = {}
        self.goal = self.world.goal or self.source

    def ways_from(self, spot: int):
        """Ways over land from a bank spot, or from the start."""
        if spot not in self.ways:
            place = self.source if spot == START else tuple(self.spots.place[spot, :2])
            self.ways[spot] = self.land.ways_from(*place)
        return self.ways[spot]

    def _walks(self) -> np.ndarray:
        """(K + 1, K + 1) seconds over land between bank spots; the last row is the start, the last column the goal."""
        k = len(self.spots.rock)
        banks = np.flatnonzero(self.spots.rock < 0)
        cells = [self.land.cell(*place[:2]) for place in self.spots.place[banks]]
        goal = self.land.cell(*self.goal)
        pace = float(search.slowest_pace(self.biped.record))
        seconds = np.full((k + 1, k + 1), np.inf)
        for i in [*banks, START]:
            ways = self.ways_from(int(i))
            if ways is not None:
                seconds[i, [*banks, k]] = ways.lengths([*cells, goal]) * pace
        return seconds

    def run(self) -> list:
        """States (spot, spot before, foot, arrived) from first to goal. Raises NoWay."""
        place = np.vstack([self.spots.place, [(*self.source, 0.0), (*self.goal, 0.0)]])
        start = self.on_spot if self.on_spot >= 0 else len(self.spots.rock)
        states, reached = search.find(self.biped.record, place, self.spots.rock, self._walks(), start, self.foot)
        if not len(states):
            raise self._no_way(set(np.flatnonzero(reached[:-2]).tolist()))
        k = len(self.spots.rock)
        name = {k: START, k + 1: GOAL}
        return [(name.get(s, s), -1 if p == k else p, f, bool(a)) for s, p, f, a in states.tolist()]

    def _no_way(self, reached: set[int]) -> NoWay:
        """Names the narrowest gap between what was reached and what was not."""
        b, name = self.biped.record, self.biped.name
        rest = [j for j in range(len(self.spots.rock)) if j not in reached]
        here = sorted(reached)
        if not rest or not here:
            return NoWay(f"{self.world.name}: no way for the {name} to the goal, and no rocks or banks in reach")
        d = self.distance[np.ix_(here, rest)]
        rocks = self.spots.rock
        same = rocks[here][:, None] == rocks[rest][None, :]
        d = np.where(same, np.inf, d)
        i, j = np.unravel_index(int(d.argmin()), d.shape)
        a, z = here[i], rest[j]
        gap = {
            "from": self.called(a), "to": self.called(z), "distance": float(d[i, j]),
            "rise": float(self.offset[a, z, 2]), "reach": float(b.max_leap),
        }  # fmt: skip
        return NoWay(
            f"{self.world.name}: no way across for the {name}: the gap from {gap['from']} to {gap['to']} is "
            f"{gap['distance']:.2f} m (rise {gap['rise']:+.2f} m); the {name} steps {b.max_step:.2f} m, leaps "
            f"{b.max_leap:.2f} m, climbs {b.max_rise:.2f} m",
            gap,
        )

    def called(self, spot: int) -> str:
        """A spot in words."""
        x, y = self.spots.place[spot, :2]
        rock = self.spots.rock[spot]
        return f"rock {rock} at ({x:.2f}, {y:.2f})" if rock >= 0 else f"the bank at ({x:.2f}, {y:.2f})"


def route(world: World, biped: Biped, standing: np.ndarray) -> np.ndarray:
    """Footprints (R, 4): side, x, y, heading (unwrapped) after the two it stands on, to the goal, where both feet end.

    standing (2, 5): side, x, y, heading, rock of the last two footprints. Raises NoWay.
    """
    side, x, y, heading, rock = standing[1]
    middle = plan.middle_of(biped.record, int(side), x, y, heading)
    crossing = _Search(world, biped, middle, START, int(side))
    if rock >= 0 and len(crossing.spots.rock):
        offsets = crossing.spots.place[:, :2] - (x, y)
        crossing.on_spot = int(np.hypot(*offsets.T).argmin())
    prints: list[list[float]] = [[side, x, y, heading]]
    path = crossing.run()
    for before, state in zip(path, path[1:], strict=False):
        _append_move(crossing, before, state, prints)
    last = prints[-1]
    middle = plan.middle_of(biped.record, int(last[0]), last[1], last[2], last[3])
    prints.append(strides.beside(biped.record, 1 - int(last[0]), middle, last[3]))
    return np.array(prints[1:])


def _append_move(crossing: _Search, before, state, prints: list) -> None:
    spot, _, foot, arrived = state
    if spot == GOAL or not arrived:
        last = prints[-1]
        target = crossing.goal if spot == GOAL else tuple(crossing.spots.place[spot, :2])
        line = crossing.ways_from(before[0]).polyline(crossing.world, *target)
        line[0] = plan.middle_of(crossing.biped.record, int(last[0]), last[1], last[2], last[3])
        wanted = None if spot == GOAL else foot
        prints += strides.walk(crossing.biped, line, last[3], 1 - int(last[0]), wanted)
        if spot != GOAL:
            prints[-1][1:3] = target
    else:
        prints.append([foot, *crossing.spots.place[spot, :2], np.nan])
        i = len(prints) - 1
        if before[1] >= 0:
            _face(prints, i - 1, i - 2, i)
        _face(prints, i, max(i - 2, 0) if before[1] >= 0 else i - 1, i)


def _face(prints: list, i: int, came_from: int, goes_to: int) -> None:
    """Heading of footprint i: along the way from one footprint to another, unwrapped against the one before."""
    ahead = np.arctan2(prints[goes_to][2] - prints[came_from][2], prints[goes_to][1] - prints[came_from][1])
    prints[i][3] = prints[i - 1][3] + strides.wrapped(ahead - prints[i - 1][3])


class RockHop:
    """The planner of river crossers: a route for everyone, found once and again whenever the world or goal changes."""

    def starts(self, world: World, characters: list[Biped], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading: all at the world's start."""
        return np.array([(*world.start, world.start_heading)] * len(characters), np.float64)

    def prepare(self, world, characters, standing, begin, seed) -> plan.Plans:
        """Plans with a route for each; standing (C, 2, 5). Raises NoWay."""
        routes = [route(world, character, standing[c]) for c, character in enumerate(characters)]
        plans = plan.plans_of(plan.ROUTE, len(characters), max(len(r) for r in routes), 1)
        for c, found in enumerate(routes):
            plans.route[c, : len(found)] = found
            plans.route_length[c], plans.route_begin[c] = len(found), begin[c]
        return plans
