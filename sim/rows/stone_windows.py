"""The window of who steps from stone to stone: solved as that of a walk is, but begun otherwise.

No stride is like the one before, so nothing repeats; but all that is expected is known. What the last window found is taken at
the times at which the feet now land; beyond it the body is guessed over the feet, and there, softly, the window's end is held.
From this guess the solver is where it ends after a third of the iterations that it takes from a walk's.
"""

from typing import NamedTuple

import numpy as np

from motion.characters.dimensions import Dimensions
from motion.com.newton import Effort
from motion.com.problem import Problem
from motion.com.standing import above_feet
from motion.com.window import lay_window, minimise_hard, put_window
from motion.track.curve import Curve, end_acceleration, evaluate, up_to
from motion.track.footprints import Footprints
from sim.rows.crowd import TENTATIVE, commit, committed_of, footprints_of
from sim.rows.rounds import open_work
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.parts import Part
from worlds.compiled.tables import row

END_STIFFNESS = (10.0, 0.2)
"""Of the window's end, position [1/s/m] and velocity [s/m]: the position keeps the solver near, the velocity is but guessed."""


class Expected(NamedTuple):
    """When the feet of a window land [s]: the newest real one and those that are expected behind it."""

    first: float
    second: float
    third: float
    fourth: float


@jit_borrowing
def expected(footprints: Footprints, n: int) -> Expected:
    """Of the footprints from n on."""
    t = footprints.contact_time
    return Expected(t[n], t[n + 1], t[n + 2], t[n + 3])


@jit_borrowing
def retime(window: Curve, points: int, was: Expected, now: Expected) -> None:
    """The last window's curve, of so many points, at other times of the contacts, in proportion between them."""
    for i in range(points):
        t = window.time[i]
        if t <= was[0]:
            continue
        k = 2 if t > was[2] else (1 if t > was[1] else 0)
        pace = (was[k + 1] - was[k]) / (now[k + 1] - now[k])
        window.time[i] = now[k] + (t - was[k]) / pace
        for axis in range(3, 6):
            window.control[i, axis] *= pace


@jit_borrowing
def _middle(footprints: Footprints, k: int, axis: int) -> float:
    """Where the body is in the middle of stance k: half way from the foot to the line between its neighbours."""
    p, last = footprints.position, len(footprints.side) - 1
    if axis == 2 or k == 0 or k == last:
        return p[k, axis]
    return 0.5 * p[k, axis] + 0.25 * (p[k - 1, axis] + p[k + 1, axis])


@jit_borrowing
def _over_feet(footprints: Footprints, t: float, height: float, state: np.ndarray) -> None:
    """Fills state (6,) with place and velocity at time t [s]: straight from the middle of a stance to that of the next."""
    f, k = footprints, len(footprints.side) - 2
    while k > 0 and f.contact_time[k] + 0.5 * f.stance_time[k] > t:
        k -= 1
    begin, end = f.contact_time[k] + 0.5 * f.stance_time[k], f.contact_time[k + 1] + 0.5 * f.stance_time[k + 1]
    for axis in range(3):
        p, q = _middle(f, k, axis), _middle(f, k + 1, axis)
        state[3 + axis] = (q - p) / (end - begin)
        state[axis] = p + (t - begin) * state[3 + axis]
    state[2] += height


@jit
def begin_on_stones(
    biped: Dimensions, footprints: Footprints, problem: Problem, control: np.ndarray, committed: Curve, last: Curve
) -> None:
    """Fills control with the end of the committed curve, which stays, and the first guess of the rest; `last` may be empty."""
    end, m, scratch = len(committed.time) - 1, len(problem.time) - 1, np.empty(6)
    for k in range(6):
        control[0, k] = committed.control[end, k]
    problem.fixed[0] = True
    if end > 0:
        end_acceleration(committed, problem.bend[0])
    above_feet(biped, footprints, scratch)
    height = scratch[2] - 0.5 * (footprints.position[-1, 2] + footprints.position[-2, 2])
    for i in range(1, m + 1):
        if len(last.time) > 1 and problem.time[i] <= last.time[-1]:
            evaluate(last, problem.time[i], control[i, :3], control[i, 3:], scratch[:3])
        else:
            _over_feet(footprints, problem.time[i], height, control[i])
    _over_feet(footprints, problem.time[m], height, problem.anchor)
    problem.anchor_stiffness[0], problem.anchor_stiffness[1] = END_STIFFNESS


@jit
def _optimise(
    biped: Dimensions, footprints: Footprints, committed: Curve, window: Curve, points: int, effort: Effort
) -> tuple[int, float, int]:
    """motion.com.window.optimise_window for stones: (control points, E, iterations)."""
    problem, stand = lay_window(biped, footprints, committed.time[-1])
    found = np.zeros((len(problem.time), 6))
    begin_on_stones(biped, footprints, problem, found, committed, up_to(window, points - 1))
    e, iterations = minimise_hard(problem, found, effort)  # what stays hard is not begun anew: it never was a walk
    put_window(window, problem, found, stand)
    return len(found), e, iterations


@Part
def optimise_stones(address: int, c: int) -> None:
    """sim.rows.rounds.optimise_step for the Work of stepping stones."""
    work = open_work(address)
    crowd = work.crowd
    n, window = crowd.real[c] - 1, row(crowd.window, c)
    footprints = footprints_of(crowd, c, n + TENTATIVE + 1)
    points, e, iterations = _optimise(
        work.round.bipeds[crowd.kind[c]], footprints, committed_of(crowd, c), window, crowd.points[c], work.effort,
    )  # fmt: skip
    crowd.points[c], crowd.window_cost[c, 0], crowd.window_cost[c, 1] = points, e, iterations
    commit(crowd, c, up_to(window, points - 1), footprints.contact_time[n - 1])
