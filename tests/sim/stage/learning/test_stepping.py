"""Stones to learn on: repeatable to the bit, walkable, and lost where one steps beside them."""

import numba
import numpy as np
import pytest

from motion.com import newton
from sim.bench.learning import onto
from sim.rows.stone_sight import SEEN
from sim.rows.stones import ACTIONS, NEXT
from sim.stage.learning import stepping
from sim.stage.learning.stepping import SteppingStones
from worlds.errors import InputError

ROWS = 40


def course(steps, **options):
    """What is seen and earned over some steps."""
    stones = SteppingStones(ROWS, level=0.4, **options)
    seen, found = stones.reset(np.arange(ROWS)), []
    for _ in range(steps):
        stepped = stones.step(onto(stones, seen))
        seen = stepped.seen
        found.append((seen, stepped.reward, stepped.fell))
    return stones, found


def test_the_same_seeds_are_the_same_to_the_bit():
    one, other = course(6)[1], course(6)[1]
    for (seen, reward, fell), (again, worth, lost) in zip(one, other, strict=True):
        assert np.array_equal(seen, again) and np.array_equal(reward, worth) and np.array_equal(fell, lost)


@pytest.mark.parametrize("threads", [1, 2])
def test_threads_change_no_bit(threads):
    if threads > numba.config.NUMBA_NUM_THREADS:
        pytest.skip("one processor alone")
    before = numba.get_num_threads()
    numba.set_num_threads(threads)
    try:
        found = course(5)[1]
    finally:
        numba.set_num_threads(before)
    for (seen, reward, fell), (again, worth, lost) in zip(found, course(5)[1], strict=True):
        assert np.array_equal(seen, again) and np.array_equal(reward, worth) and np.array_equal(fell, lost)


def test_windows_are_solved_nearly_as_well_as_can_be(monkeypatch):
    """On the hardest stones, beside an effort that spares nothing; nobody falls who need not."""
    quick = hardest()
    monkeypatch.setattr(stepping, "EFFORT", newton.TIGHT)
    tight = hardest()
    assert tight[0] < quick[0] < 1.25 * tight[0] and abs(quick[1] - tight[1]) < 0.02


def hardest():
    """(mean E of the windows of those who do not fall, share of steps that fall) over ten steps at level 1."""
    stones, cost, fell = SteppingStones(200, level=1.0), [], []
    seen = stones.reset(np.arange(200))
    for _ in range(10):
        stepped = stones.step(onto(stones, seen))
        cost.append(stones.crowd.window_cost[~stepped.fell, 0])
        fell.append(stepped.fell)
        seen = stones.begin(np.flatnonzero(stepped.fell))
    return np.concatenate(cost).mean(), np.mean(fell)


def test_a_row_does_not_depend_on_its_neighbours():
    alone = SteppingStones(1, level=0.4)
    seen = alone.reset(np.array([7]))
    together, many = SteppingStones(ROWS, level=0.4), None
    many = together.reset(np.arange(ROWS))
    for _ in range(4):
        assert np.array_equal(seen[0], many[7])
        seen, many = alone.step(onto(alone, seen)).seen, together.step(onto(together, many)).seen


def test_who_steps_onto_stones_walks_on():
    stones, found = course(12)
    assert np.mean([fell.mean() for _, _, fell in found]) < 0.03
    assert 0.3 < np.mean([reward.mean() for _, reward, _ in found]) < 1.2
    feet = stones.crowd.footprints
    n = stones.crowd.real[0] - 1
    place = stones._ground.value.stones.place[0]
    np.testing.assert_allclose(feet.position[0, n], place[NEXT - 1, [0, 1, 3]], atol=1e-5)


def test_who_steps_beside_them_has_fallen_and_stays():
    stones = SteppingStones(ROWS)
    before = stones.reset(np.arange(ROWS))
    actions = onto(stones, before)
    actions[:5, 1] = 1.0
    stepped = stones.step(actions)
    assert stepped.fell[:5].all() and not stepped.fell[5:].any() and (stepped.reward[:5] < -1).all()
    assert np.array_equal(stepped.seen[:5], before[:5])


def test_a_row_begins_anew_and_others_go_on():
    stones = SteppingStones(ROWS, level=0.5)
    seen = stones.step(onto(stones, stones.reset(np.arange(ROWS)))).seen
    again = stones.begin(np.array([2]))
    assert stones.taken.tolist() == [0 if c == 2 else 1 for c in range(ROWS)]
    others = np.arange(ROWS) != 2
    assert np.array_equal(again[others], seen[others]) and not np.array_equal(again[2], seen[2])


def test_a_curriculum_finds_its_level():
    stones = SteppingStones(ROWS, level=0.2, curriculum=True, steps=4)
    seen = stones.reset(np.arange(ROWS))
    for _ in range(4):
        actions = onto(stones, seen)
        actions[:10, 1] += 2.0
        seen = stones.step(actions, np.arange(10, ROWS) if stones.taken.any() else None).seen
    assert (stones.level[:10] < 0.2).all() and np.median(stones.level[10:]) == pytest.approx(0.3)


def test_stones_are_as_far_apart_as_they_are_to_be():
    stones = SteppingStones(400, level=1.0)
    seen = stones.reset(np.arange(400))
    ahead = seen[:, 15:18] - seen[:, 12:15]
    away = np.hypot(ahead[:, 0], ahead[:, 1]) * 0.9 / float(stones.character.biped.leg.nominal_length)
    turn = np.degrees(np.arctan2(ahead[:, 1], ahead[:, 0]))
    assert 0.64 < away.min() < 0.7 and 1.2 < away.max() < 1.26 and 15 < np.abs(turn).max() < 40.1
    assert ahead[:, 2].max() <= 0.9 * stones.character.biped.reach.max_rise + 1e-6 and seen.shape[1] == SEEN


@pytest.mark.parametrize(
    "options", [{"rows": 0}, {"rows": 2, "level": 2}, {"rows": 2, "steps": 0}, {"rows": 2, "character": "x"}]
)
def test_what_cannot_be_is_refused(options):
    with pytest.raises(InputError):
        SteppingStones(**options)


def test_actions_of_another_shape_are_refused_and_wild_ones_cut():
    stones = SteppingStones(3)
    stones.reset(np.arange(3))
    with pytest.raises(InputError, match="actions of shape"):
        stones.step(np.zeros((2, ACTIONS)))
    assert stones.step(np.array([[np.nan] * 4, [np.inf] * 4, [-1e300] * 4])).fell.any()
