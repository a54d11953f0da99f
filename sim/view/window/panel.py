"""The panel (imgui) and the live timing diagram, dressed as the studio is."""

from types import ModuleType
from typing import Any

from imgui_bundle import imgui
from imgui_bundle.python_backends.opengl_backend_programmable import ProgrammablePipelineRenderer

from motion.characters.character import character_names
from sim.view import theme
from sim.view.pictures.overlays import NAMES
from sim.view.window.app import App
from sim.view.window.choosing import places

SPAN = 3.0
"""Seconds that the timing diagram shows."""
WIDTH, EDGE, ROW = 252.0, 10.0, 20.0
"""Of the panel, around it, and the height of a row of the diagram [pixels at scale 1]."""
FIXED = imgui.WindowFlags_.no_decoration | imgui.WindowFlags_.no_inputs


class Panel:
    """Buttons for what keys do, what can be chosen, figures of the moment, and who stands when."""

    def __init__(self, pygame: ModuleType, size: tuple[int, int], scale: float = 1.0) -> None:
        self.pygame, self.scale, self.places = pygame, scale, places()
        imgui.create_context()
        imgui.get_io().set_ini_filename("")
        imgui.get_io().display_size = imgui.ImVec2(*size)
        theme.load_letters()
        theme.dress(scale)
        self.backend = ProgrammablePipelineRenderer()

    def takes(self, event: Any) -> bool:
        """Hands a mouse event to imgui; true where the mouse is over the panel."""
        io, pg = imgui.get_io(), self.pygame
        if event.type == pg.MOUSEMOTION:
            io.add_mouse_pos_event(*event.pos)
        elif event.type in (pg.MOUSEBUTTONDOWN, pg.MOUSEBUTTONUP) and event.button in (1, 2, 3):
            io.add_mouse_button_event({1: 0, 2: 2, 3: 1}[event.button], event.type == pg.MOUSEBUTTONDOWN)
        elif event.type == pg.MOUSEWHEEL:
            io.add_mouse_wheel_event(event.x, event.y)
        else:
            return False
        return io.want_capture_mouse

    def draw(self, app: App, size: tuple[int, int], rate: float) -> None:
        """Draws over the picture in the bound framebuffer."""
        io = imgui.get_io()
        io.display_size, io.delta_time = imgui.ImVec2(*size), 1 / max(rate, 1.0)
        if app.scale != self.scale:
            self.scale = app.scale
            theme.dress(self.scale)
        imgui.new_frame()
        if app.show_panel:
            self._panel(app, size, rate)
            self._diagram(app, size)
        self._notice(app, size)
        if app.show_help:
            self._help(app, size)
        imgui.render()
        self.backend.render(imgui.get_draw_data())

    def _panel(self, app: App, size: tuple[int, int], rate: float) -> None:
        """What can be done and chosen; where the window is low, it scrolls."""
        edge = EDGE * self.scale
        imgui.set_next_window_pos((edge, edge))
        room = max(size[1] - 4 * edge - 2.6 * ROW * self.scale, 3 * ROW)
        imgui.set_next_window_size_constraints((WIDTH * self.scale, 0), (WIDTH * self.scale, room))
        imgui.set_next_window_bg_alpha(0.88)
        flags = imgui.WindowFlags_.no_title_bar | imgui.WindowFlags_.no_move | imgui.WindowFlags_.always_auto_resize
        imgui.begin("Footfall", None, flags)
        sim = app.sim
        imgui.text_colored((*theme.ACCENT, 1.0), sim.world.name)
        who = f"{sim.characters[app.focus].name}, {sim.distance[app.focus]:.0f} m gone"
        if len(sim.characters) > 1:
            who = f"{app.focus + 1} of {len(sim.characters)}: {who}"
        imgui.text(who)
        seen = f", {app.in_view} in view" if len(sim.characters) > 1 else ""
        quick = f", {rate:.0f} pictures a second" if rate else ""
        imgui.text_disabled(f"{sim.time:.1f} s{quick}{seen}")
        self._buttons(app)
        self._choices(app)
        if imgui.collapsing_header("show"):
            for k, name in enumerate(NAMES):
                if k % 2:
                    imgui.same_line(0.5 * WIDTH * self.scale)
                if imgui.checkbox(name, app.show_overlays and name in app.shown)[0]:
                    app.toggle_overlay(name)
        imgui.text_disabled("h  all keys")
        imgui.end()

    def _buttons(self, app: App) -> None:
        """Rows of buttons, each of which is a key, too."""
        pause = "p" if app.driven else "space"
        rows = (
            (("go on" if app.paused else "pause", pause), ("tick", "."), ("restart", "r"), ("edit", "return")),
            (("plan", "v"), ("follow", "f"), ("all", "a"), ("stop" if app.recording else "record", "m")),
        )
        for row in rows:
            for k, (label, key) in enumerate(row):
                if k:
                    imgui.same_line()
                if imgui.button(label):
                    app.key(key)
        if app.recording:
            imgui.text_colored((*theme.WRONG, 1.0), "recording")

    def _choices(self, app: App) -> None:
        """Where, who, by which chance, and how fast."""
        imgui.push_item_width(-72 * self.scale)
        for words, names, now in (
            ("where", self.places, app.level),
            ("who", character_names(), app.sim.characters[app.focus].name),
        ):
            changed, at = imgui.combo(words, names.index(now) if now in names else -1, names)
            if changed:
                app.choose(**{"level" if words == "where" else "character": names[at]})
        changed, seed = imgui.input_int("seed", int(app.seed or 0), 1, 100, imgui.InputTextFlags_.enter_returns_true)
        if changed and seed >= 0:
            app.choose(seed=seed)
        changed, speed = imgui.slider_float("speed", app.speed, 1 / 16, 4.0, "x %.2f", imgui.SliderFlags_.logarithmic)
        if changed:
            app.speed = speed
        imgui.pop_item_width()

    def _diagram(self, app: App, size: tuple[int, int]) -> None:
        """Stances as bars, LEFT above RIGHT, the present in the middle (paper, Fig. 12)."""
        edge, row = EDGE * self.scale, ROW * self.scale
        width, height = size[0] - 2 * edge, 2.6 * row
        imgui.set_next_window_pos((edge, size[1] - height - edge))
        imgui.set_next_window_size((width, height))
        imgui.set_next_window_bg_alpha(0.6)
        imgui.begin("timing", None, FIXED)
        draw, (x0, y0) = imgui.get_window_draw_list(), imgui.get_window_pos()
        track, now = app.sim.track(app.focus), app.sim.time

        def at(t: float) -> float:
            return x0 + width * min(max(0.5 + (t - now) / SPAN, 0.0), 1.0)

        for side, t, stance in zip(track.side, track.contact_time, track.stance_time, strict=True):
            top = y0 + 0.25 * row + 1.1 * row * float(side)
            if at(t + stance) > at(t):
                draw.add_rect_filled((at(t), top), (at(t + stance), top + row), theme.ink(theme.SIDES[int(side)], 0.9), 4.0)
        for side, name in enumerate("LR"):
            place = (x0 + 0.3 * row, y0 + 0.3 * row + 1.1 * row * side)
            draw.add_text(place, theme.ink(theme.TEXT), name)
        draw.add_line((at(now), y0), (at(now), y0 + height), theme.ink(theme.TEXT, 0.9), 2.0 * self.scale)
        imgui.end()

    def _notice(self, app: App, size: tuple[int, int]) -> None:
        """What was said lately, above the diagram."""
        if not app.notice:
            return
        low = size[1] - (2 * EDGE + 2.6 * ROW if app.show_panel else EDGE) * self.scale
        imgui.set_next_window_pos((0.5 * size[0], low), imgui.Cond_.always, (0.5, 1.0))
        imgui.set_next_window_size_constraints((0, 0), (0.9 * size[0], 0.5 * size[1]))
        imgui.set_next_window_bg_alpha(0.88)
        imgui.begin("notice", None, FIXED | imgui.WindowFlags_.always_auto_resize)
        imgui.push_text_wrap_pos(min(0.7 * size[0], 420 * self.scale))
        imgui.text(app.notice)
        imgui.pop_text_wrap_pos()
        imgui.end()

    def _help(self, app: App, size: tuple[int, int]) -> None:
        imgui.set_next_window_pos((0.5 * size[0], 0.5 * size[1]), imgui.Cond_.always, (0.5, 0.5))
        imgui.begin("keys and mouse", None, FIXED | imgui.WindowFlags_.always_auto_resize)
        imgui.push_text_wrap_pos(size[0] - 6 * EDGE * self.scale)
        for line in app.help:
            imgui.text(line)
        imgui.pop_text_wrap_pos()
        imgui.end()
