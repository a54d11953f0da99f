"""Where the tracks of a scene tread on each other: two soles of different characters on the same ground at the same time."""

from collections.abc import Iterator
from math import cos, sin
from typing import NamedTuple

import numpy as np

from planner.round.soles import Sole, soles, soles_apart
from planner.script.acting import Act

OVERLAP = 0.01
"""Soles that overlap by less only touch [m]."""


class _Stance(NamedTuple):
    """A sole on the ground."""

    track: int
    number: int  # of the footprint
    sole: Sole
    begin: float  # [s]
    end: float


def trodden(acts: list[Act]) -> list[str]:
    """One sentence for each two tracks that tread on each other: where and when they first do."""
    found: dict[tuple[int, int], tuple[float, str]] = {}
    for one, other in _meetings([stance for k, act in enumerate(acts) for stance in _stances(k, act)]):
        begin, pair = max(one.begin, other.begin), (one.track, other.track)
        place = f"({other.sole.x:.2f}, {other.sole.y:.2f})"
        said = f"track.{other.track}: footprint.{other.number} at {place} treads on footprint.{one.number} of track.{one.track}"
        if pair not in found or begin < found[pair][0]:
            found[pair] = (begin, f"{said}, {begin:.2f} s into the scene")
    return [said for _, said in found.values()]


def _stances(track: int, act: Act) -> Iterator[_Stance]:
    prints, (half, radius) = act.motion.footprints, soles(act.character.biped).tolist()
    for i, ((x, y, _), heading) in enumerate(zip(prints.position.tolist(), prints.heading.tolist(), strict=True)):
        begin = float(prints.contact_time[i])
        sole = Sole(x, y, cos(heading), sin(heading), half, radius)
        yield _Stance(track, i, sole, begin, begin + float(prints.stance_time[i]))


def _meetings(stances: list[_Stance]) -> Iterator[tuple[_Stance, _Stance]]:
    """Pairs of stances of different tracks that overlap in place and time, the lesser track first; found by a grid."""
    if len({stance.track for stance in stances}) < 2:
        return
    cell = 2 * max(stance.sole.half + stance.sole.radius for stance in stances)
    grid: dict[tuple[int, int], list[_Stance]] = {}
    for stance in stances:
        i, j = (int(np.floor(v / cell)) for v in (stance.sole.x, stance.sole.y))
        for other in (k for a in (i - 1, i, i + 1) for b in (j - 1, j, j + 1) for k in grid.get((a, b), ())):
            if other.track != stance.track and other.begin < stance.end and stance.begin < other.end:
                if soles_apart(other.sole, stance.sole) < -OVERLAP:
                    yield other, stance
        grid.setdefault((i, j), []).append(stance)
