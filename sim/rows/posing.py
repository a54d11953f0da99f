"""Poses of a crowd: the one place where characters are posed in threads."""

from threading import RLock
from typing import Any, NamedTuple

import numpy as np
from numba import prange

from motion.characters.dimensions import empty_bipeds
from motion.pose.pose import Pose
from motion.pose.posing import Posed, lend_pose, lend_posed
from motion.track.curve import position_at
from sim.rows.crowd import Crowd, committed_of, empty_crowd
from worlds.compiled.beside.wide import WIDE
from worlds.compiled.jit import jit, jit_borrowing, jit_parallel
from worlds.compiled.parts import call_three, fetch, handle, take

SHARE = 4
"""Characters that a thread takes at a time; so many are no work for two."""
MANY = SHARE * WIDE
"""The same of those that are posed: they are posed WIDE at once."""
WORKERS = 64
"""More than there are threads: each works until nothing is left, and those that come late find nothing."""


THREADS = RLock()
"""Held while kernels work in threads: numba's own end the process where two Python threads ask for them at once."""


class Shown(NamedTuple):
    """What can be seen."""

    crowd: Crowd
    bipeds: Any  # recarray of Dimensions, by kind


_, open_shown, _, SHOWN = handle(Shown(empty_crowd(np.zeros(1)), empty_bipeds(1)))


@jit_borrowing
def fetch_row(crowd: Crowd, c: int) -> None:
    """Asks for what a pose of character c reads: its rows lie far apart, and too many are read at once to be foreseen."""
    f, last, m = crowd.footprints, crowd.real[c] - 4, crowd.segments[c]
    for array in (
        f.heading, f.contact_time, f.stance_time, f.step_time, f.facing, f.toe_out, f.lift, f.hold, f.strike, f.bow, f.bounce,
    ):  # fmt: skip
        fetch(array, (c, 2))
        fetch(array, (c, 7))
    for whole in (f.side, f.rock):
        fetch(whole, (c, 2))
        fetch(whole, (c, 7))
    fetch(f.nominal_length, (c, 5))
    fetch(f.stands, (c, 0))
    for n in range(last, last + 4, 2):
        fetch(f.position, (c, n, 0))
        fetch(f.normal, (c, n, 0))
    fetch(f.roll, (c, last, 0))
    for n in range(m - 12, m + 1, 8):
        fetch(crowd.committed.time, (c, n))
    for n in range(m - 8, m + 1):
        fetch(crowd.committed.control, (c, n, 0))


@jit_borrowing
def _fetch_some(crowd: Crowd, rows: np.ndarray, begin: int) -> None:
    for k in range(begin, min(begin + WIDE, len(rows))):
        fetch_row(crowd, rows[k])


@jit_borrowing
def _pose_some(part: int, crowd: Crowd, posed: Posed, pose_at: int, counter: np.ndarray) -> None:
    """Poses share after share, until none is left."""
    rows, posed_at, begin = posed.rows, lend_posed(posed), take(counter) * MANY
    while begin < len(rows):
        for k in range(begin, min(begin + MANY, len(rows)), WIDE):
            _fetch_some(crowd, rows, k + WIDE)
            call_three(part, posed_at, pose_at, k)
        begin = take(counter) * MANY


@jit_borrowing
def _posed(shown: Shown, t: float, rows: np.ndarray) -> Posed:
    crowd = shown.crowd
    return Posed(shown.bipeds, crowd.kind, crowd.footprints, crowd.real, crowd.committed, crowd.segments, t, rows)


@jit_parallel
def _pose_in_threads(part: int, shown_at: int, pose_at: int, t: float, rows: np.ndarray, counter: np.ndarray) -> None:
    for _ in prange(WORKERS):
        _work(part, shown_at, pose_at, t, rows, counter)


@jit_borrowing
def _work(part: int, shown_at: int, pose_at: int, t: float, rows: np.ndarray, counter: np.ndarray) -> None:
    shown = open_shown(shown_at)
    _pose_some(part, shown.crowd, _posed(shown, t, rows), pose_at, counter)


@jit
def pose_rows(part: int, shown_at: int, t: float, rows: np.ndarray, pose: Pose) -> None:
    """Poses the characters `rows` (K,) of the Shown at an address, at time t [s], into pose, of K rows.

    part: where motion.pose.posing.pose_some lies.
    """
    pose_at, counter = lend_pose(pose), np.zeros(1, np.int64)
    if len(rows) <= MANY:
        _work(part, shown_at, pose_at, t, rows, counter)
    else:
        _pose_in_threads(part, shown_at, pose_at, t, rows, counter)


@jit
def com_all(shown_at: int, t: float, com: np.ndarray) -> None:
    """Fills com (C, 3) with everyone's centre of mass at time t [s]: what can be seen, before it is posed."""
    crowd = open_shown(shown_at).crowd
    for c in range(len(crowd.kind)):
        position_at(committed_of(crowd, c), t, com[c])
