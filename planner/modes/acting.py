"""Walkers whose next footprint is an action of somebody who learns: a wish, of which what is free of the others is taken."""

from math import hypot
from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from planner.planner import Situation, as_numbers
from planner.round.kernel import Compiled
from planner.round.round import UNHURRIED, Me, Round, Wish, biped_of, standing
from planner.stepping.beside import middle_beside, middle_of
from planner.stepping.going_on import acted, going_on
from worlds.compiled.jit import jit_borrowing
from worlds.world import World

AHEAD, REACH = 0.35, 0.45
"""A step goes so far ahead [m], and so much less or more, of a human: from a little backward to a long one."""
WAIT = 0.25
"""Who wishes to go less than LEAST [m] stands for so long [s]."""
LEAST = 0.06


class Actions(NamedTuple):
    """What C walkers wish."""

    action: np.ndarray  # (C, 3) each -1 to 1 (planner.stepping.going_on)
    goes: np.ndarray  # (C,) bool: who does not stands where it is


@jit_borrowing
def _next_step(round: Round, me: Me) -> Wish:
    """The step of the action; the window expects one to go on as one went."""
    biped, foot, plans = biped_of(round, me), me.feet.newer, round.plans
    if not plans.goes[me.c]:
        return standing(me, WAIT)
    if not me.real:
        if foot.side == me.feet.older.side:
            return standing(me, WAIT)
        on = going_on(biped, me.feet)
        return Wish(on, on.heading, UNHURRIED, False, False)
    step = acted(biped, foot, plans.action[me.c], AHEAD, REACH)
    (x, y), (u, v) = middle_of(biped, step.side, (step.x, step.y), step.heading), middle_beside(biped, foot)
    if hypot(x - u, y - v) < LEAST * biped.leg.nominal_length / 0.9 and abs(step.heading - foot.heading) < 0.1:
        return standing(me, WAIT)
    return Wish(step, step.heading, UNHURRIED, True, True)


def _no_actions(characters: int) -> Actions:
    return Actions(np.zeros((characters, 3)), np.ones(characters, np.bool_))


class Acting:
    """Everyone steps by the actions that lie in its plans; starts (C, 3): x, y, heading [m, rad] where they stand at first."""

    name = "Acting"
    planning = Compiled(_next_step, _no_actions(1))

    def __init__(self, starts: object) -> None:
        self.places = as_numbers(starts, "starts")

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading."""
        return self.places

    def prepare(self, situation: Situation) -> Actions:
        """Actions stay, whatever the world."""
        return _no_actions(len(situation.characters)) if situation.before is None else situation.before

    def values(self) -> dict:
        """What it was made with."""
        return {"starts": self.places.tolist()}

    def check_plans(self, plans: Actions, characters: int) -> None:
        """Whether plans from a file are actions. Raises ValueError."""
        if plans.action.shape != (characters, 3) or not np.abs(plans.action).max(initial=0.0) <= 1.0:
            raise ValueError("plans: actions are from -1 to 1, three for each")
