"""Learning to step from stone to stone with numpy alone: the cross-entropy method on a linear policy.

    python -m tests.examples.learn_stones 40 curve.png

Each generation draws POLICIES policies, lets each walk ROWS courses of stones, and draws the next ones around the best. Stones
get harder with the generations. Prints reward and stones reached; with a name for it, draws the curve (needs matplotlib).
"""

import sys

import numpy as np

from sim.rows.stone_sight import SEEN
from sim.rows.stones import ACTIONS
from sim.stage.learning.stepping import SteppingStones

POLICIES, ELITE, ROWS, STEPS = 160, 24, 12, 15


def played(stones, policies, seeds):
    """(P,) mean reward and (P,) mean stones reached of linear policies (P, ACTIONS, SEEN + 1), all on the same courses."""
    seen = stones.reset(np.tile(seeds, len(policies)))
    reward, reached = np.zeros(stones.rows), np.zeros(stones.rows)
    there = np.arange(stones.rows)
    for _ in range(STEPS):
        around = np.column_stack([seen, np.ones(stones.rows)]).reshape(len(policies), ROWS, -1)
        actions = np.einsum("pas,prs->pra", policies, around).reshape(stones.rows, ACTIONS)
        seen, worth, fell, _ = stones.step(actions, there)
        reward += worth
        there = there[~fell[there]]
        reached[there] += 1
        if not len(there):
            break
    return reward.reshape(-1, ROWS).mean(axis=1), reached.reshape(-1, ROWS).mean(axis=1)


def learn(generations, seed=0):
    """The policy, and the history (G, 3) of level, mean reward and stones reached of the middle of the elite."""
    chance, history = np.random.default_rng(seed), []
    middle, spread = np.zeros((ACTIONS, SEEN + 1)), np.full((ACTIONS, SEEN + 1), 0.1)
    stones, judge, level = SteppingStones(POLICIES * ROWS, steps=STEPS), SteppingStones(ROWS, steps=STEPS), 0.0
    for k in range(generations):
        stones.first_level = judge.first_level = level
        policies = middle + spread * chance.standard_normal((POLICIES, *middle.shape))
        reward, _ = played(stones, policies, chance.integers(2**40, size=ROWS))
        best = policies[np.argsort(-reward)[:ELITE]]
        middle, spread = best.mean(axis=0), best.std(axis=0) + 0.02 * 0.98**k
        mine, reached = played(judge, middle[None], np.arange(ROWS))
        history.append((level, mine[0], reached[0]))
        print(f"generation {k + 1:3}: level {level:.2f}, reward {mine[0]:6.2f}, {reached[0]:5.1f} of {STEPS} stones")
        if reached[0] > 0.8 * STEPS:
            level = min(level + 0.05, 1.0)
    return middle, np.array(history)


def draw(history, path):
    """The learning curve."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(2, 1, sharex=True, figsize=(7, 5), layout="constrained")
    axes[0].plot(history[:, 2], color="C0")
    axes[0].set_ylabel(f"stones of {STEPS}")
    axes[0].twinx().plot(history[:, 0], color="C3", label="level")
    axes[1].plot(history[:, 1], color="C2")
    axes[1].set(ylabel="reward", xlabel="generation")
    figure.savefig(path, dpi=100)


if __name__ == "__main__":
    found, told = learn(int(sys.argv[1]) if len(sys.argv) > 1 else 2)
    if len(sys.argv) > 2:
        draw(told, sys.argv[2])
