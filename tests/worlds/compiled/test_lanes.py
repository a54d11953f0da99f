"""Lanes against plain numbers: the same kernel, the same bits; and numpy."""

import numpy as np
import pytest

from worlds.compiled.across import bits_of, lane, shifted, total, total_in_turn, turned
from worlds.compiled.jit import jit, jit_borrowing, jit_inline, stack_array
from worlds.compiled.lanes import LANES, choose, fused, lanes_of, larger, load, root, store

N = 5 * LANES


@jit_inline
def formula(x, y, on):
    r = root(x * x + y * y) / 3 - 2 * x
    r += y
    r *= 0.7
    r -= -x
    r /= 1.5
    return choose(on & (r > 0.1), r, 1 - y), larger(x, y), choose((x >= y) | (y <= 0.0), 1.0, r), choose(x < 0.5, x, 0.0)


@jit
def by_lanes(x, y, on, out):
    for i in range(0, len(x), LANES):
        a, b, c, d = formula(load(x, (i,)), load(y, (i,)), load(on, (i,)))
        store(out, (0, i), a)
        store(out, (1, i), b)
        store(out, (2, i), c)
        store(out, (3, i), d)


@jit
def by_numbers(x, y, on, out):
    for i in range(len(x)):
        out[0, i], out[1, i], out[2, i], out[3, i] = formula(x[i], y[i], on[i])


@pytest.fixture
def numbers():
    rng = np.random.default_rng(1)
    return rng.normal(size=N), rng.normal(size=N), rng.random(N) < 0.5


def test_lanes_are_numbers_to_the_bit(numbers):
    lanes, plain = np.zeros((4, N)), np.zeros((4, N))
    by_lanes(*numbers, lanes)
    by_numbers(*numbers, plain)
    np.testing.assert_array_equal(lanes, plain)


def test_formula_is_numpy_s(numbers):
    x, y, on = numbers
    lanes = np.zeros((4, N))
    by_lanes(*numbers, lanes)
    r = ((np.hypot(x, y) / 3 - 2 * x + y) * 0.7 + x) / 1.5
    np.testing.assert_allclose(lanes[0], np.where(on & (r > 0.1), r, 1 - y), rtol=1e-12)
    np.testing.assert_array_equal(lanes[1], np.maximum(x, y))
    np.testing.assert_allclose(lanes[2], np.where((x >= y) | (y <= 0), 1.0, r), rtol=1e-12)
    np.testing.assert_array_equal(lanes[3], np.where(x < 0.5, x, 0.0))


@jit
def fused_by_lanes(x, y, z, out):
    store(out, (0,), fused(load(x, (0,)), load(y, (0,)), load(z, (0,))))
    for i in range(LANES):
        out[LANES + i] = fused(x[i], y[i], z[i])


def test_a_product_and_a_sum_are_rounded_once():
    """(1 + e)^2 - 1 - 2 e is e^2, which two roundings lose."""
    e = np.array([2.0**-30, 2.0**-40, -(2.0**-35), 0.0])
    out = np.zeros(2 * LANES)
    fused_by_lanes(1 + e, 1 + e, -1 - 2 * e, out)
    assert out.tolist() == [*(e * e), *(e * e)]


@jit
def sums(x, limit):
    return total(lanes_of(x[3], x[2], x[1], x[0])), bits_of(load(x, (0,)) > limit)


@pytest.mark.parametrize("limit, found", [(0.5, 0b1111), (2.5, 0b1100), (4.0, 0)])
def test_sum_and_bits(limit, found):
    assert sums(np.array([1.0, 2.0, 3.0, 4.0]), limit) == (10.0, found)


@jit
def moved(x, out):
    first, then = load(x, (0,)), load(x, (4,))
    store(out, (0,), shifted(first, then, 0))
    store(out, (4,), shifted(first, then, 1))
    store(out, (8,), shifted(first, then, 3))
    return lane(first, 0), lane(first, 3)


def test_shifted_lanes_and_one_lane():
    x, out = np.arange(8.0), np.zeros(12)
    assert moved(x, out) == (0.0, 3.0)
    assert out.tolist() == [0, 1, 2, 3, 1, 2, 3, 4, 3, 4, 5, 6]


_small = stack_array(3, 2)


@jit_borrowing
def fibonacci(n):
    array = _small()
    array[:] = 1.0
    for k in range(n):
        array[(k + 2) % 3, 1] = array[(k + 1) % 3, 1] + array[k % 3, 1]
    return array[(n + 1) % 3, 1], array.shape[0], array[2, 0]


def test_array_on_the_stack_is_an_array():
    assert fibonacci(10) == (144.0, 3, 1.0)


@jit_borrowing
def turned_over(square, out):
    rows = turned(load(square, (0, 0)), load(square, (1, 0)), load(square, (2, 0)), load(square, (3, 0)))
    store(out, (0, 0), rows[0])
    store(out, (1, 0), rows[1])
    store(out, (2, 0), rows[2])
    store(out, (3, 0), rows[3])
    return total_in_turn(rows[0], rows[1])


def test_four_lanes_turned_over_and_the_sum_of_two_in_turn():
    square, out = np.random.default_rng(2).normal(size=(LANES, LANES)), np.zeros((LANES, LANES))
    found = turned_over(square, out)
    np.testing.assert_array_equal(out, square.T)
    assert found == sum(square[:, :2].ravel().tolist())
