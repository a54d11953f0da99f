"""What is asked of a throng: how long anyone stands, how orderly its lanes are, and how deep and long bodies overlap."""

import numpy as np

from sim.reports.flows import PER_SECOND, Flow

STILL = 0.1
"""Who is slower stands [m/s]."""
BESIDE, ALONG = 0.3, 2.5
"""Others in one's lane are no further aside and along it [m]."""
DEEP = 0.05
"""Bodies that overlap by less, in depths of the one, only graze."""
DIRECTIONS = 720
"""In so many two bodies are looked at: gaps between people are known to a hundredth of a millimetre."""


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
    """The mean speed of those who are there (F, C), along x, the way that each goes in the end [m/s]."""
    way = np.sign(flow.place[-1, :, 0] - flow.place[0, :, 0])
    return float((way * np.diff(flow.place[..., 0], axis=0))[there[1:]].mean() * PER_SECOND)


def overlaps(flow: Flow) -> np.ndarray:
    """(F, C) how deep each body lies in another, in its own depth; 0 where in none. Bodies as they are posed."""
    assert flow.heading is not None and flow.half is not None
    deep, half = np.zeros(flow.heading.shape), flow.half
    for k, place in enumerate(flow.place):
        apart = place[None] - place[:, None]
        i, j = np.nonzero(np.triu(np.hypot(apart[..., 0], apart[..., 1]) < 2 * half.max(), 1))
        inside = -gaps(half[i], flow.heading[k, i], half[j], flow.heading[k, j], apart[i, j])
        for who in (i, j):
            np.maximum.at(deep[k], who, inside / (2 * half[who, 0]))
    return deep


def gaps(half: np.ndarray, heading: np.ndarray, half2: np.ndarray, heading2: np.ndarray, apart: np.ndarray) -> np.ndarray:
    """(K,) gaps between two ellipses each of half axes (K, 2), headings (K,) and middles (K, 2) apart [m].

    Negative: how far one must move at least until they only touch.

    The largest over all directions of what is between their support lines: convex bodies are as far apart, or as deep in each
    other, as that. The gap on the line between the middles (planner.crowd.bodies.gap_between) is it only where they face alike.
    """
    way = np.linspace(0, 2 * np.pi, DIRECTIONS, endpoint=False)
    both = sum(np.hypot(a[:, :1] * np.cos(way - f[:, None]), a[:, 1:] * np.sin(way - f[:, None])) for a, f in
               ((half, heading), (half2, heading2)))  # fmt: skip
    return np.asarray((apart @ np.array([np.cos(way), np.sin(way)]) - both).max(axis=1))


def longest_overlap(flow: Flow) -> float:
    """The longest time for which anyone lies in others by more than DEEP of its depth [s]."""
    return longest_run(overlaps(flow) > DEEP) / PER_SECOND


def deepest_overlap(flow: Flow) -> float:
    """How deep a body lies in another at most, in its depth; 0 where none does."""
    return float(overlaps(flow).max())
