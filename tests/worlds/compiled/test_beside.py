"""Rows side by side against the same asked of each row."""

from typing import NamedTuple

import numpy as np
import pytest

from worlds.compiled.across import any_of, bits_of, isnt, total
from worlds.compiled.beside.places import counted, counting, each_of, load_wide, put, store_some
from worlds.compiled.beside.records import records_beside
from worlds.compiled.beside.rows import side_by_side
from worlds.compiled.beside.wide import WIDE
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.lanes import choose, larger
from worlds.compiled.tables import Integers, Numbers, Truths, Vectors, newest

SIZES = np.dtype([("arm", [("upper", float), ("lower", float)]), ("tail", [("length", float)])])
_beside, _empty_sizes = records_beside(SIZES)
C, N = 13, 6


class Things(NamedTuple):
    side: Integers
    place: Vectors
    time: Numbers
    stands: Truths


@pytest.fixture
def things():
    rng = np.random.default_rng(3)
    time = np.sort(rng.random((C, N)), axis=1)
    return Things(rng.integers(0, 2, (C, N)), rng.random((C, N, 3)), time, rng.random((C, N)) < 0.5)


@jit_borrowing
def asked(sizes, things, t):
    """What a kernel may ask of one row."""
    last = larger(newest(things.time, t), 0)
    place, end = things.place[last], len(things.time) - 1
    way = choose(things.side[last] == 1, place[0], -place[0]) + things.place[end, 2]
    return choose(things.stands[last] & (things.time[last] > 0.1), sizes.arm.lower, sizes.tail.length) + way, last


@jit
def of_many(sizes, kind, table, counts, rows, t, out, which):
    for first in range(0, len(rows), WIDE):
        at = counted(first, len(rows))
        c = each_of(rows, at, ())
        record = _beside(sizes, each_of(kind, c, ()), _empty_sizes())
        value, last = asked(record, side_by_side(table, c, each_of(counts, c, ())), t)
        put(out, at, (1,), value)
        put(which, at, (), last)


def test_what_is_asked_of_many_rows_is_that_of_each_to_the_bit(things):
    rng = np.random.default_rng(4)
    sizes = rng.random((2, 3)).view(SIZES).reshape(2).view(np.recarray)
    kind, counts, rows = rng.integers(0, 2, C), rng.integers(1, N + 1, C), rng.permutation(C)[:11]
    out, which = np.zeros((11, 2)), np.full(11, -9)
    of_many(sizes, kind, things, counts, rows, 0.5, out, which)
    for k, c in enumerate(rows):
        one = Things(*(column[c, : counts[c]] for column in things))
        assert (out[k, 1], which[k]) == asked(sizes[kind[c]], one, 0.5)
    assert (out[:, 0] == 0).all()


@jit
def moved(x, out, count, limit):
    lanes = load_wide(x, (1,))
    store_some(out, (2,), 2 * lanes, count)
    return any_of(lanes > limit), any_of(isnt(lanes > limit))


def test_some_lanes_are_stored():
    x, out = np.arange(WIDE + 1.0), np.zeros(WIDE + 4)
    assert moved(x, out, 3, 0.5) == (True, False)
    assert out.tolist() == [0, 0, 2, 4, 6] + [0] * (WIDE - 1)
    assert moved(x, out, WIDE, 4.0) == (True, True)
    assert out[2 : 2 + WIDE].tolist() == (2 * x[1:]).tolist()


@jit
def summed(x, truths, first):
    """Sums over a column from `first` on, and which of as many truths hold."""
    at = counted(first, len(x))
    counts = counting(first, len(x))
    return total(each_of(x, at, (1,))), total(counts * each_of(x, at, (1,))), bits_of(load_wide(truths, (first,)))


def test_beyond_the_last_row_lie_copies_of_it_that_count_for_nothing():
    x, truths = np.arange(2.0 * C).reshape(C, 2), np.arange(C + WIDE) % 3 == 0
    for first in (0, C - WIDE, C - 3, C - 1):
        rows = np.minimum(np.arange(first, first + WIDE), C - 1)
        all, once, bits = summed(x, truths, first)
        assert all == x[rows, 1].sum()
        assert once == x[first : first + WIDE, 1].sum()
        assert [bits >> k & 1 for k in range(WIDE)] == truths[first : first + WIDE].tolist()
