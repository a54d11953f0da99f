"""The planner of river crossers: a route for everyone, found once and again whenever the world or goal changes."""

from math import hypot

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import Footprints, Step, walker_headings
from planner.planner import NoWay, Situation, check_goal
from planner.river.crossing import Country
from planner.river.queue import berths, parking
from planner.river.queue.queueing import PLANNING
from planner.river.queue.routes import Routes, empty_routes, put_route
from planner.river.route import path_over_land, route
from planner.river.search import State
from worlds.compiled.tables import picked
from worlds.errors import InputError
from worlds.world import World

MOST = 500
"""More than that find no room on a bank, and a route is looked for for each of them."""


class RockHop:
    """Everyone crosses to the world's goal, on its rocks where there is water, one behind the other where that is narrow."""

    name = "RockHop"
    planning = PLANNING
    looks = 12.0
    """So far lie the ends of most leaps in a row [m]."""

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading: the first at the world's start, the others apart behind it. Raises InputError for too many."""
        if len(characters) > MOST:
            raise InputError(f"{len(characters)} characters: at most {MOST} cross from one start")
        return berths.starts(world, characters)

    def prepare(self, situation: Situation) -> Routes:
        """A route for each. Raises NoWay, InputError for a goal where nobody can stand."""
        world, characters = situation.world, situation.characters
        kinds = {id(one.biped): one for one in characters}
        for kind in kinds.values():
            check_goal(world, kind)
        countries = {key: Country(world, kind) for key, kind in kinds.items()}
        turn, ends = self._in_turn(situation, countries)
        found = self._routes(situation, countries, ends)
        if situation.before is not None:
            turn = _by_length(found)
        plans = empty_routes(len(characters), max(len(steps) for steps in found))._replace(ends=ends, turn=turn)
        plans.goal[:] = world.goal or world.start
        for c, steps in enumerate(found):
            put_route(plans, world, characters[c], c, steps)
        return plans

    def reconsider(self, situation: Situation) -> Routes | None:
        """Other plans where crossers wait for each other: those on land make room first, then they begin again, one by one."""
        plans, characters = situation.before, situation.characters
        if len(characters) == 1 or not parking.nothing_moves(plans):
            return None
        plans.idle[:] = 0
        begin = bool(plans.parked.any())
        left = np.flatnonzero(plans.parked if begin else ~parking.is_over(plans))
        left = left[np.argsort(plans.turn[left], kind="stable")]
        countries = {id(one.biped): Country(situation.world, one) for one in characters}
        try:
            found = self._routes(situation, countries, plans.ends)
            if not begin:
                left = left[np.argsort(_by_length([found[c] for c in left]), kind="stable")]
                afloat = situation.feet.rock[left].max(axis=1) >= 0
                left = np.concatenate([left[afloat], left[~afloat]])
            away = {} if begin else parking.places(situation, {c: found[c] for c in left.tolist()})
            ways = self._routes(situation, countries, parking.ends_of(plans, away))
        except (NoWay, InputError):
            return None  # they wait on
        return parking.other_routes(situation, {c: ways[c] for c in left.tolist()}, away)

    def _routes(self, situation: Situation, countries: dict[int, Country], ends: np.ndarray) -> list[list[Step]]:
        """Each one's steps to where it comes to rest, ends (C, 2), with the two that it stands on. Raises NoWay."""
        paths, found = self._paths(situation, countries), []
        for c, character in enumerate(situation.characters):
            feet, key = picked(situation.feet, c), id(character.biped)
            place = (float(ends[c, 0]), float(ends[c, 1]))
            found.append([*_under(feet), *route(countries[key], feet, place, paths.get(key))])
        return found

    def _paths(self, situation: Situation, countries: dict[int, Country]) -> dict[int, list[State]]:
        """Those who begin together cross in one file, the way of the first of their kind. Raises NoWay."""
        if situation.before is not None or len(situation.characters) == 1:
            return {}
        world = situation.world
        return {key: path_over_land(country, world.start, world.goal or world.start) for key, country in countries.items()}

    def _in_turn(self, situation: Situation, countries: dict[int, Country]) -> tuple[np.ndarray, np.ndarray]:
        """(C,) who goes first, and (C, 2) where each comes to rest: where it was to before, unless the goal is another one.

        Whoever has the least to go to another goal goes first, and farthest beyond the water.
        """
        world, before, count = situation.world, situation.before, len(situation.characters)
        goal, turn = world.goal or world.start, np.arange(count)
        if before is not None and (before.goal == goal).all():
            return before.turn, before.ends
        came = world.start
        if before is not None and count > 1:
            turn = _by_length(self._routes(situation, countries, np.tile(goal, (count, 1))))
            middle = situation.feet.position[:, :, :2].mean(axis=(0, 1))
            came = (float(middle[0]), float(middle[1]))
        return turn, berths.ends(world, situation.characters, goal, came)[turn]

    def arrived(self, plans: Routes) -> np.ndarray:
        """(C,) whether each is at the end of its route."""
        return parking.is_over(plans) & ~plans.parked

    def check_plans(self, plans: Routes, characters: int) -> None:
        """Whether plans from a file are routes: rounds check their steps, one by one. Raises ValueError."""
        rows = plans.steps.shape[1]
        if plans.stops.shape != plans.steps.shape or not 2 <= plans.length.min() <= plans.length.max() <= rows:
            raise ValueError("plans: routes longer than their steps")
        if (np.sort(plans.turn) != np.arange(characters)).any():
            raise ValueError("plans: a turn for each is needed")
        if (plans.ashore < 1).any() or (plans.at < 1).any() or (plans.at >= plans.length).any():
            raise ValueError("plans: beyond the ends of routes")

    def values(self) -> dict:
        """It is made of nothing."""
        return {}


def _by_length(routes: list[list[Step]]) -> np.ndarray:
    """(C,) the turn of each by the length of its route: the shortest is the first."""
    lengths = [sum(hypot(z.x - a.x, z.y - a.y) for a, z in zip(steps, steps[1:], strict=False)) for steps in routes]
    turn = np.empty(len(routes), np.int64)
    turn[np.argsort(lengths, kind="stable")] = np.arange(len(routes))
    return turn


def _under(feet: Footprints) -> list[Step]:
    """The two footprints (2,) that a route begins on."""
    places = zip(feet.side.tolist(), feet.position.tolist(), walker_headings(feet).tolist(), strict=True)
    return [Step(side, x, y, heading) for side, (x, y, _), heading in places]
