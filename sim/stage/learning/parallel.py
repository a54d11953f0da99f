"""Stepping stones for many agents at once, for PettingZoo (the extra `rl`): side by side, each on stones of its own."""

from functools import cache
from typing import Any

import numpy as np
from gymnasium import spaces
from pettingzoo import ParallelEnv

from sim.rows.stones import ACTIONS
from sim.stage.learning.gym import HIGHEST_SEED, action_space, observation_space
from sim.stage.learning.stepping import SteppingStones


class StonesParallelEnv(ParallelEnv):
    """N walkers; one that falls, or is done, leaves. Other arguments are those of SteppingStones."""

    metadata: dict[str, Any] = {"name": "footfall_stones_v0", "render_modes": []}

    def __init__(self, walkers: int = 8, render_mode: str | None = None, **options: Any) -> None:
        self.stones, self.render_mode = SteppingStones(walkers, **options), render_mode
        self.possible_agents = [f"walker_{k}" for k in range(walkers)]
        self.agents: list[str] = []
        self._row = {name: k for k, name in enumerate(self.possible_agents)}
        self._random = np.random.default_rng()

    @cache  # noqa: B019 (spaces must be the same objects each time; an environment lives as long as its spaces)
    def observation_space(self, agent: str) -> spaces.Box:
        """What a walker sees."""
        return observation_space()

    @cache  # noqa: B019
    def action_space(self, agent: str) -> spaces.Box:
        """Its next footprint."""
        return action_space()

    def reset(self, seed: int | None = None, options: dict | None = None) -> tuple[dict, dict]:
        """All stand on new stones."""
        if seed is not None:
            self._random = np.random.default_rng(seed)
        self.agents = list(self.possible_agents)
        seen = self.stones.reset(self._random.integers(HIGHEST_SEED, size=len(self.agents)))
        return {name: seen[self._row[name]] for name in self.agents}, {name: {} for name in self.agents}

    def step(self, actions: dict[str, np.ndarray]) -> tuple[dict, dict, dict, dict, dict]:
        """A footprint of each walker that is there."""
        wanted, now = np.zeros((len(self.possible_agents), ACTIONS)), self.agents
        for name in now:
            wanted[self._row[name]] = actions[name]
        stepped = self.stones.step(wanted, np.array([self._row[name] for name in now], np.int64))
        self.agents = [name for name in now if not (stepped.fell | stepped.finished)[self._row[name]]]

        def each(column: np.ndarray, kind: Any) -> dict:
            return {name: kind(column[self._row[name]]) for name in now}

        seen = {name: stepped.seen[self._row[name]] for name in now}
        return seen, each(stepped.reward, float), each(stepped.fell, bool), each(stepped.finished, bool), {n: {} for n in now}
