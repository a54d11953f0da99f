"""Stepping stones as a world to learn in, for any number of rows at once; numpy alone.

A row's character stands on a stone and sees the next two; an action is where, whither and how quickly it steps
(sim.rows.stones). A footprint beside the stone ends the episode, and so does a step that tears the body apart. Reward:
progress, less the cost E of physics and comfort over the window of the step; whoever misses pays for how far.
"""

from typing import Any, NamedTuple

import numpy as np

from motion.characters.character import Character, load_character
from motion.characters.dimensions import empty_bipeds
from motion.com.newton import Effort
from planner.round.kernel import A_ROUND
from planner.round.refusals import nothing_refused
from sim.rows import rounds
from sim.rows.crowd import empty_crowd
from sim.rows.posing import THREADS
from sim.rows.stone_sight import SEEN, observe_rows
from sim.rows.stone_windows import optimise_stones
from sim.rows.stones import ACTIONS, GROUND, begin_rows, ground_of, step_rows
from sim.stage.asked import MOST_SEED, whole
from worlds.compiled.memory import Held
from worlds.errors import InputError

STEPS = 50
"""Steps of an episode."""
COST, MOST_COST = 0.1, 40.0
"""What a unit of E takes off the reward, and the E from which a body falls."""
FALL = 1.0
"""What a fall takes off."""
HARDER, EASIER = 0.1, 0.05
"""A curriculum: how much harder stones are after an episode that was finished, and easier after one that was not half done."""
MOST_ROWS = 100_000
EFFORT = Effort(1, 0.1, 0.1, 16, 1e-2, 20.0)
"""Of the window solve: stones make every window costlier than a walk, so only falls get more of it."""
FARTHEST = 50.0
"""No number that is seen is larger, either way."""


class Stepped(NamedTuple):
    """What a step has come to, of N rows."""

    seen: np.ndarray  # (N, SEEN) float32
    reward: np.ndarray  # (N,)
    fell: np.ndarray  # (N,) bool
    finished: np.ndarray  # (N,) bool: all the steps of an episode are done


class SteppingStones:
    """N rows of stones, each with a character.

    level: 0 (near, straight on, level, large) to 1 (as ALLSTEPS); with `curriculum`, each row begins there and finds its own.
    """

    def __init__(
        self, rows: int, character: str | Character = "human", level: float = 0.0, curriculum: bool = False, steps: int = STEPS
    ) -> None:
        """Raises InputError."""
        whole("rows", rows, 1, MOST_ROWS)
        self.steps = whole("steps", steps, 1, 100_000)
        if not isinstance(level, int | float) or not 0 <= level <= 1:
            raise InputError(f"level = {level!r}: a number from 0 to 1 is needed")
        self.character = load_character(character) if isinstance(character, str) else character
        self.rows, self.curriculum, self.first_level = rows, curriculum, float(level)
        """At which level all rows begin."""
        self._optimise = optimise_stones.address
        bipeds, self.crowd = empty_bipeds(1), empty_crowd(np.zeros(rows, np.int64))
        bipeds[0] = self.character.biped
        around = A_ROUND._replace(kind=self.crowd.kind, bipeds=bipeds, intents=self.crowd.intents)
        self._work = Held(rounds.Work(self.crowd, around, 0, 0, True, 0, nothing_refused(rows), EFFORT), rounds.WORK)
        self._ground = Held(ground_of(rows), GROUND)
        self.taken = np.zeros(rows, np.int64)
        """How many steps of its episode each row has taken."""
        self._seen = np.zeros((rows, SEEN))

    @property
    def level(self) -> np.ndarray:
        """(N,) how hard the stones of each row are."""
        return self._ground.value.stones.level

    def reset(self, seeds: np.ndarray) -> np.ndarray:
        """Every row begins anew, by its seed (N,) and at the first level; returns what is seen (N, SEEN)."""
        stones = self._ground.value.stones
        stones.seed[:] = np.asarray(seeds, np.int64) & MOST_SEED
        stones.laid[:], stones.level[:] = 0, self.first_level
        return self.begin(np.arange(self.rows))

    def begin(self, rows: np.ndarray) -> np.ndarray:
        """The rows (K,) stand on new stones, others go on; returns what is seen (N, SEEN)."""
        self.taken[rows] = 0
        begin_rows(self._work.address, self._ground.address, np.ascontiguousarray(rows, np.int64))
        return self.seen()

    def seen(self) -> np.ndarray:
        """(N, SEEN) float32: what each character sees (sim.rows.stone_sight.observe_rows)."""
        observe_rows(self._work.address, self._ground.address, self._seen)
        return self._seen.clip(-FARTHEST, FARTHEST).astype(np.float32)

    def step(self, actions: Any, rows: np.ndarray | None = None) -> Stepped:
        """The rows (K,), by default all, take a step by actions (N, ACTIONS), cut to -1 to 1."""
        wanted, ground = np.asarray(actions, np.float64), self._ground.value
        if wanted.shape != (self.rows, ACTIONS):
            raise InputError(f"actions of shape {wanted.shape}: ({self.rows}, {ACTIONS}) is needed")
        ground.actions[:] = np.nan_to_num(wanted).clip(-1.0, 1.0)
        some = np.arange(self.rows) if rows is None else np.ascontiguousarray(rows, np.int64)
        with THREADS:
            step_rows(self._optimise, self._work.address, self._ground.address, some)
        self.taken[some] += 1
        return self._stepped(some)

    def _stepped(self, some: np.ndarray) -> Stepped:
        progress, cost, miss = (column[some] for column in self._ground.value.outcome)
        stepped = Stepped(self.seen(), np.zeros(self.rows), np.zeros(self.rows, bool), np.zeros(self.rows, bool))
        falls = (miss > 0) | ~(cost < MOST_COST)
        stepped.fell[some], stepped.finished[some] = falls, ~falls & (self.taken[some] >= self.steps)
        worth = progress - COST * np.minimum(np.nan_to_num(cost, nan=MOST_COST), MOST_COST)
        stepped.reward[some] = worth - falls * (FALL + np.minimum(miss, FALL))
        if self.curriculum:
            self._learn(stepped)
        return stepped

    def _learn(self, stepped: Stepped) -> None:
        """Stones that come next are harder for those who have finished, easier for those who fell early."""
        early = stepped.fell & (self.taken < 0.5 * self.steps)
        self.level[:] = (self.level + HARDER * stepped.finished - EASIER * early).clip(0.0, 1.0)
