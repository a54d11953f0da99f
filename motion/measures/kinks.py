"""Kinks: how far a velocity just after a moment differs from the one just before it.

A pose is a function of time, so both one-sided derivatives can be asked for. With x_k = x(t + k h) the parabolas through three
moments on either side have there the slopes

    x'(t-) = (x_-1 - 1.5 x_-3 + 0.5 x_-5) / h,    x'(t+) = -(x_1 - 1.5 x_3 + 0.5 x_5) / h

exact for accelerations that are constant on either side, with an error of about 5 h^2 times the third derivative. Central
differences of frames would call a strong acceleration a jump, and miss a jump that lies within a frame.
"""

import numpy as np

STEPS = (-5, -3, -1, 1, 3, 5)
"""At which multiples of `APART` around a moment values are needed."""
APART = 2e-5
"""h [s]: a third derivative of 1e5 m/s^3 then counts for 0.2 mm/s, and rounding of 1e-14 m for less."""
_BEFORE, _AFTER = np.array([0.5, -1.5, 1.0]), np.array([-1.0, 1.5, -0.5])


def kinks(values: np.ndarray) -> np.ndarray:
    """x'(t+) - x'(t-) (...) of values (6, ...) at the STEPS around a moment; metres make m/s, radians rad/s."""
    before = np.tensordot(_BEFORE, values[:3], axes=1)
    return (np.tensordot(_AFTER, values[3:], axes=1) - before) / APART
