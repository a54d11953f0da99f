"""The curve of the centre of mass: cubic Hermite segments in time (paper, section 2.3).

A segment runs between two control points, each a position p [m] and a velocity v [m/s]. With s = (t - t0) / T:

    c(t)  = h00 p0 + T h10 v0 + h01 p1 + T h11 v1
    h00 = 2s^3 - 3s^2 + 1,  h10 = s^3 - 2s^2 + s,  h01 = -2s^3 + 3s^2,  h11 = s^3 - s^2

The tangent is the velocity in time, so the curve is C1 across segments of different durations. Acceleration is linear
in time within a segment.
"""

from typing import Annotated, NamedTuple

import numpy as np

from motion.arithmetic.triples import Triple
from motion.track.footprints import Footprints
from worlds.compiled.beside.rows import ends_of
from worlds.compiled.jit import jit, jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, larger, smaller
from worlds.compiled.tables import Column, Numbers, copy_row, newest, part

Weights = tuple[Some, Some, Some, Some]


class Curve(NamedTuple):
    """m segments between m + 1 control points, each row a control point and the segment that begins there."""

    time: Numbers  # (m + 1,) [s], ascending
    control: Annotated[np.ndarray, Column(shape=(6,))]  # (m + 1, 6) position [m] and velocity [m/s]
    support: Annotated[
        np.ndarray, Column(np.int64, (2,), -1)
    ]  # (m + 1, 2) footprint of either foot, -1 in the air; no last one


class Track(NamedTuple):
    """What one character does: its footprints, and the curve over them. All that a pose is made from, with who walks."""

    footprints: Footprints
    curve: Curve


@jit_borrowing
def position_weights(s: Some, duration: Some) -> Weights:
    """Weights of (p0, v0, p1, v1) in the position at fraction s of a segment of `duration` seconds."""
    s2 = s * s
    s3 = s2 * s
    return (2 * s3 - 3 * s2 + 1, duration * (s3 - 2 * s2 + s), 3 * s2 - 2 * s3, duration * (s3 - s2))


@jit_borrowing
def velocity_weights(s: Some, duration: Some) -> Weights:
    """Weights of (p0, v0, p1, v1) in the velocity."""
    s2 = s * s
    slope = 6 * (s2 - s) / duration
    return (slope, 3 * s2 - 4 * s + 1, -slope, 3 * s2 - 2 * s)


@jit_borrowing
def acceleration_weights(s: Some, duration: Some) -> Weights:
    """Weights of (p0, v0, p1, v1) in the acceleration."""
    bend = (12 * s - 6) / (duration * duration)
    return (bend, (6 * s - 4) / duration, -bend, (6 * s - 2) / duration)


@jit_borrowing
def segment_at(time: Some, t: Some) -> Some:
    """Index of the segment holding t; `time` (m + 1,). Times outside fall to the first or last segment."""
    return smaller(larger(newest(time, t), 0), len(time) - 2)


@jit_inline
def _mixed(weights: Weights, control: Some, i: Some) -> Triple:
    """The points at both ends of segment i, and the velocities there, by their weights."""
    (w, x, y, z), (p, q) = weights, ends_of(control, i)
    return (
        w * p[0] + x * p[3] + y * q[0] + z * q[3],
        w * p[1] + x * p[4] + y * q[1] + z * q[4],
        w * p[2] + x * p[5] + y * q[2] + z * q[5],
    )


@jit_borrowing
def place_at(curve: Curve, t: Some) -> Triple:
    """Position at t."""
    i, time = segment_at(curve.time, t), curve.time
    begin = time[i]
    duration = time[i + 1] - begin
    return _mixed(position_weights((t - begin) / duration, duration), curve.control, i)


@jit_borrowing
def state_at(curve: Curve, t: Some) -> tuple[Triple, Triple, Triple]:
    """Position, velocity and acceleration at t."""
    i, time, control = segment_at(curve.time, t), curve.time, curve.control
    begin = time[i]
    duration = time[i + 1] - begin
    s = (t - begin) / duration
    return (
        _mixed(position_weights(s, duration), control, i),
        _mixed(velocity_weights(s, duration), control, i),
        _mixed(acceleration_weights(s, duration), control, i),
    )


@jit_borrowing
def position_at(curve: Curve, t: float, out: np.ndarray) -> None:
    """Position at t into out (3,)."""
    out[0], out[1], out[2] = place_at(curve, t)


@jit_borrowing
def evaluate(curve: Curve, t: float, com: np.ndarray, velocity: np.ndarray, acceleration: np.ndarray) -> None:
    """Position, velocity, acceleration at t into three (3,) arrays."""
    place, speed, bend = state_at(curve, t)
    for axis in range(3):
        com[axis], velocity[axis], acceleration[axis] = place[axis], speed[axis], bend[axis]


@jit
def states_at(curve: Curve, times: np.ndarray) -> np.ndarray:
    """Positions and velocities (n, 6) at times (n,) [s]."""
    out, bend = np.empty((len(times), 6)), np.empty(3)
    for i in range(len(times)):
        evaluate(curve, times[i], out[i, :3], out[i, 3:], bend)
    return out


@jit_borrowing
def end_acceleration(curve: Curve, out: np.ndarray) -> None:
    """Acceleration where a curve of at least one segment ends, into out (3,)."""
    i, control = len(curve.time) - 2, curve.control
    w = acceleration_weights(1.0, curve.time[i + 1] - curve.time[i])
    for axis in range(3):
        before = w[0] * control[i, axis] + w[1] * control[i, 3 + axis]
        out[axis] = before + w[2] * control[i + 1, axis] + w[3] * control[i + 1, 3 + axis]


@jit_borrowing
def up_to(curve: Curve, segments: int) -> Curve:
    """The first so many segments."""
    return part(curve, 0, segments + 1)


@jit_borrowing
def forget_segments(curve: Curve, segments: int, gone: int) -> int:
    """Of so many segments the first `gone` are forgotten; returns how many are left."""
    if gone > 0:
        for i in range(segments - gone + 1):
            copy_row(curve, gone + i, i)
    return segments - gone


@jit_borrowing
def append_segment(curve: Curve, segments: int, source: Curve, i: int) -> None:
    """Segment i of another curve follows the first so many: its support, and the control point at its end."""
    curve.time[segments + 1] = source.time[i + 1]
    for axis in range(6):
        curve.control[segments + 1, axis] = source.control[i + 1, axis]
    for leg in range(2):
        curve.support[segments, leg] = source.support[i, leg]
