"""The environments as Gymnasium's and PettingZoo's own checkers see them."""

import warnings

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium", reason="gymnasium (the extra `rl`) is not installed")
pytest.importorskip("pettingzoo", reason="pettingzoo (the extra `rl`) is not installed")

from gymnasium.utils.env_checker import check_env  # noqa: E402
from pettingzoo.test import parallel_api_test  # noqa: E402

from sim.stage.learning.gym import NAME, StonesVectorEnv  # noqa: E402
from sim.stage.learning.parallel import StonesParallelEnv  # noqa: E402


def test_gymnasium_finds_nothing():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(gymnasium.make(NAME, level=0.3).unwrapped)


def test_pettingzoo_finds_nothing():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        parallel_api_test(StonesParallelEnv(4), 1000)


def rollout(environment, seed):
    seen, _ = environment.reset(seed=seed)
    found, chance = [seen], np.random.default_rng(1)
    for _ in range(5):
        actions = chance.uniform(-1, 1, environment.action_space.shape).astype(np.float32)
        seen, reward, fell, *_ = environment.step(actions)
        found += [seen, np.asarray(reward), np.asarray(fell)]
    return found


@pytest.mark.parametrize(
    "make", [lambda: gymnasium.make(NAME, level=0.3).unwrapped, lambda: gymnasium.make_vec(NAME, 30, level=0.3).unwrapped]
)
def test_resets_with_a_seed_are_the_same_to_the_bit(make):
    one, other = make(), make()
    one.reset()
    for a, b in zip(rollout(one, 5), rollout(other, 5), strict=True):
        assert np.array_equal(a, b)
    assert not np.array_equal(rollout(one, 5)[0], rollout(one, 6)[0])


def test_a_row_of_the_vector_is_the_single_one():
    vector, single = StonesVectorEnv(3, level=0.3), gymnasium.make(NAME, level=0.3).unwrapped
    seen, _ = vector.reset(seed=[4, 5, 6])
    assert np.array_equal(seen[1], single.reset(seed=5)[0])


def test_rows_that_have_ended_begin_anew_with_the_next_step():
    vector = StonesVectorEnv(2, level=0.3)
    seen, _ = vector.reset(seed=1)
    miss = np.zeros((2, 4), np.float32)
    miss[0, 1] = 1.0
    _, _, fell, _, _ = vector.step(miss)
    assert fell[0]
    again, reward, fell, _, _ = vector.step(miss)
    assert reward[0] == 0 and not fell[0] and not np.array_equal(again[0], seen[0])


def test_walkers_leave_one_by_one():
    environment = StonesParallelEnv(5)
    environment.reset(seed=2)
    aside = {name: np.array([0, 1.0 if name == "walker_3" else 0.0, 0, 0], np.float32) for name in environment.agents}
    _, _, fell, _, _ = environment.step(aside)
    assert fell["walker_3"] and "walker_3" not in environment.agents
