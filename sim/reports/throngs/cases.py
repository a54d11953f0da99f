"""Throngs as cases of `verify`: many people, many ways, other characters, and what must not happen among them.

Bands: lanes as in laboratory experiments (Zhang et al. 2012); the rest are bounds of our own: two streams slow each other down
a little, nobody stands for long, all arrive, and bodies hardly touch.
"""

from collections.abc import Callable
from functools import lru_cache, partial

import numpy as np

from planner.round.weights import Weights
from sim.reports import flows
from sim.reports.flows import Flow
from sim.reports.people import Case, by_seeds, median_of, worst_of
from sim.reports.throngs import figures, places

TWO_WAYS = (0.55, 1.0, 1.5)
"""People per square metre where two streams pass through each other."""
SECONDS = 60.0
"""A circle of people is looked at for so long; larger characters, for as much longer as they have further to go."""
LONGEST = 400.0
"""No case takes longer [s]."""
KINDS = {"people": ("human",), "birds": ("bird",), "dinosaurs": ("dinosaur",), "people and birds": ("human", "bird")}
"""Who goes against each other."""
TEN, SIX, FIVE = 10, 6, 5
"""Chance is asked so often where the longest standstill counts, where the longest overlap does, and to compare two flows."""
OVERLAPS = (
    ("longest", " by 5 %", "s", 0.5, figures.longest_overlap),
    ("deepest", "", "of depth", 0.05, figures.deepest_overlap),
)
"""What is told of bodies that overlap: of what, by how much, unit, band, figure."""
EACH, APART = 100, 0.9
"""So many on a circle, and how far from each other [m]."""


def swap(weights: Weights, names: tuple[str, ...] = ("human",), seed: int = 1) -> Flow:
    """Everyone on a circle walks to its opposite side."""
    return flows.watched(places.circle(EACH, APART, weights, names, seed), SECONDS * flows.kinds_of(names)[1])


def across(flow: Flow, scale: float = 1.0) -> np.ndarray:
    """(F, C) who of a circle has come to within 1.5 m of its place, `scale` times that for larger ones."""
    there = np.hypot(*np.moveaxis(flow.place - (flow.world.size[0] - flow.place[0]), 2, 0)) < 1.5 * scale
    return np.logical_or.accumulate(there, axis=0)


def last_across(flow: Flow, scale: float = 1.0) -> float:
    """When the last of a circle has come to its place [s]; inf: not all have."""
    there = across(flow, scale)
    return float(flow.time[there.argmax(axis=0)].max()) if there[-1].all() else float("inf")


def still_before(flow: Flow, scale: float = 1.0) -> float:
    """The longest standstill of a circle before one has come to its place [s]; inf: not all have."""
    there = across(flow, scale)
    return figures.longest_run(figures.stands(flow) & ~there[1:]) / flows.PER_SECOND if there[-1].all() else float("inf")


@lru_cache(2 * FIVE)
def _neck(width: float, count: int, neck: float, weights: Weights, seed: int = 1) -> Flow:
    sim = flows.bottleneck(width, count, neck, weights, seed)
    return flows.watched(sim, LONGEST, flows.DOOR[0] + neck + 0.5, count <= 100)


@lru_cache(TEN)
def _against(count: int, names: tuple[str, ...], weights: Weights, seed: int = 1) -> Flow:
    sim = flows.counterflow(count, 3.0, weights, names, seed)
    return flows.watched(sim, LONGEST, sim.world.size[0] / 2)


def _slower(all: list[Flow]) -> float:
    """The flow through the second neck, in that through the first."""
    first, second = (flows.specific_flow(flow, 1.2) for flow in all)
    return second / first


def _still(scale: float, all: list[Flow]) -> float:
    return still_before(all[0], scale)


def _overlap(figure: Callable[[Flow], float], all: list[Flow]) -> float:
    return figure(all[0])


def _stands(all: list[Flow]) -> float:
    """The longest standstill before the gap of a counterflow [s]; inf: not all are through."""
    flow = all[0]
    return figures.still_longest(flow, flow.world.size[0] / 2) if np.isfinite(flows.last_through(flow)) else float("inf")


def _all_seeds(count: int, names: tuple[str, ...] = ("human",)) -> list[Callable[[Weights], Flow]]:
    """Counterflows of so many a side, by chance again and again."""
    return by_seeds(partial(_against, count, names), seeds=tuple(range(1, TEN + 1)))


def cases() -> list[Case]:
    """In the order in which they are told."""
    necks = by_seeds(partial(_neck, 1.2, 100, 1.0), partial(_neck, 1.2, 100, 4.0), seeds=tuple(range(1, FIVE + 1)))
    return [
        *(Case(f"both ways along a corridor 4 m wide, {density:g} per m^2: speed", "m/s", 0.95, 1.1,
               by_seeds(partial(places.two_ways, density)),
               median_of(lambda all: figures.speed(all[0], places.met(all[0])))) for density in TWO_WAYS),
        Case("there, at 1.5 per m^2: order of lanes", "", 0.8, 1.0, by_seeds(partial(places.two_ways, 1.5)),
             median_of(lambda all: figures.lanes(all[0], places.met(all[0])))),
        Case("a neck of 4 m instead of 1 m: flow, in that of the short one", "times", 0.5, 1.0, necks, median_of(_slower, 2)),
        *(Case(f"bottleneck {width:g} m wide: {most} that bodies overlap{by}", unit, 0.0, band,
               by_seeds(partial(_neck, width, 100, 1.0), seeds=tuple(range(1, SIX + 1))), worst_of(partial(_overlap, figure)))
          for width in (1.2, 0.9) for most, by, unit, band, figure in OVERLAPS),
        Case("bottleneck 1.2 m wide, 400 people: flow", "1/(m s)", 1.6, 2.1, [partial(_neck, 1.2, 400, 1.0)],
             lambda all: flows.specific_flow(all[0], 1.2)),
        Case("bottleneck 3 m wide, 400 people: flow", "1/(m s)", 1.6, 2.1, [partial(_neck, 3.0, 400, 1.0)],
             lambda all: flows.specific_flow(all[0], 3.0)),
        *(Case(f"{EACH} {who} on a circle change places: longest standstill", "s", 0.0, 6.0,
               by_seeds(partial(swap, names=names)), worst_of(partial(_still, flows.kinds_of(names)[1])),
               shows="circle")
          for who, names in KINDS.items()),
        *(Case(f"counterflow, 30 {who} a side: longest standstill", "s", 0.0, 15.0, _all_seeds(30, names), worst_of(_stands))
          for who, names in KINDS.items()),
        Case(f"counterflow, 60 a side, {TEN} seeds: longest standstill", "s", 0.0, 15.0, _all_seeds(60), worst_of(_stands)),
        Case(f"counterflow, 250 a side, {TEN} seeds: last through", "s", 0.0, 200.0, _all_seeds(250),
             worst_of(lambda all: flows.last_through(all[0]))),
        Case(f"counterflow, 250 a side, {TEN} seeds: longest standstill", "s", 0.0, 15.0, _all_seeds(250), worst_of(_stands)),
    ]  # fmt: skip
