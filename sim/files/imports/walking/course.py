"""A way as a walker sees it: smooth, with a direction everywhere, and led on a little before its begin and behind its end.

Who comes into sight walking has walked before: the way is led on backward, at the speed at which it begins, down to
standing; so too behind its end. Directions are those between a place some way behind and one some way ahead, so that who
stands keeps its own.
"""

from dataclasses import dataclass

import numpy as np

from sim.files.imports.trajectories.ways import Way

GRAIN = 0.05
"""Seconds between the samples."""
SMOOTH = 0.1
"""Width of the smoothing [s]: heads that sway and cameras that tremble are no course."""
RAMP = 1.2
"""Who comes into sight walking at a speed has taken so long [s] to get to it."""
MOVING = 0.25
"""Below this speed [m/s] one has not come into sight walking."""
ENTRY = 0.4
"""The speed at an end is that over so long [s]."""
REACH = 0.3
"""Direction: from this far [m] behind to this far ahead."""
CREEP = 0.02
"""A place is another one from this far [m] on."""


@dataclass(frozen=True)
class Course:
    """Samples (n,) at even times [s]; given from `begin` to `end`, led on beyond."""

    time: np.ndarray  # (n,)
    place: np.ndarray  # (n, 2) [m]
    heading: np.ndarray  # (n,) unwrapped [rad]
    begin: float
    end: float
    enters: bool  # it begins walking
    leaves: bool  # it ends walking

    def at(self, time: float) -> tuple[float, float]:
        """Where the body is to be."""
        x, y = (float(np.interp(time, self.time, self.place[:, axis])) for axis in (0, 1))
        return x, y

    def heading_at(self, time: float) -> float:
        """Where it goes."""
        return float(np.interp(time, self.time, self.heading))

    def speed(self, begin: float, end: float) -> float:
        """Mean speed [m/s] between two times."""
        (x, y), (u, v) = self.at(begin), self.at(end)
        return float(np.hypot(u - x, v - y)) / max(end - begin, 1e-9)


def course_of(way: Way) -> Course:
    """The course along a way of at least two rows."""
    velocity = [_velocity(way, at, sign) for at, sign in ((way.begin, 1.0), (way.end, -1.0))]
    walks = [bool(np.hypot(*v) > MOVING) for v in velocity]
    lead = RAMP + 1.0
    count = int(np.ceil((way.end - way.begin + 2 * lead) / GRAIN)) + 1
    time = way.begin - lead + GRAIN * np.arange(count)
    place = way.at(time)
    for (at, sign), v, walked in zip(((way.begin, -1.0), (way.end, 1.0)), velocity, walks, strict=True):
        if walked:
            beyond = np.clip(sign * (time - at), 0, RAMP)
            place += np.outer(sign * (beyond - beyond**2 / (2 * RAMP)), v)
    place = place if way.landed.any() else _smoothed(place)
    return Course(time, place, _headings(place), way.begin, way.end, *walks)


def _velocity(way: Way, at: float, sign: float) -> np.ndarray:
    """(2,) velocity [m/s] over ENTRY seconds from an end inward."""
    inward = float(np.clip(at + sign * ENTRY, way.begin, way.end))
    first, second = way.at(np.array([at, inward]))
    return sign * (second - first) / max(abs(inward - at), 1e-9)


def _smoothed(place: np.ndarray) -> np.ndarray:
    """Places weighted with a bell over time; at the ends they stand."""
    reach = int(np.ceil(3 * SMOOTH / GRAIN))
    bell = np.exp(-0.5 * (GRAIN * np.arange(-reach, reach + 1) / SMOOTH) ** 2)
    padded = np.pad(place, ((reach, reach), (0, 0)), mode="edge")
    return np.column_stack([np.convolve(padded[:, axis], bell / bell.sum(), "valid") for axis in (0, 1)])


def _headings(place: np.ndarray) -> np.ndarray:
    """(n,) unwrapped directions along places (n, 2)."""
    kept = [0]
    for k in range(1, len(place)):
        if np.hypot(*(place[k] - place[kept[-1]])) > CREEP:
            kept.append(k)
    if len(kept) < 2:
        return np.zeros(len(place))
    corners = place[kept]
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(corners, axis=0).T))])
    travelled = np.interp(np.arange(len(place)), kept, along)
    ahead, behind = np.minimum(travelled + REACH, along[-1]), np.maximum(travelled - REACH, 0.0)
    to, of = (np.column_stack([np.interp(at, along, corners[:, axis]) for axis in (0, 1)]) for at in (ahead, behind))
    return np.unwrap(np.arctan2(*(to - of).T[::-1]))
