"""The crowd: arrays over characters, and the one place where kernels are looped over them.

Each row holds what one character needs to plan and to be posed: its last REAL footprints, the tentative ones behind them,
the committed COM curve under them, and the curve of its last window for the warm start. Rows are of fixed size and never
grow. Every kernel reads and writes its own row only, so results are the same for any number of threads.
"""

from typing import NamedTuple

import numpy as np
from numba import prange

from motion import foot, window
from motion.jit import jit, jit_parallel
from motion.phases import SHORTEST_PHASE as SLIVER
from motion.pose import pose_kernel
from motion.track import Track
from planner import placing, plan, timing

REAL = 8
"""Footprints kept: the newest and its history, enough for the body heading's average and for looking a step back."""
TENTATIVE = 3
"""Footprints beyond the newest, known only to the window."""
WINDOW_TAIL = 0.0
"""Share of a step that the window goes on after the last tentative contact: more steadies its end, and costs time."""
CURVE = 14
"""Committed segments kept."""
_ROWS = REAL + TENTATIVE
_WINDOW = 2 * _ROWS + 2


class Crowd(NamedTuple):
    """C characters. Tracks are [C, REAL + TENTATIVE]; the first `real` footprints are real."""

    kind: np.ndarray  # (C,) index into the biped table
    real: np.ndarray  # (C,) real footprints in the row
    number: np.ndarray  # (C,) how many footprints have been placed before the newest: its number
    side: np.ndarray
    position: np.ndarray
    heading: np.ndarray
    normal: np.ndarray
    contact_time: np.ndarray
    stance_time: np.ndarray
    step_time: np.ndarray
    roll: np.ndarray
    nominal_length: np.ndarray
    lift: np.ndarray
    rock: np.ndarray  # (C, rows) rock under the footprint, -1 on land
    curve_count: np.ndarray  # (C,) committed segments in the row
    curve_time: np.ndarray  # (C, CURVE + 1)
    control: np.ndarray  # (C, CURVE + 1, 6)
    support: np.ndarray  # (C, CURVE, 2) footprint in the row, -1 for a foot in the air
    window_count: np.ndarray  # (C,) control points of the last window
    window_time: np.ndarray  # (C, _WINDOW)
    window_control: np.ndarray  # (C, _WINDOW, 6)
    standing: np.ndarray  # (C,) bool: the newest footprint is one of standing still
    window_cost: np.ndarray  # (C, 2) E of the last window and its iterations


def empty_crowd(kind: np.ndarray) -> Crowd:
    """A crowd of characters of these kinds, with nothing placed."""
    c, rows = len(kind), _ROWS
    normal = np.zeros((c, rows, 3))
    normal[:, :, 2] = 1.0
    return Crowd(
        kind=np.ascontiguousarray(kind, np.int64),
        real=np.zeros(c, np.int64),
        number=np.zeros(c, np.int64),
        side=np.zeros((c, rows), np.int64),
        position=np.zeros((c, rows, 3)),
        heading=np.zeros((c, rows)),
        normal=normal,
        contact_time=np.zeros((c, rows)),
        stance_time=np.zeros((c, rows)),
        step_time=np.zeros((c, rows)),
        roll=np.zeros((c, rows, 2)),
        nominal_length=np.zeros((c, rows)),
        lift=np.zeros((c, rows)),
        rock=np.full((c, rows), -1),
        curve_count=np.zeros(c, np.int64),
        curve_time=np.zeros((c, CURVE + 1)),
        control=np.zeros((c, CURVE + 1, 6)),
        support=np.full((c, CURVE, 2), -1),
        window_count=np.zeros(c, np.int64),
        window_time=np.zeros((c, _WINDOW)),
        window_control=np.zeros((c, _WINDOW, 6)),
        standing=np.zeros(c, np.bool_),
        window_cost=np.zeros((c, 2)),
    )


@jit
def track_of(crowd, c, n):
    """The first n footprints of character c."""
    return Track(
        crowd.side[c, :n],
        crowd.position[c, :n],
        crowd.heading[c, :n],
        crowd.normal[c, :n],
        crowd.contact_time[c, :n],
        crowd.stance_time[c, :n],
        crowd.step_time[c, :n],
        crowd.roll[c, :n],
        crowd.nominal_length[c, :n],
        crowd.lift[c, :n],
    )


@jit
def stand(crowd, bipeds, c, first_contact, positions, headings, normals, rocks):
    """Character c stands on its first two footprints, RIGHT then LEFT, and its curve begins above them at rest."""
    b = bipeds[crowd.kind[c]]
    for i in range(2):
        crowd.side[c, i] = 1 - i
        crowd.position[c, i] = positions[i]
        crowd.heading[c, i] = headings[i]
        crowd.normal[c, i] = normals[i]
        crowd.rock[c, i] = rocks[i]
        crowd.contact_time[c, i] = first_contact - 0.5 * (1 - i)
        crowd.stance_time[c, i] = 1.0
        crowd.step_time[c, i] = 0.5
        crowd.roll[c, i] = 0.5
        crowd.nominal_length[c, i] = b.nominal_length
    crowd.real[c], crowd.number[c] = 2, 1
    crowd.standing[c] = True
    yaw = 0.5 * (headings[0] + headings[1])
    com = np.zeros(3)
    for i in range(2):
        ankle = foot.stance_ankle(b, track_of(crowd, c, 2), i, 0.0)
        hip = foot.hip_offset(b, 1 - i, yaw)
        for axis in range(3):
            com[axis] += 0.5 * (ankle[axis] - hip[axis])
    com[2] += b.nominal_length
    crowd.curve_time[c, 0] = first_contact
    crowd.control[c, 0, :3] = com
    crowd.control[c, 0, 3:] = 0.0
    crowd.curve_count[c] = 0


@jit
def _shift(crowd, c):
    """Forgets the oldest footprint; the curve over it goes too."""
    for array in (crowd.heading, crowd.contact_time, crowd.stance_time, crowd.step_time, crowd.nominal_length, crowd.lift):
        array[c, :-1] = array[c, 1:].copy()
    for array in (crowd.side, crowd.rock):
        array[c, :-1] = array[c, 1:].copy()
    for array in (crowd.position, crowd.normal, crowd.roll):
        array[c, :-1] = array[c, 1:].copy()
    crowd.real[c] -= 1
    crowd.support[c] -= 1
    gone = 0
    for i in range(crowd.curve_count[c]):
        if crowd.curve_time[c, i + 1] <= crowd.contact_time[c, 0]:
            gone = i + 1
    _forget_segments(crowd, c, gone)
    np.maximum(crowd.support[c], -1, crowd.support[c])


@jit
def _forget_segments(crowd, c, gone):
    kept = crowd.curve_count[c] - gone
    if gone > 0:
        crowd.curve_time[c, : kept + 1] = crowd.curve_time[c, gone : gone + kept + 1].copy()
        crowd.control[c, : kept + 1] = crowd.control[c, gone : gone + kept + 1].copy()
        crowd.support[c, :kept] = crowd.support[c, gone : gone + kept].copy()
        crowd.curve_count[c] = kept


@jit
def horizon(crowd, c):
    """Time up to which character c is committed [s]."""
    return crowd.curve_time[c, crowd.curve_count[c]]


@jit
def _write(crowd, c, n, f):
    """Puts planned footprint f (a planner.plan.Placed) at row n and times the one it leaves."""
    crowd.side[c, n] = f.side
    crowd.position[c, n, 0], crowd.position[c, n, 1], crowd.position[c, n, 2] = f.x, f.y, f.z
    crowd.heading[c, n] = f.heading
    crowd.normal[c, n, 0], crowd.normal[c, n, 1], crowd.normal[c, n, 2] = f.nx, f.ny, f.nz
    crowd.rock[c, n] = f.rock
    crowd.roll[c, n, 0] = 0.5 if f.stands else 0.0
    crowd.roll[c, n, 1] = 1.0


@jit
def _time(crowd, bipeds, c, n, f):
    """Timing of footprint n - 1, from the step to footprint n (paper, section 4.1), and a first guess for n's own."""
    b = bipeds[crowd.kind[c]]
    if f.stands:
        step = f.wait
        stance = step + plan.START_OVERLAP * timing.pendulum_time(b)
        crowd.stance_time[c, n - 2] = crowd.contact_time[c, n - 1] + step - crowd.contact_time[c, n - 2]
        crowd.roll[c, n - 2, 1] = 0.5
    else:
        p, q = crowd.position[c, n - 1], crowd.position[c, n]
        length = ((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2) ** 0.5
        turn = abs(crowd.heading[c, n] - crowd.heading[c, n - 1])
        step, stance = timing.step_timing(b, length, q[2] - p[2], turn, f.side == crowd.side[c, n - 1])
        overlap = crowd.contact_time[c, n - 2] + crowd.stance_time[c, n - 2] - crowd.contact_time[c, n - 1]
        longer = timing.least_step_time(b, overlap) - step
        if longer > 0:
            step, stance = step + longer, stance + longer
    crowd.step_time[c, n - 1] = step
    crowd.stance_time[c, n - 1] = stance
    crowd.contact_time[c, n] = crowd.contact_time[c, n - 1] + step
    crowd.step_time[c, n] = step
    crowd.stance_time[c, n] = stance


@jit
def _place(crowd, bipeds, w, plans, c, seed, n, step):
    """Asks the planner for footprint number `step`, writes it at row n and times it."""
    b, two = bipeds[crowd.kind[c]], slice(n - 2, n)
    placed = plan.next_footprint(
        b, w, plans, c, seed, step, crowd.side[c, two], crowd.position[c, two], crowd.heading[c, two],
        crowd.normal[c, two], crowd.rock[c, two],
    )  # fmt: skip
    _write(crowd, c, n, placed)
    crowd.nominal_length[c, n] = b.nominal_length
    _time(crowd, bipeds, c, n, placed)
    before = n - 1
    while before > 0 and crowd.side[c, before] != placed.side:
        before -= 1
    crowd.lift[c, n] = 0.0 if placed.stands else placing.swing_lift(b, w, track_of(crowd, c, n + 1), before, n)
    return placed.stands


@jit
def window_end(track):
    """Where the window ends [s]: shortly after the last tentative footprint has landed."""
    last = len(track.side) - 1
    return track.contact_time[last] + WINDOW_TAIL * track.step_time[last]


@jit
def _optimise(crowd, bipeds, c, effort):
    """Solves the window over the real and tentative footprints and commits step n - 1 (paper, section 4.2)."""
    n = crowd.real[c] - 1
    last = n + TENTATIVE
    track = track_of(crowd, c, last + 1)
    committed = crowd.curve_count[c]
    begin = crowd.curve_time[c, committed]
    kept = crowd.window_count[c]
    time, control, support, e, iterations = window.optimise_window(
        bipeds[crowd.kind[c]], track, begin, window_end(track),
        crowd.control[c, committed], crowd.window_time[c, :kept], crowd.window_control[c, :kept], effort,
    )  # fmt: skip
    crowd.window_cost[c, 0], crowd.window_cost[c, 1] = e, iterations
    crowd.window_count[c] = len(time)
    crowd.window_time[c, : len(time)] = time
    crowd.window_control[c, : len(time)] = control
    _commit(crowd, c, time, control, support, track.contact_time[n - 1])


@jit
def _commit(crowd, c, time, control, support, until):
    """Appends the window's segments up to time `until`, forgetting the oldest where the row is full."""
    i = 0
    while i < len(support) and time[i + 1] <= until + SLIVER:
        if crowd.curve_count[c] == CURVE:
            _forget_segments(crowd, c, 1)
        k = crowd.curve_count[c]
        crowd.curve_time[c, k + 1] = time[i + 1]
        crowd.control[c, k + 1] = control[i + 1]
        crowd.support[c, k] = support[i]
        crowd.curve_count[c] = k + 1
        i += 1


@jit
def _advance(crowd, bipeds, w, plans, c, seed, effort):
    """One round of the paper's loop: footprint n, its timing, tentative footprints, step n - 1 optimised, committed."""
    if crowd.real[c] == REAL:
        _shift(crowd, c)
    n = crowd.real[c]
    crowd.number[c] += 1
    crowd.standing[c] = _place(crowd, bipeds, w, plans, c, seed, n, crowd.number[c])
    crowd.real[c] = n + 1
    for k in range(TENTATIVE):
        _place(crowd, bipeds, w, plans, c, seed, n + 1 + k, crowd.number[c] + 1 + k)
    _optimise(crowd, bipeds, c, effort)


@jit_parallel
def advance_all(crowd, bipeds, w, plans, seed, until, effort, placed):
    """Plans every character whose committed curve ends before `until` [s]; placed (C,) counts the new footprints."""
    for c in prange(len(crowd.kind)):
        placed[c] = 0
        while horizon(crowd, c) < until and placed[c] < REAL - 2:
            _advance(crowd, bipeds, w, plans, c, seed, effort)
            placed[c] += 1


@jit_parallel
def pose_all(crowd, bipeds, t, pose):
    """Poses every character at time t [s] into pose, a motion.pose.Pose of C rows."""
    for c in prange(len(crowd.kind)):
        m = crowd.curve_count[c]
        pose_kernel(
            bipeds[crowd.kind[c]], track_of(crowd, c, crowd.real[c]), crowd.curve_time[c, : m + 1],
            crowd.control[c, : m + 1], t, pose, c,
        )  # fmt: skip
