"""The crowd: arrays over characters, and the one place where kernels are looped over them.

Each row holds what one character needs to plan and to be posed: its last REAL footprints, the tentative ones behind them,
the committed COM curve under them, and the curve of its last window for the warm start. Rows are of fixed size and never
grow. Every kernel reads and writes its own row only, so results are the same for any number of threads.
"""

from typing import NamedTuple

import numpy as np
from numba import prange

from motion.characters.biped import BIPED
from motion.pose.pose import empty_pose, pose_kernel
from motion.track import foot
from motion.track.footprints import Track
from motion.track.spline import position_at
from worlds.compiled.jit import borrowed, jit, jit_borrowing, jit_parallel
from worlds.compiled.parts import fetch, handle, take

REAL = 8
"""Footprints kept: the newest and its history, enough for the body heading's average and for looking a step back."""
TENTATIVE = 3
"""Footprints beyond the newest, known only to the window."""
CURVE = 14
"""Committed segments kept."""
SHARE = 4
"""Characters that a thread takes at a time; so many are no work for two."""
WORKERS = 64
"""More than there are threads: each works until nothing is left, and those that come late find nothing."""
_ROWS = REAL + TENTATIVE
_WINDOW = 2 * _ROWS + 2


class Crowd(NamedTuple):
    """C characters. Tracks are [C, REAL + TENTATIVE]; the first `real` footprints are real."""

    kind: np.ndarray  # (C,) index into the biped table
    real: np.ndarray  # (C,) real footprints in the row
    number: np.ndarray  # (C,) how many footprints have been placed before the newest: its number
    reached: np.ndarray  # (C,) how many of its stops a walker has reached
    hindered: np.ndarray  # (C,) steps that others kept from getting on
    aim: np.ndarray  # (C, 2) unit vector of the way that it would go if nobody were there; 0, 0 where it stays
    claim: np.ndarray  # (C, 3) velocity it would take if nobody of lower rank were there [m/s], its rank (right_of_way)
    side: np.ndarray
    position: np.ndarray
    heading: np.ndarray
    normal: np.ndarray
    contact_time: np.ndarray
    stance_time: np.ndarray
    step_time: np.ndarray
    roll: np.ndarray
    nominal_length: np.ndarray
    facing: np.ndarray
    lift: np.ndarray
    hold: np.ndarray
    stands: np.ndarray  # (C, rows) bool: the foot has not moved, it only stands on
    rock: np.ndarray  # (C, rows) rock under the footprint, -1 on land
    curve_count: np.ndarray  # (C,) committed segments in the row
    curve_time: np.ndarray  # (C, CURVE + 1)
    control: np.ndarray  # (C, CURVE + 1, 6)
    support: np.ndarray  # (C, CURVE, 2) footprint in the row, -1 for a foot in the air
    window_count: np.ndarray  # (C,) control points of the last window
    window_time: np.ndarray  # (C, _WINDOW)
    window_control: np.ndarray  # (C, _WINDOW, 6)
    window_support: np.ndarray  # (C, _WINDOW, 2) footprint in the row, -1 for a foot in the air
    standing: np.ndarray  # (C,) bool: the newest footprint is one of standing still
    window_cost: np.ndarray  # (C, 2) E of the last window and its iterations


def empty_crowd(kind: np.ndarray, rows: int = _ROWS, segments: int = CURVE) -> Crowd:
    """A crowd of characters of these kinds, with nothing placed; scripted ones need rows for all that they will do."""
    c = len(kind)
    normal = np.zeros((c, rows, 3))
    normal[:, :, 2] = 1.0
    return Crowd(
        kind=np.ascontiguousarray(kind, np.int64),
        real=np.zeros(c, np.int64),
        number=np.zeros(c, np.int64),
        reached=np.zeros(c, np.int64),
        hindered=np.zeros(c, np.int64),
        aim=np.zeros((c, 2)),
        claim=np.zeros((c, 3)),
        side=np.zeros((c, rows), np.int64),
        position=np.zeros((c, rows, 3)),
        heading=np.zeros((c, rows)),
        normal=normal,
        contact_time=np.zeros((c, rows)),
        stance_time=np.zeros((c, rows)),
        step_time=np.zeros((c, rows)),
        roll=np.zeros((c, rows, 2)),
        nominal_length=np.zeros((c, rows)),
        facing=np.zeros((c, rows)),
        lift=np.zeros((c, rows)),
        hold=np.zeros((c, rows)),
        stands=np.zeros((c, rows), np.bool_),
        rock=np.full((c, rows), -1),
        curve_count=np.zeros(c, np.int64),
        curve_time=np.zeros((c, segments + 1)),
        control=np.zeros((c, segments + 1, 6)),
        support=np.full((c, segments, 2), -1),
        window_count=np.zeros(c, np.int64),
        window_time=np.zeros((c, _WINDOW)),
        window_control=np.zeros((c, _WINDOW, 6)),
        window_support=np.full((c, _WINDOW, 2), -1),
        standing=np.zeros(c, np.bool_),
        window_cost=np.zeros((c, 2)),
    )


def copied_track(crowd: Crowd, c: int, n: int) -> Track:
    """The first n footprints of character c, to keep."""
    return Track(*(getattr(crowd, name)[c, :n].copy() for name in Track._fields))


@jit_borrowing
def track_of(crowd, c, n):
    """The first n footprints of character c, for kernels: copied_track is for Python."""
    return borrowed(
        Track(
            crowd.side[c, :n],
            crowd.position[c, :n],
            crowd.heading[c, :n],
            crowd.normal[c, :n],
            crowd.contact_time[c, :n],
            crowd.stance_time[c, :n],
            crowd.step_time[c, :n],
            crowd.roll[c, :n],
            crowd.nominal_length[c, :n],
            crowd.facing[c, :n],
            crowd.lift[c, :n],
            crowd.hold[c, :n],
        )
    )


@jit
def stand(crowd, bipeds, c, first_contact, side, positions, headings, normals, rocks):
    """Character c stands on its first two footprints, the second of foot `side`; its curve begins above them at rest."""
    b = bipeds[crowd.kind[c]]
    for i in range(2):
        crowd.side[c, i] = side if i == 1 else 1 - side
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
    crowd.curve_time[c, 0] = first_contact
    above_feet(b, track_of(crowd, c, 2), crowd.control[c, 0])
    crowd.curve_count[c] = 0


@jit_borrowing
def above_feet(b, track, control):
    """Fills control (6,) with the com at rest, balanced over the middles of the last two soles, no leg over its nominal."""
    n = len(track.side)
    yaw = 0.5 * (track.heading[n - 2] + track.facing[n - 2] + track.heading[n - 1] + track.facing[n - 1])
    control[:] = 0.0
    for axis in range(2):
        control[axis] = 0.5 * (track.position[n - 2, axis] + track.position[n - 1, axis])
    control[2] = np.inf
    for i in range(n - 2, n):
        ankle = foot.stance_ankle(b, track, i, 0.0)
        hip = foot.hip_offset(b, track.side[i], yaw)
        x, y = control[0] + hip[0] - ankle[0], control[1] + hip[1] - ankle[1]
        rise = max(track.nominal_length[i] ** 2 - x * x - y * y, 0.0) ** 0.5
        control[2] = min(control[2], ankle[2] - hip[2] + rise)


@jit_borrowing
def horizon(crowd, c):
    """Time up to which character c is committed [s]."""
    return crowd.curve_time[c, crowd.curve_count[c]]


_lend, _opened = handle((empty_crowd(np.zeros(1)), np.zeros(1, BIPED).view(np.recarray), empty_pose(1)))


@jit_borrowing
def fetch_row(crowd, c):
    """Asks for what a pose of character c reads: its rows lie far apart, and too many are read at once to be foreseen."""
    last, m = crowd.real[c] - 4, crowd.curve_count[c]
    for array in (crowd.heading, crowd.contact_time, crowd.stance_time, crowd.step_time, crowd.facing, crowd.lift, crowd.hold):
        fetch(array, (c, 0))
        fetch(array, (c, 7))
    fetch(crowd.nominal_length, (c, 5))
    fetch(crowd.side, (c, 0))
    fetch(crowd.side, (c, 7))
    for n in range(last, last + 4, 2):
        fetch(crowd.position, (c, n, 0))
        fetch(crowd.normal, (c, n, 0))
    fetch(crowd.roll, (c, last, 0))
    fetch(crowd.curve_time, (c, m - 4))
    for n in range(m - 4, m + 1):
        fetch(crowd.control, (c, n, 0))


@jit_borrowing
def _pose_some(address, t, rows, counter):
    """Poses share after share, until none is left."""
    crowd, bipeds, pose = _opened(address)
    begin = take(counter) * SHARE
    while begin < len(rows):
        for k in range(begin, min(begin + SHARE, len(rows))):
            c = rows[k]
            if k + 2 < len(rows):
                fetch_row(crowd, rows[k + 2])
            m = crowd.curve_count[c]
            pose_kernel(
                bipeds[crowd.kind[c]], track_of(crowd, c, crowd.real[c]), crowd.curve_time[c, : m + 1],
                crowd.control[c, : m + 1], t, pose, k,
            )  # fmt: skip
        begin = take(counter) * SHARE


@jit_parallel
def _pose_in_threads(address, t, rows, counter):
    for _ in prange(WORKERS):
        _pose_some(address, t, rows, counter)


@jit
def pose_all(crowd, bipeds, t, rows, pose):
    """Poses the characters `rows` (K,) at time t [s] into pose, a motion.pose.pose.Pose of K rows."""
    address, counter = _lend((crowd, bipeds, pose)), np.zeros(1, np.int64)
    if len(rows) <= SHARE:
        _pose_some(address, t, rows, counter)
    else:
        _pose_in_threads(address, t, rows, counter)


@jit_borrowing
def com_all(crowd, t, com):
    """Fills com (C, 3) with everyone's centre of mass at time t [s]: what can be seen, before it is posed."""
    for c in range(len(crowd.kind)):
        m = crowd.curve_count[c]
        position_at(crowd.curve_time[c, : m + 1], crowd.control[c, : m + 1], t, com[c])
