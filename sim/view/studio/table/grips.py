"""What the mouse takes hold of in a view, and what pulling at it does: each grip makes an edit of where the mouse now is."""

from collections.abc import Callable
from dataclasses import dataclass
from math import degrees

import numpy as np

from planner.script.shaping import ComPull
from sim.files.studio.document import Document, Spot
from sim.files.studio.edits import Edit, Move, Set, Turn
from sim.files.studio.paths import BendPath
from sim.files.studio.shapes import SetShape
from sim.view.studio.desk.desk import Desk
from sim.view.studio.table.canvas import Canvas
from sim.view.studio.table.marks import BLADE, TANGENT, Prints, path_points
from sim.view.studio.table.motions import Apex, Sampled, flight_for, pull_places
from worlds.queries import terrain_height

REACH = 9.0
"""Pixels at scale 1 within which a grip is taken."""
LEAST_TIME, LONGEST_TIME = 0.02, 60.0
Ground = tuple[float, float]


@dataclass(frozen=True)
class Grip:
    """Something that can be dragged."""

    what: str  # in words, for the tooltip
    spot: Spot | None
    pull: Callable[[Ground, tuple[float, float]], Edit | None]
    """The edit for a place on the ground [m] and the way of the mouse [pixels] since it was taken."""


@dataclass
class Drag:
    """What the mouse holds in a view."""

    canvas: Canvas
    button: int
    start: np.ndarray  # (2,) where it went down
    last: np.ndarray
    grip: Grip | None = None
    taken: tuple[float, float] = (0.0, 0.0)  # the place on the ground where it was taken
    more: bool = False  # shift: adds to what is chosen
    moved: bool = False


def grip_at(
    desk: Desk, canvas: Canvas, prints: list[Prints], sampled: list[Sampled], mouse: np.ndarray, scale: float
) -> Grip | None:
    """What lies under the mouse: handles before footprints, footprints before paths."""
    reach = REACH * scale
    for one in prints:
        found = _handle(desk, canvas, one, mouse, reach)
        if found:
            return found
    special = _pull_grip(desk, canvas, mouse, reach) or _apex_grip(desk, canvas, sampled, mouse, reach)
    if desk.path >= 0:
        special = special or _path_grip(desk, canvas, mouse, reach)
    if special:
        return special
    for one in prints:
        found = _print(desk, canvas, one, mouse)
        if found:
            return found
    return _path_grip(desk, canvas, mouse, reach)


def _near(points: np.ndarray, mouse: np.ndarray, reach: float) -> int | None:
    """The nearest of the screen places (N, 2) within reach."""
    if not len(points):
        return None
    away = np.linalg.norm(points - mouse, axis=1)
    away[~np.isfinite(away)] = np.inf
    best = int(away.argmin())
    return best if away[best] <= reach else None


def _handle(desk: Desk, canvas: Canvas, prints: Prints, mouse: np.ndarray, reach: float) -> Grip | None:
    """Orientation handles and daggers of what is chosen."""
    chosen = np.array([s.number for s in desk.spots if s.track == prints.track and s.number < len(prints.side)], int)
    if not len(chosen):
        return None
    k = _near(canvas.project(prints.ahead[chosen]), mouse, reach)
    if k is not None:
        return _turning(desk, prints, int(chosen[k]))
    if not desk.shown.daggers:
        return None
    for key, seconds in (("stance_time", prints.stance), ("step_time", prints.step)):
        k = _near(canvas.project(prints.blade(seconds)[chosen]), mouse, reach)
        if k is not None:
            return _timing(desk, prints, int(chosen[k]), key)
    return None


def _turning(desk: Desk, prints: Prints, i: int) -> Grip:
    spots, place, heading = desk.spots, prints.place[i], float(prints.heading[i])

    def pull(ground: Ground, _: tuple[float, float]) -> Edit:
        angle = np.arctan2(ground[1] - place[1], ground[0] - place[0])
        return Turn(spots, degrees(float((angle - heading + np.pi) % (2 * np.pi) - np.pi)))

    return Grip("turn it", Spot(prints.track, i), pull)


def _timing(desk: Desk, prints: Prints, i: int, key: str) -> Grip:
    """The dagger: its tip is the stance time, its crossbar the step time."""
    start, out, words = prints.blade(np.zeros_like(prints.stance))[i], prints.out[i], key.replace("_", " ")
    spots = desk.spots

    def pull(ground: Ground, _: tuple[float, float]) -> Edit:
        along = (ground[0] - start[0]) * out[0] + (ground[1] - start[1]) * out[1]
        seconds = float(np.clip(along / BLADE, LEAST_TIME, LONGEST_TIME))
        return Set(spots, key, round(seconds, 4), f"Change the {words}")

    return Grip(words, Spot(prints.track, i), pull)


def _print(desk: Desk, canvas: Canvas, prints: Prints, mouse: np.ndarray) -> Grip | None:
    """A footprint under the mouse: dragging moves all that are chosen."""
    if not len(prints.side):
        return None
    size = canvas.size_at(prints.place[0]) if canvas.flat else 60.0
    k = _near(canvas.project(prints.place), mouse, max(prints.half * size, 7.0))
    return None if k is None else moving(desk, Spot(prints.track, k), prints.place[k])


def moving(desk: Desk, spot: Spot, place: np.ndarray) -> Grip:
    """Moves what is chosen, or this footprint alone where it is not."""

    def pull(ground: Ground, _: tuple[float, float]) -> Edit:
        spots = desk.spots if spot in desk.selection else (spot,)
        return Move(spots, (round(ground[0] - float(place[0]), 4), round(ground[1] - float(place[1]), 4)))

    return Grip("move it", spot, pull)


def _path_grip(desk: Desk, canvas: Canvas, mouse: np.ndarray, reach: float) -> Grip | None:
    """Points of the paths, and of the one chosen the ends of its tangents."""
    track, world = desk.track, desk.show.world
    for n, (points, ends) in enumerate(path_points(desk.document, track)):
        for tangent, places in ((False, points), (True, ends)):
            if tangent and n != desk.path:
                continue
            high = np.array([terrain_height(world.arrays, float(x), float(y)) for x, y in places])
            k = _near(canvas.project(np.column_stack([places, high])), mouse, reach)
            if k is not None:
                return _bending(desk, track, n, k, tangent, points[k])
    return None


def _bending(desk: Desk, track: int, path: int, k: int, tangent: bool, point: np.ndarray) -> Grip:
    def pull(ground: Ground, _: tuple[float, float]) -> Edit:
        to = ground
        if tangent:
            to = ((ground[0] - float(point[0])) / TANGENT, (ground[1] - float(point[1])) / TANGENT)
        desk.path = path
        return BendPath(track, path, k, to, tangent)

    return Grip("turn the tangent" if tangent else "bend the path", None, pull)


def _pull_grip(desk: Desk, canvas: Canvas, mouse: np.ndarray, reach: float) -> Grip | None:
    """Pulls on the com: over the ground in the plan, up and down in space."""
    act = desk.act(desk.track)
    if not len(act.pulls) or len(act.pulls) != len(act.track.pull):
        return None
    k = _near(canvas.project(pull_places(act)), mouse, reach)
    if k is None:
        return None
    old, size = act.track.pull[k], canvas.size_at(pull_places(act)[k])

    def pull(ground: Ground, way: tuple[float, float]) -> Edit:
        x, y, z = old.position
        place = (ground[0], ground[1], z) if canvas.flat else (x, y, z - way[1] / size)
        return SetShape(desk.track, "pull", k, ComPull(**{**dict(old), "position": place}))

    return Grip("pull the centre of mass", None, pull)


def _apex_grip(desk: Desk, canvas: Canvas, sampled: list[Sampled], mouse: np.ndarray, reach: float) -> Grip | None:
    """The top of a leap: its flight takes the time that a leap to there takes."""
    if canvas.flat or desk.track >= len(sampled) or not sampled[desk.track].apexes:
        return None
    apexes = sampled[desk.track].apexes
    k = _near(canvas.project(np.array([one.place for one in apexes])), mouse, reach)
    return None if k is None else _leaping(desk, apexes[k], canvas.size_at(apexes[k].place))


def _leaping(desk: Desk, apex: Apex, size: float) -> Grip:
    laid, number = desk.act(desk.track).laid, apex.number
    row = int(laid.row[number])
    step = float(laid.footprints.step_time[row])
    rise = 9.81 * apex.flight**2 / 8

    def pull(_: Ground, way: tuple[float, float]) -> Edit:
        flight = flight_for(rise - way[1] / size)
        return Set(
            (Spot(desk.track, number),), "step_time", round(max(step + flight - apex.flight, LEAST_TIME), 4), "Leap higher"
        )

    return Grip("drag the leap higher or lower", None, pull)


def boxed(canvas: Canvas, prints: list[Prints], corner: np.ndarray, mouse: np.ndarray) -> set[Spot]:
    """The footprints in a rectangle of the screen."""
    low, high, found = np.minimum(corner, mouse), np.maximum(corner, mouse), set[Spot]()
    for one in prints:
        if len(one.side):
            places = canvas.project(one.place)
            with np.errstate(invalid="ignore"):
                hit = ((places >= low) & (places <= high)).all(axis=1)
            found |= {Spot(one.track, int(i)) for i in np.flatnonzero(hit)}
    return found


def next_heading(document: Document, prints: Prints, ground: Ground) -> float:
    """The heading [deg] of a new footprint there: on from the last one, half turned toward the new place."""
    if not len(prints.side):
        return 0.0
    last, before = prints.place[-1], float(prints.heading[-1])
    if len(prints.side) < 2:
        return degrees(before)
    middle = 0.5 * (last + prints.place[-2])
    way = np.array(ground) - middle[:2]
    if np.linalg.norm(way) < 0.15:
        return degrees(before)
    turn = (np.arctan2(way[1], way[0]) - before + np.pi) % (2 * np.pi) - np.pi
    return degrees(before + 0.5 * float(turn)) if abs(turn) < 1.2 else degrees(before)
