"""Whether those who stand are apart: no two bodies overlap, and no two soles. Asked of starts, and of who becomes larger."""

from collections.abc import Iterator
from math import cos, hypot, sin
from typing import NamedTuple

import numpy as np

from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, RIGHT
from planner.crowd.bodies import gap_between
from planner.round.reservations import body_sizes
from planner.round.soles import Sole, soles, soles_apart
from planner.stepping.beside import beside
from worlds.errors import InputError

TOUCH = 1e-6
"""Bodies and soles that overlap by no more than this touch [m]."""
INSIDE = 0.25
"""Bodies nearer than this share of their radii are in one place."""
BODIES, SOLES = "bodies", "soles"


class Overlap(NamedTuple):
    """Two who stand in each other."""

    one: int
    other: int  # came before
    what: str  # of them overlaps


def overlap_of(bipeds: list[Dimensions], places: np.ndarray) -> Overlap | None:
    """The first of C characters at places (C, 3) x, y [m], heading [rad] that stands in one before it; None: all are apart.

    They are put into a grid one by one. Those in it are apart, so few of them lie near: it takes time in proportion to C.
    """
    reaches = {each: _reach(one) for each, one in {id(one): one for one in bipeds}.items()}
    for c, other in _near(places, 2 * max(reaches.values())):
        most = reaches[id(bipeds[c])] + reaches[id(bipeds[other])]
        if hypot(*(places[c, :2] - places[other, :2])) < most:
            what = what_overlaps(bipeds[c], places[c], bipeds[other], places[other])
            if what is not None:
                return Overlap(c, other, what)
    return None


def one_inside_another(radius: np.ndarray, rest: np.ndarray) -> tuple[int, int] | None:
    """Two of C who are in one place: no planner brings bodies of these radii (C,) so near to each other, at rest (C, 2) [m]."""
    pairs = _near(rest, 2 * float(radius.max(initial=1e-3)))
    return next((p for p in pairs if hypot(*(rest[p[0]] - rest[p[1]])) < INSIDE * (radius[p[0]] + radius[p[1]])), None)


def _near(places: np.ndarray, cell: float) -> Iterator[tuple[int, int]]:
    """Pairs of C whose places (C, 2 or more) x, y [m] lie in one cell of a grid or in two beside each other: each with those
    before it, one after the other."""
    grid: dict[tuple[int, int], list[int]] = {}
    for c, (x, y) in enumerate(places[:, :2].tolist()):
        i, j = int(x // cell), int(y // cell)
        yield from ((c, k) for a in (i - 1, i, i + 1) for b in (j - 1, j, j + 1) for k in grid.get((a, b), ()))
        grid.setdefault((i, j), []).append(c)


def check_apart(bipeds: list[Dimensions], places: np.ndarray) -> None:
    """Raises InputError where two of C who are to start at (C, 3) x, y [m], heading [rad] would stand in each other."""
    overlap = overlap_of(bipeds, places)
    if overlap:
        c, other, what = overlap
        at, there = (f"starts.{k} at ({places[k, 0]:g}, {places[k, 1]:g})" for k in (c, other))
        raise InputError(f"{at}: stands in {there}: their {what} overlap; start them apart")


def what_overlaps(one: Dimensions, place: np.ndarray, other: Dimensions, there: np.ndarray) -> str | None:
    """What of two who stand at (3,) x, y [m], heading [rad] overlaps: their bodies, their soles, or None."""
    (x, y, heading), (u, v, turned) = place.tolist(), there.tolist()
    face, faces = (cos(heading), sin(heading)), (cos(turned), sin(turned))
    if gap_between(_half(one), face, _half(other), faces, u - x, v - y) < -TOUCH:
        return BODIES
    feet, theirs = _soles(one, place), _soles(other, there)
    return SOLES if any(soles_apart(a, z) < -TOUCH for a in feet for z in theirs) else None


def _half(biped: Dimensions) -> tuple[float, float]:
    """Half the depth and width of a body that does not sway [m]."""
    deep, wide = 0.5 * body_sizes(biped)
    return float(deep), float(wide)


def _soles(biped: Dimensions, place: np.ndarray) -> list[Sole]:
    x, y, heading = place.tolist()
    half, radius = soles(biped).tolist()
    feet = (beside(biped, side, (x, y), heading) for side in (LEFT, RIGHT))
    return [Sole(u, v, cos(heading), sin(heading), half, radius) for u, v in feet]


def _reach(biped: Dimensions) -> float:
    """Radius of a disc with the body and both soles in it [m]."""
    foot, across = biped.foot, float(biped.gait.step_width)
    return max(*_half(biped), hypot(0.5 * float(foot.length), 0.5 * (across + float(foot.width))))
