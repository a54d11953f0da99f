"""A route over rocks: A* over (spot, spot before, foot), from the start over land and rocks to the goal (paper, section 4).

On land a character walks, so land is one move from where it stands to any bank spot or to the goal, as long as the shortest
way; over water it steps from spot to spot. The state holds the spot before, so that turns count exactly. The heuristic is
the straight distance at the fastest speed any move has, so the first route found costs least.
"""

from dataclasses import dataclass

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.character import Character
from motion.track.footprints import Footprints, Step
from planner.planner import NoWay
from planner.river import search
from planner.river.land import Land, Ways
from planner.river.search import State
from planner.river.spots import Spots
from planner.stepping import strides
from planner.stepping.beside import Place, middle_of
from worlds.world import World

START, GOAL = -1, -2
MARGIN = 0.08


@dataclass
class Crossing:
    """What a search works on: one character that is to cross a world."""

    world: World
    character: Character
    source: Place  # the walker's middle
    on_spot: int  # spot it stands on, START on land
    foot: int  # the foot that stands foremost

    def __post_init__(self) -> None:
        self.spots = Spots.of(self.world, self.character)
        self.land = Land.of(self.world, float(self.character.biped.body.radius) + MARGIN)
        self.offset = self.spots.place[None, :, :] - self.spots.place[:, None, :]
        self.distance = np.hypot(self.offset[:, :, 0], self.offset[:, :, 1])
        self.ways: dict[int, Ways | None] = {}
        self.goal = self.world.goal or self.source

    def ways_from(self, spot: int) -> Ways | None:
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
        pace = float(search.slowest_pace(self.character.biped))
        seconds = np.full((k + 1, k + 1), np.inf)
        for i in [*banks, START]:
            ways = self.ways_from(int(i))
            if ways is not None:
                seconds[i, [*banks, k]] = ways.lengths([*cells, goal]) * pace
        return seconds

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
        rest = [j for j in range(len(self.spots.rock)) if j not in reached]
        here = sorted(reached)
        if not rest or not here:
            return NoWay(f"{self.world.name}: no way for the {name} to the goal, and no rocks or banks in reach")
        d = self.distance[np.ix_(here, rest)]
        rocks = self.spots.rock
        same = rocks[here][:, None] == rocks[rest][None, :]
        d = np.where(same, np.inf, d)
        i, j = np.unravel_index(int(d.argmin()), d.shape)
        a, z = here[int(i)], rest[int(j)]
        gap = {
            "from": self.called(a), "to": self.called(z), "distance": float(d[i, j]),
            "rise": float(self.offset[a, z, 2]), "reach": float(reach.max_leap),
        }  # fmt: skip
        return NoWay(
            f"{self.world.name}: no way across for the {name}: the gap from {gap['from']} to {gap['to']} is "
            f"{gap['distance']:.2f} m (rise {gap['rise']:+.2f} m); the {name} steps {reach.max_step:.2f} m, leaps "
            f"{reach.max_leap:.2f} m, climbs {reach.max_rise:.2f} m",
            gap,
        )

    def called(self, spot: int) -> str:
        """A spot in words."""
        x, y = self.spots.place[spot, :2]
        rock = self.spots.rock[spot]
        return f"rock {rock} at ({x:.2f}, {y:.2f})" if rock >= 0 else f"the bank at ({x:.2f}, {y:.2f})"


def route(world: World, character: Character, feet: Footprints) -> list[Step]:
    """Steps to the goal, where both feet end, after the two footprints (2,) that the character stands on. Raises NoWay."""
    side, place, heading = int(feet.side[1]), feet.position[1], float(feet.heading[1])
    at = (float(place[0]), float(place[1]))
    crossing = Crossing(world, character, middle_of(character.biped, side, at, heading), START, side)
    if feet.rock[1] >= 0 and len(crossing.spots.rock):
        offsets = crossing.spots.place[:, :2] - at
        crossing.on_spot = int(np.hypot(*offsets.T).argmin())
    steps = [Step(side, *at, heading)]
    path = crossing.run()
    for before, state in zip(path, path[1:], strict=False):
        _append_move(crossing, before, state, steps)
    last = steps[-1]
    middle = middle_of(character.biped, last.side, (last.x, last.y), last.heading)
    return [*steps[1:], strides.step_beside(character.biped, 1 - last.side, middle, last.heading)]


def _append_move(crossing: Crossing, before: State, state: State, steps: list[Step]) -> None:
    biped, last = crossing.character.biped, steps[-1]
    if state.spot == GOAL or not state.arrived:
        target = crossing.goal if state.spot == GOAL else tuple(crossing.spots.place[state.spot, :2].tolist())
        ways = crossing.ways_from(before.spot)
        assert ways is not None  # the search has walked it
        line = ways.polyline(crossing.world, *target)
        line[0] = middle_of(biped, last.side, (last.x, last.y), last.heading)
        wanted = None if state.spot == GOAL else state.foot
        steps += strides.walk(biped, line, last.heading, 1 - last.side, wanted)
        if state.spot != GOAL:
            steps[-1] = steps[-1]._replace(x=target[0], y=target[1])
    else:
        x, y = crossing.spots.place[state.spot, :2].tolist()
        steps.append(Step(state.foot, x, y, np.nan))
        i = len(steps) - 1
        if before.before >= 0:
            _face(steps, i - 1, i - 2, i)
        _face(steps, i, max(i - 2, 0) if before.before >= 0 else i - 1, i)


def _face(steps: list[Step], i: int, came_from: int, goes_to: int) -> None:
    """Heading of step i: along the way from one footprint to another, unwrapped against the one before."""
    ahead = np.arctan2(steps[goes_to].y - steps[came_from].y, steps[goes_to].x - steps[came_from].x)
    heading = steps[i - 1].heading
    steps[i] = steps[i]._replace(heading=float(heading + wrapped(ahead - heading)))
