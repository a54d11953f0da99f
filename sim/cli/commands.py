"""The commands of the command line: each takes the parsed options and returns the exit status."""

import json
import os
import sys
import time
from dataclasses import replace
from pathlib import Path

from motion.characters.biped import CharacterError, character_names, load_biped
from planner.river.rock_hop import NoWay, RockHop
from planner.script.scene import load_scene, scene_names
from planner.wandering import Wander
from sim.cli.warmup import warm_up
from sim.files.recording import Recorder, load_recording
from sim.files.saving import restore, save
from sim.reports import literature, timings
from sim.reports.measure import in_words, measure
from sim.stage.cast import Cast
from sim.stage.performance import Performance
from sim.stage.run import run as run_headless
from sim.stage.simulation import Simulation
from worlds import reading
from worlds.errors import InputError
from worlds.level import level_names, load_level

DONE, BAD_INPUT, IMPOSSIBLE = 0, 2, 3
HEADLESS_SECONDS = 20.0
LEFT_BEHIND = ("footfall.png", "footfall.npz")
"""Picture and recording left where there is no display and nothing else was asked for."""


def run(options) -> int:
    """Runs the command of `options`; errors of people become one message and a status."""
    commands = {
        "wander": _walk,
        "river": _walk,
        "play": _play,
        "sheets": _sheets,
        "measure": _measure,
        "timing": _timing,
        "literature": _literature,
        "check": _check,
        "bench": _bench,
    }
    try:
        return commands[options.command](options)
    except (InputError, CharacterError) as error:
        print(f"footfall: {error}", file=sys.stderr)
        return BAD_INPUT
    except NoWay as error:
        print(f"footfall: {error}", file=sys.stderr)
        return IMPOSSIBLE


def make_simulation(level, character, characters: int, seed: int, river: bool) -> Simulation:
    """A simulation of `characters` of one kind on a level (name, path), crossing to its goal or wandering."""
    world = load_level(level)
    if river and world.goal is None:
        raise InputError(f"{level}: has no [goal]; `river` needs one (position, radius)")
    crowd = [load_biped(character)] * characters
    return Simulation(world, crowd, RockHop() if river else Wander(), seed)


def _play(options) -> int:
    """A scripted scene: solved as a whole, then shown, recorded or drawn like any run."""
    if options.list:
        for name in scene_names():
            print(f"{name:24}{load_scene(name).about}")
        return DONE

    def make(scene=options.level, character=options.character, seed=0) -> Performance:
        return Performance(replace(load_scene(scene), **({"character": character} if character else {})))

    return _show(options, make, scene_names())


def _sheets(options) -> int:
    """A contact sheet of every scene, or of those named."""
    from sim.view.graphics.gl import HINT, NoGL
    from sim.view.pictures.sheet import write_index, write_sheets

    folder = Path(options.folder)
    folder.mkdir(parents=True, exist_ok=True)
    try:
        paths = write_sheets({Path(n).stem: Performance(load_scene(n)) for n in options.scenes or scene_names()}, folder)
    except NoGL as error:
        raise InputError(f"contact sheets: {HINT} ({error})") from None
    if not options.scenes:
        paths.append(write_index(folder))
    print(f"wrote {len(paths)} files to {folder.resolve()}")
    return DONE


def _walk(options) -> int:
    """Wandering, or crossing to a goal, from the start or from a saved state."""

    def make(level=options.level, character=options.character, seed=options.seed) -> Simulation:
        return make_simulation(level, character, options.characters, seed, options.command == "river")

    return _show(options, make, level_names(with_goal=options.command == "river"), options.restore)


def _show(options, make, names: list[str], saved: str | None = None) -> int:
    """Runs what `make` makes, or what was saved, in a window where there is one; `names` are what the window can go on to."""
    _writable(options.record, options.screenshot, options.video, options.save)
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


def _writable(*paths: str | None) -> None:
    for path in filter(None, paths):
        folder = Path(path).resolve().parent
        if not folder.is_dir() or not os.access(folder, os.W_OK):
            raise InputError(f"{path}: the folder {folder} does not exist or cannot be written")


def _has_display() -> bool:
    if os.environ.get("SDL_VIDEODRIVER"):
        return os.environ["SDL_VIDEODRIVER"] != "dummy"
    return sys.platform in ("win32", "darwin") or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _headless(options, sim: Cast) -> int:
    """Runs without a window; leaves what was asked for, or a picture and a recording."""
    picture, record = options.screenshot, options.record
    if not options.headless and not (picture or record or options.video):
        print("There is no display: running headless.", file=sys.stderr)
        picture, record = LEFT_BEHIND
    recorder = Recorder(sim) if record else None
    video = None
    if options.video:
        from sim.view.pictures.offscreen import VideoWriter

        video = VideoWriter(sim, options.video, options.size)
    try:
        summary = run_headless(
            sim,
            options.seconds or getattr(sim, "end", sim.time + HEADLESS_SECONDS),
            recorder,
            video.add if video else None,
            options.json,
        )
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
    return DONE


def _tell(options, summary: dict, files: list[str]) -> None:
    if options.json:
        print(json.dumps(summary))
        return
    print(
        f"{summary['level']}: {summary['seconds']:.1f} s, {summary['steps']} steps, {summary['distance']:.1f} m"
        + (f", goal reached after {summary['seconds_to_goal']:.1f} s" if summary["reached_goal"] else "")
    )
    for name in files:
        print(f"wrote {Path(name).resolve()}")


def _measure(options) -> int:
    recording = load_recording(options.recording)
    _writable(options.plot)
    report = measure(recording)
    if options.plot:
        _plots().plot_run(recording, options.character_index, options.plot, options.between)
    print(json.dumps(report) if options.json else in_words(report))
    return DONE


def _timing(options) -> int:
    """The automatic timing as a table, numbers or a figure."""
    _writable(options.plot)
    bipeds = [load_biped(name) for name in ([options.character] if options.character else character_names())]
    tables = {biped.name: timings.timing_table(biped) for biped in bipeds}
    if options.plot:
        _plots().plot_timings(tables, options.plot)
    if options.json or not options.plot:
        print(json.dumps(tables) if options.json else timings.in_words(tables))
    return DONE


def _plots():
    """sim.reports.plots, where there is matplotlib."""
    try:
        from sim.reports import plots
    except ImportError as error:
        raise InputError(f"--plot: figures need matplotlib (pip install matplotlib, or the extra `plots`): {error}") from None
    return plots


def _literature(options) -> int:
    """The human beside people; a figure that does not fit is no error of the command."""
    rows = literature.compare()
    print(json.dumps(literature.as_dict(rows)) if options.json else literature.in_words(rows))
    return DONE


def _check(options) -> int:
    faults = 0
    for name in options.files:
        try:
            print(f"{name}: fine ({_checked(name)})")
        except (InputError, CharacterError) as error:
            print(error, file=sys.stderr)
            faults += 1
    return BAD_INPUT if faults else DONE


def _checked(name: str) -> str:
    """What a level, scene or character file holds, by its tables. Raises InputError, CharacterError."""
    tables = reading.tables_of(name)
    if "biped" in tables:
        return f"character {load_biped(name).name}"
    if {"footprint", "path"} & tables:
        show = Performance(load_scene(name))
        return f"scene {show.scene.name}: {show.footprints.steps} steps, {show.end:.1f} s"
    world = load_level(name)
    return f"{world.name}: {len(world.trees)} trees, {len(world.rocks)} rocks"


def _bench(options) -> int:
    from sim.bench import report

    if options.plot:
        _plots().writable_kind(options.plot)
    results = report.run(options.quick)
    if options.plot:
        _plots().plot_crowds(results["crowd"], options.plot)
    print(json.dumps(results) if options.json else report.in_words(results))
    return DONE
