"""Gravity, and the two numbers that dynamic similarity is made of (Alexander 1976)."""

from math import sqrt

from worlds.compiled.jit import jit_borrowing

GRAVITY = 9.81
"""m/s^2, along -z."""


@jit_borrowing
def pendulum_time(length: float) -> float:
    """sqrt(l / g) [s] of a length [m]: the unit of time of a leg."""
    return sqrt(length / GRAVITY)


@jit_borrowing
def froude_number(length: float, time: float, hip_height: float) -> float:
    """v^2 / (g h) of going `length` [m] in `time` [s] on legs of that hip height [m]: 0.5 is where people break into a run."""
    return (length / time) ** 2 / (GRAVITY * hip_height)
