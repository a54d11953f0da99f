"""The panel (imgui) and the live timing diagram."""

from types import ModuleType
from typing import Any

from imgui_bundle import imgui
from imgui_bundle.python_backends.opengl_backend_programmable import ProgrammablePipelineRenderer

from motion.track.phases import COLOURS, LEFT_STANCE, RIGHT_STANCE
from sim.view.window.app import App

SPAN = 3.0
"""Seconds that the timing diagram shows."""


class Panel:
    """Buttons for what keys do, figures of the moment, and who stands when."""

    def __init__(self, pygame: ModuleType, size: tuple[int, int]) -> None:
        self.pygame = pygame
        imgui.create_context()
        imgui.get_io().set_ini_filename("")
        imgui.get_io().display_size = imgui.ImVec2(*size)
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
        io.display_size, io.delta_time = imgui.ImVec2(*size), 1 / max(rate, 1)
        imgui.new_frame()
        if app.show_panel:
            self._controls(app, rate)
            self._diagram(app, size)
        if app.show_help:
            self._help(app, size)
        imgui.render()
        self.backend.render(imgui.get_draw_data())

    def _controls(self, app: App, rate: float) -> None:
        imgui.set_next_window_pos((10, 10), imgui.Cond_.once)
        imgui.set_next_window_size((238, 0))
        imgui.begin("Footfall")
        sim = app.sim
        imgui.text(f"{sim.world.name}: {sim.characters[app.focus].name}")
        imgui.text(f"{sim.time:6.2f} s   {rate:3.0f} frames/s")
        if len(sim.characters) > 1:
            imgui.text(f"character {app.focus + 1} of {len(sim.characters)}, {app.in_view} in view")
        imgui.text(f"window {sim.effort_of(app.focus)[1]} iterations")
        if imgui.button("go" if app.paused else "pause"):
            app.toggle()
        for label, key in (("tick", "."), ("restart", "r"), ("level", "n")):
            imgui.same_line()
            if imgui.button(label):
                app.key(key)
        if imgui.button("character"):
            app.key("c")
        for label, key in (("overlays", "o"), ("plan", "v"), ("edit", "return")):
            imgui.same_line()
            if imgui.button(label):
                app.key(key)
        imgui.same_line()
        if imgui.button("all"):
            app.everyone()
        changed, speed = imgui.slider_float("speed", app.speed, 1 / 16, 4.0)
        if changed:
            app.speed = speed
        if app.message:
            imgui.text_wrapped(app.message)
        imgui.text_disabled("h: help")
        imgui.end()

    def _diagram(self, app: App, size: tuple[int, int]) -> None:
        """Stances as bars, LEFT above RIGHT, the present in the middle (paper, Fig. 12)."""
        flags = imgui.WindowFlags_.no_decoration | imgui.WindowFlags_.no_inputs
        width, height = size[0] - 20, 58
        imgui.set_next_window_pos((10, size[1] - height - 10))
        imgui.set_next_window_size((width, height))
        imgui.set_next_window_bg_alpha(0.45)
        imgui.begin("timing", None, flags)
        draw, (x0, y0) = imgui.get_window_draw_list(), imgui.get_window_pos()
        track, now = app.sim.track(app.focus), app.sim.time

        def at(t: float) -> float:
            return x0 + width * min(max(0.5 + (t - now) / SPAN, 0.0), 1.0)

        for side, t, stance in zip(track.side, track.contact_time, track.stance_time, strict=True):
            top = y0 + 8 + 24 * float(side)
            colour = imgui.color_convert_float4_to_u32((*COLOURS[(LEFT_STANCE, RIGHT_STANCE)[int(side)]], 1.0))
            if at(t + stance) > at(t):
                draw.add_rect_filled((at(t), top), (at(t + stance), top + 18), colour, 4.0)
        draw.add_line((at(now), y0), (at(now), y0 + height), imgui.color_convert_float4_to_u32((1, 1, 1, 0.9)), 2.0)
        imgui.end()

    def _help(self, app: App, size: tuple[int, int]) -> None:
        imgui.set_next_window_pos((size[0] / 2 - 240, size[1] / 2 - 60))
        imgui.begin("keys and mouse", None, imgui.WindowFlags_.always_auto_resize)
        for line in app.help:
            imgui.text(line)
        imgui.end()
