"""Reservations against all pairs and against dense samples of time."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion.characters.character import load_character
from planner.round import reservations
from planner.round.reservations import COMMITTED, FEET, TENTATIVE
from planner.round.soles import Sole, soles_apart
from sim.stage.cast import table_of
from tests.crowds import lines_apart

BIPEDS = table_of([load_character(name) for name in ("bird", "human")])
SIZE = (30.0, 20.0)
REST = COMMITTED - 1


def some(count, seed):
    """Characters anywhere, some of them outside the world, with paths and feet of random times."""
    rng = np.random.default_rng(seed)
    held = reservations.empty_reservations(BIPEDS, rng.integers(0, 2, count), SIZE)
    held.path[:, 0, :2] = rng.uniform((-2, -2), (SIZE[0] + 2, SIZE[1] + 2), (count, 2))
    held.path[:, 1:, :2] = held.path[:, :1, :2] + rng.normal(0, 0.4, (count, COMMITTED + TENTATIVE - 1, 2)).cumsum(axis=1)
    held.path[:, :, 2] = rng.uniform(0, 0.7, (count, COMMITTED + TENTATIVE)).cumsum(axis=1)
    held.foot[:, :, :2] = held.path[:, :FEET, :2] + rng.normal(0, 0.1, (count, FEET, 2))
    held.foot[:, :, 2] = 1.0
    held.foot[:, :, 4] = np.where(np.arange(FEET) < FEET - 2, rng.uniform(0, 2, (count, FEET)), np.inf)
    held.due[:] = rng.integers(0, 3, count) / 60
    reservations.sort_into_cells(held)
    return held


@given(st.integers(0, 200), st.integers(0, 1000))
def test_neighbours_are_those_of_all_pairs(count, seed):
    held, near = some(count, seed), np.empty(500, np.int64)
    place = held.path[:, REST, :2]
    for c in range(count):
        found = near[: reservations.neighbours(held, c, held.reach, near)]
        close = np.flatnonzero(np.hypot(*(place - place[c]).T) < held.reach)
        assert sorted(found) == [j for j in close if j != c]


def test_every_character_lies_in_one_cell_in_order():
    held = some(300, 1)
    assert sorted(held.order) == list(range(300)) and held.start[0] == 0 and held.start[-1] == 300
    for k in range(len(held.start) - 1):
        members = held.order[held.start[k] : held.start[k + 1]]
        assert (held.cell[members] == k).all() and (np.diff(members) > 0).all()


def test_too_many_neighbours_are_told():
    held = some(300, 2)
    held.path[:, :, :2] = 5.0
    reservations.sort_into_cells(held)
    assert reservations.neighbours(held, 0, held.reach, np.empty(64, np.int64)) == -1


@pytest.mark.parametrize("seed", range(20))
def test_turns_are_taken_apart_and_by_all(seed):
    held = some(150, seed)
    due, turns = np.arange(0, 150, 2), 0
    while len(due):
        turn = reservations.without_neighbours(held, due)
        place = held.path[turn, REST, :2]
        apart = np.linalg.norm(place[:, None] - place[None], axis=2) + np.where(np.eye(len(turn)), np.inf, 0)
        assert len(turn) and apart.min() >= held.reach
        for c in set(due) - set(turn):
            close = np.hypot(*(held.path[due, REST, :2] - held.path[c, REST, :2]).T) < held.reach
            assert min((held.due[j], j) for j in due[close]) < (held.due[c], c)
        due, turns = np.setdiff1d(due, turn), turns + 1
    assert turns > 1


def at(path, t):
    """Place on a path that rests at its last point."""
    return np.array([np.interp(t, path[:, 2], path[:, k]) for k in (0, 1)])


@given(st.integers(0, 10_000))
def test_least_distance_is_that_of_dense_samples(seed):
    held = some(2, seed)
    rng = np.random.default_rng(seed)
    t0 = rng.uniform(0, 2)
    begin, end, t1 = rng.uniform(0, 20, 2), rng.uniform(0, 20, 2), t0 + rng.uniform(0.1, 1)
    times = np.linspace(t0, t0 + 4, 8001)
    mine = at(np.array([[*begin, t0], [*end, t1]]), times)
    theirs = at(held.path[0, :COMMITTED], times)
    least = reservations.least_distance(held, 0, *begin, t0, *end, t1)
    assert least == pytest.approx(np.linalg.norm(mine - theirs, axis=0).min(), abs=0.02)
    np.testing.assert_allclose(reservations.place_on_path(held, 0, t0, REST), theirs[:, 0], atol=1e-9)


def sole_at(x, y, heading=0.0, half=0.08, radius=0.05):
    return Sole(x, y, np.cos(heading), np.sin(heading), half, radius)


def test_feet_hold_their_soles_until_they_leave():
    held = some(1, 3)
    held.foot[0] = [[1, 1, 1, 0, 5.0], [2, 1, 1, 0, np.inf], [3, 1, 1, 0, np.inf]]
    half, radius = held.sole[0]
    assert not reservations.foot_is_free(held, 0, sole_at(1.0, 1.04 + radius), 0.0, 4.9)
    assert reservations.foot_is_free(held, 0, sole_at(1.0, 1.04 + radius), 0.0, 5.1)
    assert reservations.foot_is_free(held, 0, sole_at(1.0, 1.06 + radius), 0.0, 4.9), "side by side"
    assert not reservations.foot_is_free(held, 0, sole_at(1.0, 1.06 + radius), 0.02, 4.9), "with a margin"
    assert not reservations.foot_is_free(held, 0, sole_at(3.0 + half + radius, 1.0), 0.0, 99.0), "one behind the other"


@given(st.tuples(*[st.floats(-0.4, 0.4)] * 2), st.floats(-3, 3), st.floats(-3, 3))
def test_soles_are_as_far_apart_as_dense_samples_of_their_lines(place, first, second):
    a, b = sole_at(0.0, 0.0, first), sole_at(*place, second, 0.1, 0.04)
    u, v = (np.array([[s.half * s.ahead_x, s.half * s.ahead_y]]) for s in (a, b))
    twin = lines_apart(np.zeros((1, 2)), u, np.array([place]), v)[0] - 0.09
    found = soles_apart(a, b)
    assert found == pytest.approx(twin, abs=4e-3) or (found < 0 and twin < 0)
