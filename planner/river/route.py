"""A route over rocks: A* over (spot, spot before, foot), from the start over land and rocks to the goal (paper, section 4).

On land a character walks, so land is one move from where it stands to any bank spot or to the goal, as long as the shortest
way; over water it steps from spot to spot. The state holds the spot before, so that turns count exactly. The heuristic is
the straight distance at the fastest speed any move has, so the first route found costs least.
"""

from dataclasses import dataclass

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.character import Character
from motion.track.footprints import Foot, Footprints, Step
from planner.planner import NoWay
from planner.river import search
from planner.river.land import Land, Ways
from planner.river.search import State
from planner.river.spots import Spots
from planner.stepping import footing, strides
from planner.stepping.beside import Place, middle_of
from worlds import queries
from worlds.world import World

START, GOAL = -1, -2
MARGIN = 0.08
STRIDES = (1.0, 0.75, 0.55, 0.4)
"""Steps over land in preferred ones: as long as the ground allows."""
MOST_BANKS = 2000
"""Places along the banks among which the narrowest gap is looked for."""


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
        self.land = Land.of(self.world, self.character.biped, float(self.character.biped.body.radius) + MARGIN)
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
    steps.append(strides.step_beside(character.biped, 1 - last.side, middle, last.heading))
    _keep_standing(crossing, steps)
    return steps[1:]


def _keep_standing(crossing: Crossing, steps: list[Step]) -> None:
    """Moves each step onto land on which the foot may not stand to the nearest place on which it may. Raises NoWay."""
    biped, world = crossing.character.biped, crossing.world.arrays
    for k in range(1, len(steps)):
        step, before = steps[k], steps[k - 1]
        foot = Foot(before.side, before.x, before.y, before.heading, 0.0, 0.0)
        why = footing.why_not_step(biped, world, foot, step.x, step.y, step.heading)
        if why == footing.FINE or step.side == before.side or queries.rock_under(world, step.x, step.y, 0.0) >= 0:
            continue
        middle = middle_of(biped, step.side, (step.x, step.y), step.heading)
        (x, y), heading = footing.nearest_footing(biped, world, foot, middle, step.heading)
        if np.isinf(heading):
            place = f"({step.x:.2f}, {step.y:.2f})"
            name = crossing.character.name
            raise NoWay(f"{crossing.world.name}: no way for the {name}: its foot at {place} {footing.WORDS[why]}")
        steps[k] = step._replace(x=x, y=y, heading=heading)


def _append_move(crossing: Crossing, before: State, state: State, steps: list[Step]) -> None:
    biped, last = crossing.character.biped, steps[-1]
    if state.spot == GOAL or not state.arrived:
        target = crossing.goal if state.spot == GOAL else tuple(crossing.spots.place[state.spot, :2].tolist())
        ways = crossing.ways_from(before.spot)
        assert ways is not None  # the search has walked it
        line = ways.polyline(crossing.world, *target)
        line[0] = middle_of(biped, last.side, (last.x, last.y), last.heading)
        wanted = None if state.spot == GOAL else state.foot
        steps += _walked(crossing, line, last, wanted)
        if state.spot != GOAL:
            steps[-1] = steps[-1]._replace(x=target[0], y=target[1])
    else:
        x, y = crossing.spots.place[state.spot, :2].tolist()
        steps.append(Step(state.foot, x, y, np.nan))
        i = len(steps) - 1
        if before.before >= 0:
            _face(steps, i - 1, i - 2, i)
        _face(steps, i, max(i - 2, 0) if before.before >= 0 else i - 1, i)


def _walked(crossing: Crossing, line: np.ndarray, last: Step, wanted: int | None) -> list[Step]:
    """Steps along a line, shorter where the preferred ones would rise or fall too far."""
    biped, world = crossing.character.biped, crossing.world.arrays
    for stride in STRIDES:
        found = strides.walk(biped, line, last.heading, 1 - last.side, wanted, stride)
        why = {
            footing.why_not_step(biped, world, Foot(a.side, a.x, a.y, a.heading, 0.0, 0.0), z.x, z.y, z.heading)
            for a, z in zip([last, *found], found, strict=False)
        }
        if not why & {footing.HIGH, footing.DEEP}:
            break
    return found


def _face(steps: list[Step], i: int, came_from: int, goes_to: int) -> None:
    """Heading of step i: along the way from one footprint to another, unwrapped against the one before."""
    ahead = np.arctan2(steps[goes_to].y - steps[came_from].y, steps[goes_to].x - steps[came_from].x)
    heading = steps[i - 1].heading
    steps[i] = steps[i]._replace(heading=float(heading + wrapped(ahead - heading)))
