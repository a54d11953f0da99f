"""The live window: microseconds per step, and E of a wander over the global optimum of the same footprints."""

from statistics import median
from time import perf_counter

import numpy as np

from motion import newton, window
from motion.biped import Biped, load_biped
from motion.jit import jit
from motion.problem import total_cost
from motion.track import Track
from planner.wandering import Wander
from sim.crowd import TENTATIVE, track_of
from sim.rounds import window_end
from sim.simulation import Simulation
from worlds.level import load_level

STEPS = 100
REPEATS = 5
SAMPLES = 10


def wander_windows(character: str = "human", seed: int = 1) -> tuple[Simulation, np.ndarray, np.ndarray, list[float]]:
    """A wander of STEPS steps: the simulation, its whole curve (time, control), seconds per window solve."""
    biped = load_biped(character)
    sim = Simulation(load_level("forest"), [biped], Wander(), seed)
    times, controls, seconds = [0.0], [sim.crowd.control[0, 0].copy()], []
    while sim.crowd.number[0] < STEPS:
        before = [array[0].copy() for array in (sim.crowd.window_time, sim.crowd.window_control)]
        kept, committed = int(sim.crowd.window_count[0]), times[-1]
        sim.tick()
        if sim.crowd.curve_time[0, sim.crowd.curve_count[0]] <= committed:
            continue
        time, control, _ = sim.curve(0)
        if sim.crowd.number[0] > 4:
            seconds.append(_solve_time(sim, biped, committed, controls[-1], before[0][:kept], before[1][:kept]))
        new = time > committed + 1e-9
        times += time[new].tolist()
        controls += list(control[new])
    return sim, np.array(times), np.array(controls), seconds


def _solve_time(sim: Simulation, biped: Biped, begin, start, old_time, old_control) -> float:
    """Seconds to solve the window that the tick just solved again, from the same warm start, without Python's share."""
    last = int(sim.crowd.real[0]) - 1 + TENTATIVE
    track = track_of(sim.crowd, 0, last + 1)
    state = (sim.bipeds[0], track, begin, window_end(track), start, old_time, old_control, sim.effort)
    _solve_often(1, *state)
    began = perf_counter()
    _solve_often(REPEATS, *state)
    return (perf_counter() - began) / REPEATS


@jit
def _solve_often(times, b, track, begin, end, start, old_time, old_control, effort):
    for _ in range(times):
        window.optimise_window(b, track, begin, end, start, old_time, old_control, effort)


def whole_track(sim: Simulation) -> Track:
    """All footprints of the first character as one track."""
    log = sim.footprints.arrays(sim.crowd)
    return Track(**{key: np.ascontiguousarray(log[f"footprint_{key}"]) for key in Track._fields})


def over_global(sim: Simulation, times: np.ndarray, controls: np.ndarray) -> float:
    """E of the committed curve over the tightly solved optimum of the same footprints and start."""
    track = whole_track(sim)
    walking = times >= track.contact_time[3] - 1e-9  # the standing start is left out
    times, controls = times[walking], controls[walking]
    problem, _ = window.build_problem(sim.bipeds[0], track, times[0], times[-1], SAMPLES, False)
    if len(problem.time) != len(times) or np.abs(problem.time - times).max() > 1e-6:
        raise RuntimeError("the committed curve's phases are not those of the footprints")
    committed = total_cost(problem, controls)
    best = controls.copy()
    problem.fixed[0] = True
    return committed / newton.minimise(problem, best, newton.TIGHT)[0]


def report() -> dict:
    """{"us_per_step", "cost_over_global"}; medians over the steps of a wander."""
    sim, times, controls, seconds = wander_windows()
    return {"us_per_step": 1e6 * median(seconds), "cost_over_global": over_global(sim, times, controls)}
