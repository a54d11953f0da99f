"""What the mouse does in the two views: it chooses, drags, draws boxes and paths, places footprints, and moves the cameras."""

import numpy as np

from planner.script.path import hermite_path
from sim.files.studio.document import Spot
from sim.files.studio.edits import Place
from sim.files.studio.paths import AddPoint, DrawPath, tangents_of
from sim.view.studio.desk import desk as desks
from sim.view.studio.desk.desk import Desk
from sim.view.studio.table import grips, marks
from sim.view.studio.table.canvas import Canvas, Plan, Space
from sim.view.studio.table.grips import Drag, Grip
from sim.view.studio.table.views import Views

STILL = 4.0
"""A press and release no more than so many pixels apart is a click."""


class Hands:
    """The mouse, on the views."""

    def __init__(self, views: Views) -> None:
        self.views = views

    def press(self, desk: Desk, button: int, x: float, y: float, shift: bool, scale: float) -> bool:
        """A mouse button went down; whether that was in a view."""
        canvas = self.at(desk, x, y)
        if canvas is None:
            return False
        mouse = np.array([x, y], float)
        ground = canvas.ground(desk.show.world, x, y)
        grip = None
        if button == 1 and desk.tool == desks.SELECT:
            grip = grips.grip_at(desk, canvas, self.views.prints, self.views.sampled, mouse, scale)
            self._choose(desk, grip, shift)
        self.views.drag = Drag(canvas, button, mouse, mouse, grip, ground or (0.0, 0.0), shift)
        return True

    def _choose(self, desk: Desk, grip: Grip | None, shift: bool) -> None:
        """A click on a footprint chooses it; with shift, it as well, or no longer."""
        if grip is None or grip.spot is None:
            return
        if shift:
            desk.selection ^= {grip.spot}
        elif grip.spot not in desk.selection:
            desk.selection = {grip.spot}
        desk.track, desk.path = grip.spot.track, -1

    def at(self, desk: Desk, x: float, y: float) -> Canvas | None:
        """The view under the mouse."""
        for canvas, on in ((self.views.space, desk.shown.space), (self.views.plan, desk.shown.plan)):
            if on and canvas.box.holds(x, y):
                return canvas
        return None

    def move(self, desk: Desk, x: float, y: float, scale: float) -> None:
        """The mouse moved."""
        self.views.mouse = np.array([x, y], float)
        drag = self.views.drag
        if drag is None:
            canvas = self.at(desk, x, y)
            grip = (
                grips.grip_at(desk, canvas, self.views.prints, self.views.sampled, self.views.mouse, scale) if canvas else None
            )
            self.views.hovered = grip.spot if grip else None
            return
        dx, dy = (self.views.mouse - drag.last).tolist()
        drag.moved = drag.moved or float(np.abs(self.views.mouse - drag.start).max()) > STILL * scale
        drag.last = self.views.mouse
        if drag.button != 1:
            self._camera(drag, dx, dy)
        elif drag.grip and drag.moved:
            self._pull(desk, drag)
        elif drag.moved and desk.tool == desks.SELECT and isinstance(drag.canvas, Space):
            self.views.space.camera.orbit(dx, dy)
            drag.start = self.views.mouse

    def _camera(self, drag: Drag, dx: float, dy: float) -> None:
        if isinstance(drag.canvas, Space) and drag.button == 3:
            drag.canvas.camera.orbit(dx, dy)
        else:
            drag.canvas.pan(dx, dy)

    def _pull(self, desk: Desk, drag: Drag) -> None:
        """The grip follows the mouse."""
        ground = drag.canvas.ground(desk.show.world, *self.views.mouse.tolist())
        assert drag.grip is not None
        if ground is None:
            ground = drag.taken
        way = (float(self.views.mouse[0] - drag.start[0]), float(self.views.mouse[1] - drag.start[1]))
        edit = drag.grip.pull(ground, way)
        if edit is not None:
            desk.preview(edit)

    def release(self, desk: Desk, x: float, y: float) -> None:
        """The mouse button went up: an edit is done, a box chooses, a click places or draws."""
        drag, self.views.drag = self.views.drag, None
        if drag is None:
            return
        if desk.dragging:
            desk.drop()
        elif drag.button == 1 and not drag.moved and drag.grip is None:
            self._click(desk, drag)
        elif drag.button == 1 and drag.grip is None and isinstance(drag.canvas, Plan):
            found = grips.boxed(drag.canvas, self.views.prints, drag.start, np.array([x, y], float))
            desk.selection = desk.selection | found if drag.more else found

    def _click(self, desk: Desk, drag: Drag) -> None:
        """A click on the ground."""
        ground = drag.canvas.ground(desk.show.world, *drag.start.tolist())
        if ground is None:
            return
        place = (round(ground[0], 4), round(ground[1], 4))
        if desk.tool == desks.PLACE:
            own = self.views.prints[desk.track]
            heading = round(grips.next_heading(desk.document, own, place), 2)
            if desk.do(Place(desk.track, len(own.side) - 1, place, heading)):
                desk.selection = {Spot(desk.track, len(own.side))}
        elif desk.tool == desks.DRAW:
            desk.drawn.append(place)
        elif not drag.more:
            desk.selection = set()
            desk.path = self._path_at(desk, drag)

    def _path_at(self, desk: Desk, drag: Drag) -> int:
        """The path whose line was clicked, -1 for none."""
        for n, path in enumerate(desk.document.tracks[desk.track].path):
            line = hermite_path(path.points, tangents_of(path))
            places = drag.canvas.project(marks.on_ground(desk.show.world, line[::2]))
            away = np.linalg.norm(places - drag.start, axis=1)
            if np.nanmin(away, initial=np.inf) < 9:
                return n
        return -1

    def finish_path(self, desk: Desk) -> None:
        """The path that is drawn is done: another one, or more points of the one chosen."""
        points, desk.drawn, desk.tool = tuple(desk.drawn), [], desks.SELECT
        if desk.path >= 0 and points:
            for point in points:
                desk.do(
                    AddPoint(desk.track, desk.path, len(desk.document.tracks[desk.track].path[desk.path].points) - 1, point)
                )
        elif len(points) > 1:
            step = float(desk.act(desk.track).character.biped.gait.preferred_step)
            if desk.do(DrawPath(desk.track, points, round(step, 3))):
                desk.path = len(desk.document.tracks[desk.track].path) - 1

    def wheel(self, desk: Desk, clicks: float, x: float, y: float, scale: float) -> bool:
        """The wheel turned; whether that was in a view."""
        canvas = self.at(desk, x, y)
        if isinstance(canvas, Plan):
            canvas.wheel(clicks, x, y, scale)
        elif canvas is not None:
            canvas.wheel(clicks)
        return canvas is not None
