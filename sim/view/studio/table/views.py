"""The two views of the document, plan and space: as they are drawn; what the mouse does in them is in table.hands."""

from typing import Any

import numpy as np
from imgui_bundle import imgui

from motion.measures.forces import needed_force, supporting_forces
from planner.script.path import hermite_path
from planner.script.track import Track
from sim.files.studio.document import Spot, footprints_in
from sim.view import theme
from sim.view.studio.desk import desk as desks
from sim.view.studio.desk.desk import Desk
from sim.view.studio.table import grips, marks, motions
from sim.view.studio.table.canvas import Canvas, Plan, Space
from sim.view.studio.table.grips import Drag
from sim.view.studio.table.ground import draw_ground
from sim.view.studio.table.layout import Layout
from sim.view.studio.table.marks import Pen, Prints
from sim.view.studio.table.motions import Sampled
from sim.view.theme import ink

FAR, NEAR = 9.0, 5.0
"""A scene longer than FAR [m] is not shown as a whole in space: who walks is, as if it were NEAR."""


MARGIN = 0.3
"""Around what the plan shows [m]."""


class Views:
    """Plan and space, and what is drawn in both."""

    def __init__(self) -> None:
        self.plan, self.space = Plan(), Space()
        self.prints: list[Prints] = []
        self.sampled: list[Sampled] = []
        self.mouse = np.full(2, -1.0)
        self.drag: Drag | None = None
        self.hovered: Spot | None = None
        self._known: list[tuple[Track, object]] = []
        self._framed = 0  # the document that was shown whole, by how many there were
        self._com: np.ndarray | None = None
        self._time = 0.0

    def canvases(self, layout: Layout) -> list[Canvas]:
        """The views that are shown, laid into their rectangles."""
        found: list[Canvas] = []
        for canvas, box in ((self.plan, layout.plan), (self.space, layout.space)):
            if box is not None:
                canvas.box = box
                found.append(canvas)
        self.space.look()
        return found

    def look(self, desk: Desk) -> None:
        """Takes what has changed."""
        tracks = desk.document.tracks
        known = [(track, desk.act(k)) for k, track in enumerate(tracks) if k < len(desk.show.acts)]
        pairs = zip(known, self._known, strict=False)
        if len(known) == len(self._known) and all(a is c and b is d for (a, b), (c, d) in pairs):
            return
        self._known = list(known)
        self.prints = [marks.prints_of(desk.document, k, act, desk.show.world) for k, (_, act) in enumerate(known)]
        self.sampled = self.sampled[: len(known)] + [Sampled() for _ in range(len(known) - len(self.sampled))]
        for sampled, (_, act) in zip(self.sampled, known, strict=True):
            sampled.look(act)

    def frame(self, desk: Desk, scale: float) -> None:
        """Shows everything, or what is chosen."""
        places = [one.place for one in self.prints if len(one.place)]
        chosen = [self.prints[s.track].place[s.number] for s in desk.spots]
        size = np.array([*desk.show.world.size, 0.0])
        every = np.concatenate(places) if places else np.array([0.3 * size, 0.7 * size])
        points = np.array(chosen) if len(chosen) > 1 else every
        self.plan.frame(points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN, scale)
        self._com = None
        camera = self.space.camera
        span = float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))
        camera.target = 0.5 * (points.min(axis=0) + points.max(axis=0)) + np.array([0.0, 0.0, 0.6])
        if span > FAR:
            camera.target = desk.show.com(desk.playing.time)[desk.track] + np.array([0.8, 0.0, -0.2])
            span = NEAR
        camera.distance, camera.azimuth, camera.elevation = float(np.clip(0.95 * span, 3.6, 30.0)), -1.2, 0.24

    def follow(self, desk: Desk) -> None:
        """The camera goes with who is edited, as the time that is shown changes; edits leave it where it is."""
        com = desk.show.com(desk.playing.time)[desk.track]
        if self._com is not None and self._time != desk.playing.time and desk.shown.follow:
            self.space.camera.target = self.space.camera.target + com - self._com
        self._com, self._time = com, desk.playing.time

    def draw(self, draw: imgui.ImDrawList, desk: Desk, layout: Layout, picture: Any, hints: bool) -> None:
        """One frame: the picture of space lies under its marks."""
        shown = self.canvases(layout)
        if self._framed != desk.taken:
            self._framed = desk.taken
            self.frame(desk, layout.scale)
            self.space.look()
        for canvas in shown:
            box = canvas.box
            draw.push_clip_rect((box.x, box.y), (box.x + box.width, box.y + box.height), True)
            if isinstance(canvas, Plan):
                draw_ground(draw, canvas, desk.show.world, layout.scale)
            elif picture is not None:
                draw.add_image(picture, (box.x, box.y), (box.x + box.width, box.y + box.height), (0, 1), (1, 0))
            self._marks(Pen(draw, canvas, layout.scale), desk)
            if hints and canvas is shown[0]:
                self._hint(draw, canvas, desk, layout.scale)
            draw.pop_clip_rect()

    def _marks(self, pen: Pen, desk: Desk) -> None:
        """What is drawn over a view."""
        document, world, time = desk.document, desk.show.world, desk.playing.time
        for k in range(len(self.prints)):
            marks.draw_paths(pen, document, k, desk.path if k == desk.track else -1, world)
            marks.draw_prints(pen, self.prints[k], desk.selection, self.hovered)
            if desk.shown.curve:
                motions.draw_curve(pen, self.sampled[k])
            if desk.shown.ghosts:
                motions.draw_ghosts(pen, motions.ghosts_near(desk.show, k, self.sampled[k], time))
            marks.draw_handles(pen, self.prints[k], desk.selection, desk.shown.daggers and k == desk.track)
            motions.draw_apexes(pen, self.sampled[k])
            act = desk.act(k)
            if act.pulls:
                com = np.array([desk.show.com(t)[k] for t in motions.pull_times(act)])
                motions.draw_pulls(pen, act, com)
            self._moment(pen, desk, k, time)
        self._tools(pen, desk)

    def _moment(self, pen: Pen, desk: Desk, k: int, time: float) -> None:
        """The centre of mass now, and the forces on it."""
        pose = desk.show.snapshot(time, np.array([k]))
        here = pen.canvas.project(pose.com)[0]
        if pen.canvas.flat and np.isfinite(here).all():
            pen.draw.add_circle_filled(marks.vector(here), 5 * pen.scale, ink((1, 1, 1)))
            pen.draw.add_circle(marks.vector(here), 5 * pen.scale, ink(theme.TABLE), 16, 1.5)
        if desk.shown.forces:
            given = supporting_forces(pose.com, pose.com_acceleration, pose.point_of_support, pose.contact)[0]
            for leg in np.flatnonzero(pose.contact[0]):
                motions.draw_force(pen, pose.point_of_support[0, leg], given[leg], theme.SIDES[leg])
            missing = needed_force(pose.com_acceleration)[0] - given.sum(axis=0)
            motions.draw_force(pen, pose.com[0], missing, theme.ACCENT)

    def _tools(self, pen: Pen, desk: Desk) -> None:
        """The box that is drawn, the path that is drawn, the print that would be placed."""
        canvas, drag = pen.canvas, self.drag
        if (
            drag
            and drag.canvas is canvas
            and drag.button == 1
            and drag.grip is None
            and drag.moved
            and desk.tool == desks.SELECT
        ):
            pen.draw.add_rect_filled(marks.vector(drag.start), marks.vector(drag.last), ink(theme.ACCENT, 0.12))
            pen.draw.add_rect(marks.vector(drag.start), marks.vector(drag.last), ink(theme.ACCENT, 0.8))
        if desk.drawn:
            line = hermite_path(desk.drawn) if len(desk.drawn) > 1 else np.array(desk.drawn)
            marks.draw_line(pen.draw, canvas.project(marks.on_ground(desk.show.world, line)), theme.PATH, 0.9, 2 * pen.scale)
            for place in canvas.project(marks.on_ground(desk.show.world, np.array(desk.drawn))):
                if np.isfinite(place).all():
                    pen.draw.add_circle_filled(marks.vector(place), 5 * pen.scale, ink(theme.PATH))
        if desk.tool == desks.PLACE and canvas.box.holds(*self.mouse):
            ground = canvas.ground(desk.show.world, *self.mouse)
            if ground and desk.track < len(self.prints):
                self._next(pen, desk, ground)

    def _next(self, pen: Pen, desk: Desk, ground: tuple[float, float]) -> None:
        """The footprint that a click would place."""
        own = self.prints[desk.track]
        order = footprints_in(desk.document.tracks[desk.track])
        side = 0 if not order or order[-1].footprint.side == "right" else 1
        heading = np.radians(grips.next_heading(desk.document, own, ground))
        one = own._replace(
            side=np.array([side]),
            place=marks.on_ground(desk.show.world, np.array([ground])),
            heading=np.array([heading]),
            normal=np.array([[0.0, 0.0, 1.0]]),
        )
        outline = pen.canvas.project(marks.outlines(one)[0])
        if np.isfinite(outline).all():
            pen.draw.add_convex_poly_filled([marks.vector(p) for p in outline], ink(theme.SIDES[side], 0.35))

    def _hint(self, draw: imgui.ImDrawList, canvas: Canvas, desk: Desk, scale: float) -> None:
        """What to do, where nothing is there yet."""
        if any(len(one.side) for one in self.prints) or desk.drawn:
            return
        words = (
            "Press N, then click where the feet shall stand" if desk.tool == desks.SELECT else "Click: left, right, left ..."
        )
        box, wide = canvas.box, imgui.calc_text_size(words).x
        draw.add_text((box.x + 0.5 * (box.width - wide), box.y + 0.2 * box.height), ink(theme.FAINT), words)
