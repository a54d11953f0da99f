"""Footprints along a Hermite path with a step length (paper, Fig. 4)."""

from math import radians
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from motion.characters.character import Character
from motion.track.footprints import SIDES
from planner.script.footprint import Crouch, Footprint, Pause, Seconds
from planner.stepping import strides
from worlds.errors import InputError
from worlds.ground import Finite, Part, Point

Stride = Annotated[float, Field(ge=0.01, le=100, allow_inf_nan=False, strict=True)]
MOST_FOOTPRINTS = 20_000
"""A path has at most so many."""
PIECES = 64
"""Straight pieces by which a Hermite piece of a path is measured."""


class Path(Part):
    """A way along a Hermite curve through points, walked with feet to either side."""

    points: Annotated[list[Point], Field(min_length=2)]
    step_length: Stride | Annotated[list[Stride], Field(min_length=2, max_length=1000)]  # a list changes evenly along the way
    step_width: Annotated[float, Field(ge=0, le=5, strict=True)] | None = None  # the character's own
    first: Literal["left", "right"] = "left"
    feet_deg: Finite = 0.0  # the feet point this far to the left of the way: 180 backward
    facing_deg: Finite = 0.0
    crouch: Crouch = 1.0
    step_time: Seconds | None = None
    stance_time: Seconds | None = None
    stand: Pause = 0.0  # at its end


def hermite_path(points: object) -> np.ndarray:
    """Points (P, 2) along the cubic Hermite curve through given ones; a tangent is half the way between its neighbours."""
    p = np.array(points, np.float64)
    if len(p) == 2:
        return p
    tangents = np.gradient(p, axis=0)
    s = np.linspace(0, 1, PIECES + 1)[:, None]
    pieces = [
        (2 * s**3 - 3 * s**2 + 1) * a + (s**3 - 2 * s**2 + s) * u + (3 * s**2 - 2 * s**3) * z + (s**3 - s**2) * v
        for a, z, u, v in zip(p[:-1], p[1:], tangents[:-1], tangents[1:], strict=True)
    ]
    return np.vstack([pieces[0], *(piece[1:] for piece in pieces[1:])])


def footprints_along(path: Path, character: Character) -> list[Footprint]:
    """The footprints of a character along a path; the first two are stood on."""
    line = hermite_path(path.points)
    length = float(np.hypot(*np.diff(line, axis=0).T).sum())
    middles, directions = strides.along(line, np.concatenate([[0.0, 0.0], _distances(path, length), [length]]))
    width = character.biped.gait.step_width if path.step_width is None else path.step_width
    side = 1 - SIDES.index(path.first)  # the foot that steps first is the older of the two stood on
    footprints = []
    for k, (middle, direction) in enumerate(zip(middles, np.unwrap(directions), strict=True)):
        foot = (side + k + 1) % 2
        heading = direction + radians(path.feet_deg)
        across = 0.5 * width * (1 - 2 * foot)
        place = (middle[0] - across * np.sin(heading), middle[1] + across * np.cos(heading))
        footprints.append(_footprint(path, foot, place, heading, k > 1, last=k == len(middles) - 1))
    return footprints


def _distances(path: Path, length: float) -> np.ndarray:
    """Where along the way the feet land; all steps a little longer or shorter, so that they end where it ends."""
    lengths = np.atleast_1d(np.array(path.step_length, np.float64))
    if length / lengths.min() > MOST_FOOTPRINTS:
        least = f"{length:.4g} m in steps of {lengths.min():g} m"
        raise InputError(f"path: {least} are more than {MOST_FOOTPRINTS} footprints; give longer steps or a shorter path")
    if length == 0:
        raise InputError("path.points: all in one place; a path leads somewhere")
    ends = [0.0]
    while ends[-1] < length:
        share = np.linspace(0, 1, len(lengths))
        ends.append(ends[-1] + float(np.interp(ends[-1] / length, share, lengths)))
    if len(ends) > 2 and ends[-1] - length > 0.5 * (ends[-1] - ends[-2]):
        ends.pop()
    return np.array(ends[1:]) * length / ends[-1]


def _footprint(path: Path, foot: int, place: Point, heading: float, moving: bool, last: bool) -> Footprint:
    return Footprint(
        side=SIDES[foot],  # type: ignore[arg-type]
        position=place,
        heading_deg=float(np.degrees(heading)),
        step_time=path.step_time if moving else None,
        stance_time=path.stance_time if moving else None,
        stand=path.stand if last else 0.0,
        crouch=path.crouch,
        facing_deg=path.facing_deg,
    )
