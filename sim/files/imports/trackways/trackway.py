"""A trackway: prints with their sides and headings, and what palaeontologists read from it.

Speed from the stride S [m] and the height of the hip h [m]: v = k sqrt(g) S^1.67 h^-1.17, with k = 0.25 (R. McN. Alexander,
Nature 261, 1976) or, for bipeds, k = 0.226 (J. Ruiz & A. Torices, Ichnos 20, 2013). Gait by S / h: a walk below 2, a run
above 2.9, a trot between (Alexander 1976; R. A. Thulborn 1982). Pace angulation is the angle at a print between the paces to
and from it. Gauge is how far a print lies from the line of the other foot's stride around it.
"""

from dataclasses import dataclass
from math import sqrt
from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.track.footprints import LEFT, SIDES
from sim.files.imports.trackways.prints import Prints

LAWS = {"alexander": 0.25, "ruiz": 0.226}
"""Coefficient k of the speed, by who has found it."""
WALKS, RUNS = 2.0, 2.9
"""Relative strides S / h up to which one walks, and beyond which one runs."""


class Spread(NamedTuple):
    """A quantity over the prints of a trackway."""

    mean: float
    deviation: float


@dataclass(frozen=True)
class Trackway:
    """n prints in metres."""

    name: str
    points: np.ndarray  # (n, 2) middle of the print [m]
    inferred: np.ndarray  # (n,) bool: nobody has seen it
    first_side: int  # LEFT or RIGHT
    hip_height: float  # [m]

    @property
    def side(self) -> np.ndarray:
        """(n,) LEFT or RIGHT, in turn."""
        return (np.arange(len(self.points)) + self.first_side) % 2

    @property
    def headings(self) -> np.ndarray:
        """(n,) the direction of the course at each print, unwrapped [rad].

        From the print before to the print behind it, which are of one foot; at either end that of its neighbour, for a single
        pace goes askew.
        """
        ahead = self.points[2:] - self.points[:-2]
        inner = np.unwrap(np.arctan2(ahead[:, 1], ahead[:, 0]))
        return np.concatenate([inner[:1], inner, inner[-1:]])

    @property
    def strides(self) -> np.ndarray:
        """(n - 2,) from each print to the same foot's next [m]."""
        return np.hypot(*(self.points[2:] - self.points[:-2]).T)

    @property
    def paces(self) -> np.ndarray:
        """(n - 1,) from each print to the next, of the other foot [m]."""
        return np.hypot(*np.diff(self.points, axis=0).T)

    def speed(self, law: str) -> float:
        """Speed [m/s] of the mean stride by one of LAWS."""
        return LAWS[law] * sqrt(GRAVITY) * float(self.strides.mean()) ** 1.67 * self.hip_height**-1.17

    def step_times(self, law: str) -> np.ndarray:
        """(n - 1,) seconds from each print to the next, of an animal that goes on at the trackway's speed: half a stride each.

        The strides around a step's two prints are averaged; at the ends there is one.
        """
        strides = self.strides
        around = np.concatenate([strides[:1], 0.5 * (strides[:-1] + strides[1:]), strides[-1:]])
        return 0.5 * around / self.speed(law)


def completed(prints: Prints, scale: float, hip_height: float, first_side: str) -> Trackway:
    """The trackway of prints whose units are `scale` metres; a missing one lies evenly between the same foot's neighbours."""
    points, inferred = prints.points * scale, ~np.isfinite(prints.points[:, 0])
    for side in range(2):
        rows = np.arange(side, len(points), 2)
        known = rows[~inferred[rows]]
        for axis in range(2):
            points[rows, axis] = np.interp(rows, known, points[known, axis])
    return Trackway(prints.name, points, inferred, SIDES.index(first_side), hip_height)


def _spread(values: np.ndarray) -> Spread:
    return Spread(float(values.mean()), float(values.std()))


def angulation(points: np.ndarray) -> np.ndarray:
    """(n - 2,) pace angulation at the inner prints of points (n, 2) [rad]: pi where the prints lie in one line."""
    back, ahead = points[:-2] - points[1:-1], points[2:] - points[1:-1]
    cosine = (back * ahead).sum(axis=1) / (np.hypot(*back.T) * np.hypot(*ahead.T))
    return np.arccos(np.clip(cosine, -1, 1))


def gauge(points: np.ndarray) -> np.ndarray:
    """(n - 2,) distance of the inner prints from the line between the prints before and behind them [m]."""
    ahead, to = points[2:] - points[:-2], points[1:-1] - points[:-2]
    return np.abs(ahead[:, 0] * to[:, 1] - ahead[:, 1] * to[:, 0]) / np.hypot(*ahead.T)


def gait(relative_stride: float) -> str:
    """Walk, trot or run by the stride in hip heights."""
    return "walk" if relative_stride < WALKS else "run" if relative_stride > RUNS else "trot"


def report(trackway: Trackway, law: str) -> dict:
    """Figures of a trackway as plain values: metres, degrees, m/s; `walked` is the speed of the scene."""
    way, angles = trackway, np.degrees(angulation(trackway.points))
    relative = float(way.strides.mean()) / way.hip_height
    return {
        "name": way.name,
        "prints": len(way.points),
        "first_side": SIDES[way.first_side],
        "inferred": [int(k) + 1 for k in np.flatnonzero(way.inferred)],
        "hip_height": way.hip_height,
        "stride": _spread(way.strides)._asdict(),
        "pace": _spread(way.paces)._asdict(),
        "pace_angulation_deg": _spread(angles)._asdict(),
        "gauge": _spread(gauge(way.points))._asdict(),
        "speed": {name: way.speed(name) for name in LAWS},
        "walked": float(0.5 * way.strides[LEFT:].sum() / way.step_times(law)[1:].sum()),
        "relative_stride": relative,
        "gait": gait(relative),
    }


def in_words(figures: dict) -> str:
    """A report for people."""
    rows = [
        f"{figures['name']}: {figures['prints']} prints, first {figures['first_side']}, hip height {figures['hip_height']:g} m"
    ]
    for key, unit in (("stride", "m"), ("pace", "m"), ("pace_angulation_deg", "deg"), ("gauge", "m")):
        said = key.removesuffix("_deg").replace("_", " ")
        rows.append(f"  {said:18}{figures[key]['mean']:8.3f} {unit}  (+- {figures[key]['deviation']:.3f})")
    for law, who in (("alexander", "Alexander 1976"), ("ruiz", "Ruiz and Torices 2013")):
        rows.append(f"  {'speed':18}{figures['speed'][law]:8.3f} m/s  {who}")
    rows.append(f"  {'gait':18}{figures['gait']:>8}  (stride of {figures['relative_stride']:.2f} hip heights)")
    if figures["inferred"]:
        said = ", ".join(map(str, figures["inferred"]))
        rows.append(f"  inferred: print {said}: missing, put evenly between the same foot's neighbours")
    return "\n".join(rows)
