"""Gates: who comes in, where each goes next, and who is gone.

People come as a Poisson process of each source's rate; where there is no room for them they wait outside, in their order. Each
goes from one waiting area of its source to the next, and then to that of its exits where it is out soonest as things are.
"""

from functools import cached_property

import numpy as np

from motion.characters.character import Character
from planner.modes.people.areas import places_in
from planner.modes.people.crowding import Grid
from planner.modes.people.mix import Mix, Person
from planner.modes.visiting import Visits
from planner.planner import Moment, fault_of_place
from planner.stepping import random
from planner.stepping.field import ways_from
from worlds.contents.polygons import inside, nearest
from worlds.contents.traffic import Traffic, corners

DUE, PLACE, PLACE_TOO, WAIT, STAY, STAY_TOO = range(210, 216)
"""Purposes of chance (planner.stepping.random)."""
INTO = 0.3
"""One goes for a place so far [m] inside its exit."""
BETTER = 0.85
"""Another exit is taken that takes less than this share of the time that the one in mind takes."""
BETTER_AT_FIRST = 1.0
"""Who has none in mind yet takes the best."""
ARRIVED = 2.25
"""Who stands within so many of its steps of its place in a waiting area has arrived: others may be in the way."""
MARGIN = 0.3
"""Nobody is put nearer to the border of an area than this [m], where it is wide enough."""


class Gates:
    """The tables of a level's traffic by numbers: areas are its waiting areas, then its exits."""

    def __init__(self, traffic: Traffic, mix: Mix) -> None:
        self.traffic, self.mix = traffic, mix
        areas = [one.area for one in traffic.waiting] + [one.area for one in traffic.exit]
        self.polygons = [corners(area) for area in areas]
        waiting, exits, people = ([one.name for one in table] for table in (traffic.waiting, traffic.exit, mix.populations))
        first = len(waiting)
        self.via = [[waiting.index(name) for name in one.via] for one in traffic.source]
        self.to = [[first + exits.index(name) for name in one.to or exits] for one in traffic.source]
        self.of = [[people.index(name) for name in one.population] for one in traffic.source]
        self.people: dict[tuple[int, int, int], Person] = {}

    @cached_property
    def sources(self) -> list[np.ndarray]:
        """Areas of the sources, each (P, 2) [m]."""
        return [corners(one.area) for one in self.traffic.source]

    def first(self, seed: int, s: int) -> float:
        """When the first comes who is not there at the beginning [s]."""
        return self.traffic.source[s].after + self._pause(seed, s, self.traffic.source[s].at_first, 1)

    def _pause(self, seed: int, s: int, serial: int, count: int) -> float:
        rate = self.traffic.source[s].rate
        u = random.uniform(seed, s, serial, DUE)
        return float(-np.log(1 - u) * count / rate) if rate > 0 else 1e12

    def population(self, seed: int, s: int, serial: int) -> int:
        """Of whom somebody is."""
        return self.mix.choose(seed, (s, serial), self.of[s])

    def draw(self, plans: Visits, seed: int, time: float) -> None:
        """Counts those who are due by now; a group is due together."""
        for s, source in enumerate(self.traffic.source):
            most = source.most if source.most is not None else np.inf
            if time == 0:
                plans.drawn[s] = min(source.at_first, most)
            while plans.due[s] <= time and plans.drawn[s] < most:
                serial = int(plans.drawn[s])
                count = self.mix.group(seed, (s, serial), self.population(seed, s, serial))
                plans.drawn[s] = min(serial + count, most)
                plans.due[s] += self._pause(seed, s, int(plans.drawn[s]), count)

    def head(self, seed: int, s: int, serial: int, before: int) -> int:
        """The first of the group of somebody, whose predecessor's group began with `before`."""
        count = self.mix.group(seed, (s, before), self.population(seed, s, before))
        return before if serial < before + count else serial

    def person(self, seed: int, s: int, serial: int, head: int) -> Person:
        """Somebody, of the population of its group's first."""
        key = (s, serial, head)
        if key not in self.people:
            self.people.clear()  # only those who wait at the door are asked for twice
            self.people[key] = self.mix.person(seed, (s, serial), self.population(seed, s, head))
        return self.people[key]


def let_out(plans: Visits, gates: Gates, moment: Moment) -> np.ndarray:
    """(K,) rows of those who are in their exits: they are gone."""
    first, gone = len(gates.traffic.waiting), []
    for a in range(first, len(gates.polygons)):
        rows = np.flatnonzero(plans.there & (plans.area == a) & (plans.rest == 0))
        out = rows[inside(gates.polygons[a], moment.place[rows])]
        plans.gone[a] += len(out)
        if len(out):
            plans.last[a] = moment.time
        gone.append(out)
    rows = np.concatenate(gone)
    plans.there[rows], plans.until[rows], plans.group[rows] = False, moment.time, -1
    return rows


def lead(plans: Visits, gates: Gates, moment: Moment, grid: Grid, thinks: bool) -> None:
    """Sets where everyone goes who is there; `thinks`: exits are weighed anew."""
    first, stops, time = len(gates.traffic.waiting), plans.stops, moment.time
    there = np.flatnonzero(plans.there)
    far = np.hypot(*(stops.stops[there, 0] - moment.place[there]).T)
    arrived = (plans.area[there] < first) & (plans.rest[there] == 0) & moment.standing[there]
    for c in there[arrived & (far < ARRIVED * np.array([_stride(moment.characters[c]) for c in there]))].tolist():
        low, high = gates.traffic.waiting[plans.area[c]].seconds
        chance = random.uniform(moment.seed, int(plans.source[c]), int(plans.serial[c]), WAIT + 100 * (1 + int(plans.stage[c])))
        plans.rest[c], plans.stage[c] = time + low + (high - low) * chance + 1e-9, plans.stage[c] + 1
    over = there[(plans.rest[there] > 0) & (plans.rest[there] <= time)]
    plans.rest[over] = 0.0
    for c in over.tolist():
        go_on(plans, gates, moment, grid, c)
    out = np.flatnonzero(plans.there & (plans.area >= first) & (plans.rest == 0))
    if thinks:
        _choose_exits(plans, gates, moment, grid, out)
    for a in range(first, len(gates.polygons)):
        rows = out[plans.area[out] == a]
        if len(rows):
            place = moment.place[rows]
            into = nearest(gates.polygons[a], place)
            ahead = into - place
            stops.stops[rows, 0] = into + INTO * ahead / np.maximum(np.hypot(*ahead.T), 1e-6)[:, None]


def go_on(plans: Visits, gates: Gates, moment: Moment, grid: Grid, c: int) -> None:
    """Where c goes next: to a place in its next waiting area, or out."""
    s, stops = int(plans.source[c]), plans.stops
    stops.start[c] = moment.place[c]
    if plans.stage[c] < len(gates.via[s]):
        a = gates.via[s][int(plans.stage[c])]
        who = (s, 64 * int(plans.serial[c]) + int(plans.stage[c]))
        stops.stops[c, 0] = _room_in(gates.polygons[a], moment, who, moment.characters[c])
        stops.again[c] = False
    else:
        a = gates.to[s][0]
        stops.again[c] = True
        plans.area[c] = a
        _choose_exits(plans, gates, moment, grid, np.array([c]), BETTER_AT_FIRST)
        a = int(plans.area[c])
    plans.area[c], stops.field[c, 0] = a, a


def _choose_exits(
    plans: Visits, gates: Gates, moment: Moment, grid: Grid, rows: np.ndarray, better: float = BETTER
) -> None:  # fmt: skip
    """Rows (K,) take another exit where that is better."""
    every, fields = np.arange(len(grid.area))[:, None], plans.stops.fields
    ways = ways_from(fields, grid.cell, every, moment.place[rows])
    for k, c in enumerate(rows.tolist()):
        of = gates.to[int(plans.source[c])]
        best = of[int(np.argmin(ways[of, k]))]
        if ways[best, k] < better * ways[plans.area[c], k]:
            plans.area[c] = plans.stops.field[c, 0] = best


def _stride(character: Character) -> float:
    return float(character.biped.gait.preferred_step)


def _room_in(polygon: np.ndarray, moment: Moment, who: tuple[int, int], character: Character) -> np.ndarray:
    """(2,) a place in an area where somebody can stand, by chance; its middle where none is found."""
    for place in places_in(polygon, moment.seed, who, STAY, MARGIN):
        if fault_of_place(moment.world, character, (*place.tolist(), 0.0)) is None:
            return place
    return polygon.mean(axis=0)
