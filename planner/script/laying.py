"""From given footprints to footprints as they are walked: laid on the ground, timed, swings lifted over what lies between."""

from math import isnan, nan, radians
from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from motion.track.footprints import SIDES, STEP, Footprints, Step, step_in
from planner.round.round import UNHURRIED, Wish
from planner.script.footprint import Footprint
from planner.stepping.arriving import STAND_TIME
from planner.stepping.placing import lay_swing
from planner.stepping.taking import speed_before, stand_at, take_step
from worlds.arrays import WorldArrays, no_world
from worlds.compiled.jit import jit
from worlds.compiled.tables import empty
from worlds.errors import InputError

SUPPORTS = {"roll": nan, "middle": 0.5, "toe": 1.0}
"""Where a standing foot presses: at one share of the sole throughout, heel to toe (paper, section 2.4), or NaN: it rolls."""
LEAST_SHARE = 0.2
"""Of its automatic time, which a step keeps that makes up for a given time of arrival; at most it is as many times as long."""
SHORTEST_SWING = 0.05
"""A foot must have left for this long [s] before it lands again."""


class Laid(NamedTuple):
    """Footprints to walk, and which of them each given one became."""

    footprints: Footprints  # (n,)
    row: np.ndarray  # (len(given),) row of each given footprint; the rows between stand on


def laid(
    given: list[Footprint], character: Character, world: WorldArrays | None = None, stand_before: float = 0.4,
    stand_after: float = 0.6, support: str = "roll", name: str = "track",
) -> Footprints:  # fmt: skip
    """Footprints to walk, from standing on the first two of those given to standing on the last two.

    The first two are stood on for `stand_before` [s], the last for `stand_after` at least; times that are not given follow from
    the distance stepped (paper, section 4.1). world: the ground, flat without one. Raises InputError, which says `name`, where
    feet cannot do that.
    """
    return lay(given, character, world, stand_before, stand_after, support, name).footprints


def lay(
    given: list[Footprint], character: Character, world: WorldArrays | None = None, stand_before: float = 0.4,
    stand_after: float = 0.6, support: str = "roll", name: str = "track",
) -> Laid:  # fmt: skip
    """As `laid`, and where in it the given footprints are."""
    steps, row = _steps(given, stand_before, name)
    footprints = empty(Footprints, len(steps) + 2)
    headings = _headings(given)
    first = np.array([(*given[i].position, headings[i]) for i in range(2)])
    ground = no_world() if world is None else world
    biped, side = character.biped, SIDES.index(given[1].side)
    paces = by_themselves(biped, ground, footprints, side, first, steps)
    lay_steps(biped, ground, footprints, side, first, steps, paces)
    if any(one.at is not None for one in given):
        _pin(steps, footprints, given, row, name)
        lay_steps(biped, ground, footprints, side, first, steps, paces)
    finish_steps(biped, ground, footprints, SUPPORTS[support], stand_after)
    _check(footprints, name)
    return Laid(footprints, row)


def _pin(steps: np.ndarray, footprints: Footprints, given: list[Footprint], row: np.ndarray, name: str) -> None:
    """Stretches or shortens the steps before each footprint that is to be there `at` a time, all by the same share.

    They are those since the footprint before it that has such a time, or since the beginning; a stance that is given goes with
    its step, the others keep their shares by themselves. Raises InputError where two such times leave no time between them.
    """
    before, since = 1, float(footprints.contact_time[1])
    for i, one in enumerate(given):
        if one.at is None or i < 2:
            continue
        n, now = int(row[i]), float(footprints.contact_time[row[i]])
        start = float(footprints.contact_time[before])
        share = (one.at - since) / max(now - start, 1e-9)
        if not LEAST_SHARE <= share <= 1 / LEAST_SHARE:
            raise InputError(
                f"{name}: footprint.{i}.at = {one.at:g} s: {one.at - since:.2f} s after the last time that is given, at "
                f"{since:.2f} s; the steps between take {now - start:.2f} s by themselves, and can be made "
                f"{1 / LEAST_SHARE:g} times as quick or slow; give a later or an earlier time"
            )
        for k in range(before, n):
            steps["time"][k - 1] = share * footprints.step_time[k]
            if not isnan(steps["stance_time"][k - 1]):
                steps["stance_time"][k - 1] *= share
        before, since = n, one.at


@jit
def lay_steps(
    biped: Dimensions, world: WorldArrays, footprints: Footprints, side: int, first: np.ndarray, steps: np.ndarray,
    paces: np.ndarray,
) -> None:  # fmt: skip
    """Fills footprints (K + 2,): two to stand on at `first` (2, 3), the second of foot `side`, and those of steps (K,).

    paces (K,): the speed [m/s] that the step before each is taken to have had, NaN: the one it had.
    """
    stand_at(biped, world, footprints, side, first, 0.0, 0.0)
    for k in range(2, len(footprints.side)):
        step = step_in(steps[k - 2])
        take_step(biped, world, footprints, k, Wish(step, step.heading, UNHURRIED, False, False), 0.0, paces[k - 2])


@jit
def by_themselves(
    biped: Dimensions, world: WorldArrays, footprints: Footprints, side: int, first: np.ndarray, steps: np.ndarray
) -> np.ndarray:
    """The speed (K,) [m/s] that the step before each would have if no times were given, NaN where none are; lays footprints.

    Whether a step is walked, run or leapt follows from it. Who gives one step another time means that step alone: if the times
    of the next ones followed from the given one, a dagger that is dragged would turn a run behind it into a walk at once.
    """
    free, paces, given = steps.copy(), np.full(len(steps), np.nan), False
    for k in range(len(steps)):
        given |= not (isnan(free[k].time) and isnan(free[k].stance_time))
        free[k].time = free[k].stance_time = np.nan
    if not given:
        return paces
    lay_steps(biped, world, footprints, side, first, free, paces)
    for k in range(len(steps)):
        paces[k] = speed_before(footprints, k + 2)
    return paces


@jit
def finish_steps(biped: Dimensions, world: WorldArrays, footprints: Footprints, support: float, rest: float) -> None:
    """Lets who has walked on the footprints stand on the last two, presses where `support` says, and lifts the swings."""
    n = len(footprints.side)
    stands = n - 1 if footprints.side[n - 1] == footprints.side[n - 2] else n - 2  # after a hop on one foot
    footprints.roll[stands:n, 1] = 0.5
    if not np.isnan(support):
        footprints.roll[2:n] = support
    end = footprints.contact_time[n - 1] + rest
    footprints.stance_time[stands:n] = end + STAND_TIME - footprints.contact_time[stands:n]
    for k in range(2, n):
        lay_swing(biped, world, footprints, k)


def _headings(given: list[Footprint]) -> np.ndarray:
    return np.unwrap(np.radians([footprint.heading_deg for footprint in given]))


def _steps(given: list[Footprint], stand_before: float, name: str) -> tuple[np.ndarray, np.ndarray]:
    """The steps (K,) STEP after the first two footprints: onto each one, or standing on; and the row that each given one
    becomes. Raises InputError."""
    if len(given) < 2:
        raise InputError(f"{name}: {len(given)} footprints; at least two are needed, to stand on")
    steps, headings, row = list[Step](), _headings(given), np.arange(len(given))
    if stand_before or len(given) == 2:
        steps += _standing(given, 1, given[2 % len(given)].side, stand_before or STAND_TIME, headings)
    for i in range(2, len(given)):
        before, footprint = given[i - 1], given[i]
        time, stance = (nan if t is None else t for t in (before.step_time, before.stance_time))
        side, facing = SIDES.index(footprint.side), radians(footprint.facing_deg)
        x, y = footprint.position
        row[i] = len(steps) + 2
        steps.append(Step(side, x, y, headings[i], time, stance, 0.0, footprint.crouch, facing))
        if footprint.stand:
            if before.side == footprint.side:
                raise InputError(f"{name}: footprint.{i}.stand: after a hop the other foot is in the air; add its footprint")
            following = given[i + 1].side if i + 1 < len(given) else before.side
            steps += _standing(given, i, following, footprint.stand, headings)
    return np.array(steps, STEP), row


def _standing(given: list[Footprint], i: int, following: str, seconds: float, headings: np.ndarray) -> list[Step]:
    """Standing on footprints i - 1 and i, in the order that lets foot `following` step next."""
    order = [i - 1] if given[i - 1].side != following else [i - 1, i]
    crouch, facing, each = given[i].crouch, radians(given[i].facing_deg), seconds / len(order)
    return [Step(SIDES.index(given[k].side), *given[k].position, headings[k], nan, nan, each, crouch, facing) for k in order]


def _check(footprints: Footprints, name: str) -> None:
    """A foot must leave before it lands again. Raises InputError."""
    last: dict[int, int] = {}
    for n, side in enumerate(footprints.side.tolist()):
        moved = side in last and np.abs(footprints.position[n] - footprints.position[last[side]]).max() > 1e-9
        left = footprints.contact_time[last[side]] + footprints.stance_time[last[side]] if moved else -np.inf
        if left > footprints.contact_time[n] - SHORTEST_SWING:
            x, y, _ = footprints.position[n]
            raise InputError(
                f"{name}: the {SIDES[side]} foot lands on ({x:.2f}, {y:.2f}) at "
                f"{footprints.contact_time[n]:.2f} s but has left its last footprint only at {left:.2f} s; a swing takes "
                f"{SHORTEST_SWING:g} s at least: give that footprint a shorter stance_time, or the steps between longer "
                "step_times"
            )
        last[side] = n
