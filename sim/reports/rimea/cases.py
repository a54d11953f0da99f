"""The RiMEA tests (guideline 4.1.1, RiMEA e.V. 2022) as cases of `verify`, beside those that sim.reports.verify has itself.

Test 8 compares parameters of a model with its own former runs, and test 14 needs two floors: neither is here. Bands are those
of the guideline where it tells them; where it asks for a behaviour, the figure is what shows it, and the band where it does.
"""

from functools import partial

import numpy as np

from planner.round.weights import Weights
from sim.reports.flows import Flow
from sim.reports.people import MANY, Case, by_seeds, median_of, worst_of
from sim.reports.rimea import figures, rooms
from sim.reports.rimea.rooms import SEED
from worlds.contents.traffic import Traffic
from worlds.world import World

JAM = "in a door of 1 m two may each wait for the other"
LONGEST = 240.0
"""No room takes longer [s]."""
DOORS = np.array([0.7, 22.2])
"""RiMEA 10: x of the main exit and of the other one [m]."""


def _emptied(place: tuple[World, Traffic], weights: Weights, seed: int = SEED) -> Flow:
    return rooms.watched(rooms.visited(*place, weights, seed), LONGEST)


def _ratio(flows: list[Flow]) -> float:
    """How many times as long the second takes as the first."""
    first, second = (figures.all_out(flow) for flow in flows)
    return second / first


def _between(flows: list[Flow]) -> float:
    """Where the second lies between the first, 0, and the third, 1."""
    short, middle, long = (figures.all_out(flow) for flow in flows)
    return (middle - short) / (long - short)


def cases() -> list[Case]:
    """All but 1, 4, 6 and 16."""
    reaction = rooms.reacting()
    return [
        Case("RiMEA 2: one goes up stairs, over the ground", "m/s", 0.42, 0.75, [partial(rooms.stairs, True)],
             lambda flows: figures.speed_between(flows[0], 5.0, 13.0), 2),
        Case("RiMEA 3: one goes down stairs", "m/s", 0.52, 0.90, [partial(rooms.stairs, False)],
             lambda flows: figures.speed_between(flows[0], 5.0, 13.0), 3),
        Case("RiMEA 5: ten set out by chance, latest after its time", "s", 0.0, 2.0, [partial(_emptied, reaction)],
             lambda flows: figures.latest_start(flows[0], reaction[1], SEED), 5),
        Case("RiMEA 7: 50 people by age, share as fast as theirs", "", 0.95, 1.0, [_aged],
             lambda flows: figures.within_their_ages(flows[0], rooms.AGES, SEED), 7),
        Case("RiMEA 9: a hall with two doors instead of four takes", "times", 1.7, 2.3,
             by_seeds(*(partial(_emptied, rooms.hall(doors)) for doors in (4, 2))), median_of(_ratio, 2), 9, JAM),
        Case("RiMEA 10: 23 from 12 cabins, by another exit than theirs", "", 0, 0, by_seeds(partial(_emptied, rooms.cabins())),
             worst_of(lambda flows: figures.wrong_exits(flows[0], DOORS)), 10),
        Case("RiMEA 11: share that takes the far exit for the crowd", "", 0.05, 0.5,
             by_seeds(partial(_emptied, rooms.two_exits())), median_of(lambda flows: figures.share_beyond(flows[0], 14.0)), 11,
             "the jam at the near exit does not grow as long as the way to the far one"),
        Case("RiMEA 12: behind a passage none stand before the exit", "", 0, 3,
             by_seeds(partial(_emptied, rooms.two_rooms()), seeds=MANY),
             median_of(lambda flows: figures.standing_within(flows[0], 16.0, 26.0)), 12),
        Case("RiMEA 13: stairs after a passage take", "times", 1.1, 4.0,
             by_seeds(*(partial(_emptied, rooms.before_stairs(climbs=climbs)) for climbs in (False, True)), seeds=MANY),
             median_of(_ratio, 2), 13),
        Case("RiMEA 15: a corner between straight ways, short 0, long 1", "", 0.0, 1.0,
             by_seeds(*(partial(_emptied, rooms.around(kind)) for kind in ("short", "corner", "long")), seeds=MANY),
             median_of(_between, 3), 15,
             "at the inner corner, which all make for, one waits for the other"),
    ]  # fmt: skip


def _aged(weights: Weights) -> Flow:
    return rooms.looked_at(rooms.aged(), 60.0, lambda place: bool((place[:, 0] > 24.0).all()))
