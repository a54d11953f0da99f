"""Runs that are shown: in a window where there is one, or headless, leaving what was asked for."""

import json
import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from sim.files.recording import Recorder
from sim.files.saving import restore, save
from sim.stage.cast import Cast
from sim.stage.run import run as run_headless
from sim.stage.simulation import Simulation
from sim.stage.warmup import warm_up
from worlds.errors import InputError

HEADLESS_SECONDS = 20.0
LEFT_BEHIND = ("footfall.png", "footfall.npz")
"""Picture and recording left where there is no display and nothing else was asked for."""


def show(options: Any, make: Callable[..., Cast], names: list[str], saved: str | None = None) -> int:
    """Runs what `make` makes, or what was saved, in a window where there is one; `names` are what the window can go on to."""
    writable(options.record, options.screenshot, options.video, options.save)
    begin = time.perf_counter()
    warm_up(options.command, lambda line: print(line, file=sys.stderr, flush=True))
    sim = restore(saved) if saved else make()
    if saved and options.seconds and options.seconds <= sim.time:
        raise InputError(f"--seconds {options.seconds:g}: {saved} is at {sim.time:g} s already; give a later time")
    sim.snapshot()
    if not options.json:
        print(f"Ready after {time.perf_counter() - begin:.1f} s.", file=sys.stderr, flush=True)
    if options.headless or not _has_display():
        return _headless(options, sim)
    from sim.view.window.window import run_window

    return run_window(make, sim, options, names)


def writable(*paths: str | None) -> None:
    """Raises InputError where a folder that is to be written to is not there or not ours."""
    for path in filter(None, paths):
        folder = Path(path).resolve().parent
        if not folder.is_dir() or not os.access(folder, os.W_OK):
            raise InputError(f"{path}: the folder {folder} does not exist or cannot be written")


def _has_display() -> bool:
    if os.environ.get("SDL_VIDEODRIVER"):
        return os.environ["SDL_VIDEODRIVER"] != "dummy"
    return sys.platform in ("win32", "darwin") or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _headless(options: Any, sim: Cast) -> int:
    """Runs without a window; leaves what was asked for, or a picture and a recording."""
    picture, record = options.screenshot, options.record
    if not options.headless and not (picture or record or options.video):
        print("There is no display: running headless.", file=sys.stderr)
        picture, record = LEFT_BEHIND
    recorder, video = Recorder(sim) if record else None, None
    if recorder:
        recorder.capture()
    if options.video:
        from sim.view.pictures.offscreen import VideoWriter

        video = VideoWriter(sim, options.video, options.size)
    try:
        until = options.seconds or getattr(sim, "end", sim.time + HEADLESS_SECONDS)
        watching = ([recorder.capture] if recorder else []) + ([video.add] if video else [])
        summary = run_headless(sim, until, *watching, quiet=options.json)
    finally:
        if video:
            video.close()
    if recorder:
        recorder.save(record)
    if picture:
        from sim.view.pictures.offscreen import render_image

        render_image(sim, picture, options.size)
    if options.save and isinstance(sim, Simulation):
        save(sim, options.save)
    _tell(options, summary, [name for name in (picture, record, options.video, options.save) if name])
    return 0


def _tell(options: Any, summary: dict, files: list[str]) -> None:
    if options.json:
        print(json.dumps(summary))
        return
    print(
        f"{summary['level']}: {summary['seconds']:.1f} s, {summary['steps']} steps, {summary['distance']:.1f} m"
        + (f", goal reached after {summary['seconds_to_goal']:.1f} s" if summary["reached_goal"] else "")
    )
    for name in files:
        print(f"wrote {Path(name).resolve()}")
