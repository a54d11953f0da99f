"""What each weight of a step's cost does: a little scene at none of it, as it is, and at twice as much, and a figure of each.

Where two meet they do so many times beside each other, each time a little further aside: what one of them does hangs on a
centimetre, what all do on the weight.
"""

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

import numpy as np

from planner.round.weights import PEOPLE, Weights
from sim.reports import flows
from sim.reports.flows import PER_SECOND, Flow
from sim.reports.people import BODIES, STANDING, WAYS, Weighed
from sim.reports.throngs import figures, places
from worlds.world import World

TIMES = (0.0, 1.0, 2.0)
"""Of the weight as it is."""
PAIRS, LANE, WAY = 15, 16.0, 12.0
"""So many meet, so far from each other [m]; and how far each of them goes [m]."""
SLOWLY = 0.45
"""Share of its step that the first of a file takes."""
Box = tuple[float, float, float, float]


class Scene(NamedTuple):
    """A little scene that shows what a weight does."""

    run: Callable[[Weights], Flow]
    figure: Callable[[Flow], float]
    more: str  # what more of it does
    words: str  # of the figure
    box: Box  # what of it is shown: least and largest x, least and largest y [m]
    drawn: str = WAYS
    moment: float = 0.0  # at which bodies are shown [s]


def _meeting(begin: tuple[float, float], end: tuple[float, float], aside: tuple[float, float], weights: Weights) -> Flow:
    """One goes WAY along x, the other from begin to end [m], moved aside by up to that, either way: laid over each other."""
    off = np.linspace(-1, 1, PAIRS)[:, None] * aside
    starts = np.stack([0 * off, begin + off], axis=1)
    stops = np.stack([(WAY, 0.0) + 0 * off, (end if end != begin else begin) + off], axis=1)
    lane = np.stack([np.full(PAIRS, 2.0), LANE * (np.arange(PAIRS) + 0.5)], axis=1)[:, None]
    way = (stops - starts).reshape(-1, 2)
    begins = np.column_stack([(starts + lane).reshape(-1, 2), np.arctan2(way[:, 1], way[:, 0])])
    world = World("meeting", (WAY + 8.0, LANE * PAIRS))
    sim = flows.people(world, begins, (stops + lane).reshape(-1, 1, 2), weights)
    flow = flows.watched(sim, 11.0)
    return flow._replace(place=flow.place - np.repeat(lane[:, 0], 2, axis=0), world=World("meeting", (WAY, 1.0)))


def _apart(flow: Flow) -> float:
    """How near two who meet come to each other, on average [m]."""
    return float(np.hypot(*np.moveaxis(flow.place[:, ::2] - flow.place[:, 1::2], 2, 0)).min(axis=0).mean())


def _aside(flow: Flow) -> float:
    """How far the first of two leaves its line, on average [m]."""
    return float(np.abs(flow.place[:, ::2, 1]).max(axis=0).mean())


def _file(weights: Weights) -> Flow:
    """Eight in a file, of whom the first is slow."""
    k = np.arange(8)
    starts, stops = np.column_stack([11.5 - 1.5 * k, 1.5 + 0 * k, 0 * k]), np.column_stack([29.0 - k, 1.5 + 0 * k])
    world = World("file", (30.0, 3.0), walls=flows.walls([(0, 1), (30, 1)], [(0, 2), (30, 2)]))
    sim = flows.people(world, starts, stops[:, None], weights)
    sim.plans.pace[0] = SLOWLY
    return flows.watched(sim, 15.0, bodies=True)


def _behind(flow: Flow) -> float:
    """How far each is behind the one before it in the last three seconds, on average [m]."""
    return float(-np.diff(flow.place[-3 * PER_SECOND :, :, 0], axis=1).mean())


def _party(weights: Weights) -> Flow:
    """36 set out together."""
    row, column = np.divmod(np.arange(36), 6)
    starts = np.column_stack([2 + 0.5 * row, 5 + 0.6 * column, 0 * row])
    sim = flows.people(World("party", (28.0, 13.0)), starts, (starts[:, :2] + (20, 0))[:, None], weights)
    return flows.watched(sim, 5.0, bodies=True)


def _nearest(flow: Flow) -> float:
    """How far it is to the four nearest others in the last four seconds, on average [m]."""
    place = flow.place[-4 * PER_SECOND :]
    away = np.hypot(*np.moveaxis(place[:, :, None] - place[:, None], 3, 0))
    return float(np.sort(away + np.where(np.eye(place.shape[1]), np.inf, 0), axis=2)[..., :4].mean())


def _streams(weights: Weights) -> Flow:
    """25 a side pass through each other along a corridor."""
    back, aside = np.divmod(np.arange(25), 5)
    x, y = 1.0 + back, 1.6 + 0.7 * aside
    starts = np.concatenate([np.column_stack([x, y, 0 * x]), np.column_stack([28 - x, y, 0 * x + np.pi])])
    stops = np.concatenate([np.column_stack([x + 22, y]), np.column_stack([6 - x, y])])
    world = World("streams", (28.0, 6.0), walls=flows.walls([(0, 1), (28, 1)], [(0, 5), (28, 5)]))
    return flows.watched(flows.people(world, starts, stops[:, None], weights), 26.0)


def _order(flow: Flow) -> float:
    """Of the lanes in the middle of a corridor."""
    return figures.lanes(flow, np.abs(flow.place[..., 0] - 0.5 * flow.world.size[0]) < 5)


def _through(flow: Flow) -> float:
    """How fast they walk along x in the middle of a corridor, on average [m/s]."""
    return figures.speed(flow, np.abs(flow.place[..., 0] - 0.5 * flow.world.size[0]) < 5)


def _circle(weights: Weights) -> Flow:
    """24 change places."""
    return flows.watched(places.circle(24, 1.0, weights), 12.0)


def _off_middle(flow: Flow) -> float:
    """How near they come to the middle of the world, on average [m]."""
    return float(np.hypot(*np.moveaxis(flow.place - 0.5 * np.array(flow.world.size), 2, 0)).min(axis=0).mean())


def _door(weights: Weights) -> Flow:
    """Ten a side go against each other through a door for one, by a seed with which it tells."""
    sim = flows.counterflow(10, 0.8, weights, seed=9)
    return flows.watched(sim, 60.0, sim.world.size[0] / 2, bodies=True)


def _throng(density: float, weights: Weights) -> Flow:
    """On a ring, so many per square metre."""
    return flows.watched(flows.ring(density, weights), 10.0, bodies=True)


def _pace(flow: Flow) -> float:
    """How fast they get on at the end, on average [m/s]."""
    later, sooner = flow.place[-1], flow.place[-1 - 2 * PER_SECOND]
    return float(np.hypot(*(later - sooner).T).mean()) / 2


def _standing(flow: Flow) -> float:
    """Share of the time for which people stand, once they have set out [%]."""
    return 100 * float(figures.stands(flow)[5 * PER_SECOND :].mean())


_FAN, _FILE, _PARTY = (2.6, 9.4, -1.4, 1.4), (16.8, 24.0, 0.7, 2.3), (3.2, 13.2, 3.6, 9.6)
_ROUND, _DOOR = (0.0, 15.6, 3.2, 12.4), (3.5, 16.5, 4.0, 10.0)
_HEAD_ON = partial(_meeting, (WAY, 0.0), (0.0, 0.0), (0.0, 0.6))
_ACROSS = partial(_meeting, (6 - 4.2, -4.2), (6 + 4.2, 4.2), (0.9, 0.0))
_RING: Box = (1.0, 19.0, 9.6, 19.2)
_STANDS = partial(_meeting, (6.0, 0.0), (6.0, 0.0), (0.0, 0.6))
SCENES = {
    "progress": Scene(_HEAD_ON, _apart, "presses on", "two who meet pass {:.2f} m apart", _FAN),
    "turn": Scene(_ACROSS, _aside, "walks straighter", "one evades another by {:.2f} m", _FAN),
    "gap": Scene(_file, _behind, "follows from further behind", "each {:.2f} m behind the next", _FILE, BODIES, 14.9),
    "ahead": Scene(partial(_throng, 2.0), _pace, "looks further ahead for throngs", "get on at {:.2f} m/s", _RING, BODIES, 9.9),
    "meet": Scene(_streams, _through, "passes more slowly", "walk at {:.2f} m/s", (8.0, 20.0, 0.8, 5.2)),
    "touch": Scene(_HEAD_ON, _apart, "swerves wider", "two who meet pass {:.2f} m apart", _FAN),
    "horizon": Scene(_STANDS, _apart, "looks further ahead", "pass who stands {:.2f} m apart", _FAN),
    "near": Scene(_party, _nearest, "spreads out", "{:.2f} m to four others", _PARTY, BODIES, 4.9),
    "distance": Scene(_party, _nearest, "feels others further off", "{:.2f} m to four others", _PARTY, BODIES, 4.9),
    "side": Scene(_streams, _order, "parts streams into lanes", "order of lanes {:.2f}", (8.0, 20.0, 0.8, 5.2)),
    "around": Scene(_circle, _off_middle, "goes wider around", "up to {:.1f} m from the middle", _ROUND),
    "rank": Scene(_door, flows.last_through, "makes way sooner", "last through after {:.0f} s", _DOOR, BODIES, 20.0),
    "stand": Scene(partial(_throng, 3.0), _standing, "shuffles on", "stand {:.1f} % of the time", _RING, STANDING, 9.9),
}


def weighed(weights: Weights = PEOPLE) -> Iterator[Weighed]:
    """Weight by weight, as they come."""
    for name, scene in SCENES.items():
        values = [times * getattr(weights, name) for times in TIMES]
        found = [scene.run(weights.of(name, value)) for value in values]
        told = [scene.figure(flow) for flow in found]
        words = [scene.words.format(one) if np.isfinite(one) else "not all come through" for one in told]
        yield Weighed(name, scene.more, values, found, told, words, scene.box, scene.drawn, scene.moment)
