"""Stepping stones for Gymnasium (the extra `rl`): one row, or many as a vector of environments that one call steps.

Importing this registers "footfall/Stones-v0" for `gymnasium.make` and `gymnasium.make_vec`.
"""

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from sim.rows.stone_sight import SEEN
from sim.rows.stones import ACTIONS
from sim.stage.learning.stepping import FARTHEST, SteppingStones

NAME = "footfall/Stones-v0"
HIGHEST_SEED = 2**62


def observation_space() -> spaces.Box:
    """What a character sees."""
    return spaces.Box(-FARTHEST, FARTHEST, (SEEN,), np.float32)


def action_space() -> spaces.Box:
    """The next footprint."""
    return spaces.Box(-1.0, 1.0, (ACTIONS,), np.float32)


class StonesEnv(gymnasium.Env):
    """One character on stepping stones; arguments are those of SteppingStones."""

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(self, render_mode: str | None = None, **options: Any) -> None:
        self.render_mode = render_mode
        self.stones = SteppingStones(1, **options)
        self.observation_space, self.action_space = observation_space(), action_space()

    def reset(self, *, seed: int | None = None, options: dict | None = None) -> tuple[np.ndarray, dict]:
        """New stones: the same ones for the same seed, others for none."""
        super().reset(seed=seed)
        return self.stones.reset(self.np_random.integers(HIGHEST_SEED, size=1))[0], {}

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict]:
        """A footprint."""
        stepped = self.stones.step(np.asarray(action)[None])
        return stepped.seen[0], float(stepped.reward[0]), bool(stepped.fell[0]), bool(stepped.finished[0]), {}


class StonesVectorEnv(VectorEnv):
    """Many of them in one; a row that has ended begins anew with the next step, which is then none of its actions."""

    metadata: dict[str, Any] = {"autoreset_mode": AutoresetMode.NEXT_STEP, "render_modes": []}

    def __init__(self, num_envs: int = 1, render_mode: str | None = None, **options: Any) -> None:
        self.num_envs, self.render_mode = num_envs, render_mode
        self.stones = SteppingStones(num_envs, **options)
        self.single_observation_space, self.single_action_space = observation_space(), action_space()
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._over = np.zeros(num_envs, bool)

    def reset(self, *, seed: int | list[int] | None = None, options: dict | None = None) -> tuple[np.ndarray, dict]:
        """New stones for all, by one seed or one each."""
        super().reset(seed=seed if isinstance(seed, int) else None)
        if seed is None or isinstance(seed, int):
            seeds = self.np_random.integers(HIGHEST_SEED, size=self.num_envs)
        else:
            seeds = np.array([np.random.default_rng(one).integers(HIGHEST_SEED) for one in seed])
        self._over[:] = False
        return self.stones.reset(seeds), {}

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict]:
        """A footprint of each row that has not ended."""
        anew, on = np.flatnonzero(self._over), np.flatnonzero(~self._over)
        stepped = self.stones.step(actions, on)
        seen = self.stones.begin(anew) if len(anew) else stepped.seen
        self._over = stepped.fell | stepped.finished
        return seen, stepped.reward, stepped.fell, stepped.finished, {}


if NAME not in gymnasium.registry:
    gymnasium.register(NAME, entry_point=StonesEnv, vector_entry_point=StonesVectorEnv)
