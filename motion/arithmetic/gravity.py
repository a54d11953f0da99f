"""Gravity, and the two numbers that dynamic similarity is made of (Alexander 1976)."""

from worlds.compiled.jit import jit_borrowing
from worlds.compiled.lanes import Some, root

GRAVITY = 9.81
"""m/s^2, along -z."""


@jit_borrowing
def pendulum_time(length: Some) -> Some:
    """sqrt(l / g) [s] of a length [m]: the unit of time of a leg."""
    return root(length / GRAVITY)


@jit_borrowing
def froude_number(length: float, time: float, hip_height: float) -> float:
    """v^2 / (g h) of going `length` [m] in `time` [s] on legs of that hip height [m]: 0.5 is where people break into a run."""
    return (length / time) ** 2 / (GRAVITY * hip_height)
