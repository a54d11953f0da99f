"""Crowds of wanderers in an open forest: how far they keep real time, what a tick costs, and how that grows."""

from statistics import median
from time import perf_counter

import numba
import numpy as np

from motion.characters.character import load_character
from motion.pose.pose import empty_pose
from planner.modes.wander import Wander
from planner.round import reservations
from planner.round.kernel import ROUND
from sim.rows import rounds
from sim.stage.simulation import Simulation
from worlds.compiled.jit import jit
from worlds.compiled.memory import Held
from worlds.compiled.parts import call
from worlds.compiled.tables import copied
from worlds.world import World

SETTLE = 90
"""Ticks before anything is timed: nobody stands any more."""
FRAMES = 30
"""Poses of everyone per simulated second."""
SAMPLE = 4096
"""Characters whose next step is timed part by part."""
PER_CHARACTER, PER_TREE = 36.0, 60.0
"""Square metres."""


def open_forest(n: int) -> World:
    """Flat ground with a tree per PER_TREE and room for n characters."""
    side = max(40.0, (PER_CHARACTER * n) ** 0.5)
    places = np.random.Generator(np.random.Philox(key=7)).uniform(2, side - 2, (int(side * side / PER_TREE), 2))
    places = places[np.hypot(*(places - side / 2).T) > 3]
    trees = np.column_stack([places, np.full(len(places), 0.3)])
    return World("open forest", (side, side), trees=trees, start=(side / 2, side / 2))


def measure(n: int, seconds: float, character: str = "bird") -> dict:
    """Figures of n wanderers: simulated over wall seconds without and with poses, on one thread and on two."""
    sim = Simulation(open_forest(n), [load_character(character)] * n, Wander(), 1)
    for _ in range(SETTLE):
        sim.tick()
    sim.snapshot()  # the first one loads kernels
    threads = numba.get_num_threads()
    begun = int(sim.crowd.number.sum())
    ticks, poses = _run(sim, seconds)
    steps = int(sim.crowd.number.sum()) - begun
    figures = {
        "realtime_ratio": seconds / sum(ticks),
        "realtime_ratio_with_poses": seconds / (sum(ticks) + sum(poses)),
        "threads": threads,
        "tick_ms_median": 1e3 * median(ticks),
        "tick_ms_p99": 1e3 * float(np.percentile(ticks, 99)),
        "tick_ms_max": 1e3 * max(ticks),
        "steps_per_second": steps / seconds / n,
        "ms_per_character_second": 1e3 * (sum(ticks) + sum(poses)) / seconds / n,
        "bytes_per_character": _bytes(sim) / n,
    }
    numba.set_num_threads(1)
    try:
        alone = _run(sim, seconds)
        figures["realtime_ratio_with_poses_1_thread"] = seconds / sum(map(sum, alone))
        return figures | _parts(sim, sum(alone[1]) / len(alone[1]) / n)
    finally:
        numba.set_num_threads(threads)


def _run(sim: Simulation, seconds: float) -> tuple[list[float], list[float]]:
    """Wall seconds of each tick, and of posing everyone FRAMES times per simulated second."""
    pose, rows = empty_pose(len(sim.characters)), np.arange(len(sim.characters))
    ticks, poses = [], []
    for k in range(int(seconds * sim.tick_rate)):
        begin = perf_counter()
        sim.tick()
        ticks.append(perf_counter() - begin)
        if k % (sim.tick_rate // FRAMES) == 0:
            begin = perf_counter()
            sim.pose_into(pose, sim.time, rows)
            poses.append(perf_counter() - begin)
    return ticks, poses


def _parts(sim: Simulation, pose_seconds: float) -> dict:
    """Microseconds of one core: of planning and of optimising a step, told on a copy of the crowd, and of a pose."""
    crowd = copied(sim.crowd)
    rows = np.sort(np.argsort(sim.reservations.due, kind="stable")[:SAMPLE])
    reservations.sort_into_cells(sim.reservations)
    parts, round = rounds.compiled_parts(), Held(sim.work.value.round._replace(intents=crowd.intents), ROUND)
    work = Held(sim.work.value._replace(crowd=crowd, round=round.value, round_at=round.address), rounds.WORK)
    _of_rows(parts.plan, work.address, rows[:0])
    begin = perf_counter()
    _of_rows(parts.plan, work.address, rows)
    planned = perf_counter()
    _of_rows(parts.optimise, work.address, rows)
    solved = perf_counter()
    return {
        "planning_us_per_step": 1e6 * (planned - begin) / len(rows),
        "optimising_us_per_step": 1e6 * (solved - planned) / len(rows),
        "posing_us": 1e6 * pose_seconds,
    }


@jit
def _of_rows(part: int, address: int, rows: np.ndarray) -> None:
    for c in rows:
        call(part, address, c)


def _bytes(sim: Simulation) -> int:
    """Of the arrays that hold the characters: what they do, and what the others see of them."""
    return _size(sim.crowd) + _size(sim.reservations)


def _size(table: object) -> int:
    """Bytes of the arrays of a tuple, and of tuples in it."""
    if isinstance(table, tuple):
        return sum(_size(part) for part in table)
    return table.nbytes if isinstance(table, np.ndarray) else 0


def growth(by_count: dict[str, dict]) -> float | None:
    """Exponent p of cost ~ characters^p over crowds of 1000 and more; 1 is a flat cost per character."""
    many = [(int(n), row["ms_per_character_second"]) for n, row in by_count.items() if int(n) >= 1000]
    if len(many) < 2:
        return None
    count, cost = np.log(np.array(many)).T
    return 1 + float(np.polyfit(count, cost, 1)[0])


def in_words(by_count: dict[str, dict]) -> list[str]:
    """A line for each crowd."""
    return [
        f"{n} character(s): {row['realtime_ratio']:.2f} times real time, {row['realtime_ratio_with_poses']:.2f} with "
        f"{FRAMES} poses/s ({row['realtime_ratio_with_poses_1_thread']:.2f} on one thread); "
        f"tick median {row['tick_ms_median']:.2f}, 99 % {row['tick_ms_p99']:.2f}, worst {row['tick_ms_max']:.2f} ms; "
        f"us of a core: planning {row['planning_us_per_step']:.0f} and optimising {row['optimising_us_per_step']:.0f} "
        f"per step, {row['posing_us']:.1f} per pose; {row['bytes_per_character'] / 1024:.1f} KB each"
        for n, row in by_count.items()
    ]
