"""What of a scene cannot be walked, and what will be ugly: each footprint by its number, with the value and what is allowed."""

import logging
from collections.abc import Iterator
from math import hypot
from typing import NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from planner.script.footprint import Footprint
from planner.stepping.footing import BORDER, FINE, TREE, WATER, WORDS, under_sole, why_not_stand
from worlds.arrays import WorldArrays
from worlds.errors import InputError

LONG, BEYOND = 1.01, 1.05
"""Shares of the longest leap beyond which one is ugly, and cannot be taken: legs would stretch."""
CLIMB, NEAR_LIMIT = 1.2, 0.9
"""Shares of the highest and deepest step beyond which one cannot be taken, and from which it is ugly."""
SHARP = 1.3
"""Share of the sharpest turn of a step beyond which it is ugly."""
ON_FOOT = 0.5
"""Feet this near to each other, in step widths or widths of the sole, whichever is less, stand on each other."""
SAID = 8
"""So many faults are told one by one."""
LOG = logging.getLogger("footfall")


class Finding(NamedTuple):
    """Something about a footprint."""

    wrong: bool  # it cannot be walked; else it will be ugly
    said: str


def review(given: list[Footprint], character: Character, world: WorldArrays, name: str) -> list[str]:
    """What will be ugly, logged and returned. Raises InputError, which says `name`, for what cannot be walked."""
    headings = np.unwrap(np.radians([footprint.heading_deg for footprint in given]))
    found = [finding for i in range(len(given)) for finding in _of_footprint(given, headings, i, character, world)]
    wrong, ugly = ([one.said for one in found if one.wrong is kind] for kind in (True, False))
    if wrong:
        raise InputError("\n".join(f"{name}: {said}" for said in _shortened(wrong)))
    return warned(ugly, name)


def warned(ugly: list[str], name: str) -> list[str]:
    """What will be ugly, once it is logged."""
    for said in _shortened(ugly):
        LOG.warning("%s: warning: %s", name, said)
    return ugly


def _shortened(said: list[str]) -> list[str]:
    return said if len(said) <= SAID else [*said[:SAID], f"and {len(said) - SAID} more like these"]


def _of_footprint(
    given: list[Footprint], headings: np.ndarray, i: int, character: Character, world: WorldArrays
) -> Iterator[Finding]:
    x, y = given[i].position
    said = f"footprint.{i} at ({x:.2f}, {y:.2f})"
    why = why_not_stand(character.biped, world, x, y, float(headings[i]))
    if why != FINE:
        yield Finding(why in (TREE, WATER, BORDER), f"{said}: {WORDS[why]}")
    if i:
        yield from _of_step(given, headings, i, character, said)
        yield from _of_rise(given, headings, i, character, world, said)


def _of_step(given: list[Footprint], headings: np.ndarray, i: int, character: Character, said: str) -> Iterator[Finding]:
    """Of the step from the footprint before: too far, too sharp, onto the other foot."""
    biped, name, (x, y), (u, v) = character.biped, character.name, given[i].position, given[i - 1].position
    length, most, turn = hypot(x - u, y - v), float(biped.reach.max_leap), abs(float(headings[i] - headings[i - 1]))
    if length > LONG * most:
        far = f"{length:.2f} m from the one before"
        yield Finding(length > BEYOND * most, f"{said}: {far}; the {name} leaps {most:.2f} m at most")
    if given[i].side != given[i - 1].side and length < _on_foot(biped):
        yield Finding(True, f"{said}: is on the other foot, {length:.2f} m from it; {_on_foot(biped):.2f} m or more is allowed")
    if turn > SHARP * biped.reach.max_turn and i > 1:
        degrees, allowed = np.degrees([turn, biped.reach.max_turn])
        yield Finding(False, f"{said}: turns by {degrees:.0f} degrees; the {name} turns by {allowed:.0f} in a step")


def _on_foot(biped: Dimensions) -> float:
    return ON_FOOT * float(min(biped.gait.step_width, biped.foot.width))


def _of_rise(
    given: list[Footprint], headings: np.ndarray, i: int, character: Character, world: WorldArrays, said: str
) -> Iterator[Finding]:
    """Of the height between it and the footprint before."""
    biped = character.biped
    low, high = (under_sole(biped, world, *given[k].position, float(headings[k]))[0] for k in (i - 1, i))
    rise, up = high - low, high > low
    most = float(biped.reach.max_rise if up else biped.reach.max_drop)
    if abs(rise) > NEAR_LIMIT * most:
        step = f"a step {'up' if up else 'down'} of {abs(rise):.2f} m"
        yield Finding(abs(rise) > CLIMB * most, f"{said}: {step}; the {character.name} takes {most:.2f} m at most")
