"""Elementary functions against the system's, and lanes against numbers."""

import numpy as np
import pytest

from motion.arithmetic.functions import angle, arc_cosine, arc_sine, exponential, levelled, logarithm, power, turn
from worlds.compiled.jit import jit
from worlds.compiled.lanes import LANES, load, store

RNG = np.random.default_rng(5)
NEAR = np.concatenate([RNG.normal(size=396), [0.0, -0.0, 1e-9, -1e-9]])
FAR = np.concatenate([RNG.uniform(-1e4, 1e4, 398), [np.pi / 2, -np.pi]])
SHARE = np.concatenate([RNG.uniform(-1, 1, 396), [-1.0, 0.0, 1.0, 1 - 1e-12]])
NAMES = ("cosine", "sine", "arc_cosine", "arc_sine", "exponential", "logarithm", "tanh", "angle", "power")
TRUE = (
    np.cos, np.sin, lambda x: np.arccos(np.clip(x, -1, 1)), lambda x: np.arcsin(np.clip(x, -1, 1)), np.exp,
    lambda x: np.log(np.abs(x) + 1e-6), np.tanh,
)  # fmt: skip


@jit
def _all(x, y):
    (c, s), share = turn(x), 1.0 * x
    made = (c, s, arc_cosine(share), arc_sine(share), exponential(x), logarithm(abs(x) + 1e-6), levelled(x))
    return made, (angle(x, y), power(abs(x), abs(y) / (1.0 + abs(y)) + 0.1))


@jit
def by_lanes(x, y, out):
    for i in range(0, len(x), LANES):
        (a, b, c, d, e, f, g), (h, k) = _all(load(x, (i,)), load(y, (i,)))
        for row, lanes in enumerate((a, b, c, d, e, f, g, h, k)):
            store(out, (row, i), lanes)


@jit
def by_numbers(x, y, out):
    for i in range(len(x)):
        (a, b, c, d, e, f, g), (h, k) = _all(x[i], y[i])
        for row, number in enumerate((a, b, c, d, e, f, g, h, k)):
            out[row, i] = number


@pytest.mark.parametrize(("x", "y"), [(NEAR, NEAR[::-1].copy()), (SHARE, NEAR), (3 * NEAR, FAR)])
def test_they_are_the_system_s_and_lanes_are_numbers(x, y):
    lanes, numbers = np.empty((len(NAMES), len(x))), np.empty((len(NAMES), len(x)))
    by_lanes(x, y, lanes)
    by_numbers(x, y, numbers)
    np.testing.assert_array_equal(lanes, numbers)
    expected = [true(x) for true in TRUE] + [np.arctan2(y, x)]
    for name, found, wanted in zip(NAMES, numbers, expected, strict=False):
        error = np.abs(found - wanted) / np.maximum(np.abs(wanted), 1.0)
        assert error[(x != 0) & (y != 0)].max() < 5e-16, name
    np.testing.assert_allclose(numbers[8], np.abs(x) ** (np.abs(y) / (1 + np.abs(y)) + 0.1), rtol=1e-13)


def test_angles_of_many_turns():
    assert max(abs(turn(x)[0] - np.cos(x)) + abs(turn(x)[1] - np.sin(x)) for x in FAR.tolist()) < 5e-16


def test_beyond_where_they_are_asked_for_they_end_somewhere():
    assert angle(0.0, 0.0) == 0.0
    assert exponential(-1e6) < 1e-300 and exponential(1e6) > 1e300
    assert power(0.0, 1.5) == 0.0 and levelled(1e3) == 1.0
    assert arc_cosine(1.5) == 0.0 and arc_cosine(-1.5) == pytest.approx(np.pi)
