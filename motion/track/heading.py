"""Body heading: a function of the footprints alone (paper, section 2.5).

The mean heading of footprints i and i + 1, each with its `facing` (how far the body turns away from it), holds at contact
i; between contacts it goes linearly. That broken line runs half a step ahead of the body, and a box average over the last
WINDOW seconds takes the lead back and rounds the corners:

    heading(t) = 1/W integral over [t - W, t] of line(tau) dtau

so the heading at t needs no footprint beyond the next, and never changes when later ones arrive.
"""

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from motion.characters.dimensions import Dimensions
from motion.track.footprints import Footprints
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.tables import newest

WINDOW_STEPS = 1.0
"""Length of the average in nominal step times sqrt(l / g) * 1.6: longer is calmer, but lags in a turn."""


@jit_borrowing
def window_length(biped: Dimensions) -> float:
    """Seconds of the moving average, from the pendulum time of the character's leg."""
    return WINDOW_STEPS * 1.6 * pendulum_time(biped.leg.nominal_length)


@jit_borrowing
def _value(footprints: Footprints, i: int) -> float:
    j = min(i + 1, len(footprints.side) - 1)
    return 0.5 * (footprints.heading[i] + footprints.facing[i] + footprints.heading[j] + footprints.facing[j])


@jit_borrowing
def body_heading(biped: Dimensions, footprints: Footprints, t: float) -> float:
    """Heading of the body [rad] at time t [s], unwrapped."""
    return mean_heading(footprints, t, window_length(biped))


@jit_borrowing
def mean_heading(footprints: Footprints, t: float, window: float) -> float:
    """Mean of the broken line over the last `window` [s] before t [rad].

    Sums the pieces of the line that lie in the window, the latest first: only footprints near t enter, so that forgetting
    old ones changes no bit.
    """
    begin, upper, total = t - window, t, 0.0
    last = max(newest(footprints.contact_time, t), 0)
    for i in range(last, -1, -1):
        lower = max(footprints.contact_time[i], begin)
        if lower < upper:
            total += (upper - lower) * _line(footprints, i, 0.5 * (upper + lower))
            upper = lower
        if upper <= begin:
            break
    if upper > begin:
        total += (upper - begin) * _value(footprints, 0)
    return total / window


@jit_borrowing
def _line(footprints: Footprints, i: int, t: float) -> float:
    """The broken line at t >= contact i, before contact i + 1."""
    if i + 1 >= len(footprints.side):
        return _value(footprints, i)
    span = footprints.contact_time[i + 1] - footprints.contact_time[i]
    s = (t - footprints.contact_time[i]) / span if span > 0 else 0.0
    return _value(footprints, i) + s * (_value(footprints, i + 1) - _value(footprints, i))


@jit
def body_headings(biped: Dimensions, footprints: Footprints, times: np.ndarray, out: np.ndarray) -> None:
    """body_heading at many ascending times (k,) into out (k,), in time linear in both.

    The line's integral up to a time, from its integral up to the contact before, is a parabola.
    """
    _lay_headings(footprints, window_length(biped), times, np.zeros((3, len(footprints.side))), out)


@jit_borrowing
def _lay_headings(footprints: Footprints, window: float, times: np.ndarray, room: np.ndarray, out: np.ndarray) -> None:
    """body_headings, with room (3, n) of zeros for the line at the contacts: its value, its slope, its integral."""
    n, contact = len(footprints.side), footprints.contact_time
    value, slope, upto = room[0], room[1], room[2]
    for i in range(n):
        value[i] = _value(footprints, i)
        if i > 0:
            span = contact[i] - contact[i - 1]
            slope[i - 1] = (value[i] - value[i - 1]) / span if span > 0 else 0.0
            upto[i] = upto[i - 1] + 0.5 * span * (value[i] + value[i - 1])
    lead, tail = 0, 0
    for k in range(len(times)):
        while lead + 1 < n and contact[lead + 1] <= times[k]:
            lead += 1
        while tail + 1 < n and contact[tail + 1] <= times[k] - window:
            tail += 1
        x, y = times[k] - contact[lead], times[k] - window - contact[tail]
        rise, fall = (0.5 * slope[lead] if x > 0 else 0.0), (0.5 * slope[tail] if y > 0 else 0.0)  # level before the first
        out[k] = (upto[lead] + x * (value[lead] + rise * x) - upto[tail] - y * (value[tail] + fall * y)) / window
