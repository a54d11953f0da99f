"""The round: all that one tick's planning works on; what one who plans knows of itself; and what it wishes to do."""

from typing import Any, NamedTuple

import numpy as np

from motion.characters.dimensions import Dimensions
from motion.track.footprints import Feet, Step, stand_for, step_onto
from planner.round.reservations import Intents, Reservations
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit_borrowing

UNHURRIED = 2.2
"""Longest step time of a walk, in pendulum times of the hip's height: longer is dawdling."""

PATIENT = 8
"""Up to so many steps that others hindered make one more impatient, and more content."""


class Round(NamedTuple):
    """C characters in a world; nothing but the plans and intents of the one who plans may be written."""

    kind: np.ndarray  # (C,) which of the bipeds each character is
    bipeds: Any  # recarray of Dimensions
    world: WorldArrays
    plans: Any  # what the planner has prepared, of its own type
    reservations: Reservations  # what all show to the others
    intents: Intents
    seed: int
    weights: Any  # (kinds,) records of planner.round.weights: what a step among others costs


class Me(NamedTuple):
    """Who plans a step."""

    c: int  # its row
    number: int  # of the step: how many footprints were placed before
    real: bool  # false: a tentative one, of which nothing may be remembered
    hindered: int  # how many of its latest steps others kept from getting on
    feet: Feet


class Wish(NamedTuple):
    """What a planner wants next."""

    step: Step
    course: float  # where it goes on to, which it may not reach at once [rad]
    longest: float = UNHURRIED  # step time of a walk, in pendulum times
    avoids: bool = False  # others are in its way: another step near it will do
    goes: bool = False  # somewhere: it may claim a right of way


@jit_borrowing
def biped_of(round: Round, me: Me) -> Dimensions:
    """The dimensions of the one who plans."""
    return round.bipeds[round.kind[me.c]]


@jit_borrowing
def standing(me: Me, seconds: float) -> Wish:
    """To stand on for so long [s]: the older foot stays where it is."""
    foot = me.feet.older
    return Wish(stand_for(foot, seconds), foot.heading, UNHURRIED, False, False)


@jit_borrowing
def stepping(side: int, place: tuple[float, float], heading: float, course: float, goes: bool) -> Wish:
    """To set a foot down at a place [m], going around others."""
    return Wish(step_onto(side, place[0], place[1], heading), course, UNHURRIED, True, goes)
