"""What both views draw over their picture: prints, handles, timing daggers, paths, the curve, ghosts, pulls, forces.

Everything is computed for all footprints at once and drawn one by one where it is in view. A dagger is the paper's (Fig. 3):
its blade is as long as the stance, its crossbar lies where the next foot lands.
"""

from typing import Any, NamedTuple

import numpy as np
from imgui_bundle import imgui

from motion.track.footprints import SIDES
from planner.script.acting import Act
from planner.script.path import hermite_path
from sim.files.studio.document import Document, Spot, footprints_in
from sim.files.studio.paths import tangents_of
from sim.view import theme
from sim.view.studio.table.canvas import Box, Canvas
from sim.view.theme import ink
from worlds.queries import terrain_height
from worlds.world import World

AHEAD = 1.35
"""The orientation handle lies so many half soles ahead."""
BLADE = 0.55
"""Length of a dagger [m/s]."""
SIDES_OF_SOLE = 12
TANGENT = 1 / 3
"""Of a path's tangent, that its handle shows, as of a Bezier curve."""


class Prints(NamedTuple):
    """The footprints of a track as they are drawn, (N, ...)."""

    track: int
    side: np.ndarray  # 0 left, 1 right
    place: np.ndarray  # (N, 3) [m]
    heading: np.ndarray  # [rad]
    normal: np.ndarray  # (N, 3) of the ground under the soles
    stance: np.ndarray  # stance time [s]
    step: np.ndarray  # step time [s]
    contact: np.ndarray  # [s]
    pinned: np.ndarray  # bool
    half: float  # of the sole's length [m]
    wide: float  # half its width

    @property
    def ahead(self) -> np.ndarray:
        """(N, 3) where the orientation handles are."""
        return self.place + AHEAD * 2 * self.half * _flat(self.heading)

    @property
    def out(self) -> np.ndarray:
        """(N, 3) unit directions away from the other foot: daggers point there."""
        return (1 - 2 * self.side)[:, None] * _flat(self.heading + 0.5 * np.pi)

    def blade(self, seconds: np.ndarray) -> np.ndarray:
        """(N, 3) points of the daggers at so many seconds."""
        return self.place + (1.4 * self.wide + BLADE * seconds)[:, None] * self.out


class Pen(NamedTuple):
    """What is drawn with: a list of imgui's, the view that it is in, and how large things are."""

    draw: imgui.ImDrawList
    canvas: Canvas
    scale: float


def _flat(angle: np.ndarray) -> np.ndarray:
    return np.stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)], axis=1)


def _along(heading: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """(N, 3) directions over ground with a normal, as seen from above in these headings."""
    flat = _flat(heading)
    flat[:, 2] = -(flat[:, :2] * normal[:, :2]).sum(axis=1) / np.maximum(normal[:, 2], 0.2)
    return flat


def prints_of(document: Document, k: int, act: Act, world: World) -> Prints:
    """The footprints of a track; where the act is of another state, as far as it goes."""
    order = footprints_in(document.tracks[k])
    n, rows, laid = len(order), act.laid.row, act.motion.footprints
    place = np.empty((n, 3))
    for i, one in enumerate(order):
        x, y = one.footprint.position
        place[i] = x, y, 0.0 if i < len(rows) else terrain_height(world.arrays, x, y)
    known, normal = rows[: min(n, len(rows))], np.tile((0.0, 0.0, 1.0), (n, 1))
    place[: len(known), 2], normal[: len(known)] = laid.position[known, 2], laid.normal[known]
    times = np.zeros((3, n))
    for row, values in zip(times, (laid.stance_time, laid.step_time, laid.contact_time), strict=True):
        row[: len(known)] = values[known]
    given = [one.footprint for one in order]
    side, heading = [SIDES.index(one.side) for one in given], [one.heading_deg for one in given]
    pinned = [one.at is not None for one in given]
    foot = act.character.biped.foot
    return Prints(
        k, np.array(side, int), place, np.radians(heading), normal, times[0], times[1], times[2], np.array(pinned, bool),
        0.5 * float(foot.length), 0.5 * float(foot.width),
    )  # fmt: skip


def outlines(prints: Prints, grow: float = 1.0) -> np.ndarray:
    """(N, SIDES_OF_SOLE, 3) outlines of soles: narrower at the heel, round at the toes."""
    angle = np.linspace(0, 2 * np.pi, SIDES_OF_SOLE, endpoint=False)
    along, across = np.cos(angle), np.sin(angle) * (0.82 + 0.22 * np.cos(angle))
    forward, left = (_along(direction, prints.normal) for direction in (prints.heading, prints.heading + 0.5 * np.pi))
    outline = grow * prints.half * along[None, :, None] * forward[:, None, :]
    outline = outline + grow * prints.wide * across[None, :, None] * left[:, None, :]
    return np.asarray(prints.place[:, None, :] + outline)


def vector(point: np.ndarray) -> Any:
    """A place of the screen for imgui."""
    return imgui.ImVec2(float(point[0]), float(point[1]))


def inside(box: Box, points: np.ndarray, margin: float = 40.0) -> np.ndarray:
    """(N,) whether screen places are in a box, or nearly."""
    with np.errstate(invalid="ignore"):
        x, y = points[:, 0], points[:, 1]
        return np.asarray(
            (x > box.x - margin) & (x < box.x + box.width + margin) & (y > box.y - margin) & (y < box.y + box.height + margin)
        )


def draw_prints(pen: Pen, prints: Prints, selected: set[Spot], hovered: Spot | None) -> None:
    """The soles, their numbers, and, of those chosen, the handles."""
    draw, canvas, scale = pen
    if not len(prints.side):
        return
    middles = canvas.project(prints.place)
    seen = np.flatnonzero(inside(canvas.box, middles))
    size = canvas.size_at(prints.place[seen[0]]) * 2 * prints.half if len(seen) else 0.0
    outline = canvas.project(outlines(prints).reshape(-1, 3)).reshape(len(prints.side), -1, 2)
    for i in seen:
        spot, colour = Spot(prints.track, int(i)), theme.SIDES[int(prints.side[i])]
        chosen = spot in selected
        if size < 6 * scale and not chosen:
            draw.add_circle_filled(vector(middles[i]), 2.5 * scale, ink(colour, 0.9))
            continue
        points = [vector(one) for one in outline[i]]
        draw.add_convex_poly_filled(points, ink(colour, 0.85 if chosen or spot == hovered else 0.55))
        if chosen or spot == hovered:
            draw.add_polyline(points, ink(theme.ACCENT if chosen else theme.TEXT), 1.6 * scale, imgui.ImDrawFlags_.closed)
        if prints.pinned[i]:
            draw.add_circle_filled(vector(middles[i]), 4 * scale, ink(theme.PINNED))
        if size > 26 * scale and canvas.flat:
            text = str(int(i))
            where = middles[i] - 0.5 * np.array([7.0 * len(text), 14.0]) * scale
            draw.add_text(vector(where), ink((1, 1, 1), 0.85), text)


def draw_handles(pen: Pen, prints: Prints, selected: set[Spot], daggers: bool) -> None:
    """Orientation handles of what is chosen, and the timing daggers."""
    draw, canvas, scale = pen
    if not len(prints.side):
        return
    parts = (prints.place, prints.ahead, prints.blade(np.zeros_like(prints.stance)), prints.blade(prints.stance))
    start, ahead, hilt, tip = (canvas.project(part) for part in parts)
    cross, along = prints.blade(prints.step), 0.07 * _flat(prints.heading)
    bar = canvas.project(np.concatenate([cross - along, cross + along])).reshape(2, -1, 2)
    for i in np.flatnonzero(inside(canvas.box, start, 120.0)):
        chosen = Spot(prints.track, int(i)) in selected
        if (
            daggers
            and np.isfinite(tip[i]).all()
            and np.isfinite(bar[:, i]).all()
            and (chosen or canvas.size_at(prints.place[i]) > 45 * scale)
        ):
            shade = ink(theme.ACCENT if chosen else theme.FAINT, 0.95 if chosen else 0.45)
            draw.add_line(vector(hilt[i]), vector(tip[i]), shade, (2.4 if chosen else 1.4) * scale)
            draw.add_line(vector(bar[0, i]), vector(bar[1, i]), shade, (2.4 if chosen else 1.4) * scale)
            if chosen:
                draw.add_circle_filled(vector(tip[i]), 4.5 * scale, ink(theme.ACCENT))
                draw.add_rect_filled(
                    vector(bar[:, i].mean(axis=0) - 4 * scale),
                    vector(bar[:, i].mean(axis=0) + 4 * scale),
                    ink(theme.ACCENT),
                    1.5,
                )
        if chosen and np.isfinite(ahead[i]).all():
            draw.add_line(vector(start[i]), vector(ahead[i]), ink(theme.PINNED, 0.8), 1.5 * scale)
            draw.add_circle_filled(vector(ahead[i]), 5 * scale, ink(theme.PINNED))


def path_points(document: Document, k: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """(points, ends of the tangents' handles) (P, 2) of each path of a track [m]."""
    found = []
    for path in document.tracks[k].path:
        points = np.array(path.points, np.float64)
        found.append((points, points + TANGENT * np.array(tangents_of(path))))
    return found


def on_ground(world: World, points: np.ndarray) -> np.ndarray:
    """Points (N, 2) with their heights, (N, 3) [m]."""
    heights = [terrain_height(world.arrays, float(x), float(y)) for x, y in points]
    return np.column_stack([points, heights])


def draw_paths(pen: Pen, document: Document, k: int, chosen: int, world: World) -> None:
    """The paths of a track, and of the one chosen its points and tangents."""
    draw, canvas, scale = pen
    for n, (path, (points, ends)) in enumerate(zip(document.tracks[k].path, path_points(document, k), strict=True)):
        line = canvas.project(on_ground(world, hermite_path(path.points, tangents_of(path))[::4]))
        draw_line(draw, line, theme.PATH, 0.9 if n == chosen else 0.45, (2.2 if n == chosen else 1.6) * scale)
        marks = canvas.project(on_ground(world, points))
        for i, mark in enumerate(marks):
            if np.isfinite(mark).all():
                draw.add_circle_filled(vector(mark), (5.5 if n == chosen else 4.0) * scale, ink(theme.PATH))
            if n == chosen:
                end = canvas.project(on_ground(world, ends[i : i + 1]))[0]
                if np.isfinite(end).all() and np.isfinite(mark).all():
                    draw.add_line(vector(mark), vector(end), ink(theme.PATH, 0.6), 1.2 * scale)
                    draw.add_circle(vector(end), 4.5 * scale, ink(theme.PATH), 12, 1.6 * scale)


def draw_line(draw: imgui.ImDrawList, points: np.ndarray, colour: theme.Colour, alpha: float, width: float) -> None:
    """A line through those of the screen places (N, 2) that are there."""
    known = points[np.isfinite(points).all(axis=1)]
    if len(known) > 1:
        draw.add_polyline([imgui.ImVec2(x, y) for x, y in known.tolist()], ink(colour, alpha), width, 0)
