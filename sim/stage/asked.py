"""What a program may ask of a cast: checked once where it comes in, for kernels check nothing. Each raises InputError."""

from collections.abc import Sequence
from math import isfinite
from numbers import Integral, Real
from typing import Any

import numpy as np

from motion.characters.character import Character
from worlds.errors import InputError
from worlds.world import World

MOST_CHARACTERS = 200_000
"""A character takes 5 KB, and more while it is made."""
RATES = (10, 1000)
"""Ticks per second: fewer than that, and a tick is longer than a step."""
MOST_SEED = 2**63 - 1
AGES = 1e9
"""Nothing is asked for that is so far away in time [s]."""


def check_cast(world: Any, characters: Sequence[Character], seed: Any, tick_rate: Any) -> None:
    """Whether a cast can be made of these."""
    if not isinstance(world, World):
        raise InputError(f"world = {world!r}: a worlds.world.World is needed")
    if not 1 <= len(characters) <= MOST_CHARACTERS:
        raise InputError(f"{len(characters)} characters: 1 to {MOST_CHARACTERS} are allowed")
    for c, character in enumerate(characters):
        if not isinstance(character, Character):
            raise InputError(f"characters.{c} = {character!r}: a motion.characters.character.Character is needed")
    whole("seed", seed, 0, MOST_SEED)
    whole("tick_rate", tick_rate, *RATES)


def whole(what: str, value: Any, low: int, high: int) -> int:
    """A whole number in a range."""
    if not isinstance(value, Integral) or isinstance(value, bool) or not low <= int(value) <= high:
        raise InputError(f"{what} = {value!r}: a whole number from {low} to {high} is needed")
    return int(value)


def moment(time: Any) -> float:
    """A time [s]."""
    if not isinstance(time, Real) or isinstance(time, bool) or not isfinite(time) or abs(float(time)) > AGES:
        raise InputError(f"time = {time!r}: a finite number of seconds is needed")
    return float(time)


def rows_of(rows: Any, count: int) -> np.ndarray:
    """Numbers of characters, of whom there are `count`."""
    found = np.asarray(rows)
    if found.ndim == 1 and not found.size:
        return np.zeros(0, np.int64)
    if found.ndim != 1 or found.dtype.kind not in "iu":
        raise InputError(f"rows of type {found.dtype} and shape {found.shape}: an array (K,) of whole numbers is needed")
    wrong = found[(found < 0) | (found >= count)]
    if len(wrong):
        raise InputError(f"rows: {wrong[0]}; there are {count} characters, counted from 0")
    return np.ascontiguousarray(found, np.int64)


def check_places(side: Any, places: Any) -> np.ndarray:
    """Two places to stand on, (2, 3): x, y [m], heading [rad]; the second is of foot `side`."""
    found = np.ascontiguousarray(places, np.float64)
    if side not in (0, 1) or found.shape != (2, 3) or not np.isfinite(found).all() or np.abs(found).max() > 1e6:
        raise InputError(f"side = {side!r}, places of shape {found.shape}: 0 or 1, and (2, 3) finite numbers, are needed")
    return found
