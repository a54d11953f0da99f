"""Poses of a crowd: the one place where characters are posed in threads."""

from typing import Any, NamedTuple

import numpy as np
from numba import prange

from motion.characters.dimensions import empty_bipeds
from motion.pose.pose import Pose, empty_pose
from motion.pose.posing import pose_kernel
from sim.rows.crowd import Crowd, empty_crowd, track_of
from worlds.compiled.jit import jit, jit_borrowing, jit_parallel
from worlds.compiled.parts import fetch, handle, take

SHARE = 4
"""Characters that a thread takes at a time; so many are no work for two."""
WORKERS = 64
"""More than there are threads: each works until nothing is left, and those that come late find nothing."""


class Posing(NamedTuple):
    """What is posed, and where to."""

    crowd: Crowd
    bipeds: Any
    pose: Pose


_lend, _open, _ = handle(Posing(empty_crowd(np.zeros(1)), empty_bipeds(1), empty_pose(1)))


@jit_borrowing
def fetch_row(crowd: Crowd, c: int) -> None:
    """Asks for what a pose of character c reads: its rows lie far apart, and too many are read at once to be foreseen."""
    f, last, m = crowd.footprints, crowd.real[c] - 4, crowd.segments[c]
    for array in (f.heading, f.contact_time, f.stance_time, f.step_time, f.facing, f.lift, f.hold):
        fetch(array, (c, 0))
        fetch(array, (c, 7))
    fetch(f.nominal_length, (c, 5))
    fetch(f.side, (c, 0))
    fetch(f.side, (c, 7))
    for n in range(last, last + 4, 2):
        fetch(f.position, (c, n, 0))
        fetch(f.normal, (c, n, 0))
    fetch(f.roll, (c, last, 0))
    fetch(crowd.committed.time, (c, m - 4))
    for n in range(m - 4, m + 1):
        fetch(crowd.committed.control, (c, n, 0))


@jit_borrowing
def _pose_some(address: int, t: float, rows: np.ndarray, counter: np.ndarray) -> None:
    """Poses share after share, until none is left."""
    posing = _open(address)
    crowd, begin = posing.crowd, take(counter) * SHARE
    while begin < len(rows):
        for k in range(begin, min(begin + SHARE, len(rows))):
            c = rows[k]
            if k + 2 < len(rows):
                fetch_row(crowd, rows[k + 2])
            pose_kernel(posing.bipeds[crowd.kind[c]], track_of(crowd, c), t, posing.pose, k)
        begin = take(counter) * SHARE


@jit_parallel
def _pose_in_threads(address: int, t: float, rows: np.ndarray, counter: np.ndarray) -> None:
    for _ in prange(WORKERS):
        _pose_some(address, t, rows, counter)


@jit
def pose_all(crowd: Crowd, bipeds: Any, t: float, rows: np.ndarray, pose: Pose) -> None:
    """Poses the characters `rows` (K,) at time t [s] into pose, of K rows."""
    address, counter = _lend(Posing(crowd, bipeds, pose)), np.zeros(1, np.int64)
    if len(rows) <= SHARE:
        _pose_some(address, t, rows, counter)
    else:
        _pose_in_threads(address, t, rows, counter)
