"""Throngs in places of their own: two streams along a corridor, and a circle whose people change places."""

import numpy as np

from planner.round.weights import Weights
from sim.reports import flows
from sim.reports.flows import CORRIDOR, Flow
from sim.stage.simulation import Simulation
from worlds.world import World

STREAM, BEFORE = 24.0, 4.0
"""How long each of two streams is at first, and how far its front from the middle [m]."""
MET = 9.0
"""Who is no further from the middle than this is where the streams meet [m]."""


def two_ways(density: float, weights: Weights, seed: int = 1) -> Flow:
    """Two streams, half of so many people per square metre each, along a corridor: until half of them have met nobody any more.

    Both are as dense as half of it at first, so that where they pass through each other they are as dense as is asked for.
    """
    rows = 5
    count = round(0.5 * density * STREAM * CORRIDOR)
    k = np.arange(count)
    back, aside = BEFORE + (k // rows + 0.5 * (k % 2)) * STREAM * rows / count, (k % rows - 2) * (CORRIDOR - 0.8) / (rows - 1)
    half = STREAM + BEFORE + 4.0
    east, west = np.stack([half - back, aside + 3.5, 0 * k], 1), np.stack([half + back, aside + 3.5, 0 * k + np.pi], 1)
    stops = np.concatenate([np.stack([x + 0 * back, aside + 3.5], 1) for x in (2 * half - 1.5, 1.5)])
    lines = [[(0.0, y), (2 * half, y)] for y in (3.5 + s * 0.5 * (CORRIDOR + flows.THICK) for s in (-1, 1))]
    world = World("two ways", (2 * half, 7.0), walls=flows.walls(*lines))
    sim = flows.people(world, np.concatenate([east, west]), stops[:, None], weights, seed=seed)
    return flows.watched(sim, (BEFORE + 0.75 * STREAM) / 1.1)


def met(flow: Flow) -> np.ndarray:
    """(F, C) who is where the streams have met: near the middle, while those who come against it are there, too."""
    x = flow.place[..., 0] - 0.5 * flow.world.size[0]
    first = np.sign(x[0])
    there = np.abs(x) < MET
    both = (there & (first < 0)).sum(axis=1), (there & (first > 0)).sum(axis=1)
    return there & (np.minimum(*both) > 0.5 * np.maximum(*both))[:, None]


def circle(count: int, apart: float, weights: Weights, names: tuple[str, ...] = ("human",), seed: int = 1) -> Simulation:
    """So many on a circle, so far from each other [m], walk to its opposite side: characters of these names by turns; all
    lengths are as much larger as the widest of them is wider than people."""
    kinds, scale = flows.kinds_of(names)
    angle, radius = 2 * np.pi * np.arange(count) / count, scale * apart * count / (2 * np.pi)
    out, middle = radius * np.column_stack([np.cos(angle), np.sin(angle)]), radius + 4.0 * scale
    starts, stops = np.column_stack([middle + out, angle + np.pi]), (middle - out)[:, None]
    return flows.by_turns(World("circle", (2 * middle, 2 * middle)), kinds, starts, stops, weights, scale, seed)
