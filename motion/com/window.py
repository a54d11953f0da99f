"""From timed footprints to their COM curve: of a whole track, and of the live window (paper, sections 2.3 and 4.2).

When footprint n is placed, step n gets its timing and step n-1, which is about to be executed, is optimised together with
step n and the planner's tentative footprints beyond it; then step n-1 is committed and never changes again. The window's
first control point is the end of what is already committed.
"""

from typing import NamedTuple

import numpy as np

from motion.characters.dimensions import Dimensions
from motion.com import guess, laying, newton
from motion.com import problem as problems
from motion.com.newton import Effort
from motion.com.problem import Layout, Problem
from motion.com.standing import above_feet, settling
from motion.track.curve import Curve, end_acceleration, evaluate, segment_at, up_to
from motion.track.footprints import Footprints
from worlds.compiled.jit import jit, jit_borrowing, stack_array

LIVE = Layout(3, False, True, False, 1e-7, 2)
"""Of the live window, whose timing stays: the residual is nearly linear in a piece, three samples find it. The
last two of its steps are rough: that costs less to solve, and what comes of it is no worse (bench --only window)."""
SCENE = Layout(3, False, True, True, 3e-6)
"""Of tracks that are solved as a whole: more pieces, so that the curve follows a timing that is dragged without a jump."""
PHASE, STEP = Layout(10, False, False, False, 0.0), Layout(10, True, False, False, 0.0)
LAYOUTS = {"smooth": SCENE, "phase": PHASE, "step": STEP}
"""By name: several segments to a phase, with continuous forces; one to a phase; one to a step, as in the paper."""
ANCHOR_STIFFNESS = (10.0, 1.0)
"""Of the window's end, position [1/s/m] and velocity [s/m]: more steadies the end, and insists on a foreseen state."""
REST_STIFFNESS = (200.0, 60.0)
"""The same of who stands: it is at rest there."""
STRIDES = 4
"""Footprints after which a walk repeats: twice both feet."""
IRREGULAR = 1.5
"""Ratio of two strides' times from which on one says nothing about the other."""
_empty_state = stack_array(1, 3)


class Span(NamedTuple):
    """A whole motion, or a part of one, between two states that stay."""

    begin: float  # [s]
    end: float  # [s]
    state: np.ndarray  # (2, 6) position and velocity of the com at either end
    bend: np.ndarray  # (2, 3) its acceleration there
    pull: np.ndarray  # (P, 5) soft springs on the com: time [s], place [m], stiffness [1/s/m]


class Solved(NamedTuple):
    """What a solver tells of its work."""

    cost: float  # E
    iterations: int


@jit_borrowing
def _warm_start(problem: Problem, control: np.ndarray, first: int, last: Curve) -> int:
    """Control points from `first` on that lie within the last curve's time take that curve; returns the first beyond it."""
    scratch = _empty_state()
    for i in range(first, len(control)):
        if problem.time[i] > last.time[-1]:
            return i
        evaluate(last, problem.time[i], control[i, :3], control[i, 3:], scratch[0])
    return len(control)


@jit_borrowing
def _regular(footprints: Footprints, newest: int, last: Curve) -> bool:
    """Whether the window's last stride repeats, about, the one two strides before: alternating feet, similar timing."""
    n, contact = newest - STRIDES, footprints.contact_time
    if n < 2 or not last.time[0] <= contact[n] <= last.time[-1]:
        return False
    for k in range(STRIDES):
        i, j = newest - k, n - (k % 2)
        if footprints.side[i] != footprints.side[j] or footprints.side[i] == footprints.side[i - 1]:
            return False
    pace = (contact[newest] - contact[newest - 2]) / (contact[n] - contact[n - 2])
    return 1 / IRREGULAR < pace < IRREGULAR and footprints.side[n] != footprints.side[n - 1]


@jit_borrowing
def _repeat(footprints: Footprints, newest: int, t: float, last: Curve, out: np.ndarray) -> None:
    """Fills out (6,) with the state at time t by that of the last curve STRIDES footprints before.

    It keeps its place between the two feet in their mean heading, and the difference of its velocity from their mean.
    """
    n, position, heading, contact = newest - STRIDES, footprints.position, footprints.heading, footprints.contact_time
    evaluate(last, t - contact[newest] + contact[n], out[:3], out[3:], _empty_state()[0])
    turn = 0.5 * (heading[newest] + heading[newest - 1] - heading[n] - heading[n - 1])
    c, s = np.cos(turn), np.sin(turn)
    before, after = contact[n] - contact[n - 2], contact[newest] - contact[newest - 2]
    for axis in range(3):
        out[axis] -= 0.5 * (position[n, axis] + position[n - 1, axis])
        out[3 + axis] -= (position[n, axis] - position[n - 2, axis]) / before
    for k in (0, 3):
        out[k], out[k + 1] = c * out[k] - s * out[k + 1], s * out[k] + c * out[k + 1]
    for axis in range(3):
        out[axis] += 0.5 * (position[newest, axis] + position[newest - 1, axis])
        out[3 + axis] += (position[newest, axis] - position[newest - 2, axis]) / after


@jit_borrowing
def _stands(footprints: Footprints) -> bool:
    """Whether it stands at the end, on both feet."""
    newest = len(footprints.side) - 1
    return footprints.stands[newest] and footprints.stands[newest - 1]


@jit_borrowing
def begin_window(
    biped: Dimensions, footprints: Footprints, problem: Problem, control: np.ndarray, committed: Curve, last: Curve
) -> None:
    """Fills control with the end of the committed curve, fixed with its acceleration, and the first guess of the rest.

    Where the window's end is foreseeable, springs hold it there: at rest for who stands, else in the stride's next turn.
    """
    end = len(committed.time) - 1
    for k in range(6):
        control[0, k] = committed.control[end, k]
    problem.fixed[0] = True
    if end > 0:
        end_acceleration(committed, problem.bend[0])
    newest, stands = len(footprints.side) - 1, _stands(footprints)
    if stands:
        above_feet(biped, footprints, problem.anchor)
        problem.anchor_stiffness[0], problem.anchor_stiffness[1] = REST_STIFFNESS
    if len(last.time) < 2:
        guess.straight_guess(problem, control, 1)
        return
    first, m = _warm_start(problem, control, 1, last), len(problem.time) - 1
    if first > m:
        return
    if not stands and _regular(footprints, newest, last):
        for i in range(first, m + 1):
            _repeat(footprints, newest, problem.time[i], last, control[i])
        for k in range(6):
            problem.anchor[k] = control[m, k]
        problem.anchor_stiffness[0], problem.anchor_stiffness[1] = ANCHOR_STIFFNESS
    else:
        guess.straight_guess(problem, control, first)


@jit
def optimise_track(
    biped: Dimensions, footprints: Footprints, span: Span, guess_curve: Curve, layout: Layout, effort: Effort
) -> tuple[Curve, Solved]:
    """Optimises a motion, or a part of one, from a curve over the same time, or from none (of one row).

    At its ends position, velocity and, of a smooth curve, acceleration are fixed: what is before and after fits on.
    """
    problem, support = laying.build_problem(biped, footprints, span.begin, span.end, layout)
    problem = problems.with_effort(problem, problem.strength, problem.jerk_weight, on_pieces(problem.time, span.pull))
    last = len(problem.time) - 1
    control, stand = np.zeros((last + 1, 6)), np.full((last + 1, 2), -1)
    control[0], control[last] = span.state[0], span.state[1]
    problem.bend[:] = span.bend
    problem.fixed[0] = problem.fixed[last] = True
    if len(guess_curve.time) > 1:
        _warm_start(problem, control[:last], 1, guess_curve)
    else:
        guess.straight_guess(problem, control, 1)
    e, iterations = newton.minimise(problem, control, effort)
    stand[:-1] = support
    return Curve(problem.time, control, stand), Solved(e, iterations)


@jit
def on_pieces(time: np.ndarray, pull: np.ndarray) -> np.ndarray:
    """Springs (P, 5) by their times as springs by segments, those within the time (m + 1,) of the segments."""
    out, kept = np.zeros((len(pull), pull.shape[1] + 1)), 0
    for n in range(len(pull)):
        if time[0] < pull[n, 0] < time[-1]:
            i = segment_at(time, pull[n, 0])
            out[kept, 0], out[kept, 1] = i, (pull[n, 0] - time[i]) / (time[i + 1] - time[i])
            out[kept, 2:] = pull[n, 1:]
            kept += 1
    return out[:kept]


@jit_borrowing
def window_end(footprints: Footprints) -> float:
    """Where the window ends [s]: when the last tentative footprint has landed."""
    return footprints.contact_time[len(footprints.side) - 1]


@jit
def lay_window(biped: Dimensions, footprints: Footprints, begin: float) -> tuple[Problem, np.ndarray]:
    """Problem and support of the live window from `begin` [s] on."""
    problem, support = laying.build_problem(biped, footprints, begin, window_end(footprints), LIVE)
    if _stands(footprints):
        pull = on_pieces(problem.time, settling(biped, footprints, problem.time, REST_STIFFNESS[0]))
        problem = problems.with_effort(problem, problem.strength, problem.jerk_weight, pull)
    return problem, support


@jit
def optimise_window(
    biped: Dimensions, footprints: Footprints, committed: Curve, window: Curve, points: int, effort: Effort
) -> tuple[int, Solved]:
    """Optimises the window from the end of the committed curve on, in place; returns its control points.

    `window` holds the last window's curve in its first `points` rows (0: none, a cold start), and this one's afterwards; it has
    rows for all that there can be.
    """
    end = len(committed.time) - 1
    problem, stand = lay_window(biped, footprints, committed.time[end])
    found = np.zeros((len(problem.time), 6))
    begin_window(biped, footprints, problem, found, committed, up_to(window, points - 1))
    e, iterations = minimise_hard(problem, found, effort)
    if is_hard(problem, e, effort):
        e, more = _begin_anew(problem, found, e)
        iterations += more
    put_window(window, problem, found, stand)
    return len(found), Solved(e, iterations)


@jit_borrowing
def put_window(window: Curve, problem: Problem, control: np.ndarray, support: np.ndarray) -> None:
    """What was found, control (m + 1, 6) and support (m, 2), into the first rows of a window; a slice compiles for long."""
    for i in range(len(control)):
        window.time[i] = problem.time[i]
        for k in range(6):
            window.control[i, k] = control[i, k]
    for i in range(len(support)):
        window.support[i, 0], window.support[i, 1] = support[i, 0], support[i, 1]


@jit_borrowing
def is_hard(problem: Problem, e: float, effort: Effort) -> bool:
    """Whether a window costs more than those of a walk do."""
    return e > effort.hard * (problem.time[-1] - problem.time[0])


@jit
def minimise_hard(problem: Problem, control: np.ndarray, effort: Effort) -> tuple[float, int]:
    """newton.minimise, and more effort where that leaves the window hard; returns (E, iterations)."""
    return _minimise_hard(newton.workspace(problem), problem, control, effort)


@jit_borrowing
def _minimise_hard(work: newton.Workspace, problem: Problem, control: np.ndarray, effort: Effort) -> tuple[float, int]:
    e, iterations = newton.minimise_in(work, problem, control, effort)
    if is_hard(problem, e, effort):
        e, more = newton.minimise_in(work, problem, control, newton.HARDER)
        iterations += more
    return e, iterations


@jit
def _begin_anew(problem: Problem, control: np.ndarray, e: float) -> tuple[float, int]:
    """The better of the curve found, of cost e, and one from a cold start: a bad last window must not spoil all that follow."""
    cold = control.copy()
    guess.straight_guess(problem, cold, 1)
    cold_e, iterations = newton.minimise(problem, cold, newton.ANEW)
    if cold_e < e:
        for i in range(len(control)):
            for k in range(6):
                control[i, k] = cold[i, k]
    return min(cold_e, e), iterations
