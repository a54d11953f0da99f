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
from worlds.compiled.across import any_of
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, choose, larger, smaller
from worlds.compiled.tables import newest

WINDOW_STEPS = 1.0
"""Length of the average in nominal step times sqrt(l / g) * 1.6: longer is calmer, but lags in a turn."""


@jit_borrowing
def window_length(biped: Dimensions) -> Some:
    """Seconds of the moving average, from the pendulum time of the character's leg."""
    return WINDOW_STEPS * 1.6 * pendulum_time(biped.leg.nominal_length)


@jit_inline
def _faced(footprints: Footprints, i: Some) -> Some:
    """Half of what footprint i adds to the line: where the body faces over it."""
    return 0.5 * (footprints.heading[i] + footprints.facing[i])


@jit_borrowing
def _value(footprints: Footprints, i: Some) -> Some:
    """The line at contact i."""
    return _faced(footprints, i) + _faced(footprints, smaller(i + 1, len(footprints.side) - 1))


@jit_borrowing
def body_heading(biped: Dimensions, footprints: Footprints, t: Some) -> Some:
    """Heading of the body [rad] at time t [s], unwrapped."""
    return mean_heading(footprints, t, window_length(biped))


@jit_borrowing
def mean_heading(footprints: Footprints, t: Some, window: Some) -> Some:
    """Mean of the broken line over the last `window` [s] before t [rad].

    Sums the pieces of the line that lie in the window, the latest first: only footprints near t enter, so that forgetting
    old ones changes no bit. Level before the first contact, and from the last one on.
    """
    last, i = len(footprints.side) - 1, larger(newest(footprints.contact_time, t), 0)
    begin, upper, total, j = t - window, t + 0.0 * window, 0.0 * window, smaller(i + 1, last)
    contact, ends = footprints.contact_time[i], footprints.contact_time[j]
    own, after = _faced(footprints, i), _faced(footprints, j)
    value, then = own + after, after + _faced(footprints, smaller(j + 1, last))
    while any_of((upper > begin) & (i >= 0)):
        lower, span = larger(contact, begin), ends - contact
        inside = (lower < upper) & (i >= 0)
        gone = choose(span > 0.0, (0.5 * (upper + lower) - contact) / span, 0.0)
        total += choose(inside, (upper - lower) * (value + gone * (then - value)), 0.0)
        upper = choose(inside, lower, upper)
        i -= 1
        at = larger(i, 0)
        ends, after, then = contact, own, value
        contact, own = footprints.contact_time[at], _faced(footprints, at)
        value = own + after
    return (total + choose(upper > begin, (upper - begin) * _value(footprints, 0), 0.0)) / window


@jit
def body_headings(biped: Dimensions, footprints: Footprints, times: np.ndarray, out: np.ndarray) -> None:
    """body_heading at times (K, m) that ascend down each column, and from one column to the next, into out (K, at least m).

    In time linear in both: the line's integral up to a time, from its integral up to the contact before, is a parabola.
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
    lead, tail, share = 0, 0, 1 / window
    for i in range(times.shape[1]):
        for k in range(times.shape[0]):
            t = times[k, i]
            while lead + 1 < n and contact[lead + 1] <= t:
                lead += 1
            while tail + 1 < n and contact[tail + 1] <= t - window:
                tail += 1
            x, y = t - contact[lead], t - window - contact[tail]
            rise, fall = (0.5 * slope[lead] if x > 0 else 0.0), (0.5 * slope[tail] if y > 0 else 0.0)  # level before the first
            gone = upto[lead] - upto[tail] + x * (value[lead] + rise * x) - y * (value[tail] + fall * y)
            out[k, i] = share * gone
