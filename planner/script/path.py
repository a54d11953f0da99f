"""Footprints along a Hermite path with a step length (paper, Fig. 4), and those of them that were moved by hand.

The path is C1: from point p_k to p_{k+1} with tangents m_k, m_{k+1},

    c(s) = h00 p_k + h10 m_k + h01 p_{k+1} + h11 m_{k+1}    (motion.track.curve has the four polynomials)

A print moved by hand keeps its offset in the frame of the path (along, to the left), so it goes where the path is bent to.
"""

from math import cos, radians, sin
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, model_validator

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from motion.track.footprints import SIDES
from planner.script.footprint import Crouch, Footprint, Moment, Pause, Seconds
from planner.stepping import strides, timing
from worlds.errors import InputError
from worlds.ground import Finite, Part, Point

Stride = Annotated[float, Field(ge=0.01, le=100, allow_inf_nan=False, strict=True)]
Count = Annotated[int, Field(ge=0, le=20_000, strict=True)]
MOST_FOOTPRINTS = 20_000
"""A path has at most so many."""
PIECES = 64
"""Straight pieces by which a Hermite piece of a path is measured."""


class Moved(Part):
    """What was changed by hand about one footprint of a path. What is not given is as the path has it."""

    step: Count  # which: 0 and 1 are stood on at its beginning, 2 is its first step
    offset: Point = (0.0, 0.0)  # [m] along the path and to the left of it
    turn_deg: Finite = 0.0  # the foot points this far away from where the path has it
    step_time: Seconds | None = None
    stance_time: Seconds | None = None
    stand: Pause | None = None
    crouch: Crouch | None = None
    facing_deg: Finite | None = None
    at: Moment | None = None


class Path(Part):
    """A way along a Hermite curve through points, walked with feet to either side."""

    points: Annotated[tuple[Point, ...], Field(min_length=2, max_length=1000)]
    tangents: tuple[Point, ...] | None = None  # at the points [m]; half the way between a point's neighbours without them
    step_length: Stride | Annotated[tuple[Stride, ...], Field(min_length=2, max_length=1000)]  # several: evenly along the way
    step_width: Annotated[float, Field(ge=0, le=5, strict=True)] | None = None  # the character's own
    stagger: Annotated[float, Field(ge=-2, le=2, strict=True)] = 0.0  # right feet land so much farther along [m]
    first: Literal["left", "right"] = "left"
    after: Count = 0  # of the single footprints of its track, so many come before it
    feet_deg: Finite = 0.0  # the feet point this far to the left of the way: 180 backward
    facing_deg: Finite = 0.0
    crouch: Crouch = 1.0
    step_time: Seconds | None = None
    stance_time: Seconds | None = None
    stand: Pause = 0.0  # at its end
    moved: tuple[Moved, ...] = ()

    @model_validator(mode="after")
    def _a_tangent_to_each_point(self) -> "Path":
        if self.tangents is not None and len(self.tangents) != len(self.points):
            raise ValueError(f"{len(self.tangents)} tangents for {len(self.points)} points; give one to each, or none")
        return self


def hermite_path(points: object, tangents: object = None) -> np.ndarray:
    """Points (P, 2) along the cubic Hermite curve through given ones; a tangent is half the way between its neighbours."""
    p = np.array(points, np.float64)
    if len(p) == 2 and tangents is None:
        return p
    slopes = np.gradient(p, axis=0) if tangents is None else np.array(tangents, np.float64)
    s = np.linspace(0, 1, PIECES + 1)[:, None]
    pieces = [
        (2 * s**3 - 3 * s**2 + 1) * a + (s**3 - 2 * s**2 + s) * u + (3 * s**2 - 2 * s**3) * z + (s**3 - s**2) * v
        for a, z, u, v in zip(p[:-1], p[1:], slopes[:-1], slopes[1:], strict=True)
    ]
    return np.vstack([pieces[0], *(piece[1:] for piece in pieces[1:])])


def footprints_along(path: Path, character: Character) -> list[Footprint]:
    """The footprints of a character along a path; the first two are stood on."""
    line = hermite_path(path.points, path.tangents)
    length = float(np.hypot(*np.diff(line, axis=0).T).sum())
    middles, directions = strides.along(line, np.concatenate([[0.0, 0.0], _distances(path, length), [length]]))
    steps, last = np.hypot(*np.diff(middles, axis=0).T), len(middles) - 1
    side = 1 - SIDES.index(path.first)  # the foot that steps first is the older of the two stood on
    moved, footprints = {one.step: one for one in path.moved}, []
    for k, (middle, direction) in enumerate(zip(middles, np.unwrap(directions), strict=True)):
        foot = (side + k + 1) % 2
        heading = direction + radians(path.feet_deg)
        width = _width(path, character.biped, float(steps[k - 1]) if 1 < k < last else 0.0)
        across, ahead = 0.5 * width * (1 - 2 * foot), path.stagger * (foot - 0.5)
        place = (
            float(middle[0] - across * np.sin(heading) + ahead * np.cos(direction)),
            float(middle[1] + across * np.cos(heading) + ahead * np.sin(direction)),
        )
        footprint = _footprint(path, foot, place, heading, k > 1, last=k == last)
        footprints.append(_as_moved(footprint, moved[k], float(direction)) if k in moved else footprint)
    return footprints


def _width(path: Path, biped: Dimensions, length: float) -> float:
    """Distance [m] between the lines of left and right where a step of that length [m] ends; 0: a foot that stands there."""
    if path.step_width is not None:
        return path.step_width
    speed = timing.pace_of(biped, length) if path.step_time is None else length / path.step_time
    return timing.width_at(biped, speed)


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


OWN = ("step_time", "stance_time", "stand", "crouch", "facing_deg", "at")
"""What a moved footprint may have of its own."""


def _as_moved(footprint: Footprint, moved: Moved, direction: float) -> Footprint:
    """The path's footprint as it was changed by hand."""
    (x, y), (along, left) = footprint.position, moved.offset
    c, s = cos(direction), sin(direction)
    own = {name: value for name in OWN if (value := getattr(moved, name)) is not None}
    place = (x + c * along - s * left, y + s * along + c * left)
    return footprint.model_copy(update={"position": place, "heading_deg": footprint.heading_deg + moved.turn_deg, **own})


def directions_along(path: Path) -> np.ndarray:
    """The directions (n,) [rad] of the path where its footprints are."""
    line = hermite_path(path.points, path.tangents)
    length = float(np.hypot(*np.diff(line, axis=0).T).sum())
    directions = strides.along(line, np.concatenate([[0.0, 0.0], _distances(path, length), [length]]))[1]
    return np.asarray(np.unwrap(directions))
