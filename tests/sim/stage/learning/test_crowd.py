"""Agents in one world: they see each other, and do not overlap."""

import warnings

import numpy as np
import pytest

pytest.importorskip("gymnasium", reason="gymnasium (the extra `rl`) is not installed")
pytest.importorskip("pettingzoo", reason="pettingzoo (the extra `rl`) is not installed")

from pettingzoo.test import parallel_api_test  # noqa: E402

from sim.stage.learning.crowd import EACH, OWN, CrowdParallelEnv  # noqa: E402
from tests.crowds import Watch  # noqa: E402
from worlds.errors import InputError  # noqa: E402


def toward(seen):
    """Actions of who walks straight to its place, whoever is in the way, (N, 3) of what is seen (N, ...)."""
    off = np.arctan2(seen[:, 1], seen[:, 0])
    near = np.hypot(*seen[:, :2].T) < 1.5
    return np.column_stack([np.where(near, -0.4, 0.7), np.zeros(len(seen)), (off / 0.6).clip(-1, 1)])


def walked(walkers, beats, seed=3):
    env = CrowdParallelEnv(walkers, beats=beats)
    seen, _ = env.reset(seed=seed)
    watch, found = Watch(env.sim), []
    while env.agents:
        names = list(env.agents)
        actions = toward(np.array([seen[name] for name in names]))
        seen, reward, there, late, _ = env.step(dict(zip(names, actions, strict=True)))
        watch._look()
        found.append((seen, reward, there, late))
    return env, watch.figures(), found


def test_pettingzoo_finds_nothing():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        parallel_api_test(CrowdParallelEnv(5), 1000)


def test_they_cross_without_overlapping_and_most_arrive():
    env, figures, found = walked(12, 80)
    assert figures["feet overlaps"] == 0 and figures["body overlap % of depth"] <= 5, figures
    arrived = {name for _, _, there, _ in found for name, yes in there.items() if yes}
    assert len(arrived) >= 8
    ways = np.hypot(*(env.sim.com()[:, :2] - env.goals).T)
    assert (ways[[env._row[name] for name in arrived]] < 1.0).all()


def test_they_see_each_other():
    env = CrowdParallelEnv(3)
    seen, _ = env.reset(seed=1)
    for _ in range(10):
        names = list(env.agents)
        seen, *_ = env.step(dict(zip(names, toward(np.array([seen[name] for name in names])), strict=True)))
    com, feet = env.sim.com()[:, :2], env.sim.feet()
    heading, here, m = feet.heading[0, 1], feet.position[0, 1, :2], -1.0 if feet.side[0, 1] == 0 else 1.0
    one = min((1, 2), key=lambda k: np.hypot(*(com[k] - com[0])))
    sight = seen["walker_0"][OWN : OWN + EACH]
    c, s = np.cos(heading), np.sin(heading)
    place = here + np.array([[c, -s], [s, c]]) @ (sight[1:3] * (1, m))
    assert sight[0] == 1 and np.allclose(place, com[one], atol=1e-5) and np.hypot(*sight[3:5]) > 0.3


def test_the_same_seed_is_the_same_to_the_bit():
    (_, _, one), (_, _, other) = walked(5, 6), walked(5, 6)
    for (seen, reward, *_), (again, worth, *_) in zip(one, other, strict=True):
        assert reward == worth and all(np.array_equal(seen[name], again[name]) for name in seen)
    assert not np.array_equal(walked(5, 1, seed=4)[2][0][0]["walker_0"], one[0][0]["walker_0"])


def test_who_is_in_the_way_is_gone_around_or_waited_for():
    """An action is taken to the letter where nobody is near."""
    env = CrowdParallelEnv(1)
    env.reset(seed=0)
    for _ in range(6):
        env.step({"walker_0": np.array([0.5, 0.0, 0.0])})
    alone = env.sim.walked().footprints.position[3:, :2]
    steps = np.hypot(*np.diff(alone, axis=0).T)
    assert steps.std() < 0.02 and 0.5 < steps.mean() < 0.7


@pytest.mark.parametrize("options", [{"walkers": 0}, {"walkers": 1000}, {"walkers": 2, "beats": 0}])
def test_what_cannot_be_is_refused(options):
    with pytest.raises(InputError):
        CrowdParallelEnv(**options)
