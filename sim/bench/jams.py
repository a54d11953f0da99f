"""What a walker in a jam costs, and how long it takes until a large crowd has begun: by the processor time of this process.

Processor time does not count what other programs take; planning and optimising run on one thread.
"""

from collections.abc import Callable
from time import process_time

import numba

from motion.characters.character import load_character
from planner.modes.wander import Wander
from sim.bench.crowds import open_forest
from sim.stage.simulation import Simulation

DENSITIES = (1.0, 2.0)
"""People per square metre, on a ring."""
SETTLE = 5.0
"""Seconds before anything is timed: the jam has formed."""
MANY = 10_000


def _cost(sim: Simulation, seconds: float) -> float:
    """Milliseconds of one core per person and simulated second, planning and optimising, without poses."""
    while sim.time < SETTLE:
        sim.tick()
    began = process_time()
    while sim.time < SETTLE + seconds:
        sim.tick()
    return 1e3 * (process_time() - began) / seconds / len(sim.characters)


def _beginning(count: int) -> float:
    """Seconds of one core until so many wanderers in an open forest have planned their first steps; kernels are loaded."""
    world, bird = open_forest(count), load_character("bird")
    Simulation(open_forest(2), [bird] * 2, Wander(), 1).tick()
    began = process_time()
    Simulation(world, [bird] * count, Wander(), 1)
    return process_time() - began


def report(ring: Callable[[float], Simulation], seconds: float, count: int) -> dict:
    """{"ms_per_character_second" by density [1/m^2] of people whom `ring` makes, "begin_s" by number of characters}."""
    threads = numba.get_num_threads()
    numba.set_num_threads(1)
    try:
        costs = {f"{density:g}": _cost(ring(density), seconds) for density in DENSITIES}
        return {"ms_per_character_second": costs, "begin_s": {str(count): _beginning(count)}}
    finally:
        numba.set_num_threads(threads)


def in_words(figures: dict) -> list[str]:
    """A line for each."""
    costs = ", ".join(f"{ms:.2f} at {density}" for density, ms in figures["ms_per_character_second"].items())
    jam = f"people in a jam: ms of a core per character and second {costs} per square metre"
    return [jam, *(f"{count} wanderers have begun after {s:.1f} s of a core" for count, s in figures["begin_s"].items())]
