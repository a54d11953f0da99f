"""The live window: microseconds per step; E of the committed curve over that of windows solved tightly, and over the global
optimum of the same footprints."""

from statistics import median
from time import thread_time
from typing import NamedTuple

import numpy as np

from motion.characters.character import load_character
from motion.characters.dimensions import Dimensions
from motion.com import laying, newton, window
from motion.com.newton import Effort
from motion.com.problem import Problem, total_cost
from motion.track.curve import Curve
from motion.track.footprints import Footprints
from planner.modes.wander import Wander
from sim.rows.crowd import TENTATIVE, WINDOW
from sim.stage.simulation import Simulation
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.tables import copied, empty, picked
from worlds.level import load_level

STEPS = 100
REPEATS = 50


class Window(NamedTuple):
    """Arguments of motion.com.window.optimise_window but for the effort, copied."""

    biped: Dimensions
    footprints: Footprints
    committed: Curve  # up to where it begins
    last: Curve  # what the last window had found


def wander_windows(character: str = "human", seed: int = 1) -> tuple[Simulation, Curve, list[Window]]:
    """A wander of STEPS steps: the simulation, its whole curve, and the windows it solved."""
    sim = Simulation(load_level("forest"), [load_character(character)], Wander(), seed)
    sim.keep_footprints()
    pieces, windows = [sim.curve(0)], []
    while sim.crowd.number[0] < STEPS:
        last = copied(picked(sim.crowd.window, (0, slice(0, int(sim.crowd.points[0])))))
        committed = sim.curve(0)
        begin = float(committed.time[-1])
        sim.tick()
        curve = sim.curve(0)
        if curve.time[-1] <= begin:
            continue
        if sim.crowd.number[0] > 4:
            windows.append(_window(sim, committed, last))
        pieces.append(picked(curve, curve.time > begin + 1e-9))
    return sim, Curve(*(np.concatenate(columns) for columns in zip(*pieces, strict=True))), windows


def _window(sim: Simulation, committed: Curve, last: Curve) -> Window:
    """The window that the tick just solved."""
    count = int(sim.crowd.real[0]) + TENTATIVE
    footprints = copied(picked(sim.crowd.footprints, (0, slice(0, count))))
    return Window(sim.bipeds[0], footprints, committed, last)


def solve(one: Window, effort: Effort) -> tuple[Curve, float, int]:
    """(curve, E, iterations) of a window from its own warm start."""
    room = _room(one)
    points, solved = window.optimise_window(one.biped, one.footprints, one.committed, room, len(one.last.time), effort)
    return picked(room, slice(0, points)), solved.cost, solved.iterations


def _room(one: Window) -> Curve:
    """A curve with rows for all that there can be, which begins with the last window's."""
    room = empty(Curve, WINDOW)
    for column, values in zip(room, one.last, strict=True):
        column[: len(values)] = values
    return room


def solve_seconds(windows: list[Window], effort: Effort) -> list[float]:
    """Seconds to solve each window, from its own warm start, without Python's share."""
    seconds = []
    for one in windows:
        _solve_often(1, one, _room(one), effort)
        began = thread_time()
        _solve_often(REPEATS, one, _room(one), effort)
        seconds.append((thread_time() - began) / REPEATS)
    return seconds


def walked_again(sim: Simulation, windows: list[Window], effort: Effort) -> Curve:
    """The curve of the same wander, had its windows been solved with that effort."""
    pieces, last = [windows[0].committed], windows[0].last
    ends = [float(one.committed.time[-1]) for one in windows[1:]] + [float(sim.curve(0).time[-1])]
    for one, end in zip(windows, ends, strict=True):
        last = solve(one._replace(committed=pieces[-1], last=last), effort)[0]
        pieces.append(picked(last, slice(0, int(np.searchsorted(last.time, end + 1e-9)))))
    return Curve(*(np.concatenate([pieces[0][k], *(piece[k][1:] for piece in pieces[1:])]) for k in range(3)))


@jit_borrowing
def _copy(source: Curve, goal: Curve) -> None:
    """Control points into the first rows of a longer curve."""
    for i in range(len(source.time)):
        goal.time[i] = source.time[i]
        for k in range(6):
            goal.control[i, k] = source.control[i, k]


@jit
def _solve_often(times: int, one: Window, room: Curve, effort: Effort) -> None:
    kept = len(one.last.time)
    for _ in range(times):
        _copy(one.last, room)
        window.optimise_window(one.biped, one.footprints, one.committed, room, kept, effort)


def _walked(sim: Simulation, curve: Curve) -> tuple[Problem, np.ndarray]:
    """The problem of the footprints that were walked, and a curve's control points on it, but for the standing start."""
    footprints = sim.walked().footprints
    walking = curve.time >= footprints.contact_time[3] - 1e-9
    times, controls = curve.time[walking], curve.control[walking]
    problem, _ = laying.build_problem(sim.bipeds[0], footprints, times[0], times[-1], window.LIVE._replace(samples=5, rough=0))
    if len(problem.time) != len(times) or np.abs(problem.time - times).max() > 1e-6:
        raise RuntimeError("the committed curve's phases are not those of the footprints")
    return problem, controls


def over_tight(sim: Simulation, curve: Curve, windows: list[Window]) -> float:
    """E of the committed curve over that of the same wander with windows that are solved tightly."""
    tight = walked_again(sim, windows, newton.TIGHT)
    return total_cost(*_walked(sim, curve)) / total_cost(*_walked(sim, tight))


def over_global(sim: Simulation, curve: Curve) -> float:
    """E of the committed curve over the tightly solved optimum of the same footprints and start."""
    problem, controls = _walked(sim, curve)
    best = controls.copy()
    problem.fixed[0] = True
    return total_cost(problem, controls) / newton.minimise(problem, best, newton.TIGHT)[0]


def report() -> dict:
    """{"us_per_step" (median over the steps of a wander), "cost_over_tight", "cost_over_global"}."""
    sim, curve, windows = wander_windows()
    return {
        "us_per_step": 1e6 * median(solve_seconds(windows, newton.LIVE)),
        "cost_over_tight": over_tight(sim, curve, windows),
        "cost_over_global": over_global(sim, curve),
    }
