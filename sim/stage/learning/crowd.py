"""A crowd to learn in, for PettingZoo (the extra `rl`): agents in one world, who see each other and go to places of their own.

They stand around a circle and have to get to its other side, all through its middle. A step of the environment is a beat of
BEAT seconds; whoever's next footprint is due in it takes it by its newest action. Soles and bodies do not overlap: what
others hold is free for nobody, and of what is free the nearest to the wish is taken, or the walker stands.
"""

from functools import cache
from typing import Any

import numpy as np
from gymnasium import spaces
from pettingzoo import ParallelEnv

from motion.characters.character import Character, load_character
from planner.planners import PLANNERS
from sim.stage.asked import whole
from sim.stage.learning.gym import HIGHEST_SEED
from sim.stage.learning.stepping import FARTHEST
from sim.stage.simulation import Simulation
from worlds.world import World

BEAT = 0.5
"""Seconds of a step."""
BEATS = 120
"""Steps after which everybody has had time enough."""
SEEN_OTHERS, OTHERS_AWAY = 5, 8.0
"""So many of the nearest others are seen, within this distance [m]."""
THERE = 0.6
"""A place is reached within so many [m]."""
PER_BEAT, STANDING, ARRIVED = 0.05, 0.05, 1.0
"""What each beat takes off the reward, what standing takes off besides, and what arriving is worth."""
ROOM = 1.1
"""Metres of the circle for each, at least."""
OWN, EACH = 8, 5
"""Numbers that are seen of oneself, and of each of the others."""
MOST_WALKERS = 200


class CrowdParallelEnv(ParallelEnv):
    """N walkers; an agent that has arrived is done, and stands there. Actions are footprints: ahead, aside, turned, -1 to 1."""

    metadata: dict[str, Any] = {"name": "footfall_crowd_v0", "render_modes": []}

    def __init__(
        self, walkers: int = 8, character: str | Character = "human", beats: int = BEATS, render_mode: str | None = None
    ) -> None:
        """Raises InputError."""
        whole("walkers", walkers, 1, MOST_WALKERS)
        self.beats, self.render_mode = whole("beats", beats, 1, 100_000), render_mode
        self.character = load_character(character) if isinstance(character, str) else character
        self.possible_agents = [f"walker_{k}" for k in range(walkers)]
        self.agents: list[str] = []
        self._row = {name: k for k, name in enumerate(self.possible_agents)}
        self._random = np.random.default_rng()
        self._radius = max(4.0, ROOM * walkers / (2 * np.pi))

    @cache  # noqa: B019 (spaces must be the same objects each time; an environment lives as long as its spaces)
    def observation_space(self, agent: str) -> spaces.Box:
        """What a walker sees (`seen`)."""
        return spaces.Box(-FARTHEST, FARTHEST, (OWN + EACH * SEEN_OTHERS,), np.float32)

    @cache  # noqa: B019
    def action_space(self, agent: str) -> spaces.Box:
        """Its next footprint."""
        return spaces.Box(-1.0, 1.0, (3,), np.float32)

    def reset(self, seed: int | None = None, options: dict | None = None) -> tuple[dict, dict]:
        """All stand around a circle, each with a place to go to on its other side."""
        if seed is not None:
            self._random = np.random.default_rng(seed)
        self.agents, self._beat = list(self.possible_agents), 0
        count, half = len(self.agents), self._radius + 3.0
        angle = 2 * np.pi * (np.arange(count) + self._random.uniform(-0.1, 0.1, count)) / count
        around = self._radius * np.column_stack([np.cos(angle), np.sin(angle)])
        self.goals = half - around
        starts = np.column_stack([half + around, angle + np.pi])
        world = World("circle", (2 * half, 2 * half))
        one = int(self._random.integers(HIGHEST_SEED))
        self.sim = Simulation(world, [self.character] * count, PLANNERS["Acting"](starts), one)
        self._left = self._away()
        seen = self.seen()
        return {name: seen[self._row[name]] for name in self.agents}, {name: {} for name in self.agents}

    def _away(self) -> np.ndarray:
        """(N,) how far each is from where it goes [m]."""
        return np.hypot(*(self.goals - self.sim.com()[:, :2]).T)

    def _velocity(self) -> np.ndarray:
        """(N, 2) over the last tenth of a second [m/s]."""
        now = self.sim.time
        return (self.sim.com(now) - self.sim.com(max(now - 0.1, 0.0)))[:, :2] / 0.1

    def step(self, actions: dict[str, np.ndarray]) -> tuple[dict, dict, dict, dict, dict]:
        """A beat."""
        plans, now = self.sim.plans, self.agents
        for name in now:
            plans.action[self._row[name]] = np.nan_to_num(np.asarray(actions[name], np.float64)).clip(-1.0, 1.0)
        for _ in range(round(BEAT * self.sim.tick_rate)):
            self.sim.tick()
        self._beat += 1
        left, before = self._away(), self._left
        self._left = left
        there, over = left < THERE, self._beat >= self.beats
        plans.goes[there] = False
        reward = before - left - PER_BEAT - STANDING * self.sim.crowd.standing + ARRIVED * there
        self.agents = [] if over else [name for name in now if not there[self._row[name]]]
        seen = self.seen()

        def each(column: np.ndarray, kind: Any) -> dict:
            return {name: kind(column[self._row[name]]) for name in now}

        sights = {name: seen[self._row[name]] for name in now}
        return sights, each(reward, float), each(there, bool), each(over & ~there, bool), {name: {} for name in now}

    def seen(self) -> np.ndarray:
        """(N, OWN + EACH SEEN_OTHERS) float32, along the heading of each newer foot, mirrored where the right foot is next.

        Where it goes (up to FARTHEST m away), its com and velocity, the older foot; then of the nearest others, nearest
        first: 1 where there is one, place and velocity. Metres and metres per second.
        """
        feet, com, velocity = self.sim.feet(), self.sim.com()[:, :2], self._velocity()
        here, heading = feet.position[:, 1, :2], feet.heading[:, 1]
        mirror = np.where(feet.side[:, 1] == 0, -1.0, 1.0)

        def turned(way: np.ndarray) -> np.ndarray:
            c, s = np.cos(heading), np.sin(heading)
            shape = (-1, *(1,) * (way.ndim - 2))
            c, s, m = c.reshape(shape), s.reshape(shape), mirror.reshape(shape)
            return np.stack([way[..., 0] * c + way[..., 1] * s, m * (way[..., 1] * c - way[..., 0] * s)], axis=-1)

        own = [turned(one) for one in (self.goals - here, com - here, velocity, feet.position[:, 0, :2] - here)]
        apart = np.linalg.norm(com[:, None] - com[None], axis=2)
        np.fill_diagonal(apart, np.inf)
        nearest = np.argsort(apart, axis=1, kind="stable")[:, :SEEN_OTHERS]
        rows = np.arange(len(com))[:, None]
        known = (apart[rows, nearest] < OTHERS_AWAY)[..., None]
        others = np.concatenate([known, turned(com[nearest] - here[:, None]), turned(velocity[nearest])], axis=2) * known
        found = np.zeros((len(com), OWN + EACH * SEEN_OTHERS))
        found[:, :OWN] = np.concatenate(own, axis=1)
        found[:, OWN : OWN + EACH * nearest.shape[1]] = others.reshape(len(com), -1)
        return found.clip(-FARTHEST, FARTHEST).astype(np.float32)
