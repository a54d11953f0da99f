"""Places where the flow of people is known, as simulations: a corridor, a corner, a ring, a bottleneck, a counterflow."""

from typing import NamedTuple

import numpy as np

from motion.characters.character import Character, load_character
from planner.modes.walk_to import WalkTo
from planner.round.reservations import body_sizes
from planner.round.weights import PEOPLE, Weights
from sim.stage.simulation import Simulation
from worlds.queries import survey
from worlds.world import Wall, World

PER_SECOND = 10
"""Looks at where everyone is."""
THICK = 0.2
"""Walls [m]."""
RING, CORRIDOR = 7.0, 4.0
"""Radius of the ring's middle, and width of its corridor [m]."""
DOOR = (14.0, 6.0)
"""Where the bottleneck, and the gap of a counterflow, begins [m]."""


class Flow(NamedTuple):
    """A simulation that was looked at: F moments, C characters, metres and seconds."""

    time: np.ndarray  # (F,)
    place: np.ndarray  # (F, C, 2) of the centres of mass
    world: World
    heading: np.ndarray | None = None  # (F, C) of the bodies as they are posed [rad], where that was looked at
    half: np.ndarray | None = None  # (C, 2) half the depth and the width of their bodies


def watched(sim: Simulation, seconds: float, done: float | None = None, bodies: bool = False) -> Flow:
    """Looked at for so long, or until everyone is beyond x = `done` [m], each from the side where it began; also how the
    `bodies` face."""
    every, time, place, heading = sim.tick_rate // PER_SECOND, [], [], []
    first = sim.com()[:, 0]
    while sim.time < seconds:
        if sim.ticks % every == 0:
            time.append(sim.time)
            place.append(sim.com()[:, :2].copy())
            if bodies:
                heading.append(_facing(sim))
            if done is not None and ((place[-1][:, 0] - done) * (first - done) < 0).all():
                break
        sim.tick()
    flow = Flow(np.array(time), np.array(place), sim.world)
    half = np.array([0.5 * body_sizes(one.biped) for one in sim.characters])
    return flow._replace(heading=np.array(heading), half=half) if bodies else flow


def _facing(sim: Simulation) -> np.ndarray:
    """(C,) where the bodies face as they are posed now [rad]."""
    w, x, y, z = sim.snapshot().body_rotation_wxyz.T
    return np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


def people(
    world: World, starts: np.ndarray, stops: np.ndarray, weights: Weights = PEOPLE, again: bool = False, seed: int = 1
) -> Simulation:  # fmt: skip
    """Humans who walk from starts (C, 3) x, y, heading to stops (C, P, 2)."""
    planner = WalkTo(starts, stops, again=again, near=1.2)
    return Simulation(world, [load_character("human")] * len(starts), planner, seed, weights=weights)


def walls(*lines: list[tuple[float, float]]) -> tuple[Wall, ...]:
    """Walls along polylines [m]."""
    return tuple(Wall(np.array(line, float), THICK) for line in lines)


def corridor() -> Simulation:
    """One walks 40 m straight on."""
    world = World("corridor", (46.0, 6.0), walls=walls([(1, 2), (45, 2)], [(1, 4), (45, 4)]))
    return people(world, np.array([[2.0, 3.0, 0.0]]), np.array([[[44.0, 3.0]]]))


def corner(count: int = 20) -> Simulation:
    """So many walk around a corner of a corridor 2 m wide, to the left."""
    world = World("corner", (16.0, 16.0), walls=walls([(1, 1), (14, 1), (14, 15)], [(1, 3.2), (11.8, 3.2), (11.8, 15)]))
    k = np.arange(count)
    starts = np.stack([2.0 + 0.8 * (k // 3), 1.55 + 0.55 * (k % 3), 0.0 * k], axis=1)
    stops = np.stack([12.3 + 0.45 * (k % 3), 14.0 - 0.6 * (k // 3)], axis=1)
    return people(world, starts, stops[::-1][:, None])


def ring(density: float, weights: Weights = PEOPLE, seed: int = 1) -> Simulation:
    """People on a ring, `density` of them per square metre, all the same way round."""
    count, rows = round(2 * np.pi * RING * CORRIDOR * density), 6
    middle = RING + CORRIDOR / 2 + 1
    around = np.linspace(0, 2 * np.pi, 49)
    circles = [
        [(middle + r * np.cos(a), middle + r * np.sin(a)) for a in around]
        for r in (RING - CORRIDOR / 2 - THICK / 2, RING + CORRIDOR / 2 + THICK / 2)
    ]
    radii = RING + (np.arange(rows) - (rows - 1) / 2) * (CORRIDOR - 0.6) / (rows - 1)
    shares = np.floor(np.cumsum(radii / radii.sum()) * count + 0.5).astype(int)
    per = np.diff(shares, prepend=0)
    radius, angle = np.repeat(radii, per), np.concatenate([np.arange(n) * 2 * np.pi / n + 0.7 * k for k, n in enumerate(per)])
    starts = np.column_stack([middle + radius * np.cos(angle), middle + radius * np.sin(angle), angle + np.pi / 2])
    on = angle[:, None] + np.arange(1, 25) * 2 * np.pi / 24
    stops = middle + radius[:, None, None] * np.stack([np.cos(on), np.sin(on)], axis=2)
    return people(World("ring", (2 * middle, 2 * middle), walls=walls(*circles)), starts, stops, weights, True, seed)


def ring_speed(flow: Flow) -> float:
    """Mean speed around the ring in the last two thirds of the time [m/s]; who sways back loses that way."""
    off = flow.place[len(flow.time) // 3 :] - flow.world.size[0] / 2
    angle = np.unwrap(np.arctan2(off[..., 1], off[..., 0]), axis=0)
    way = np.diff(angle, axis=0) * np.hypot(off[1:, :, 0], off[1:, :, 1])
    return float(abs(way.mean()) * PER_SECOND)


def bottleneck(width: float, count: int = 100, neck: float = 1.0, weights: Weights = PEOPLE, seed: int = 1) -> Simulation:
    """So many wait before a neck of this width and length [m], and go through it."""
    x, y = DOOR
    half = 0.5 * (width + THICK)
    left = [(1.0, y + 5), (x, y + 5), (x, y + half), (x + neck, y + half)]
    right = [(px, 2 * y - py) for px, py in left]
    k, (rows, behind, beside) = np.arange(count), (12, 0.55, 0.62) if count <= 250 else (16, 0.47, 0.59)
    starts = np.stack([x - 1.5 - behind * (k // rows), y + beside * (k % rows - 0.5 * (rows - 1)), 0.0 * k], axis=1)
    stops = np.stack([np.full(count, 38.0), y + np.clip(1.5 * (starts[:, 1] - y), -5.4, 5.4)], axis=1)
    return people(World("bottleneck", (40.0, 2 * y), walls=walls(left, right)), starts, stops[:, None], weights, seed=seed)


def specific_flow(flow: Flow, width: float) -> float:
    """People per metre and second through the bottleneck: of those from the fifth to the eighth in ten; 0 if hardly any."""
    through = np.sort(flow.time[(flow.place[..., 0] > DOOR[0] + 0.5).argmax(axis=0)])
    through = through[through > 0]
    a, b = int(0.2 * len(through)), int(0.8 * len(through)) - 1
    return float((b - a) / max(through[b] - through[a], 1e-9) / width) if b > a + 5 else 0.0


def kinds_of(names: tuple[str, ...]) -> tuple[list[Character], float]:
    """Characters of these names, and how much wider than people the widest of them is."""
    kinds = [load_character(name) for name in names]
    return kinds, float(max(body_sizes(one.biped)[1] for one in kinds) / body_sizes(load_character("human").biped)[1])


def by_turns(
    world: World, kinds: list[Character], starts: np.ndarray, stops: np.ndarray, weights: Weights, scale: float, seed: int
) -> Simulation:  # fmt: skip
    """Characters of these kinds by turns, so much wider than people, who walk from starts (C, 3) to stops (C, P, 2)."""
    who = [kinds[c % len(kinds)] for c in range(len(starts))]
    return Simulation(world, who, WalkTo(starts, stops, near=1.2 * scale), seed, weights=weights)


def counterflow(
    count: int, gap: float = 3.0, weights: Weights = PEOPLE, names: tuple[str, ...] = ("human",), seed: int = 1
) -> Simulation:
    """So many a side go against each other through a gap of this width [m]: characters of these names by turns; all lengths
    are as much larger as the widest of them is wider than people."""
    kinds, scale = kinds_of(names)
    rows = 8 if count > 40 else 4
    columns = -(-count // rows)
    size = (2 * (1.6 * columns + 6.0), max(14.0, 1.6 * rows + 4))
    x, y = size[0] / 2, size[1] / 2
    half = 0.5 * (gap + THICK)
    column, row = np.divmod(np.arange(count), rows)
    from_gap, aside = 3 + 0.8 * (columns - 1 - column), 0.8 * (row - (rows - 1) / 2)
    ahead = list(zip(from_gap.tolist(), aside.tolist(), strict=True))
    begin = np.concatenate([[[-f, a, 0.0] for f, a in ahead], [[f, a, np.pi] for f, a in ahead]])
    end = np.concatenate([np.stack([s * (4 + 1.6 * column), 2 * aside], axis=1) for s in (1, -1)])
    begin[:, :2] += (x, y)
    begin[:, :2] *= scale
    lines = [[(scale * x, scale * v) for v in ends] for ends in ((0, y - half), (size[1], y + half))]
    world = World("counterflow", (scale * size[0], scale * size[1]), walls=walls(*lines))
    return by_turns(world, kinds, begin, scale * (end + (x, y))[:, None], weights, scale, seed)


def last_through(flow: Flow) -> float:
    """When the last is through the middle of the world [s]; inf: not all are."""
    x, first = flow.world.size[0] / 2, flow.place[0, :, 0]
    through = (flow.place[..., 0] - x) * (first - x) < 0
    return float(flow.time[through.argmax(axis=0)].max()) if through.any(axis=0).all() else float("inf")


def in_walls(flow: Flow) -> int:
    """How many places of anyone's centre of mass lie in a wall."""
    found = np.empty((flow.place[..., 0].size, 4))
    survey(flow.world.arrays, np.ascontiguousarray(flow.place.reshape(-1, 2)), found)
    return int((found[:, 3] < 0).sum())


def trajectories(flow: Flow) -> str:
    """The file that PedPy's load_trajectory_from_txt reads: number, frame, x, y, z [m] of everyone at every look."""
    lines = [f"# framerate: {PER_SECOND}", "# id frame x/m y/m z/m"]
    for c in range(flow.place.shape[1]):
        there = np.flatnonzero(~np.isnan(flow.place[:, c, 0])).tolist()
        lines += [f"{c + 1} {k} {flow.place[k, c, 0]:.4f} {flow.place[k, c, 1]:.4f} 0" for k in there]
    return "\n".join(lines) + "\n"
