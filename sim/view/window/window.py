"""The window: events in, time on, pictures out."""

import sys
import time as clock
from collections.abc import Callable
from types import ModuleType
from typing import Any

from sim.files.saving import save
from sim.stage.cast import Cast
from sim.stage.simulation import Simulation
from sim.view.graphics import gl
from sim.view.window.app import FRAME, App
from sim.view.window.plan_screen import PlanScreen

STILL = 4
"""A press and release no more than so many pixels apart is a click, else a drag."""


def run_window(make: Callable[..., Cast], sim: Cast, options: Any, levels: list[str]) -> int:
    """Opens the window and runs until it is closed, or for --seconds; returns the exit status."""
    gl.prefer_egl_without_display()
    import pygame

    pygame.display.init()
    app = App(make, sim, options, levels)
    screen = _open_screen(pygame, options.size)
    extras = _Extras(options, app.sim)
    last, frames, began = clock.perf_counter(), 0, clock.perf_counter()
    while app.running and app.ticks_left():
        for event in pygame.event.get():
            handle(app, screen, event, pygame)
        now = clock.perf_counter()
        app.advance(now - last)
        extras.follow(app.sim)
        last = now
        screen.draw(app)
        frames += 1
        clock.sleep(max(FRAME - (clock.perf_counter() - now), 0))
    extras.end(app.sim)
    shown = frames / max(clock.perf_counter() - began, 1e-9)
    if options.json:
        print(f'{{"frames_per_second": {shown:.1f}, "seconds": {app.sim.time}}}')
    pygame.quit()
    return 0


class _Extras:
    """--record, --save and --screenshot of a window: the recording replays the same ticks, so it holds each of them."""

    def __init__(self, options: Any, sim: Cast) -> None:
        self.options = options
        self.recorder = None
        if options.record:
            from sim.files.recording import Recorder

            self.recorder = Recorder(sim)
            self.recorder.capture()
        self._ticks = sim.ticks

    def follow(self, sim: Cast) -> None:
        """Captures the ticks that have passed: poses are functions of time, so they can be asked for afterwards."""
        if self.recorder and self.recorder.sim is sim:
            for tick in range(self._ticks + 1, sim.ticks + 1):
                self.recorder.capture(tick / sim.tick_rate)
            self._ticks = sim.ticks

    def end(self, sim: Cast) -> None:
        """Writes what was asked for."""
        if self.recorder:
            self.recorder.save(self.options.record)
        if self.options.save and isinstance(sim, Simulation):
            save(sim, self.options.save)
        if self.options.screenshot:
            from sim.view.pictures.offscreen import render_image

            render_image(sim, self.options.screenshot, self.options.size)


def handle(app: App, screen: Any, event: Any, pygame: ModuleType) -> None:
    """One pygame event."""
    if screen.takes(event):
        return
    if event.type == pygame.QUIT:
        app.running = False
    elif event.type == pygame.KEYDOWN:
        app.key(pygame.key.name(event.key))
    elif event.type == pygame.KEYUP:
        app.key_up(pygame.key.name(event.key))
    elif event.type == pygame.MOUSEWHEEL:
        app.camera.zoom(event.y)
    elif event.type == pygame.MOUSEMOTION and any(event.buttons):
        app.drag(*event.rel)
    elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
        app.pressed = event.pos
    elif event.type == pygame.MOUSEBUTTONUP and event.button == 1 and app.pressed:
        width, height = screen.size
        if max(abs(event.pos[0] - app.pressed[0]), abs(event.pos[1] - app.pressed[1])) <= STILL:
            app.click(2 * event.pos[0] / width - 1, 1 - 2 * event.pos[1] / height, width / height)
        app.pressed = None
    elif event.type == pygame.VIDEORESIZE:
        screen.resize(event.size)


def _open_screen(pygame: ModuleType, size: tuple[int, int]) -> Any:
    """The 3D screen, or the plan view where there is no OpenGL."""
    try:
        from sim.view.window.screen import Screen3D

        return Screen3D(pygame, size)
    except (gl.NoGL, pygame.error) as error:
        print(f"{gl.HINT} ({error}); showing the plan view", file=sys.stderr)
        return PlanScreen(pygame, size)
