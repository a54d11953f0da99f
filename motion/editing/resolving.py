"""A motion after an edit: the time around what has changed is solved anew, all else stays as it was, to the bit.

Of the footprints before and after the edit the first p and the last q agree, the latter but for a shift in time. Between them,
and MARGIN footprints to either side, the curve is free; where that window begins and ends, position, velocity and acceleration
are held, so what is before it and after it fits on:

    | unchanged | MARGIN  changed  MARGIN | unchanged, shifted in time |

The window is solved from the curve of before, carried along: times are mapped contact by contact, places with the footprints.
So a drag, which is many small edits, follows one solution instead of finding another at each move.
"""

from typing import NamedTuple

import numpy as np

from motion.com.newton import Effort
from motion.com.problem import Layout
from motion.com.window import Span, optimise_track
from motion.motion import Motion, Pull, solve, springs_of
from motion.track.curve import Curve, acceleration_weights, states_at
from motion.track.footprints import Footprints
from worlds.compiled.tables import picked

MARGIN = 5
"""Footprints to either side of a change that may move with it: fewer are quicker, more leave less of a difference."""
AROUND = 8
"""Footprints beyond the window that are laid with it: they turn body and pelvis."""
SAME = 1e-9
"""Contacts that differ by no more [s] are shifted alike."""
EDIT = Effort(3, 0.3, 1e-3, 100, 1e-4)
"""Of a window whose first guess is good: not so smooth that it would forget it."""


class Change(NamedTuple):
    """Which footprints differ before and after an edit."""

    first: int  # the first that differs
    before: int  # of those before the edit, one beyond the last that differs
    after: int  # the same of those after it
    later: float  # by how much those that follow are later [s]


class Window(NamedTuple):
    """Where the old curve is cut, and what of it stays."""

    head: int  # control points of the old curve up to the window's beginning
    tail: int  # the old control point where the window ends; the last one where nothing follows
    whole: bool  # whether it is all of the motion


def resolve(
    motion: Motion, footprints: Footprints, end: float, layout: Layout, effort: Effort = EDIT, pulls: tuple[Pull, ...] = (),
    touched: tuple[float, float] | None = None,
) -> Motion:  # fmt: skip
    """The motion over footprints that differ from those of `motion` here and there, solved where they differ.

    touched: times [s] between which something else has changed, a pull. Where nearly all has changed, all is solved.
    """
    change = _with_times(changed(motion.footprints, footprints), motion.footprints, touched)
    if change is None:
        return motion if end == motion.end else solve(footprints, motion.character, end, layout, pulls=pulls)
    cut = _cut(motion, footprints, change, end)
    if cut.whole:
        return solve(footprints, motion.character, end, layout, pulls=pulls)
    return _joined(motion, footprints, change, cut, _part(motion, footprints, change, cut, (layout, effort, pulls)))


def changed(before: Footprints, after: Footprints) -> Change | None:
    """Which footprints differ; None where none do."""
    n, m = len(before.side), len(after.side)
    shortest = min(n, m)
    same, moved = np.ones(shortest, bool), np.ones(shortest, bool)
    for name, old in before._asdict().items():
        new = getattr(after, name)
        same &= (old[:shortest] == new[:shortest]).reshape(shortest, -1).all(axis=1)
        if name != "contact_time":
            moved &= (old[n - shortest :] == new[m - shortest :]).reshape(shortest, -1).all(axis=1)
    if n == m and same.all():
        return None
    later = float(after.contact_time[-1] - before.contact_time[-1])
    moved &= np.abs(after.contact_time[m - shortest :] - before.contact_time[n - shortest :] - later) < SAME
    head = shortest if same.all() else int(np.argmin(same))
    tail = shortest if moved.all() else int(np.argmin(moved[::-1]))
    tail = min(tail, shortest - head)
    return Change(head, n - tail, m - tail, later)


def _with_times(change: Change | None, footprints: Footprints, touched: tuple[float, float] | None) -> Change | None:
    """A change that takes in the footprints around two times."""
    if touched is None:
        return change
    count = len(footprints.side)
    low, high = np.searchsorted(footprints.contact_time, touched, side="right")
    if change is None:
        return Change(max(int(low) - 1, 0), int(high), int(high), 0.0)
    more = max(int(high) - change.before, 0)
    more = min(more, count - change.before)
    return Change(min(change.first, max(int(low) - 1, 0)), change.before + more, change.after + more, change.later)


def _cut(motion: Motion, footprints: Footprints, change: Change, end: float) -> Window:
    """Where the old curve is cut: at contacts, where a phase begins."""
    old, time = motion.footprints, motion.curve.time
    first, last = change.first - MARGIN, change.before + MARGIN
    head = _point_at(time, float(old.contact_time[first])) if first > 1 else 0
    tail = _point_at(time, float(old.contact_time[last])) if last < len(old.side) else len(time) - 1
    follows = last < len(old.side) and abs(end - motion.end - change.later) < SAME
    return Window(head, tail if follows else len(time) - 1, head == 0 and not follows)


def _point_at(time: np.ndarray, t: float) -> int:
    """The control point nearest to a time [s]."""
    return int(np.argmin(np.abs(time - t)))


def _part(
    motion: Motion, footprints: Footprints, change: Change, cut: Window, how: tuple[Layout, Effort, tuple[Pull, ...]]
) -> Motion:  # fmt: skip
    """The window alone, over its own footprints."""
    layout, effort, pulls = how
    curve, last = motion.curve, len(motion.curve.time) - 1
    begin, finish = float(curve.time[cut.head]), float(curve.time[cut.tail]) + change.later
    state = np.array([curve.control[cut.head], curve.control[cut.tail]])
    bend = np.zeros((2, 3))
    if layout.smooth:
        bend[0] = _bend_at(curve, cut.head) if cut.head else 0.0
        bend[1] = _bend_at(curve, cut.tail) if cut.tail < last else 0.0
    rows = _rows(footprints, begin, finish)
    span = Span(begin, finish, state, bend, springs_of(pulls))
    guess = _carried(motion, footprints, change, cut, begin, finish)
    mine = picked(footprints, rows)
    found, solved = optimise_track(motion.character.biped, mine, span, guess, layout, effort)
    support = np.where(found.support >= 0, found.support + rows.start, -1)
    return Motion(motion.character, footprints, found._replace(support=support), solved)


def _rows(footprints: Footprints, begin: float, end: float) -> slice:
    """The footprints of a window, and AROUND to either side."""
    contact = footprints.contact_time
    low, high = np.searchsorted(contact, begin, side="right") - 1, np.searchsorted(contact, end, side="left") + 1
    return slice(max(int(low) - AROUND, 0), min(int(high) + AROUND, len(contact)))


def _bend_at(curve: Curve, i: int) -> np.ndarray:
    """Acceleration (3,) at control point i, by the segment that ends there."""
    w = acceleration_weights(1.0, float(curve.time[i] - curve.time[i - 1]))
    a, b = curve.control[i - 1], curve.control[i]
    return np.asarray(w[0] * a[:3] + w[1] * a[3:] + w[2] * b[:3] + w[3] * b[3:])


def _carried(motion: Motion, footprints: Footprints, change: Change, cut: Window, begin: float, end: float) -> Curve:
    """The old curve over the window's time: contact by contact it keeps its share of time, and goes with the footprints."""
    old = motion.footprints
    where = _pairs(change, len(old.side), len(footprints.side))
    keep = (footprints.contact_time[where[1]] > begin) & (footprints.contact_time[where[1]] < end)
    where = where[:, keep]
    then = np.concatenate([[motion.curve.time[cut.head]], old.contact_time[where[0]], [motion.curve.time[cut.tail]]])
    now = np.concatenate([[begin], footprints.contact_time[where[1]], [end]])
    moved = np.vstack([np.zeros(3), footprints.position[where[1]] - old.position[where[0]], np.zeros(3)])
    order = np.concatenate([[True], np.diff(np.maximum.accumulate(then)) > 0]) & np.concatenate([[True], np.diff(now) > 0])
    then, now, moved = then[order], now[order], moved[order]
    times = np.unique(np.concatenate([now, np.linspace(begin, end, 8 * len(now))]))
    place = states_at(motion.curve, np.interp(times, now, then))[:, :3]
    place += np.stack([np.interp(times, now, moved[:, k]) for k in range(3)], axis=1)
    control = np.hstack([place, np.gradient(place, times, axis=0)])
    return Curve(times, control, np.full((len(times), 2), -1))


def _pairs(change: Change, before: int, after: int) -> np.ndarray:
    """(2, K) footprints before and after the edit that are the same ones."""
    both = min(change.before, change.after)
    head = np.arange(both)
    return np.vstack(
        [np.concatenate([head, np.arange(change.before, before)]), np.concatenate([head, np.arange(change.after, after)])]
    )


def _joined(motion: Motion, footprints: Footprints, change: Change, cut: Window, part: Motion) -> Motion:
    """What was before, the window, and what follows, later."""
    old, new, more = motion.curve, part.curve, change.after - change.before
    after = old.support[cut.tail :]
    time = np.concatenate([old.time[: cut.head], new.time[:-1], old.time[cut.tail :] + change.later])
    control = np.vstack([old.control[: cut.head], new.control[:-1], old.control[cut.tail :]])
    support = np.vstack([old.support[: cut.head], new.support[:-1], np.where(after >= 0, after + more, -1)])
    return Motion(motion.character, footprints, Curve(time, control, support), part.solved)
