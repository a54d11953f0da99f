"""The row of a character as time goes on: its oldest footprints and segments are forgotten, committed ones appended."""

from motion.track.phases import SHORTEST_PHASE as SLIVER
from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def copy_footprint(crowd, c, source, goal):
    """Row `goal` of character c becomes what row `source` is."""
    crowd.side[c, goal], crowd.rock[c, goal], crowd.stands[c, goal] = (
        crowd.side[c, source],
        crowd.rock[c, source],
        crowd.stands[c, source],
    )
    for array in (crowd.heading, crowd.contact_time, crowd.stance_time, crowd.step_time):
        array[c, goal] = array[c, source]
    for array in (crowd.nominal_length, crowd.facing, crowd.lift, crowd.hold):
        array[c, goal] = array[c, source]
    for k in range(3):
        crowd.position[c, goal, k], crowd.normal[c, goal, k] = crowd.position[c, source, k], crowd.normal[c, source, k]
    for k in range(2):
        crowd.roll[c, goal, k] = crowd.roll[c, source, k]


@jit_borrowing
def shift(crowd, c):
    """Forgets the oldest footprint; the curve over it goes too."""
    for i in range(crowd.real[c] - 1):
        copy_footprint(crowd, c, i + 1, i)
    crowd.real[c] -= 1
    for i in range(crowd.curve_count[c]):
        for leg in range(2):
            crowd.support[c, i, leg] = max(crowd.support[c, i, leg] - 1, -1)
    gone = 0
    for i in range(crowd.curve_count[c]):
        if crowd.curve_time[c, i + 1] <= crowd.contact_time[c, 0]:
            gone = i + 1
    _forget_segments(crowd, c, gone)


@jit_borrowing
def _forget_segments(crowd, c, gone):
    if gone == 0:
        return
    kept = crowd.curve_count[c] - gone
    for i in range(kept + 1):
        crowd.curve_time[c, i] = crowd.curve_time[c, gone + i]
        for k in range(6):
            crowd.control[c, i, k] = crowd.control[c, gone + i, k]
    for i in range(kept):
        for leg in range(2):
            crowd.support[c, i, leg] = crowd.support[c, gone + i, leg]
    crowd.curve_count[c] = kept


@jit_borrowing
def commit(crowd, c, time, control, support, until):
    """Appends the window's segments up to time `until`, forgetting the oldest where the row is full."""
    i = 0
    while i < len(support) and time[i + 1] <= until + SLIVER:
        if crowd.curve_count[c] == crowd.support.shape[1]:
            _forget_segments(crowd, c, 1)
        k = crowd.curve_count[c]
        crowd.curve_time[c, k + 1] = time[i + 1]
        for axis in range(6):
            crowd.control[c, k + 1, axis] = control[i + 1, axis]
        crowd.support[c, k, 0], crowd.support[c, k, 1] = support[i, 0], support[i, 1]
        crowd.curve_count[c] = k + 1
        i += 1
