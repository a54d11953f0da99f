"""Bodies that would touch press each other apart.

Plans keep bodies apart, but the com sways beside its plan. Where a body that has just been solved would lie in another's,
springs pull its com out of it, until it does not; so of any two, who is committed later keeps off the other.
"""

from typing import Any

import numpy as np

from motion.characters.dimensions import Dimensions
from motion.com import newton
from motion.com import problem as problems
from motion.com.newton import Effort
from motion.com.window import ANCHOR_STIFFNESS, Solved, lay_window, on_pieces, put_window
from motion.track.curve import Curve, end_acceleration
from motion.track.footprints import Footprints
from planner.round.reservations import Reservations
from sim.rows.crowd import TENTATIVE, Crowd, committed_of, footprints_of, horizon
from sim.rows.touching import close, place_of, press
from worlds.compiled.jit import jit, jit_borrowing, stack_array
from worlds.compiled.tables import row

MOMENTS = 5
"""At so many bodies are looked at until what is committed ends, and at as many more until the newest foot lands."""
TIMES = 5
"""So often a window is solved again at most."""
STIFFNESS = 2000.0
"""Of a spring that pulls one body out of another [1/s/m]: more lets them overlap less, and pushes harder."""
DEAREST = 1.0
"""A press may make a window cost so much more [m/s]; a body that would be thrown aside for more, as where a planner wants it to
go through another, or one has just changed its kind, is left where it was."""
MOST = 96
"""Where more others than this are near, one looks for those who are nearer."""
_others = stack_array(MOST, dtype=np.int64)


@jit
def _solve_pressed(
    biped: Dimensions, footprints: Footprints, committed: Curve, window: Curve, points: int, pull: np.ndarray, effort: Effort
) -> Solved:
    """Solves a window of so many control points again from what was found, with springs (P, 5) that pull the com: time [s],
    place [m], stiffness [1/s/m]; in place. Its end stays about where it was found."""
    problem, stand = lay_window(biped, footprints, window.time[0])
    pulls = np.concatenate((problem.pull, on_pieces(problem.time, pull)))
    problem = problems.with_effort(problem, problem.strength, problem.jerk_weight, pulls)
    found = window.control[:points].copy()
    problem.fixed[0] = True
    if len(committed.time) > 1:
        end_acceleration(committed, problem.bend[0])
    problem.anchor[:] = found[points - 1]
    problem.anchor_stiffness[0], problem.anchor_stiffness[1] = ANCHOR_STIFFNESS
    e, iterations = newton.minimise(problem, found, effort)
    put_window(window, problem, found, stand)
    return Solved(e, iterations)


@jit_borrowing
def _add_presses(crowd: Crowd, bipeds: Any, held: Reservations, c: int, near: np.ndarray, pull: np.ndarray) -> bool:
    """Moves the places of springs (P, 5) by how far others press c's body then; returns whether any does."""
    found = False
    for m in range(len(pull)):
        dx, dy = press(crowd, bipeds, held, c, pull[m, 0], near)
        if dx != 0 or dy != 0:
            pull[m, 1] += dx
            pull[m, 2] += dy
            pull[m, 4], found = STIFFNESS, True
    return found


@jit_borrowing
def _lay_springs(crowd: Crowd, c: int, pull: np.ndarray) -> None:
    """Fills in springs (2 MOMENTS, 5) that would hold c's com where it was found; none has a stiffness yet."""
    n, contact = crowd.real[c] - 1, crowd.footprints.contact_time
    for m in range(2 * MOMENTS):
        begin, end = (horizon(crowd, c), contact[c, n - 1]) if m < MOMENTS else (contact[c, n - 1], contact[c, n])
        pull[m, 0], pull[m, 4] = begin + (end - begin) * (m % MOMENTS + 1) / MOMENTS, 0.0
        pull[m, 1], pull[m, 2], pull[m, 3] = place_of(crowd, c, pull[m, 0])


@jit_borrowing
def press_apart(crowd: Crowd, bipeds: Any, held: Reservations, c: int, solved: Solved, effort: Effort) -> Solved:
    """Solves c's window again, where its body would lie in others. solved: what was found; returns what is found then."""
    near = _others()
    count = close(crowd, held, c, near)
    return _press_apart(crowd, bipeds, held, (c, solved, effort), near[:count]) if count > 0 else solved


@jit
def _press_apart(
    crowd: Crowd, bipeds: Any, held: Reservations, own: tuple[int, Solved, Effort], near: np.ndarray
) -> Solved:  # fmt: skip
    c, solved, effort = own
    pull = np.empty((2 * MOMENTS, 5))
    _lay_springs(crowd, c, pull)
    footprints = footprints_of(crowd, c, crowd.real[c] + TENTATIVE)
    found, iterations = solved, solved.iterations
    for _ in range(TIMES):
        if not _add_presses(crowd, bipeds, held, c, near, pull):
            break
        springs, before = pull[pull[:, 4] > 0], crowd.window.control[c].copy()
        pressed = _solve_pressed(
            bipeds[crowd.kind[c]], footprints, committed_of(crowd, c), row(crowd.window, c), crowd.points[c], springs, effort
        )
        iterations += pressed.iterations
        if pressed.cost > solved.cost + DEAREST:
            crowd.window.control[c] = before
            break
        found = pressed
    return Solved(found.cost, iterations)
