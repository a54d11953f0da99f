"""Cubic Hermite segments in time (paper, section 2.3).

A segment runs between two control points, each a position p [m] and a velocity v [m/s]. With s = (t - t0) / T:

    c(t)  = h00 p0 + T h10 v0 + h01 p1 + T h11 v1
    h00 = 2s^3 - 3s^2 + 1,  h10 = s^3 - 2s^2 + s,  h01 = -2s^3 + 3s^2,  h11 = s^3 - s^2

The tangent is the velocity in time, so the curve is C1 across segments of different durations. Acceleration is linear
in time within a segment.
"""

import numpy as np

from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def position_weights(s, duration):
    """Weights of (p0, v0, p1, v1) in the position at fraction s of a segment of `duration` seconds."""
    s2 = s * s
    s3 = s2 * s
    return (2 * s3 - 3 * s2 + 1, duration * (s3 - 2 * s2 + s), 3 * s2 - 2 * s3, duration * (s3 - s2))


@jit_borrowing
def velocity_weights(s, duration):
    """Weights of (p0, v0, p1, v1) in the velocity."""
    s2 = s * s
    slope = 6 * (s2 - s) / duration
    return (slope, 3 * s2 - 4 * s + 1, -slope, 3 * s2 - 2 * s)


@jit_borrowing
def acceleration_weights(s, duration):
    """Weights of (p0, v0, p1, v1) in the acceleration."""
    bend = (12 * s - 6) / (duration * duration)
    return (bend, (6 * s - 4) / duration, -bend, (6 * s - 2) / duration)


@jit_borrowing
def segment_at(time, t):
    """Index of the segment holding t; `time` (m+1,) is ascending. Times outside fall to the first or last segment."""
    index = np.searchsorted(time, t, side="right") - 1
    return min(max(index, 0), len(time) - 2)


@jit_borrowing
def position_at(time, control, t, out):
    """Position at t into out (3,)."""
    i = segment_at(time, t)
    duration = time[i + 1] - time[i]
    p = position_weights((t - time[i]) / duration, duration)
    for axis in range(3):
        out[axis] = (
            p[0] * control[i, axis]
            + p[1] * control[i, 3 + axis]
            + p[2] * control[i + 1, axis]
            + p[3] * control[i + 1, 3 + axis]
        )


@jit_borrowing
def evaluate(time, control, t, com, velocity, acceleration):
    """Position, velocity, acceleration at t into three (3,) arrays. time (m+1,), control (m+1, 6)."""
    i = segment_at(time, t)
    duration = time[i + 1] - time[i]
    s = (t - time[i]) / duration
    position = position_weights(s, duration)
    speed = velocity_weights(s, duration)
    bend = acceleration_weights(s, duration)
    for axis in range(3):
        p0, v0 = control[i, axis], control[i, 3 + axis]
        p1, v1 = control[i + 1, axis], control[i + 1, 3 + axis]
        com[axis] = position[0] * p0 + position[1] * v0 + position[2] * p1 + position[3] * v1
        velocity[axis] = speed[0] * p0 + speed[1] * v0 + speed[2] * p1 + speed[3] * v1
        acceleration[axis] = bend[0] * p0 + bend[1] * v0 + bend[2] * p1 + bend[3] * v1
