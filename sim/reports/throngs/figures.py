"""What is asked of a throng: how long anyone stands, how orderly its lanes are, and how deep and long bodies overlap."""

import numpy as np

from planner.crowd.bodies import gap_between
from sim.reports.flows import PER_SECOND, Flow

STILL = 0.1
"""Who is slower stands [m/s]."""
BESIDE, ALONG = 0.3, 2.5
"""Others in one's lane are no further aside and along it [m]."""
DEEP = 0.05
"""Bodies that overlap by less, in depths of the one, only graze."""


def stands(flow: Flow) -> np.ndarray:
    """(F - 1, C) who stands from one look to the next."""
    return np.hypot(*np.moveaxis(np.diff(flow.place, axis=0), 2, 0)) * PER_SECOND < STILL


def still_longest(flow: Flow, until: float | None = None) -> float:
    """The longest time that anyone stands [s]: until it is beyond x = `until` [m], from the side where it began."""
    still = stands(flow)
    if until is not None:
        x = flow.place[..., 0] - until
        still &= (x * x[0] > 0)[1:]
    return longest_run(still) / PER_SECOND


def longest_run(true: np.ndarray) -> int:
    """The longest run of true ones down the columns of (F, C)."""
    run, longest = np.zeros(true.shape[1], np.int64), 0
    for row in true:
        run = np.where(row, run + 1, 0)
        longest = max(longest, int(run.max(initial=0)))
    return longest


def lanes(flow: Flow, there: np.ndarray) -> float:
    """The order of lanes of two streams along x: the mean of ((same - against) / (same + against))^2 over the others in one's
    lane; 0 without lanes, 1 where nobody has anyone against it there (Rex & Loewen 2007). there (F, C): who is asked."""
    way, found = np.sign(flow.place[-1, :, 0] - flow.place[0, :, 0]), [np.zeros(0)]
    for k in range(0, len(flow.time), PER_SECOND):
        away = np.abs(flow.place[k][:, None] - flow.place[k])
        near = (away[..., 1] < BESIDE) & (away[..., 0] < ALONG) & ~np.eye(len(way), dtype=bool) & there[k][:, None]
        same, all = (near & (way[:, None] == way)).sum(axis=1), near.sum(axis=1)
        found.append(((2 * same - all) / np.maximum(all, 1))[all > 0] ** 2)
    return float(np.concatenate(found).mean())


def speed(flow: Flow, there: np.ndarray) -> float:
    """The mean speed along x of those who are there (F, C) [m/s]."""
    return float(np.abs(np.diff(flow.place[..., 0], axis=0))[there[1:]].mean() * PER_SECOND)


def overlaps(flow: Flow) -> np.ndarray:
    """(F, C) how deep each body lies in another, in its own depth; 0 where in none. Bodies as they are posed."""
    assert flow.heading is not None and flow.half is not None
    deep, reach = np.zeros(flow.heading.shape), 2 * float(flow.half.max())
    for k, place in enumerate(flow.place):
        apart = place[None] - place[:, None]
        for i, j in np.argwhere(np.hypot(apart[..., 0], apart[..., 1]) < reach).tolist():
            if i != j:
                deep[k, i] = max(deep[k, i], -_gap(flow, k, i, j) / (2 * flow.half[i, 0]))
    return deep


def _gap(flow: Flow, k: int, i: int, j: int) -> float:
    """Between the bodies of two at moment k [m]."""
    assert flow.heading is not None and flow.half is not None
    (x, y), (first, second) = (flow.place[k, j] - flow.place[k, i]).tolist(), flow.half[[i, j]].tolist()
    one, other = ((float(np.cos(a)), float(np.sin(a))) for a in flow.heading[k, [i, j]])
    return float(gap_between(tuple(first), one, tuple(second), other, x, y))


def longest_overlap(flow: Flow) -> float:
    """The longest time for which anyone lies in others by more than DEEP of its depth [s]."""
    return longest_run(overlaps(flow) > DEEP) / PER_SECOND
