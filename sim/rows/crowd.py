"""The crowd: arrays over characters, a row of each for all that it needs to plan and to be posed.

A row holds the last REAL footprints, the tentative ones behind them, the committed curve under them, and the curve of the
last window for the warm start. Rows are of fixed size and never grow. Every kernel writes its own row only, so results are the
same for any number of threads.
"""

from typing import Annotated, Any, NamedTuple

import numpy as np

from motion.com.standing import above_feet
from motion.track.curve import Curve, append_segment, forget_segments, up_to
from motion.track.footprints import Footprints, first, forget_oldest
from motion.track.phases import SHORTEST_PHASE
from planner.round.reservations import Intents
from planner.stepping.taking import stand_at
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.tables import Column, empty, row

REAL = 8
"""Footprints kept: the newest and its history, enough for the body heading's average and for looking a step back."""
TENTATIVE = 3
"""Footprints beyond the newest, known only to the window."""
CURVE = 30
"""Committed segments kept."""
_ROWS = REAL + TENTATIVE
WINDOW = 38
"""Control points of a window, at most: four steps of three phases, three pieces each."""


class Crowd(NamedTuple):
    """C characters; footprints are (C, REAL + TENTATIVE), of which the first `real` are real."""

    kind: np.ndarray  # (C,) index into the table of bipeds
    real: np.ndarray  # (C,) real footprints in the row
    number: np.ndarray  # (C,) how many footprints have been placed before the newest: its number
    standing: np.ndarray  # (C,) bool: the newest footprint is one of standing still
    paused: np.ndarray  # (C,) bool: it takes no further step until told otherwise
    footprints: Footprints
    segments: np.ndarray  # (C,) committed segments in the row
    committed: Curve  # (C, CURVE + 1)
    points: np.ndarray  # (C,) control points of the last window
    window: Curve  # (C, WINDOW)
    window_cost: Annotated[np.ndarray, Column(shape=(2,))]  # (C, 2) E of the last window and its iterations
    intents: Intents


def empty_crowd(kind: np.ndarray, rows: int = _ROWS, segments: int = CURVE) -> Crowd:
    """A crowd of characters of these kinds, with nothing placed; scripted ones need rows for all that they will do."""
    c = len(kind)
    return Crowd(
        kind=np.ascontiguousarray(kind, np.int64),
        real=np.zeros(c, np.int64),
        number=np.zeros(c, np.int64),
        standing=np.zeros(c, np.bool_),
        paused=np.zeros(c, np.bool_),
        footprints=empty(Footprints, c, rows),
        segments=np.zeros(c, np.int64),
        committed=empty(Curve, c, segments + 1),
        points=np.zeros(c, np.int64),
        window=empty(Curve, c, WINDOW),
        window_cost=np.zeros((c, 2)),
        intents=empty(Intents, c),
    )


@jit_borrowing
def footprints_of(crowd: Crowd, c: int, count: int) -> Footprints:
    """The first so many footprints of character c."""
    return first(row(crowd.footprints, c), count)


@jit_borrowing
def committed_of(crowd: Crowd, c: int) -> Curve:
    """The committed curve of character c."""
    return up_to(row(crowd.committed, c), crowd.segments[c])


@jit_borrowing
def horizon(crowd: Crowd, c: int) -> float:
    """Time up to which character c is committed [s]."""
    return crowd.committed.time[c, crowd.segments[c]]


@jit
def stand(
    crowd: Crowd, bipeds: Any, world: WorldArrays, c: int, side: int, places: np.ndarray, contact: float, soles: bool
) -> None:
    """Character c stands since `contact` [s] at places (2, 3) x, y, heading, the second with foot `side`.

    soles: the headings are those of the soles; else the walker's, and toes point outward.
    """
    biped = bipeds[crowd.kind[c]]
    stand_at(biped, world, row(crowd.footprints, c), side, places, contact, 0.0 if soles else biped.gait.toe_out)
    crowd.real[c], crowd.number[c], crowd.segments[c], crowd.points[c] = 2, 1, 0, 0
    crowd.standing[c] = True
    crowd.committed.time[c, 0] = contact
    above_feet(biped, footprints_of(crowd, c, 2), crowd.committed.control[c, 0])


@jit_borrowing
def shift(crowd: Crowd, c: int) -> None:
    """Forgets the oldest footprint; the curve over it goes too."""
    forget_oldest(row(crowd.footprints, c), crowd.real[c])
    crowd.real[c] -= 1
    curve, gone = row(crowd.committed, c), 0
    for i in range(crowd.segments[c]):
        for leg in range(2):
            curve.support[i, leg] = max(curve.support[i, leg] - 1, -1)
        if curve.time[i + 1] <= crowd.footprints.contact_time[c, 0]:
            gone = i + 1
    crowd.segments[c] = forget_segments(curve, crowd.segments[c], gone)


@jit_borrowing
def commit(crowd: Crowd, c: int, source: Curve, until: float) -> None:
    """Appends the segments of a curve up to time `until` [s], forgetting the oldest where the row is full."""
    curve, i = row(crowd.committed, c), 0
    while i < len(source.time) - 1 and source.time[i + 1] <= until + SHORTEST_PHASE:
        if crowd.segments[c] == len(curve.time) - 1:
            crowd.segments[c] = forget_segments(curve, crowd.segments[c], 1)
        append_segment(curve, crowd.segments[c], source, i)
        crowd.segments[c] += 1
        i += 1
