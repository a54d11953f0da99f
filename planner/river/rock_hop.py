"""The planner of river crossers: a route for everyone, found once and again whenever the world or goal changes."""

from typing import Any, NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.track.footprints import STEP, Step, step_in
from planner.planner import STAND_TIME, Situation
from planner.river.route import route
from planner.round.kernel import Compiled
from planner.round.round import UNHURRIED, Me, Round, Wish, standing
from worlds.errors import InputError
from worlds.world import World

MOST = 500
"""Who starts in one place plans after all the others there: the time for it grows with the square of their number."""


class Routes(NamedTuple):
    """The routes of C characters."""

    begin: np.ndarray  # (C,) number of the step that is the route's first
    length: np.ndarray  # (C,)
    steps: Any  # (C, R) records of STEP


def _next_step(round: Round, me: Me) -> Wish:
    """The route's next step; before it and after it, standing."""
    plans, k = round.plans, me.number - round.plans.begin[me.c]
    if k < 0 or k >= plans.length[me.c]:
        return standing(me, STAND_TIME)
    step = step_in(plans.steps[me.c, k])
    return Wish(step, step.heading, UNHURRIED, False, False)


def _empty_routes(characters: int, steps: int) -> Routes:
    return Routes(np.zeros(characters, np.int64), np.zeros(characters, np.int64), np.zeros((characters, steps), STEP))


_PLANNING = Compiled(_next_step, _empty_routes(1, 1))


class RockHop:
    """Everyone crosses to the world's goal, on its rocks where there is water."""

    name = "RockHop"
    planning = _PLANNING

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading: all at the world's start. Raises InputError for too many."""
        if len(characters) > MOST:
            raise InputError(f"{len(characters)} characters: at most {MOST} cross from one start")
        return np.array([(*world.start, world.start_heading)] * len(characters), np.float64)

    def prepare(self, situation: Situation) -> Routes:
        """A route for each. Raises NoWay."""
        feet, characters = situation.feet, situation.characters
        alike: dict[tuple, list[Step]] = {}  # those who are alike, and stand in one place, go one way
        found = []
        for c, character in enumerate(characters):
            mine = type(feet)(*(column[c] for column in feet))
            key = (id(character.biped), *(column.tobytes() for column in (mine.side, mine.position, mine.heading, mine.rock)))
            if key not in alike:
                alike[key] = route(situation.world, character, mine)
            found.append(alike[key])
        plans = _empty_routes(len(characters), max(len(steps) for steps in found))
        for c, steps in enumerate(found):
            plans.steps[c, : len(steps)] = np.array(steps, STEP)
            plans.length[c], plans.begin[c] = len(steps), situation.number[c]
        return plans

    def check_plans(self, plans: Routes, characters: int) -> None:
        """Whether plans from a file are routes: rounds check their steps, one by one. Raises ValueError."""
        if not (0 <= plans.length.min() <= plans.length.max() <= plans.steps.shape[1] and plans.begin.min() >= 0):
            raise ValueError("plans: routes longer than their steps")
        if plans.begin.max() > 2**53:
            raise ValueError("plans: routes that never begin")

    def values(self) -> dict:
        """It is made of nothing."""
        return {}
