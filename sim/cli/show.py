"""Runs that are shown: in a window where there is one, or headless, leaving what was asked for; and the studio."""

import json
import os
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from sim.cli import agreeing, stopping
from sim.cli.sketching import sketched
from sim.cli.status import BAD_INPUT, DONE
from sim.files import outputs
from sim.files.saving import restore
from sim.files.studio import keeping
from sim.stage.cast import Cast
from sim.stage.run import run as run_headless
from sim.stage.warmup import warm_up
from sim.view.pictures.results import Names, Results, Wanted
from worlds.compiled.telling import tell
from worlds.errors import InputError

Hand = Callable[[Cast], None]
HEADLESS_SECONDS = 20.0
NO_DISPLAY = "There is no display: running headless."
LEFT_BEHIND = ("footfall.png", "footfall.npz")
"""Picture and recording left where there is no display and nothing else was asked for."""


def show(
    options: Any, make: Callable[..., Cast], names: list[str], check: Callable[[], None], saved: str | None = None,
    hands: tuple[Hand, ...] = (),
) -> int:  # fmt: skip
    """Runs what `make` makes, or what was saved, in a window where there is one; `names` are what the window can go on to.

    check: raises InputError where what is asked for cannot be. hands: what acts on a run without a window after each tick, as a
    person does in one.
    """
    windowed = not options.headless and has_display()
    wanted = _wanted(options, windowed)
    wanted.check()
    if windowed and wanted.video is not None:
        raise InputError(f"--video {wanted.video}: films are made without a window: add --headless")
    begin = time.perf_counter()
    _get_ready(options, check, windowed)
    sim = _restored(options, saved) if saved else make()
    if saved and options.seconds and options.seconds <= sim.time:
        raise InputError(f"--seconds {options.seconds:g}: {saved} is at {sim.time:g} s already; give a later time")
    sim.snapshot()
    if not options.json:
        tell(f"Ready after {time.perf_counter() - begin:.1f} s.")
    if not windowed:
        return _headless(options, sim, wanted, hands)
    from sim.view.window.window import run_window

    with stopping.between_ticks():
        return run_window(make, sim, options, names, wanted, stopping.asked)


def _get_ready(options: Any, check: Callable[[], None], windowed: bool) -> None:
    """Checks what is asked for and compiles what it needs; where that takes long, a window shows the world meanwhile."""

    def work(told: Callable[[str], None]) -> None:
        check()
        warm_up(options.command, told, options.characters)

    if not windowed:
        work(tell)
        return
    from sim.view.window.waiting import wait_for

    wait_for(work, tell, sketched(getattr(options, "level", None)), options.size)


def _names(options: Any) -> Names:
    """What the run's files are called."""
    level = None if "restore" in options and options.restore else getattr(options, "level", None)
    return Names(level, (options.character,) if getattr(options, "character", None) else ())


def _restored(options: Any, path: str) -> Cast:
    """The saved simulation, if it is what was asked for; else raises InputError."""
    sim = restore(path)
    agreeing.restored(options, sim)
    return sim


def _wanted(options: Any, windowed: bool) -> Wanted:
    """What the run is to leave; where there is no display and nothing was asked for, a picture and a recording."""
    wanted = Wanted(options.record, options.screenshot, options.video, options.save, options.scene, options.size)
    if options.headless or windowed:
        return wanted
    named = [f"{name}={os.environ[name]}" for name in ("DISPLAY", "WAYLAND_DISPLAY") if os.environ.get(name)]
    tell(f"{', '.join(named)}: no display answers there; running headless." if named else NO_DISPLAY)
    if any(name is not None for name in (*wanted[:3], wanted.scene)):
        return wanted
    picture, record = LEFT_BEHIND
    return wanted._replace(screenshot=picture, record=record)


def has_display() -> bool:
    if os.environ.get("SDL_VIDEODRIVER"):
        return os.environ["SDL_VIDEODRIVER"] != "dummy"
    if sys.platform in ("win32", "darwin"):
        return True
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return False
    from sim.view.window.window import opens

    return opens()


def _headless(options: Any, sim: Cast, wanted: Wanted, hands: tuple[Hand, ...]) -> int:
    """Runs without a window; leaves what was asked for, or what there is so far where it is stopped."""
    until = options.seconds or getattr(sim, "end", sim.time + HEADLESS_SECONDS)
    with stopping.between_ticks():
        results = Results(wanted, sim, _names(options))
        acting = [partial(hand, sim) for hand in hands]
        try:
            summary = run_headless(sim, until, lambda: results.follow(sim), *acting, quiet=options.json, stop=stopping.asked)
            results.end(sim)
        except Exception:
            results.end(sim)
            raise
        _tell(options, summary, results.done)
    return BAD_INPUT if results.faults else DONE


def _tell(options: Any, summary: dict, files: list[str]) -> None:
    if options.json:
        print(json.dumps(summary))
        return
    print(
        f"{summary['level']}: {summary['seconds']:.1f} s, {summary['steps']} steps, {summary['distance']:.1f} m"
        + (f", goal reached after {summary['seconds_to_goal']:.1f} s" if summary["reached_goal"] else "")
    )
    if "people" in summary:
        print(_people_in_words(summary["people"]))
    if options.command == "river" and not summary["reached_goal"] and not stopping.asked():
        tell(f"It ends before the goal is reached: --seconds T, more than {summary['seconds']:g}, lets it go on.")
    for name in files:
        print(f"wrote {os.path.abspath(name)}")


def _people_in_words(people: dict) -> str:
    exits = ", ".join(f"{count} by {name}" for name, count in people["exits"].items())
    return (
        f"{people['came']} came, {people['went']} went ({exits}), {people['there']} are there, {people['outside']} wait outside"
    )


def edit(options: Any) -> int:
    """Opens a scene, or a new one, in the studio; or draws it, its pictures, or measures it, and ends."""
    outputs.check({"--screenshot": options.screenshot})
    unseen = options.screenshot or options.pictures or options.latency
    if not unseen and not has_display():
        raise InputError("edit: there is no display; --screenshot P.png draws the studio once")
    if unseen:
        os.environ["SDL_VIDEODRIVER"] = "offscreen"
    warm_up("edit", tell)
    from sim.view.graphics.gl import HINT, NoGL, prefer_egl_without_display

    prefer_egl_without_display()  # before anything of the studio asks for OpenGL
    try:
        if unseen:
            _unseen(options)
        else:
            from sim.view.studio.studio import run_studio

            with stopping.between_ticks():
                run_studio(_desk(options), options.size, options.scale, stopping.asked)
    except NoGL as error:
        raise InputError(f"edit: {HINT} ({error})") from None
    return DONE


def _desk(options: Any) -> Any:
    """The desk with what was asked for on it."""
    from sim.view.studio.desk.desk import Desk

    desk = Desk()
    if options.level == keeping.PIPED:
        desk.begin(keeping.piped(sys.stdin.buffer), "What was walked")
    elif options.level:
        desk.open(options.level)
    return desk


def _unseen(options: Any) -> None:
    """What needs no window that anybody sees."""
    if options.latency:
        from sim.view.studio.latency import latencies

        print(json.dumps([one._asdict() for one in latencies()], indent=1))
    elif options.pictures:
        from sim.view.studio.pictures import write_pictures

        folder = Path(options.pictures)
        folder.mkdir(parents=True, exist_ok=True)
        tell(f"wrote {len(write_pictures(folder))} files to {folder.resolve()}")
    else:
        from sim.view.studio.pictures import draw_once

        draw_once(_desk(options), options.screenshot, options.size, options.scale)
        tell(f"wrote {os.path.abspath(options.screenshot)}")
