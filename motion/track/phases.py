"""Phases of support: who stands when (paper, section 2.2).

A phase is a stretch of time in which the set of standing feet does not change. Its `support` row holds, for the left
and the right foot, the index of the footprint it stands on, or -1 while it swings.
"""

import numpy as np

from motion.track.footprints import LEFT, RIGHT, Footprints
from worlds.compiled.jit import jit, jit_borrowing

LEFT_STANCE, RIGHT_STANCE, DOUBLE_STANCE, FLIGHT = 0, 1, 2, 3
NAMES = ("left stance", "right stance", "double stance", "flight")
"""Phases in words, by their numbers."""
COLOURS = {LEFT_STANCE: (0.92, 0.18, 0.85), RIGHT_STANCE: (0.90, 0.12, 0.12)}
COLOURS |= {DOUBLE_STANCE: (0.10, 0.14, 0.55), FLIGHT: (0.55, 0.80, 0.98)}
"""Red, green and blue in which the paper's figures draw each phase."""
SHORTEST_PHASE = 1e-3
"""Phases shorter than this [s] are dropped: a sliver changes nothing one can see but makes the spline stiff."""


@jit_borrowing
def phase_of(left: int, right: int) -> int:
    """Phase of a support row (footprint indices, -1 while swinging)."""
    if left >= 0:
        return DOUBLE_STANCE if right >= 0 else LEFT_STANCE
    return RIGHT_STANCE if right >= 0 else FLIGHT


@jit_borrowing
def support_at(footprints: Footprints, begin: int, t: float) -> tuple[int, int]:
    """Footprints (left, right) carrying the body at time t [s], -1 for a foot in the air; scans from footprint `begin`."""
    left, right = -1, -1
    for i in range(begin, len(footprints.side)):
        if footprints.contact_time[i] > t:
            break
        if t < footprints.contact_time[i] + footprints.stance_time[i]:
            if footprints.side[i] == LEFT:
                left = i
            else:
                right = i
    return left, right


@jit_borrowing
def _next_event(footprints: Footprints, which: int, cursor: int, landed: bool) -> tuple[float, int]:
    """Time of the next landing or leaving of foot `which`, whose current footprint is `cursor`, and its footprint then."""
    if landed:
        return footprints.contact_time[cursor] + footprints.stance_time[cursor], cursor
    count, following = len(footprints.side), cursor + 1
    while following < count and footprints.side[following] != which:
        following += 1
    return (footprints.contact_time[following] if following < count else np.inf), following


@jit
def build_phases(footprints: Footprints, begin: float, end: float, time: np.ndarray, support: np.ndarray) -> int:
    """Phases between `begin` and `end` [s], by merging the two feet's landings and leavings: linear in the n footprints.

    Fills time (>= 2n + 2,) and support (>= 2n + 1, 2); returns the number of phases.
    """
    cursor = np.full(2, -1)
    landed = np.zeros(2, np.bool_)
    m = 0
    time[0] = begin
    while True:
        t0, next0 = _next_event(footprints, LEFT, cursor[0], landed[0])
        t1, next1 = _next_event(footprints, RIGHT, cursor[1], landed[1])
        which = LEFT if t0 <= t1 else RIGHT
        t = min(t0, t1, end)
        if t - time[m] > SHORTEST_PHASE:
            support[m, 0] = cursor[0] if landed[0] else -1
            support[m, 1] = cursor[1] if landed[1] else -1
            m += 1
            time[m] = t
        if t >= end:
            time[m] = end
            return m
        cursor[which] = next0 if which == LEFT else next1
        landed[which] = not landed[which]


@jit_borrowing
def merge_by_step(time: np.ndarray, support: np.ndarray, count: int) -> int:
    """The paper's layout in place: one segment per step, a flight by itself. Returns the number of segments."""
    kept = 0
    for i in range(count):
        left, right = support[i, 0], support[i, 1]
        new = i == 0 or phase_of(left, right) == FLIGHT or phase_of(support[i - 1, 0], support[i - 1, 1]) == FLIGHT
        if not new:
            was_left, was_right = support[i - 1, 0], support[i - 1, 1]
            new = (left != was_left and left >= 0) or (right != was_right and right >= 0)
        if new:
            time[kept] = time[i]
            support[kept, 0], support[kept, 1] = left, right
            kept += 1
    time[kept] = time[count]
    return kept
