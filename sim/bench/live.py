"""The live window: microseconds per step; E of each window over the same window solved tightly; E of the committed curve
over the global optimum of the same footprints."""

from statistics import median
from time import perf_counter
from typing import NamedTuple

import numpy as np

from motion.characters.biped import load_biped
from motion.com import laying, newton, window
from motion.com.problem import total_cost
from motion.track.footprints import Track
from planner.wandering import Wander
from sim.rows.crowd import TENTATIVE, copied_track
from sim.rows.rounds import window_end
from sim.stage.simulation import Simulation
from worlds.compiled.jit import jit
from worlds.level import load_level

STEPS = 100
REPEATS = 5
SAMPLES = 10


class Window(NamedTuple):
    """Arguments of motion.com.window.optimise_window but for the effort, copied."""

    b: np.record
    track: Track
    begin: float
    end: float
    start: np.ndarray
    old_time: np.ndarray
    old_control: np.ndarray


def wander_windows(character: str = "human", seed: int = 1) -> tuple[Simulation, np.ndarray, np.ndarray, list[Window]]:
    """A wander of STEPS steps: the simulation, its whole curve (time, control), and the windows it solved."""
    sim = Simulation(load_level("forest"), [load_biped(character)], Wander(), seed)
    sim.footprints.keep(sim.crowd)
    times, controls, windows = [0.0], [sim.crowd.control[0, 0].copy()], []
    while sim.crowd.number[0] < STEPS:
        before = [array[0].copy() for array in (sim.crowd.window_time, sim.crowd.window_control)]
        kept, committed = int(sim.crowd.window_count[0]), times[-1]
        sim.tick()
        if sim.crowd.curve_time[0, sim.crowd.curve_count[0]] <= committed:
            continue
        time, control, _ = sim.curve(0)
        if sim.crowd.number[0] > 4:
            windows.append(_window(sim, committed, controls[-1], before[0][:kept], before[1][:kept]))
        new = time > committed + 1e-9
        times += time[new].tolist()
        controls += list(control[new])
    return sim, np.array(times), np.array(controls), windows


def _window(sim: Simulation, begin, start, old_time, old_control) -> Window:
    """The window that the tick just solved."""
    last = int(sim.crowd.real[0]) - 1 + TENTATIVE
    track = copied_track(sim.crowd, 0, last + 1)
    return Window(sim.bipeds[0], track, begin, window_end(track), start, old_time, old_control)


def solve(one: Window, effort: newton.Effort) -> tuple[np.ndarray, np.ndarray, float, int]:
    """(time, control, E, iterations) of a window from its own warm start."""
    time, control, support = _room(one)
    points, e, iterations = window.optimise_window(*one[:5], len(one.old_time), time, control, support, effort)
    return time[:points], control[:points], e, iterations


def _room(one: Window) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """time, control and support that hold the previous window's curve, and will hold this one's."""
    room, kept = 2 * len(one.track.side) + 3, len(one.old_time)
    time, control = np.zeros(room), np.zeros((room, 6))
    time[:kept], control[:kept] = one.old_time, one.old_control
    return time, control, np.zeros((room, 2), np.int64)


def solve_seconds(windows: list[Window], effort: newton.Effort) -> list[float]:
    """Seconds to solve each window, from its own warm start, without Python's share."""
    seconds = []
    for one in windows:
        _solve_often(1, *one, *_room(one), effort)
        began = perf_counter()
        _solve_often(REPEATS, *one, *_room(one), effort)
        seconds.append((perf_counter() - began) / REPEATS)
    return seconds


def over_tight(windows: list[Window], effort: newton.Effort) -> float:
    """E of all windows over E of the same windows solved tightly: the better from the same start or on from the solution."""
    live, tight = 0.0, 0.0
    for one in windows:
        control = solve(one, effort)[1]
        problem, _ = window.lay_window(*one[:4])
        again = np.zeros_like(control)
        window.begin_window(one.track, problem, again, *one[4:])
        live += total_cost(problem, control)
        tight += min(newton.minimise(problem, x, newton.TIGHT)[0] for x in (control, again))
    return live / tight


@jit
def _solve_often(times, b, track, begin, end, start, old_time, old_control, time, control, support, effort):
    for _ in range(times):
        time[: len(old_time)] = old_time
        control[: len(old_time)] = old_control
        window.optimise_window(b, track, begin, end, start, len(old_time), time, control, support, effort)


def whole_track(sim: Simulation) -> Track:
    """All footprints of the first character as one track."""
    log = sim.footprints.arrays(sim.crowd)
    return Track(**{key: np.ascontiguousarray(log[f"footprint_{key}"]) for key in Track._fields})


def over_global(sim: Simulation, times: np.ndarray, controls: np.ndarray) -> float:
    """E of the committed curve over the tightly solved optimum of the same footprints and start."""
    track = whole_track(sim)
    walking = times >= track.contact_time[3] - 1e-9  # the standing start is left out
    times, controls = times[walking], controls[walking]
    problem, _ = laying.build_problem(sim.bipeds[0], track, times[0], times[-1], SAMPLES, False)
    if len(problem.time) != len(times) or np.abs(problem.time - times).max() > 1e-6:
        raise RuntimeError("the committed curve's phases are not those of the footprints")
    committed = total_cost(problem, controls)
    best = controls.copy()
    problem.fixed[0] = True
    return committed / newton.minimise(problem, best, newton.TIGHT)[0]


def report() -> dict:
    """{"us_per_step" (median over the steps of a wander), "cost_over_tight", "cost_over_global"}."""
    sim, times, controls, windows = wander_windows()
    return {
        "us_per_step": 1e6 * median(solve_seconds(windows, sim.effort)),
        "cost_over_tight": over_tight(windows, sim.effort),
        "cost_over_global": over_global(sim, times, controls),
    }
