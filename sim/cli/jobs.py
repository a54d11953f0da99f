"""The commands of the command line: each takes the parsed options and returns the exit status."""

import json
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

from motion.characters.character import character_names, load_character
from planner.planner import NoWay
from planner.script.scene import load_scene, scene_names
from sim.cli.show import show, writable
from sim.files.recording import load_recording
from sim.reports import literature, timings
from sim.reports.measure import measure
from sim.reports.measured import in_words
from sim.stage.making import make_simulation
from sim.stage.performance import Performance
from sim.stage.simulation import Simulation
from worlds import reading
from worlds.errors import InputError
from worlds.level import level_names, load_level

DONE, BAD_INPUT, IMPOSSIBLE = 0, 2, 3


def run(options: Any) -> int:
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
    except InputError as error:
        print(f"footfall: {error}", file=sys.stderr)
        return BAD_INPUT
    except NoWay as error:
        print(f"footfall: {error}", file=sys.stderr)
        return IMPOSSIBLE


def _play(options: Any) -> int:
    """A scripted scene: solved as a whole, then shown, recorded or drawn like any run."""
    if options.list:
        for name in scene_names():
            print(f"{name:24}{load_scene(name).about}")
        return DONE

    def make(scene: str = options.level, character: str | None = options.character, seed: int = 0) -> Performance:
        return Performance(load_scene(scene), load_character(character) if character else None)

    return show(options, make, scene_names())


def _sheets(options: Any) -> int:
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


def _walk(options: Any) -> int:
    """Wandering, or crossing to a goal, from the start or from a saved state."""

    def make(level: str = options.level, character: str = options.character, seed: int = options.seed) -> Simulation:
        return make_simulation(level, character, options.characters, seed, options.command == "river")

    return show(options, make, level_names(with_goal=options.command == "river"), options.restore)


def _measure(options: Any) -> int:
    recording = load_recording(options.recording)
    writable(options.plot)
    report = measure(recording)
    if options.plot:
        _plots().plot_run(recording, options.character_index, options.plot, options.between)
    print(json.dumps(report) if options.json else in_words(report))
    return DONE


def _timing(options: Any) -> int:
    """The automatic timing as a table, numbers or a figure."""
    writable(options.plot)
    characters = [load_character(name) for name in ([options.character] if options.character else character_names())]
    tables = {character.name: timings.timing_table(character) for character in characters}
    if options.plot:
        _plots().plot_timings(tables, options.plot)
    if options.json or not options.plot:
        print(json.dumps(tables) if options.json else timings.in_words(tables))
    return DONE


def _plots() -> ModuleType:
    """sim.reports.plots, where there is matplotlib."""
    try:
        from sim.reports import plots
    except ImportError as error:
        raise InputError(f"--plot: figures need matplotlib (pip install matplotlib, or the extra `plots`): {error}") from None
    return plots


def _literature(options: Any) -> int:
    """The human beside people; a figure that does not fit is no error of the command."""
    rows = literature.compare()
    print(json.dumps(literature.as_dict(rows)) if options.json else literature.in_words(rows))
    return DONE


def _check(options: Any) -> int:
    faults = 0
    for name in options.files:
        try:
            print(f"{name}: fine ({_checked(name)})")
        except InputError as error:
            print(error, file=sys.stderr)
            faults += 1
    return BAD_INPUT if faults else DONE


def _checked(name: str) -> str:
    """What a level, scene or character file holds, by its tables. Raises InputError."""
    tables = reading.tables_of(name)
    if {"biped", "leg"} & tables:
        return f"character {load_character(name).name}"
    if {"footprint", "path"} & tables:
        show = Performance(load_scene(name))
        return f"scene {show.scene.name}: {show.footprints.steps} steps, {show.end:.1f} s"
    world = load_level(name)
    return f"{world.name}: {len(world.trees)} trees, {len(world.rocks)} rocks"


def _bench(options: Any) -> int:
    from sim.bench import report

    if options.plot:
        _plots().writable_kind(options.plot)
    results = report.run(options.quick)
    if options.plot:
        _plots().plot_crowds(results["crowd"], options.plot)
    print(json.dumps(results) if options.json else report.in_words(results))
    return DONE
