"""Which step costs least, found without weighing all: as if all were weighed; and terms told from afar: as if from near."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planner.crowd import terms
from planner.crowd.bodies import extent, way_to_touch
from planner.crowd.candidates import DIRECTIONS, Candidate, bearing_of, candidate
from planner.crowd.choosing import (
    CANDIDATE,
    SHORTER_BY,
    STAND,
    WISH,
    Scratch,
    _cheapest,
    _dense,
    _lay,
    _past_those,
    _shorten,
    _speed_in,
    cost_of,
    least_cost,
)  # fmt: skip
from planner.crowd.neighbour import NEIGHBOUR, close_by
from planner.round.weights import PEOPLE, table_of_weights
from tests.planner.crowd.test_avoiding import around, nothing_held
from tests.planner.crowd.test_terms import B, other, waiting
from worlds.world import World

ROUND = around(nothing_held(), World("plain", (12.0, 12.0)))._replace(bipeds=np.array([B], B.dtype).view(np.recarray))
numbers = st.floats(-1, 1)


def throng(seed, count=20):
    """So many around, at random, some with the right of way."""
    r = np.random.Generator(np.random.Philox(key=seed))
    others = np.zeros(count, NEIGHBOUR)
    for name in ("x", "y", "rest_x", "rest_y"):
        others[name] = r.uniform(-2, 2, count)
    for name in ("vx", "vy"):
        others[name] = r.uniform(-1.3, 1.3, count)
    turn = r.uniform(0, 6, count)
    others["deep"], others["wide"], others["face_x"], others["face_y"] = 0.15, 0.25, np.cos(turn), np.sin(turn)
    others["along"] = r.uniform(-1, 1, count)
    claims = r.uniform(0, 1, count) < 0.3
    others["claim_x"] = np.where(claims, r.uniform(-1, 1, count), np.inf)
    others["claim_y"], others["rank"] = others["claim_x"], claims
    return others


def scratch_of(me, others):
    steps = np.empty(WISH + 1, CANDIDATE).view(np.recarray)
    dense, cost, weighed = np.empty((len(others), 3)), np.empty(WISH + 1), np.empty(WISH + 1, np.bool_)
    dense = dense[: _dense(ROUND, me, others, dense)]
    return Scratch(others, others, dense, _past_those(ROUND, me, others), cost, weighed, np.empty(STAND), steps)


def weighed(seed, right):
    """(walker, others, scratch) of one who chooses in a throng, as it wishes to go on straight ahead."""
    me, others = waiting(course=0.3), throng(seed)
    scratch = scratch_of(me, others)
    _lay(ROUND, me, right, Candidate(5.5, 5.1, 0.1, 5.5, 5.0, 0.5), scratch)
    return me, others, scratch


def test_nobody_who_is_behind_or_comes_against_one_makes_it_dense_ahead():
    me, others = waiting(), throng(3)
    others["x"], others["along"] = np.abs(others["x"]), 0.0
    nobody = scratch_of(me, others)._replace(close=others[:0])
    assert _speed_in(ROUND, me, nobody, 1.0, 0.0) < 0.9 * me.full and _speed_in(ROUND, me, nobody, -1.0, 0.0) == me.full
    others["along"] = -1.0
    nobody = scratch_of(me, others)._replace(close=others[:0], most=me.full)
    assert _speed_in(ROUND, me, nobody, 1.0, 0.0) == me.full


def test_who_meets_others_walks_more_slowly_until_they_are_past():
    me, others = waiting(), throng(3)
    others["x"], others["along"] = np.abs(others["x"]), -1.0
    slow = me.full * (1 - PEOPLE.meet)
    assert _speed_in(ROUND, me, scratch_of(me, others)._replace(close=others[:0]), 1.0, 0.0) == slow
    for x, along in ((-others["x"], -1.0), (others["x"] + 3, -1.0), (others["x"], 0.0)):
        others["x"], others["along"] = x, along
        assert _past_those(ROUND, me, others) == me.full, "behind, far off, or not against one"


@given(st.integers(0, 500), st.floats(0, 2.5))
@settings(max_examples=60, deadline=None)
def test_the_cheapest_is_that_of_all(seed, right):
    me, others, scratch = weighed(seed, right)
    allowed = np.isfinite(scratch.cost)
    costs = [cost_of(ROUND, me, others, right, Candidate(*step), k != STAND) for k, step in enumerate(scratch.step)]
    least = [least_cost(ROUND, me, right, Candidate(*step), k != STAND) for k, step in enumerate(scratch.step)]
    assert (np.array(least) <= costs).all()
    k = _cheapest(ROUND, me, right, scratch)
    assert k == np.argmin(np.where(allowed, costs, np.inf)) and scratch.cost[k] == costs[k]
    assert scratch.weighed.sum() <= len(DIRECTIONS) + 2


def test_some_steps_are_never_weighed():
    counts = []
    for seed in range(40):
        me, _, scratch = weighed(seed, 0.0)
        _cheapest(ROUND, me, 0.0, scratch)
        counts.append(scratch.weighed.sum())
    assert np.mean(counts) < 0.8 * (WISH + 1)


@given(numbers, numbers, numbers, numbers, numbers, numbers)
def test_danger_told_from_afar_is_danger(px, py, vx, vy, ux, uy):
    me, one = waiting(), other(3 * px, 3 * py, ux, uy)[0]
    told = terms.danger(me, one, vx, vy, PEOPLE.horizon, 0.3)
    speed = np.hypot(vx - ux, vy - uy)
    if speed < 1e-9:
        assert told == 0
        return
    dx, dy = (vx - ux) / speed, (vy - uy) / speed
    half = (0.15, 0.25)
    deep, wide = 2 * extent(half, (1.0, 0.0), dx, dy), 2 * extent(half, (1.0, 0.0), -dy, dx)
    time = max(way_to_touch(3 * px, 3 * py, dx, dy, deep, wide), 0.0) / speed / 0.3
    whole = speed / me.full * (1 / max(time, terms.SOON) - 1 / PEOPLE.horizon) if time < PEOPLE.horizon else 0.0
    assert told == pytest.approx(whole, abs=1e-7)


@given(numbers, numbers, numbers, st.floats(0, 1.5))
def test_a_bound_on_the_speed_leaves_the_least_as_it_is(px, py, vx, most):
    me, one = waiting(), other(3 * px, 3 * py, vx)[0]
    whole = terms.speed_behind(me, one, 1.0, 0.0, 0.4, 0.4)
    assert min(terms.speed_behind(me, one, 1.0, 0.0, 0.4, 0.4, most), most) == min(whole, most)


def test_spacing_is_told_by_those_who_are_close_alone():
    told = 0
    for seed in range(60):
        me, others, all = weighed(seed, 0.5)
        close = np.zeros(len(others), NEIGHBOUR)
        close = close[: close_by(ROUND, me, others, close)]
        few = all._replace(close=close, cost=np.empty(WISH + 1), length=np.empty(STAND), step=all.step.copy())
        _lay(ROUND, me, 0.5, Candidate(5.5, 5.1, 0.1, 5.5, 5.0, 0.5), few)
        for mine, theirs in ((few.cost, all.cost), (few.length, all.length), (few.step, all.step)):
            np.testing.assert_array_equal(mine, theirs)
        told += len(close) < len(others)
    assert told > 30, "some are told to be too far away"


def test_a_shorter_step_costs_as_much_as_the_dearest_on_the_way():
    for seed in range(40):
        me, others, scratch = weighed(seed, 0.5)
        k = int(np.argmax(scratch.length))
        scratch.cost[k] = 0.5 * scratch.cost[k]
        before, length = scratch.cost[k], scratch.length[k]
        _shorten(ROUND, me, 0.5, np.zeros(0, np.int64), k, scratch)
        if np.isfinite(scratch.cost[k]):
            tried = length * SHORTER_BY ** np.arange(1, 30)
            tried = tried[tried > scratch.length[k] - 1e-9]
            to = bearing_of(B, me, DIRECTIONS[k])
            costs = [cost_of(ROUND, me, others, 0.5, candidate(B, me, to, far), True) for far in tried]
            assert scratch.cost[k] == pytest.approx(max(before, *costs)) and scratch.weighed[k]
            assert scratch.length[k] == pytest.approx(tried[-1]) and tried[-1] < length


def test_no_weight_is_negative():
    with pytest.raises(ValueError, match="weights.side: -1"):
        table_of_weights(PEOPLE._replace(side=-1.0), 1)


def test_a_model_that_there_is_not_is_refused():
    with pytest.raises(ValueError, match="there are steps, orca"):
        table_of_weights(PEOPLE._replace(model="fields"), 1)
