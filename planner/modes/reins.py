"""What characters that are driven are told: wishes that stay until others come."""

from math import pi
from typing import Any, NamedTuple

import numpy as np

from planner.stepping import random
from worlds.errors import InputError
from worlds.errors.wording import nearest

STAND, TURN, CREEP, WALK, RUN = range(5)
PACES = ("stand", "turn", "creep", "walk", "run")
"""In words, by their numbers; to turn is to turn on the spot, toward the direction."""
SPELL, KEYS = 75, 100
"""Ticks between keys by chance; the first purpose of their numbers (planner.stepping.random)."""


class Reins(NamedTuple):
    """What C characters are told."""

    direction: np.ndarray  # (C,) over the ground [rad]
    pace: np.ndarray  # (C,) a number of PACES
    aside: np.ndarray  # (C,) how far the direction lies to the left of where the feet are to point [rad]
    leap: np.ndarray  # (C,) bool: the next step is a leap
    last: np.ndarray  # (C,) how far the last step that was planned is to bring the middle [m]; 0: it stands


def no_reins(characters: int) -> Reins:
    c = characters
    return Reins(np.zeros(c), np.zeros(c, np.int64), np.zeros(c), np.zeros(c, np.bool_), np.zeros(c))


def told(plans: Reins, who: np.ndarray, direction: Any, pace: Any, aside: Any, leap: Any) -> Reins:
    """The reins of the characters `who` (K,) as they are wished; each wish one value, or K of them. Raises InputError."""
    wished = Reins(
        _angles(direction, "direction"), np.array([_pace_of(word) for word in pace], np.int64), _angles(aside, "aside"),
        np.array(leap, np.bool_), plans.last[who],
    )  # fmt: skip
    for name, values in wished._asdict().items():
        if values.shape not in ((1,), (len(who),)):
            raise InputError(f"steer: {len(values)} values of {name}, {len(who)} characters: one, or one each, is needed")
    return Reins(*(np.broadcast_to(values, (len(who),)) for values in wished))


def tell(plans: Reins, who: np.ndarray, wished: Reins) -> None:
    """Tells the characters `who` (K,) what was `told`; a leap that was wished before is not forgotten."""
    plans.direction[who], plans.pace[who], plans.aside[who] = wished.direction, wished.pace, wished.aside
    plans.leap[who] |= wished.leap


def differing(plans: Reins, who: np.ndarray, wished: Reins) -> np.ndarray:
    """(K,) bool: which of the characters `who` are to do something else than they were told before."""
    same = [getattr(plans, name)[who] == getattr(wished, name) for name in ("direction", "pace", "aside")]
    return ~np.logical_and.reduce(same) | wished.leap


def _pace_of(word: str) -> int:
    if word not in PACES:
        raise InputError(f"steer: pace = {word!r}: {', '.join(PACES)} are allowed{nearest(word, PACES)}")
    return PACES.index(word)


def _angles(values: Any, what: str) -> np.ndarray:
    """Angles [rad] within half a turn, the same directions."""
    angles = np.array(values, np.float64)
    if not np.isfinite(angles).all() or np.abs(angles).max(initial=0.0) > 1e6:
        raise InputError(f"steer: {what} = {values!r}: finite angles [rad], up to 1e6, are needed")
    return (angles + pi) % (2 * pi) - pi


def by_chance(seed: int, ticks: int, characters: int) -> Reins | None:
    """Keys pressed by chance, for everyone, after so many ticks; None where none is. The same at every call."""
    if ticks % SPELL:
        return None
    dice = np.array(
        [[random.uniform(seed, c, ticks // SPELL, KEYS + k) for k in range(4)] for c in range(characters)], np.float64
    )
    pace = np.searchsorted((0.06, 0.12, 0.25, 0.7), dice[:, 1]).astype(np.int64)
    aside = np.select([dice[:, 2] < 0.08, dice[:, 2] < 0.16, dice[:, 2] < 0.24], [0.5 * pi, -0.5 * pi, pi - 0.01], 0.0)
    return Reins(2 * pi * dice[:, 0] - pi, pace, aside, dice[:, 3] < 0.2, np.zeros(characters))
