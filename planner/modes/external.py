"""Footprints fed by a program: the seam for games, learning and editors.

A program hands steps over, for one character or many, whenever it likes (sim.stage.commands.Give); they are taken in their
order, to the letter. Who has none left stands; while the body is still on its way to the last one, the window expects it to go
on as it went.
"""

from math import isfinite
from typing import Any, NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import SIDES, STEP, Step, step_in
from planner.planner import Situation, as_numbers
from planner.round.kernel import Compiled
from planner.round.round import UNHURRIED, Me, Round, Wish, biped_of, standing
from planner.stepping.going_on import going_on
from worlds.compiled.jit import jit_borrowing
from worlds.errors import InputError
from worlds.world import World

ROOM = 64
"""Steps that a character can be given ahead."""
WAIT = 0.1
"""Who has no step to take looks for one again after this time [s]."""
LONGEST = 60.0
"""No step or stance is asked for that is longer than this [s]."""


class Queues(NamedTuple):
    """What C characters have been given."""

    first: np.ndarray  # (C,) number of the step in the first place
    given: np.ndarray  # (C,) how many there are
    steps: Any  # (C, ROOM) records of STEP


@jit_borrowing
def _onward(round: Round, me: Me) -> Wish:
    """A guess: it goes on as it went."""
    step = going_on(biped_of(round, me), me.feet)
    return Wish(step, step.heading, UNHURRIED, False, False)


def _next_step(round: Round, me: Me) -> Wish:
    """The next of those that were given."""
    plans, k = round.plans, me.number - round.plans.first[me.c]
    if 0 <= k < plans.given[me.c]:
        step = step_in(plans.steps[me.c, k])
        return Wish(step, step.heading, UNHURRIED, False, False)
    if me.real or me.feet.newer.side == me.feet.older.side:
        return standing(me, WAIT)
    return _onward(round, me)


def _empty_queues(characters: int) -> Queues:
    return Queues(np.zeros(characters, np.int64), np.zeros(characters, np.int64), np.zeros((characters, ROOM), STEP))


_PLANNING = Compiled(_next_step, _empty_queues(1))


class External:
    """Characters that take the steps they are given. starts (C, 3): x, y, heading [m, rad] where they stand at first."""

    name = "External"
    lays_soles = True
    planning = _PLANNING

    def __init__(self, starts: object) -> None:
        self.places = as_numbers(starts, "starts")
        if self.places.ndim != 2 or self.places.shape[1] != 3 or not np.isfinite(self.places).all():
            raise InputError(f"starts of shape {self.places.shape}: (C, 3), finite numbers x, y, heading, are needed")

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading."""
        return self.places

    def prepare(self, situation: Situation) -> Queues:
        """What was given stays given, whatever the world."""
        return _empty_queues(len(situation.characters)) if situation.before is None else situation.before

    def values(self) -> dict:
        """What it was made with."""
        return {"starts": self.places.tolist()}

    def check_plans(self, plans: Queues, characters: int) -> None:
        """Whether plans from a file are queues: rounds check their steps, one by one. Raises ValueError."""
        given = plans.given
        if plans.steps.shape != (characters, ROOM) or not (0 <= given.min() <= given.max() <= ROOM):
            raise ValueError(f"plans: at most {ROOM} steps are given ahead")
        if not 0 <= plans.first.min() <= plans.first.max() <= 2**53:
            raise ValueError("plans: steps that never begin")

    def left(self, plans: Queues, planned: np.ndarray) -> np.ndarray:
        """(C,) steps given that are not taken yet; planned (C,): the number of each one's newest footprint."""
        return np.maximum(plans.first + plans.given - (planned + 1), 0)

    def give(self, plans: Queues, c: int, steps: list[Step], number: int, world: World) -> None:
        """Adds steps for character c behind those that it has; `number`: of the step that it plans next.

        Raises InputError for steps that cannot be taken, or too many; then none is added.
        """
        if plans.first[c] + plans.given[c] > number:
            taken = max(number - int(plans.first[c]), 0)
            ahead = plans.steps[c, taken : plans.given[c]].copy()
        else:
            ahead = np.zeros(0, STEP)
        if len(ahead) + len(steps) > ROOM:
            raise InputError(f"{len(steps)} steps: character {c} has {len(ahead)} to take; {ROOM} in all is the most")
        for k, step in enumerate(steps):
            _check(step, k, world)
        rows = np.concatenate([ahead, np.array(steps, STEP)])
        plans.first[c], plans.given[c] = number, len(rows)
        plans.steps[c, : len(rows)] = rows


def _check(step: Step, k: int, world: World) -> None:
    """Raises InputError where a step is not one."""
    if not isinstance(step, Step):
        raise InputError(f"steps.{k} = {step!r}: a motion.track.footprints.Step is needed")
    if step.side not in (0, 1):
        raise InputError(f"steps.{k}.side = {step.side!r}: 0 ({SIDES[0]}) or 1 ({SIDES[1]}) is allowed")
    place = (step.x, step.y, step.heading)
    if not all(isinstance(value, (int, float, np.number)) and isfinite(value) for value in place):
        raise InputError(f"steps.{k} = {place}: x, y [m] and heading [rad] must be finite numbers")
    if not (0 <= step.x <= world.size[0] and 0 <= step.y <= world.size[1]):
        allowed = f"0..{world.size[0]:g} by 0..{world.size[1]:g} is allowed"
        raise InputError(f"steps.{k} at ({step.x:g}, {step.y:g}): is outside the world; {allowed}")
    for name in ("time", "stance_time"):
        value = getattr(step, name)
        if not (np.isnan(value) or 0 < value <= LONGEST):
            raise InputError(f"steps.{k}.{name} = {value!r}: more than 0, at most {LONGEST:g} s, or NaN: automatic")
    if not (0 <= step.stands <= LONGEST and 0.5 <= step.crouch <= 1.05 and isfinite(step.facing)):
        raise InputError(f"steps.{k}: stands 0 to {LONGEST:g} s, crouch 0.5 to 1.05 and a finite facing are allowed")
