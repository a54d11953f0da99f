"""Who cannot go on backs off: where crossers are at odds on a bank, those on land make room, and begin again one by one.

A goal that is moved finds crossers in each other's ways, where the order in which they go helps nobody: the first waits for
ground on which others stand, who wait for it. Nobody goes on any more then, which is how it is known. Everyone on land who has
still to cross then walks, around the others, to a place off the ways of those on rocks, and off those that others go before it
from their places. Those on rocks go ashore meanwhile. When all have come to rest, they cross in the order of their places, each
off the ways of whom it is behind, as they would from a start (planner.river.queue.queueing).
"""

import numpy as np

from motion.track.footprints import Step
from planner.planner import Situation
from planner.river.grid import SPACING
from planner.river.land import Ways, land_for
from planner.river.queue.berths import MARGIN, SPREAD, room
from planner.river.queue.routes import Routes, ashore_of, empty_routes, is_wet, put_route
from planner.stepping.beside import Place
from planner.stepping.strides import along
from worlds.world import World

PATIENCE = 24
"""So many looks, six in a second, at which nobody has gone on, until those who wait are known to wait for each other."""
FARTHEST = 30.0
"""Nobody goes farther to make room [m]."""


def is_over(plans: Routes) -> np.ndarray:
    """(C,) whether each is where it is to be, for now or for good."""
    return plans.at >= plans.length - 1


def nothing_moves(plans: Routes) -> bool:
    """Whether those who have still to cross have all stood for long; counts the looks."""
    rests = is_over(plans)
    left = ~rests | plans.parked
    idle = bool(left.any() and (plans.waits | rests).all())
    plans.idle[:] = plans.idle + 1 if idle else 0
    return int(plans.idle[0]) >= PATIENCE


def ends_of(plans: Routes, away: dict[int, Place]) -> np.ndarray:
    """(C, 2) where each is bound for, for now: those who make room to their places [m]."""
    ends = plans.ends.copy()
    for c, place in away.items():
        ends[c] = place
    return ends


def other_routes(situation: Situation, routes: dict[int, list[Step]], away: dict[int, Place]) -> Routes:
    """The plans of before but for these routes, by rows in the order in which they shall cross; the others come after them."""
    before, characters = situation.before, situation.characters
    rows = max(before.steps.shape[1], *(len(steps) for steps in routes.values()))
    plans = empty_routes(len(characters), rows)
    for old, new in zip(before, plans, strict=True):
        new[tuple(slice(length) for length in old.shape)] = old
    for c, steps in routes.items():
        put_route(plans, situation.world, characters[c], c, steps)
    for c, place in away.items():
        plans.parked[c] = plans.walks[c] = True
        plans.aside[c] = place
    order = [*routes, *(c for c in np.argsort(plans.turn, kind="stable").tolist() if c not in routes)]
    plans.turn[order] = np.arange(len(order))
    plans.idle[:] = 0
    return plans


def places(situation: Situation, routes: dict[int, list[Step]]) -> dict[int, Place]:
    """Where those on land go meanwhile, by their rows, whose routes these are, in the order in which they shall cross [m]."""
    world, middle = situation.world, np.asarray(situation.feet.position[:, :, :2].mean(axis=1))
    largest = max(situation.characters, key=lambda one: float(one.biped.body.radius))
    land, apart = land_for(world, largest), 2 * room(largest) + MARGIN
    afloat = [c for c in routes if situation.feet.rock[c].max() >= 0]
    taken = [np.delete(middle, list(routes), axis=0), *(_between(routes[c][: ashore_of(world, routes[c]) + 1]) for c in afloat)]
    found: dict[int, Place] = {}
    for c in routes:
        x, y = middle[c].tolist()
        ways, back = land.ways_from(x, y), land.ways_from(*_entry(world, routes[c]))
        if c in afloat or ways is None or back is None:
            continue
        tried = (_nearest(ways, np.vstack(taken), spread * apart) for spread in SPREAD)
        place = found[c] = next((one for one in tried if one), (x, y))
        taken += [np.array([place]), _fine(back.polyline(world, *place))]
    return found


def _between(steps: list[Step]) -> np.ndarray:
    """Points (N, 2) of the body's way from step to step [m]."""
    xy = np.array([(step.x, step.y) for step in steps])
    return _fine(0.5 * (xy[1:] + xy[:-1]))


def _fine(line: np.ndarray) -> np.ndarray:
    """Points (N, 2) of a polyline, close together."""
    return along(line, np.arange(0.0, np.hypot(*np.diff(line, axis=0).T).sum(), MARGIN))[0] if len(line) > 1 else line


def _entry(world: World, steps: list[Step]) -> tuple[float, float]:
    """Where a route leaves the land [m]; where it ends, if it does not."""
    last = next((a for a, z in zip(steps, steps[1:], strict=False) if is_wet(world.arrays, a, z)), steps[-1])
    return float(last.x), float(last.y)


def _nearest(ways: Ways, taken: np.ndarray, apart: float) -> tuple[float, float] | None:
    """The place nearest by these ways that is so far apart from all points (N, 2) that are taken [m], if there is one."""
    rows, columns = np.nonzero(ways.distance < FARTHEST)
    cells = (np.column_stack([columns, rows]) + 0.5)[np.argsort(ways.distance[rows, columns], kind="stable")] * SPACING
    for part in np.array_split(cells, max(len(cells) // 64, 1)):
        free = np.ones(len(part), bool)
        for few in np.array_split(taken, max(len(taken) // 512, 1)):
            free &= (np.hypot(*(part[:, None] - few[None]).transpose(2, 0, 1)) >= apart).all(axis=1)
        if free.any():
            x, y = part[free.argmax()].tolist()
            return x, y
    return None
