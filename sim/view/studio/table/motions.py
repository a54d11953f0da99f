"""What both views draw of the motion: the curve of the centre of mass by phase, ghosts at contacts, pulls, apexes, forces.

Points of the curve and ghosts are computed once for each motion (by `Sampled`), and only projected from frame to frame.
"""

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import GRAVITY
from motion.motion import placed
from motion.track import phases
from motion.track.curve import Curve
from planner.script.acting import Act
from planner.script.shaping import time_of
from sim.stage.scripted.rehearsal import Rehearsal
from sim.view import theme
from sim.view.studio.table.marks import Pen, draw_line, inside, vector
from sim.view.theme import ink

PIECES = 5
"""Straight pieces to a segment of the curve."""
FINE = 2.5
"""Points of the curve that are drawn are so many pixels apart."""
GHOSTS = 9
"""Ghosts that are drawn, those nearest in time."""
FORCE = 0.05
"""Length of a force's arrow [m per m/s^2]."""
LEAST_FLIGHT = 0.03


@dataclass
class Sampled:
    """The curve of an act in straight pieces."""

    curve: Curve | None = None
    spans: list["Span"] = field(default_factory=list)  # the phases
    points: np.ndarray = field(default_factory=lambda: np.zeros((0, PIECES + 1, 3)))  # (m, PIECES + 1, 3) along each segment
    apexes: list["Apex"] = field(default_factory=list)
    ghosts: dict[int, np.ndarray] = field(default_factory=dict)  # contact: (B, 2, 3) ends of bones

    def look(self, act: Act) -> None:
        """Takes another motion."""
        if self.curve is act.motion.curve:
            return
        self.curve, self.ghosts = act.motion.curve, {}
        self.spans, self.points = spans_of(act.motion.curve), points_of(act.motion.curve)
        self.apexes = apexes_of(act)


class Span(NamedTuple):
    """A phase of support."""

    phase: int
    begin: float  # [s]
    end: float
    first: int  # its segments of the curve
    last: int  # one beyond


@dataclass(frozen=True)
class Apex:
    """The highest point of a flight."""

    number: int  # of the footprint that it leaves
    place: np.ndarray  # (3,) [m]
    flight: float  # [s]


def points_of(curve: Curve) -> np.ndarray:
    """(m, PIECES + 1, 3) places along each segment."""
    s = np.linspace(0, 1, PIECES + 1)
    duration = np.diff(curve.time)[:, None, None]
    h = (2 * s**3 - 3 * s**2 + 1, s**3 - 2 * s**2 + s, 3 * s**2 - 2 * s**3, s**3 - s**2)
    a, b = curve.control[:-1, None], curve.control[1:, None]
    p = h[0][:, None] * a[..., :3] + duration * h[1][:, None] * a[..., 3:]
    return np.asarray(p + h[2][:, None] * b[..., :3] + duration * h[3][:, None] * b[..., 3:])


def spans_of(curve: Curve) -> list[Span]:
    """The phases of a curve, one after the other."""
    support = curve.support[:-1]
    begin = np.concatenate([[0], np.flatnonzero((support[1:] != support[:-1]).any(axis=1)) + 1])
    end = np.append(begin[1:], len(support))
    which = [phases.phase_of(left, right) for left, right in support[begin].tolist()]
    times = curve.time.tolist()
    return [Span(k, times[a], times[b], a, b) for k, a, b in zip(which, begin.tolist(), end.tolist(), strict=True)]


def apexes_of(act: Act) -> list[Apex]:
    """The highest points of the flights, but the briefest."""
    curve, contact = act.motion.curve, act.motion.footprints.contact_time
    row, found = act.laid.row, []
    for i in np.flatnonzero((curve.support[:-1] < 0).all(axis=1)):
        flight = float(curve.time[i + 1] - curve.time[i])
        if flight < LEAST_FLIGHT:
            continue
        points = points_of(Curve(curve.time[i : i + 2], curve.control[i : i + 2], curve.support[i : i + 2]))[0]
        left = int(np.searchsorted(contact, curve.time[i], side="right")) - 1
        number = int(np.searchsorted(row, left, side="right")) - 1
        found.append(Apex(number, points[points[:, 2].argmax()], flight))
    return found


def flight_for(rise: float) -> float:
    """The time of a flight [s] that rises so far [m] above where it begins: g t^2 / 8."""
    return float(np.sqrt(8 * max(rise, 1e-4) / GRAVITY))


def draw_curve(pen: Pen, sampled: Sampled) -> None:
    """The curve in the colours of its phases."""
    draw, canvas, scale = pen
    if not sampled.spans:
        return
    places, each = canvas.project(sampled.points.reshape(-1, 3)), sampled.points.shape[1]
    first, last = each * np.array([(span.first, span.last) for span in sampled.spans]).T
    seen = _seen(places, first, last)
    for k in np.flatnonzero(inside(canvas.box, places[first], 200.0)):
        line = places[first[k] : last[k]][seen[first[k] : last[k]]]
        draw_line(draw, line, theme.PHASES[sampled.spans[k].phase], 0.95, 2.2 * scale)


def _seen(places: np.ndarray, first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """(N,) bool: the screen places (N, 2) of a curve that are FINE apart along it, and the ends of each of its spans."""
    way = np.cumsum(np.nan_to_num(np.hypot(*np.diff(places, axis=0).T)))
    seen = np.diff(np.floor(way / FINE), prepend=[0.0, 0.0]) > 0
    seen[first] = seen[last - 1] = True
    return seen


def draw_apexes(pen: Pen, sampled: Sampled) -> None:
    """Diamonds on the highest points of flights: they can be dragged up and down in space."""
    draw, canvas, scale = pen
    if canvas.flat or not sampled.apexes:
        return
    for place in canvas.project(np.array([one.place for one in sampled.apexes])):
        if np.isfinite(place).all():
            x, y, r = float(place[0]), float(place[1]), 5 * scale
            draw.add_quad_filled((x - r, y), (x, y - r), (x + r, y), (x, y + r), ink(theme.PHASES[phases.FLIGHT]))


def pull_places(act: Act) -> np.ndarray:
    """(P, 3) where pulls want the com."""
    return np.array([one.place for one in act.pulls], np.float64).reshape(-1, 3)


def draw_pulls(pen: Pen, act: Act, com: np.ndarray) -> None:
    """Where pulls want the com, joined to where it is then, com (P, 3)."""
    draw, canvas, scale = pen
    if not len(act.pulls):
        return
    for there, here in zip(canvas.project(pull_places(act)), canvas.project(com), strict=True):
        if np.isfinite(there).all() and np.isfinite(here).all():
            draw.add_line(vector(there), vector(here), ink(theme.COM_PULL, 0.6), 1.4 * scale)
            draw.add_circle_filled(vector(there), 5.5 * scale, ink(theme.COM_PULL))


def pull_times(act: Act) -> list[float]:
    """The times [s] of an act's pulls."""
    return [time_of(act.laid, one.footprint, one.after) for one in act.track.pull if one.footprint < len(act.laid.row)]


def ghosts_near(show: Rehearsal, c: int, sampled: Sampled, time: float) -> list[np.ndarray]:
    """The bones at the contacts nearest to a time, (B, 2, 3) each."""
    contact = show.acts[c].motion.footprints.contact_time
    wanted = np.sort(np.argsort(np.abs(contact - time))[:GHOSTS])
    for i in wanted:
        if int(i) not in sampled.ghosts:
            at = placed(show.bones(c, float(contact[i])), show.skeleton(c))
            sampled.ghosts[int(i)] = np.stack([at.head[0], at.tip[0]], axis=1)
    return [sampled.ghosts[int(i)] for i in wanted]


def draw_ghosts(pen: Pen, ghosts: list[np.ndarray]) -> None:
    """Onion skins: the bones at contacts, as thin lines."""
    draw, canvas, scale = pen
    for bones in ghosts:
        ends = canvas.project(bones.reshape(-1, 3)).reshape(-1, 2, 2)
        for a, b in ends[np.isfinite(ends).all(axis=(1, 2))]:
            draw.add_line(vector(a), vector(b), ink(theme.TEXT, 0.28), 2.2 * scale)


def draw_force(pen: Pen, start: np.ndarray, force: np.ndarray, colour: theme.Colour) -> None:
    """An arrow of a force per mass (3,) [m/s^2] that acts at a place (3,)."""
    draw, canvas, scale = pen
    size = float(np.linalg.norm(force))
    if size < 0.3:
        return
    a, b = canvas.project(np.array([start, start + FORCE * force]))
    if not np.isfinite([a, b]).all() or np.linalg.norm(b - a) < 3:
        return
    along = (b - a) / np.linalg.norm(b - a)
    across, r = np.array([-along[1], along[0]]), 5 * scale
    draw.add_line(vector(a), vector(b - r * along), ink(colour, 0.95), 2.6 * scale)
    draw.add_triangle_filled(
        vector(b), vector(b - 2 * r * along + r * across), vector(b - 2 * r * along - r * across), ink(colour)
    )
