"""Rooms of the RiMEA guideline 4.1.1, with people in them, as simulations; what is made smaller is named.

People come at once, by the tables of a level's traffic, and go out; where they went is a Flow, NaN where somebody is not there.
"""

from collections.abc import Callable

import numpy as np

from planner.modes.people.mix import Mix
from planner.modes.people.visitors import Visiting
from planner.modes.walk_to import WalkTo
from planner.round.weights import Weights
from sim.reports.flows import PER_SECOND, Flow, people
from sim.stage.simulation import Simulation
from worlds.contents.traffic import Exit, Population, Source, Traffic
from worlds.world import Wall, World

SEED = 1
Line = list[tuple[float, float]]
Box = tuple[float, float, float, float]
"""x and y of a corner, x and y of the opposite one [m]."""
THIN = 0.04
"""Walls [m]."""
STAIR = (0.17, 0.29)
"""Rise and run of a step [m]."""


def box(of: Box) -> list[tuple[float, float]]:
    """The area of a box."""
    return [of[:2], of[2:]]


def walls(*lines: Line) -> tuple[Wall, ...]:
    """Thin walls along polylines [m], so that passages are hardly narrower than the lines are apart."""
    return tuple(Wall(np.array(line, float), THIN) for line in lines)


def room(of: Box, doors: list[tuple[str, float, float]]) -> tuple[Wall, ...]:
    """Walls around a box but for doors, each on a side (west, east, south, north), from and to along it [m]."""
    x0, y0, x1, y1 = of
    sides = {"west": ("y", x0, y0, y1), "east": ("y", x1, y0, y1), "south": ("x", y0, x0, x1), "north": ("x", y1, x0, x1)}
    lines: list[Line] = []
    for side, (axis, at, begin, end) in sides.items():
        gaps = sorted((one[1] - 0.5 * THIN, one[2] + 0.5 * THIN) for one in doors if one[0] == side)
        for first, last in [*gaps, (end, end)]:
            if first - begin > 1e-6:
                lines.append([(begin, at), (first, at)] if axis == "x" else [(at, begin), (at, first)])
            begin = last
    return walls(*lines)


def visited(world: World, traffic: Traffic, weights: Weights, seed: int = SEED) -> Simulation:
    """A level's people, who are all there at first."""
    count = sum(one.at_first for one in traffic.source)
    planner = Visiting(traffic)
    return Simulation(world, [planner.mix.characters[0]] * count, planner, seed, weights=weights)


def watched(sim: Simulation, seconds: float) -> Flow:
    """Looked at for so long, or until everyone is gone."""
    every, time, place = sim.tick_rate // PER_SECOND, [], []
    while sim.time < seconds:
        if sim.ticks % every == 0:
            there = sim.present()
            time.append(sim.time)
            place.append(np.where(there[:, None], sim.com()[:, :2], np.nan))
            if not there.any():
                break
        sim.tick()
    return Flow(np.array(time), np.array(place), sim.world)


def stairs(up: bool, weights: Weights) -> Flow:
    """RiMEA 2 and 3: one walks 10 m of stairs (along the ground), up or down."""
    rise, run = STAIR
    count = round(10.0 / run)
    world = World(
        "stairs", (18.0, 5.0), "stairs", (4.0, rise, run, count), walls=walls([(1, 1.5), (17, 1.5)], [(1, 3.5), (17, 3.5)])
    )
    begin, end = (2.5, 15.5) if up else (15.5, 2.5)
    sim = people(world, np.array([[begin, 2.5, 0.0 if up else np.pi]]), np.array([[[end, 2.5]]]), weights)
    return looked_at(sim, 60.0, lambda place: bool(abs(place[0, 0] - begin) > 12.6))


def looked_at(sim: Simulation, seconds: float, done: Callable[[np.ndarray], bool]) -> Flow:
    """Looked at for so long, or until the places (C, 2) of everyone are as `done` says."""
    every, time, place = sim.tick_rate // PER_SECOND, [], []
    while sim.time < seconds:
        if sim.ticks % every == 0:
            time.append(sim.time)
            place.append(sim.com()[:, :2].copy())
            if done(place[-1]):
                break
        sim.tick()
    return Flow(np.array(time), np.array(place), sim.world)


REACTION = (10.0, 60.0)
"""RiMEA 5: people set out by chance within these times [s] (the guideline: 10 to 100)."""


def reacting() -> tuple[World, Traffic]:
    """RiMEA 5: ten in a room of 8 by 5 m with a door of 1 m."""
    world = World("reaction", (12.0, 8.0), walls=room((1.0, 1.5, 9.0, 6.5), [("east", 3.5, 4.5)]))
    people = Population(name="people", reaction=REACTION)
    source = Source(area=box((1.5, 2.0, 8.0, 6.0)), at_first=10)
    return world, Traffic(population=[people], source=[source], exit=[Exit(name="out", area=box((10.0, 2.5, 12.0, 5.5)))])


AGED = [(20.0, 30.0, 1.0), (30.0, 50.0, 2.0), (50.0, 80.0, 2.0)]
"""RiMEA 7: ages and shares."""
LANE = 2.0
"""RiMEA 7: everyone walks alone, so far from the next [m]."""


AGES = Traffic(population=[Population(name="people", ages=AGED)])
"""RiMEA 7: who walks."""


def aged(count: int = 50) -> Simulation:
    """RiMEA 7: so many people of a population by age, each straight on over 24 m, far from the others."""
    mix = Mix(AGES.population)
    persons = [mix.person(SEED, (c, 0), 0) for c in range(count)]
    y = 1.5 + LANE * np.arange(count)
    starts, stops = np.stack([0 * y + 2.0, y, 0 * y], axis=1), np.stack([0 * y + 26.0, y], axis=1)
    world = World("ages", (30.0, float(y[-1]) + 2.0))
    return Simulation(world, [one.character for one in persons], WalkTo(starts, stops[:, None], near=1.2), SEED)


def hall(doors: int, count: int = 300) -> tuple[World, Traffic]:
    """RiMEA 9: a hall of 20 by 14 m with four doors of 1 m, or two (30 by 20 m, 1000 people there)."""
    gaps = [("north", 6.0, 7.0), ("north", 13.0, 14.0), ("south", 6.0, 7.0), ("south", 13.0, 14.0)]
    world = World("hall", (24.0, 22.0), walls=room((2.0, 4.0, 22.0, 18.0), [(s, a + 2, b + 2) for s, a, b in gaps[:doors]]))
    exits = [Exit(name=name, area=box((2.0, y, 22.0, y + 1.5))) for name, y in (("north", 19.6), ("south", 0.9))]
    source = Source(area=box((3.0, 5.0, 21.0, 17.0)), at_first=count)
    return world, Traffic(source=[source], exit=exits[:1] if doors <= 2 else exits)


CABINS = 6
"""RiMEA 10: along either side of the corridor."""


def cabins() -> tuple[World, Traffic]:
    """RiMEA 10: 23 people in 12 cabins of 3 by 3 m; those of eight go by the main exit, those of four by the other one."""
    x = [2.0 + 3.0 * k for k in range(CABINS)]
    lines, sources, people = walls(), list[Source](), 0
    for k in range(2 * CABINS):
        side, i = divmod(k, CABINS)
        of = (x[i], 1.0, x[i] + 3.0, 4.0) if side == 0 else (x[i], 6.0, x[i] + 3.0, 9.0)
        lines += room(of, [("north" if side == 0 else "south", x[i] + 1.0, x[i] + 2.0)])
        count = min(2, 23 - people)
        people += count
        inner = (of[0] + 0.4, of[1] + 0.4, of[2] - 0.4, of[3] - 0.4)
        sources.append(Source(area=box(inner), at_first=count, to=["main"] if i < 4 else ["secondary"]))
    lines += walls([(x[-1] + 3.0, 4.0), (23.0, 4.0)], [(x[-1] + 3.0, 6.0), (23.0, 6.0)])
    exits = [Exit(name="main", area=box((0.2, 4.1, 1.2, 5.9))), Exit(name="secondary", area=box((21.4, 4.1, 22.9, 5.9)))]
    return World("cabins", (24.0, 10.0), walls=lines), Traffic(source=sources, exit=exits)


def two_exits(count: int = 120) -> tuple[World, Traffic]:
    """RiMEA 11: a room of 20 by 12 m, doors of 1 m in the west and in the east; all are in its western half."""
    world = World("exits", (26.0, 14.0), walls=room((3.0, 1.0, 23.0, 13.0), [("west", 6.5, 7.5), ("east", 6.5, 7.5)]))
    exits = [Exit(name="near", area=box((0.2, 5.0, 1.6, 9.0))), Exit(name="far", area=box((24.4, 5.0, 25.8, 9.0)))]
    return world, Traffic(source=[Source(area=box((4.5, 2.0, 13.0, 12.0)), at_first=count)], exit=exits)


def two_rooms(count: int = 80) -> tuple[World, Traffic]:
    """RiMEA 12: a room, a passage of 2 by 5 m, a second room and its exit, as wide as the passage (150 people there)."""
    lines = room((1.0, 1.0, 11.0, 11.0), [("east", 5.0, 7.0)])
    lines += walls([(11.0, 5.0), (16.0, 5.0)], [(11.0, 7.0), (16.0, 7.0)])
    lines += room((16.0, 1.0, 26.0, 11.0), [("west", 5.0, 7.0), ("east", 5.0, 7.0)])
    exits = [Exit(name="out", area=box((27.6, 4.0, 29.8, 8.0)))]
    return World("two rooms", (30.0, 12.0), walls=lines), Traffic(
        source=[Source(area=box((1.5, 1.5, 9.0, 10.5)), at_first=count)], exit=exits
    )


def before_stairs(count: int = 50, climbs: bool = True) -> tuple[World, Traffic]:
    """RiMEA 13: a room of 8 by 5 m and a passage 2 m wide, which goes up stairs, or does not."""
    rise, run = STAIR
    lines = room((1.0, 1.5, 9.0, 6.5), [("east", 3.0, 5.0)])
    lines += walls([(9.0, 3.0), (21.0, 3.0)], [(9.0, 5.0), (21.0, 5.0)])
    kind, numbers = ("stairs", (13.0, rise, run, 15)) if climbs else ("flat", ())
    world = World("before stairs", (24.0, 8.0), kind, numbers, walls=lines)
    exits = [Exit(name="out", area=box((20.0, 3.1, 22.0, 4.9)))]
    return world, Traffic(source=[Source(area=box((1.4, 1.9, 8.6, 6.1)), at_first=count)], exit=exits)


def around(kind: str, count: int = 60) -> tuple[World, Traffic]:
    """RiMEA 15: a passage 2 m wide: 'short' and 'long' are straight, as long as the 'corner' is inside and outside."""
    inside, outside, begin = 8.0, 10.0, (1.5, 10.0)
    if kind == "corner":
        lines = walls([(1, 3), (1, 1), (12 + inside + 2, 1), (12 + inside + 2, 1 + inside + 8)],
                      [(1, 3), (12 + inside, 3), (12 + inside, 1 + inside + 8)])  # fmt: skip
        world = World("corner", (12 + inside + 4, inside + 11), walls=lines)
        out = (12 + inside + 0.1, inside + 7.5, 12 + inside + 1.9, inside + 9.0)
    else:
        end = 12 + inside + (inside + 5.5 if kind == "short" else outside + 7.5)
        world = World("straight", (end + 3, 4.0), walls=walls([(1, 3), (1, 1), (end + 2, 1)], [(1, 3), (end + 2, 3)]))
        out = (end, 1.1, end + 1.5, 2.9)
    source = Source(area=box((begin[0], 1.0, begin[1], 3.0)), at_first=count)
    return world, Traffic(source=[source], exit=[Exit(name="out", area=box(out))])
