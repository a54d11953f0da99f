"""The studio: events in, edits and time on, pictures out."""

import time as clock
from collections.abc import Callable
from types import ModuleType
from typing import Any

from imgui_bundle import imgui

from sim.view.studio.bars import overlays
from sim.view.studio.bars.inspector import Inspector
from sim.view.studio.bars.menus import Menus
from sim.view.studio.bars.timeline import Timeline
from sim.view.studio.desk.desk import DRAW, Desk
from sim.view.studio.desk.keys import pressed
from sim.view.studio.screen import StudioScreen
from sim.view.studio.table.gizmo import Gizmo
from sim.view.studio.table.hands import Hands
from sim.view.studio.table.layout import BAR, STRIP, Layout, Splits, layout_of
from sim.view.studio.table.views import Views
from sim.view.studio.typing import typed_into
from sim.view.window.window import typed

FRAME = 1 / 60
GRAB = 5.0
"""Pixels at scale 1 within which a border between two parts is taken."""
ALT, CTRL, SHIFT = 0x0300, 0x00C0 | 0x0C00, 0x0003
"""pygame's masks of modifier keys; Ctrl, or the command key of a Mac."""


class Studio:
    """The window and all that is in it."""

    def __init__(self, pygame: ModuleType, size: tuple[int, int], desk: Desk, scale: float = 1.0) -> None:
        self.pygame, self.desk = pygame, desk
        self.screen = StudioScreen(pygame, size, scale)
        self.views, self.timeline, self.menus, self.inspector = Views(), Timeline(), Menus(), Inspector()
        self.hands, self.splits = Hands(self.views), Splits()
        self.layout: Layout = layout_of(size, 24 * scale, scale, desk.shown, self.splits)
        self.gizmo, self.busy, self.border = Gizmo(), 0.0, ""

    def handle(self, event: Any) -> None:
        """One pygame event."""
        pg, io = self.pygame, imgui.get_io()
        if event.type == pg.QUIT:
            self.desk.asked = "quit"
        elif event.type == pg.VIDEORESIZE:
            self.screen.resize(event.size)
        elif event.type in (pg.MOUSEMOTION, pg.MOUSEBUTTONDOWN, pg.MOUSEBUTTONUP, pg.MOUSEWHEEL):
            self._mouse(event, io)
        elif event.type in (pg.KEYDOWN, pg.KEYUP, pg.TEXTINPUT):
            typed_into(io, event, pg)
            asks = imgui.is_popup_open("", imgui.PopupFlags_.any_popup)
            if event.type == pg.KEYDOWN and not (io.want_text_input or asks):  # who is asked something answers that first
                self._key(event)

    def _key(self, event: Any) -> None:
        """A key that no field takes."""
        ctrl, shift = bool(event.mod & CTRL), bool(event.mod & SHIFT)
        name = typed(event, self.pygame)
        if ctrl:
            name = self.pygame.key.name(event.key)
        if self.desk.tool == DRAW and name == "return":
            self.hands.finish_path(self.desk)
        elif name == "f" and shift:
            self.views.look(self.desk)
            self.views.frame(self.desk, self.screen.scale)
        elif ctrl and name in ("=", "+", "-"):
            self.screen.set_scale(self.screen.scale * (1 / 1.15 if name == "-" else 1.15))
        else:
            pressed(self.desk, name, ctrl, shift)

    def _mouse(self, event: Any, io: imgui.IO) -> None:
        """The mouse: to imgui where its windows are, else to the views and the timeline."""
        pg = self.pygame
        if event.type == pg.MOUSEMOTION:
            io.add_mouse_pos_event(*event.pos)
            self._moved(*event.pos)
            return
        if event.type == pg.MOUSEWHEEL:
            io.add_mouse_wheel_event(event.x, event.y)
            if not io.want_capture_mouse:
                self._wheel(event)
            return
        if event.button > 3:
            return
        down = event.type == pg.MOUSEBUTTONDOWN
        io.add_mouse_pos_event(*event.pos)
        io.add_mouse_button_event({1: 0, 2: 2, 3: 1}[event.button], down)
        if down and (self._border(*event.pos) or not (self._over_window(io, event.pos) or self.gizmo.holds)):
            self._press(event)
        elif not down:
            self._release(event)

    def _over_window(self, io: imgui.IO, place: tuple[int, int]) -> bool:
        """Whether one of imgui's windows is there: as it was in the last frame, or by where the windows lie."""
        boxes = (self.layout.panel, self.layout.play)
        over = any(box is not None and box.holds(*place) for box in boxes)
        return over or (io.want_capture_mouse and imgui.is_any_item_hovered()) or self._popup(place)

    def _popup(self, place: tuple[int, int]) -> bool:
        popup = imgui.is_popup_open("", imgui.PopupFlags_.any_popup)
        above = min(box.y for box in (self.layout.plan, self.layout.space) if box is not None)
        return bool(popup) or self.desk.shown.help or place[1] < above

    def _border(self, x: float, y: float) -> str:
        """The border between two parts of the window that lies there."""
        layout, near = self.layout, GRAB * self.screen.scale
        if abs(y - layout.play.y) < near:
            return "timeline"
        if y < layout.play.y and layout.panel and abs(x - layout.panel.x) < near:
            return "panel"
        return "views" if layout.plan and layout.space and abs(x - layout.space.x) < near and y < layout.play.y else ""

    def _resize(self, x: float, y: float) -> None:
        """A border follows the mouse."""
        (width, height), scale, splits = self.screen.size, self.screen.scale, self.splits
        if self.border == "timeline":
            strips = STRIP if self.desk.shown.strips else 0.0
            splits.timeline = min(max((height - y) / scale - BAR - strips, 70.0), 400.0)
        elif self.border == "panel":
            splits.panel = min(max((width - x) / scale, 170.0), 500.0)
        elif self.layout.space and self.layout.plan:
            room = self.layout.space.x + self.layout.space.width - self.layout.plan.x
            splits.views = min(max((x - self.layout.plan.x) / room, 0.15), 0.85)

    def _press(self, event: Any) -> None:
        x, y = event.pos
        mods = self.pygame.key.get_mods()
        self.border = self._border(x, y) if event.button == 1 else ""
        if self.border:
            return
        if self.layout.timeline.holds(x, y):
            self.timeline.press(self.desk, x, y, bool(mods & ALT))
        elif event.button == 3 and self.desk.tool == DRAW and self.desk.drawn:
            self.hands.finish_path(self.desk)
        else:
            self.views.look(self.desk)
            self.hands.press(self.desk, event.button, x, y, bool(mods & SHIFT), self.screen.scale)

    def _moved(self, x: float, y: float) -> None:
        if self.border:
            self._resize(x, y)
        elif self.timeline.held:
            self.timeline.move(self.desk, x, bool(self.pygame.key.get_mods() & ALT))
        else:
            self.hands.move(self.desk, x, y, self.screen.scale)

    def _release(self, event: Any) -> None:
        if self.border:
            self.border = ""
        elif self.timeline.held:
            self.timeline.release(self.desk)
        else:
            self.hands.release(self.desk, *event.pos)

    def _wheel(self, event: Any) -> None:
        x, y = self.pygame.mouse.get_pos() if not hasattr(event, "pos") else event.pos
        if self.layout.timeline.holds(x, y):
            self.timeline.wheel(event.y, x, not self.pygame.key.get_mods() & SHIFT)
        else:
            self.hands.wheel(self.desk, event.y, x, y, self.screen.scale)

    def frame(self, seconds: float) -> None:
        """Lets time pass and draws."""
        begin = clock.perf_counter()
        self.desk.advance(seconds)
        self.screen.begin(seconds)
        top = self.menus.bar(self.desk)
        scale = self.screen.scale
        self.layout = layout_of(self.screen.size, top, scale, self.desk.shown, self.splits)
        self.views.look(self.desk)
        self.views.follow(self.desk)
        self.views.space.stay_above(self.desk.show.world)
        self.views.canvases(self.layout)
        picture = self.screen.picture(self.desk, self.views.space) if self.layout.space else None
        draw = imgui.get_background_draw_list()
        self.views.draw(draw, self.desk, self.layout, picture, True)
        if self.layout.space:
            self.gizmo.draw(draw, self.desk, self.views.space)
        spans = self.views.sampled[self.desk.track].spans
        self.timeline.draw(draw, self.desk, spans, self.inspector.healing.debts, self.layout)
        self.inspector.draw(self.desk, self.layout)
        if self.layout.panel is None:
            self.inspector.healing.debts.look(self.desk.show, self.desk.track, self.desk.playing.time)
        overlays.play(self.desk, self.layout)
        self.menus.asked(self.desk)
        overlays.help(self.desk, self.screen.size, scale)
        overlays.notices(imgui.get_foreground_draw_list(), self.desk, self.layout)
        self.screen.end()
        self.busy = clock.perf_counter() - begin
        self.screen.adapt(self.busy)


def run_studio(desk: Desk, size: tuple[int, int], scale: float, stop: Callable[[], bool]) -> None:
    """Opens the window and runs until it is closed, or until `stop` says so. Raises NoGL."""
    import pygame

    pygame.display.init()
    pygame.key.set_repeat(350, 60)
    studio, last = Studio(pygame, size, desk, scale), clock.perf_counter()
    while desk.running and not stop():
        for event in pygame.event.get():
            studio.handle(event)
        now = clock.perf_counter()
        studio.frame(now - last)
        last = now
        clock.sleep(max(FRAME - (clock.perf_counter() - now), 0))
    pygame.quit()
