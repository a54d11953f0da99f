"""The window: events in, time on, pictures out."""

import os
import time as clock
from collections.abc import Callable
from types import ModuleType
from typing import Any

from sim.stage.cast import Cast
from sim.view.graphics import gl
from sim.view.pictures.results import Names, Results, Wanted
from sim.view.window.app import FRAME, App
from sim.view.window.driving import Pad
from sim.view.window.plan_screen import PlanScreen
from worlds.compiled.telling import tell

STILL = 4
"""A press and release no more than so many pixels apart is a click, else a drag."""


def run_window(
    make: Callable[..., Cast], sim: Cast, options: Any, levels: list[str], wanted: Wanted, stop: Callable[[], bool]
) -> int:
    """Opens the window and runs until it is closed, for --seconds, or until `stop` says so; returns the exit status."""
    gl.prefer_egl_without_display()
    import pygame

    pygame.display.init()
    app = App(make, sim, options, levels)
    screen = _open_screen(pygame, options.size, app.scale)
    app.recording = wanted.record or ""
    names = Names(app.level, (str(app.character),) if app.character else ())
    results, pad = Results(wanted, app.sim, names), Pad(pygame)
    last, frames, began = clock.perf_counter(), 0, clock.perf_counter()
    while app.running and app.ticks_left() and not stop():
        for event in pygame.event.get():
            handle(app, screen, event, pygame)
        app.sticks = pad.read()
        now = clock.perf_counter()
        app.advance(now - last)
        _record(app, results)
        results.follow(app.sim)
        last = now
        screen.draw(app)
        frames += 1
        clock.sleep(max(FRAME - (clock.perf_counter() - now), 0))
    results.end(app.sim)
    shown = frames / max(clock.perf_counter() - began, 1e-9)
    if options.json:
        print(f'{{"frames_per_second": {shown:.1f}, "seconds": {app.sim.time}}}')
    for name in results.done:
        tell(f"wrote {os.path.abspath(name)}")
    pygame.quit()
    return 2 if results.faults else 0


def _record(app: App, results: Results) -> None:
    """What is recorded follows what the window asks for; says what became of it."""
    done, faults = len(results.done), len(results.faults)
    results.record_to(app.recording or None)
    if len(results.faults) > faults:
        app.say(results.faults[-1])
    elif len(results.done) > done:
        app.say(f"wrote {results.done[-1]}")


def opens() -> bool:
    """Whether there is a display that answers. Where none does, SDL would draw a window that nobody sees."""
    import pygame

    try:
        pygame.display.init()
    except pygame.error:
        return False
    unseen = pygame.display.get_driver() in ("offscreen", "dummy") and not os.environ.get("SDL_VIDEODRIVER")
    pygame.display.quit()
    return not unseen


def handle(app: App, screen: Any, event: Any, pygame: ModuleType) -> None:
    """One pygame event."""
    if screen.takes(event):
        return
    if event.type == pygame.QUIT:
        app.running = False
    elif event.type == pygame.KEYDOWN:
        app.key(typed(event, pygame))
    elif event.type == pygame.KEYUP:
        app.key_up(typed(event, pygame))
    elif event.type == pygame.WINDOWFOCUSLOST:
        app.driver.held.clear()
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


def typed(event: Any, pygame: ModuleType) -> str:
    """What a key types, wherever it sits on this keyboard; a key's own name where it types nothing."""
    letter = getattr(event, "unicode", "").lower()
    return letter if letter.isascii() and letter.isprintable() and letter.strip() else pygame.key.name(event.key)


def _open_screen(pygame: ModuleType, size: tuple[int, int], scale: float = 1.0) -> Any:
    """The 3D screen, or the plan view where there is no OpenGL."""
    try:
        from sim.view.window.screen import Screen3D

        return Screen3D(pygame, size, scale)
    except (gl.NoGL, pygame.error) as error:
        tell(f"{gl.HINT} ({error}); showing the plan view")
        return PlanScreen(pygame, size)
