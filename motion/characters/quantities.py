"""What a number of a character is: its unit, the range that is allowed, its meaning, and how it grows with the character."""

import math
from typing import Any, NamedTuple

import numpy as np

SCALES = (0.01, 100.0)
"""How much smaller and larger a character may be made."""


class Quantity(NamedTuple):
    """One number. In files angles are degrees, and their keys say so; kernels get radians."""

    unit: str  # m, rad, 1/s^2/m, or nothing
    low: float
    high: float
    meaning: str
    default: float | None = None  # where a file does not say it

    @property
    def key(self) -> str:
        """What the key in a file ends in."""
        return "_deg" if self.unit == "rad" else ""

    def from_file(self, value: float, scale: float) -> float:
        """The number for kernels, of a character that is `scale` times as large as its file says.

        Lengths grow by `scale`, times by its square root, so that speeds keep their Froude number and accelerations are
        what they were; the comfort weight, in 1/s^2/m, then falls with the square.
        """
        growth = {"m": 1, "1/s^2/m": -2}.get(self.unit, 0)
        return math.radians(value) if self.unit == "rad" else value * scale**growth if growth and scale != 1 else value

    def can_be(self, value: float) -> bool:
        """Whether kernels can have it: what a file allows, for a character of any `scale` that a file allows."""
        low, high = sorted((self.from_file(self.low, 1.0), self.from_file(self.high, 1.0)))
        if self.unit == "m":
            low, high = low * SCALES[1 if low < 0 else 0], high * SCALES[1]
        elif self.unit == "1/s^2/m":
            low, high = low * SCALES[1] ** -2, high * SCALES[0] ** -2
        return low <= value <= high


def metres(meaning: str, low: float = 1e-3, high: float = 100.0, default: float | None = None) -> Any:
    """A length [m]."""
    return Quantity("m", low, high, meaning, default)


def place(meaning: str) -> Any:
    """A coordinate [m] of either sign."""
    return Quantity("m", -100.0, 100.0, meaning)


def degrees(meaning: str, low: float = 0.0, high: float = 90.0, default: float | None = None) -> Any:
    """An angle: degrees in files, radians in kernels."""
    return Quantity("rad", low, high, meaning, default)


def share(meaning: str, low: float = 0.0, high: float = 1.0, default: float | None = None) -> Any:
    """A number without a unit."""
    return Quantity("", low, high, meaning, default)


def weight(meaning: str) -> Any:
    """A weight of the comfort cost [1/s^2/m]."""
    return Quantity("1/s^2/m", 1e-3, 1e6, meaning)


def quantities_of(table: type) -> dict[str, Quantity]:
    """The numbers of a table, in the order in which it declares them."""
    return {name: getattr(table, name) for name in table.__annotations__}


def dtype_of(table: type) -> np.dtype:
    """The record of a table for kernels."""
    return np.dtype([(name, np.float64) for name in quantities_of(table)])
