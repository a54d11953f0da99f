"""Wishes that no body can do: kernels index memory by what planners answer, so nothing else may reach them.

Who wished such a thing stands; the tick then raises what was refused (ValueError), for the person who wrote the planner.
"""

from math import isfinite, isnan
from typing import Any

import numpy as np

from motion.track.footprints import STEP, Step, step_in
from planner.round.round import Wish
from worlds.compiled.jit import jit_borrowing

LONGEST = 3600.0
"""No step or stance is wished for that is longer than this [s]."""
TURNED = 1e6
"""Nobody has turned further than this [rad]: a heading beyond it is a mistake."""
BEYOND = 100.0
"""Footprints may lie so far beyond the border [m], where the ground goes on: keeping inside is the planner's own affair."""
LOWEST, HIGHEST = 0.5, 1.05
"""Crouching, and stretching, as shares of the nominal leg."""
NO_ANSWER = Wish(Step(-1, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0), 0.0, 0.0, False, False)
"""What stands where a planner writes its wish, before it does."""


def nothing_refused(characters: int) -> np.ndarray:
    """(C,) records of STEP, all zero: nothing was refused to anyone."""
    return np.zeros(characters, STEP)


@jit_borrowing
def can_be(wish: Wish, bounds: np.ndarray) -> bool:
    """Whether kernels can take a wish: finite numbers, a place in the world or near it, times that pass."""
    step, x, y = wish.step, wish.step.x, wish.step.y
    near = -BEYOND <= x - bounds[0] <= bounds[2] + BEYOND and -BEYOND <= y - bounds[1] <= bounds[3] + BEYOND
    placed = 0 <= step.side <= 1 and near
    turned = abs(step.heading) < TURNED and abs(step.facing) < TURNED and isfinite(wish.course)
    timed = (isnan(step.time) or 0 < step.time <= LONGEST) and (isnan(step.stance_time) or 0 < step.stance_time <= LONGEST)
    held = 0 <= step.stands <= LONGEST and LOWEST <= step.crouch <= HIGHEST
    return placed and turned and timed and held and 0 < wish.longest <= LONGEST


@jit_borrowing
def refuse(record: Any, step: Step) -> None:
    """Keeps a step that was refused, unless one is kept already."""
    if record.stands == 0 and record.crouch == 0:
        record.side, record.x, record.y, record.heading = step.side, step.x, step.y, step.heading
        record.time, record.stance_time, record.stands = step.time, step.stance_time, step.stands
        record.crouch, record.facing = step.crouch if step.crouch != 0 else -1.0, step.facing


def raise_refused(refused: np.ndarray, planner: str, bounds: np.ndarray) -> None:
    """Raises ValueError for the first step that was refused (and forgets all): who wished it, and what is allowed."""
    who = np.flatnonzero((refused["stands"] != 0) | (refused["crouch"] != 0))
    if not len(who):
        return
    c, step = int(who[0]), step_in(refused[who[0]])
    refused[:] = 0
    if step.side == NO_ANSWER.step.side and step.stands == NO_ANSWER.step.stands:
        raise ValueError(f"planner {planner}: next_step gave no answer for character {c}; compiled code raised something in it")
    allowed = (
        f"side 0 or 1, x and y in 0..{bounds[2]:g} by 0..{bounds[3]:g}, give or take {BEYOND:g} m, finite headings, times "
        f"above 0 or NaN, stands of 0 or more, crouch {LOWEST:g} to {HIGHEST:g}, a finite course, a longest step time above 0"
    )
    raise ValueError(f"planner {planner}: character {c} cannot do {step}; allowed are {allowed}")
