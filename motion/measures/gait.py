"""How a character goes: its strides, and how the com moves over them. F frames of one character.

A stride lasts from a contact of a foot to the next of the same foot, with at most one of the other between (none: a hop). The
walked line is the com averaged over a stride's time about each moment; bob and sway are what the com does about that line,
up and to the left, so that neither a slope nor a gentle turn counts. Duty factor: share of the stride that the foot stands.
"""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY, pendulum_time
from motion.track import phases
from motion.track.footprints import Footprints

LONGEST = 7.0
"""A stride longer than this, in pendulum times sqrt(h / g), is one in which the character stands still."""
STANDS = 0.8
"""So is one of a larger duty factor."""
GAITS = ("walk", "run", "hop", "stand")


class Strides(NamedTuple):
    """N strides of either foot."""

    first: np.ndarray  # (N,) footprint that begins it
    between: np.ndarray  # (N,) the other foot's, -1 in a hop
    last: np.ndarray  # (N,) the same foot's next
    begin: np.ndarray  # (N,) [s]
    duration: np.ndarray  # (N,) [s]
    stance: np.ndarray  # (N,) [s]


def strides_of(footprints: Footprints, begin: float, end: float, hip_height: float) -> Strides:
    """The strides that lie wholly after `begin` and up to `end` [s]. footprints (K,), by contact time."""
    rows = []
    contact, longest = footprints.contact_time, LONGEST * pendulum_time(hip_height)
    for foot in range(2):
        own = np.flatnonzero(footprints.side == foot)
        for first, last in zip(own[:-1].tolist(), own[1:].tolist(), strict=True):
            duration, stance = contact[last] - contact[first], footprints.stance_time[first]
            inside = contact[first] > begin and contact[last] <= end
            if inside and last - first <= 2 and duration <= longest and stance < STANDS * duration:
                rows.append((first, first + 1 if last - first == 2 else -1, last, contact[first], duration, stance))
    columns = np.array(rows, np.float64).reshape(-1, 6).T
    return Strides(*(column.astype(np.int64) for column in columns[:3]), *columns[3:])


class Excursions(NamedTuple):
    """What the com does over each of N strides [m]; NaN where the recording does not reach half a stride to either side."""

    bob: np.ndarray  # (N,) highest less lowest
    sway: np.ndarray  # (N,) leftmost less rightmost
    at_midstance: np.ndarray  # (N,) height in the middle of the stance: 0 the lowest, 1 the highest of the stride
    length: np.ndarray  # (N,) gone along the walked line


def excursions_of(strides: Strides, time: np.ndarray, com: np.ndarray) -> Excursions:
    """What the com does over each stride. com (F, 3) at evenly spaced times (F,) [s]."""
    out = np.full((4, len(strides.begin)), np.nan)
    for i, (begin, duration, stance) in enumerate(zip(strides.begin, strides.duration, strides.stance, strict=True)):
        part = slice(*np.searchsorted(time, (begin - 0.5 * duration, begin + 1.5 * duration)))
        if begin - 0.5 * duration < time[0] or begin + 1.5 * duration > time[-1]:
            continue
        inside = (time[part] >= begin) & (time[part] < begin + duration)
        left, up, along = off_line(time[part], com[part], duration)[inside].T
        middle = np.interp(begin + 0.5 * stance, time[part][inside], up)
        out[:, i] = np.ptp(up), np.ptp(left), (middle - up.min()) / max(np.ptp(up), 1e-9), along.mean() * duration
    return Excursions(*out)


def off_line(time: np.ndarray, com: np.ndarray, span: float) -> np.ndarray:
    """(left, up, speed) (F, 3) [m, m, m/s]: where the com is from the walked line, and how fast that line is gone along.

    The line is the com's mean over `span` [s] about each moment, less toward the ends of time.
    """
    dt = (time[-1] - time[0]) / max(len(time) - 1, 1)
    integral = np.vstack([np.zeros(3), np.cumsum(0.5 * dt * (com[1:] + com[:-1]), axis=0)])
    half = np.minimum(np.minimum(0.5 * span, time - time[0]), time[-1] - time)
    half = np.maximum(half, 0.5 * dt)[:, None]
    ahead, behind = np.minimum(time + half[:, 0], time[-1]), np.maximum(time - half[:, 0], time[0])
    wide = (ahead - behind)[:, None]
    way = (_at(ahead, time, com) - _at(behind, time, com)) / wide
    off = com - (_at(ahead, time, integral) - _at(behind, time, integral)) / wide
    speed = np.hypot(way[:, 0], way[:, 1])
    left = (off[:, 1] * way[:, 0] - off[:, 0] * way[:, 1]) / np.maximum(speed, 1e-9)
    return np.column_stack([left, off[:, 2], speed])


def _at(t: np.ndarray, time: np.ndarray, values: np.ndarray) -> np.ndarray:
    return np.column_stack([np.interp(t, time, column) for column in values.T])


def kinds_of(strides: Strides) -> np.ndarray:
    """Index (N,) into GAITS: a stride without the other foot is a hop, others walk from a duty factor of one half on."""
    return np.where(strides.between < 0, 2, np.where(strides.stance < 0.5 * strides.duration, 1, 0))


def shares_of(strides: Strides, time: np.ndarray) -> dict[str, float]:
    """Share of the frames in each gait; where a stride of each foot covers a frame, both count half. The rest stands."""
    counts = np.zeros((len(time), 3))
    for kind, begin, duration in zip(kinds_of(strides), strides.begin, strides.duration, strict=True):
        counts[np.searchsorted(time, begin) : np.searchsorted(time, begin + duration), kind] += 1
    shares = counts / np.maximum(counts.sum(axis=1, keepdims=True), 1)
    moving = shares.mean(axis=0)
    return dict(zip(GAITS, (*moving.tolist(), float(1 - moving.sum())), strict=True))


def moving(strides: Strides, time: np.ndarray) -> np.ndarray:
    """Frames (F,) bool that belong to a stride."""
    change = np.zeros(len(time) + 1, np.int64)
    np.add.at(change, np.searchsorted(time, strides.begin), 1)
    np.add.at(change, np.searchsorted(time, strides.begin + strides.duration), -1)
    return np.cumsum(change[:-1]) > 0


def stepping(strides: Strides, footprints: Footprints) -> tuple[np.ndarray, np.ndarray]:
    """(step length, step width) (M,) [m] of the strides with both feet: half the stride, and the other foot's distance from
    its line, negative where it crosses over."""
    both = strides.between >= 0
    first, other, last = (part[both] for part in (strides.first, strides.between, strides.last))
    place, heading = footprints.position[:, :2], footprints.heading
    way, off = place[last] - place[first], place[other] - place[first]
    length = np.hypot(way[:, 0], way[:, 1])
    goes = np.sign(way[:, 0] * np.cos(heading[first]) + way[:, 1] * np.sin(heading[first]))
    left = goes * (way[:, 0] * off[:, 1] - way[:, 1] * off[:, 0]) / np.maximum(length, 1e-9)
    return 0.5 * length, np.where(footprints.side[other] == 0, left, -left)


def report(footprints: Footprints, time: np.ndarray, com: np.ndarray, phase: np.ndarray, hip_height: float) -> dict:
    """The gait in figures: means over all strides (None where there is none); lengths in m, cadence in steps per minute."""
    strides = strides_of(footprints, float(time[0]), float(time[-1]), hip_height)
    excursions, going = excursions_of(strides, time, com), moving(strides, time)
    length, width = stepping(strides, footprints)
    shares = shares_of(strides, time)
    steps = np.where(strides.between < 0, 1, 2)
    speed = _mean(excursions.length / strides.duration)
    return {
        "name": max(GAITS, key=lambda name: shares[name]),
        "shares": shares,
        "strides": len(strides.begin),
        "bob": _mean(excursions.bob),
        "sway": _mean(excursions.sway),
        "height_at_midstance": _mean(excursions.at_midstance),
        "step_length": _mean(length),
        "step_width": _mean(width),
        "cadence": float(60 * steps.sum() / strides.duration.sum()) if len(steps) else None,
        "duty_factor": _mean(strides.stance / strides.duration),
        "double_support": _mean((phase == phases.DOUBLE_STANCE)[going]),
        "flight": _mean((phase == phases.FLIGHT)[going]),
        "speed": speed,
        "froude": None if speed is None else speed**2 / (GRAVITY * hip_height),
    }


def _mean(values: np.ndarray) -> float | None:
    known = values[~np.isnan(values)] if values.dtype.kind == "f" else values
    return float(known.mean()) if len(known) else None
