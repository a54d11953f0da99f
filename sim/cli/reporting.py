"""`measure`, `timing`, `literature` and `bench`: figures, as words, numbers or pictures."""

import json
from types import ModuleType
from typing import Any

from motion.characters.character import character_names, load_character
from sim.cli.show import writable
from sim.cli.status import DONE
from sim.files.recording import load_recording
from sim.reports import literature, measured, timings
from sim.reports.measure import measure
from worlds.errors import InputError


def measured_run(options: Any) -> int:
    """The quality of a recorded run."""
    recording = load_recording(options.recording)
    writable(options.plot)
    report = measure(recording)
    if options.plot:
        _plots().plot_run(recording, options.character_index, options.plot, options.between)
    print(json.dumps(report) if options.json else measured.in_words(report))
    return DONE


def timing(options: Any) -> int:
    """The automatic timing as a table, numbers or a figure."""
    writable(options.plot)
    characters = [load_character(name) for name in ([options.character] if options.character else character_names())]
    tables = {character.name: timings.timing_table(character) for character in characters}
    if options.plot:
        _plots().plot_timings(tables, options.plot)
    if options.json or not options.plot:
        print(json.dumps(tables) if options.json else timings.in_words(tables))
    return DONE


def people(options: Any) -> int:
    """The human beside people; a figure that does not fit is no error of the command."""
    rows = literature.compare()
    print(json.dumps(literature.as_dict(rows)) if options.json else literature.in_words(rows))
    return DONE


def bench(options: Any) -> int:
    """Speed against other solvers."""
    from sim.bench import report

    if options.plot:
        _plots().writable_kind(options.plot)
    results = report.run(options.quick)
    if options.plot:
        _plots().plot_crowds(results["crowd"], options.plot)
    print(json.dumps(results) if options.json else report.in_words(results))
    return DONE


def _plots() -> ModuleType:
    """sim.reports.plots, where there is matplotlib."""
    try:
        from sim.reports import plots
    except ImportError as error:
        raise InputError(f"--plot: figures need matplotlib (pip install matplotlib, or the extra `plots`): {error}") from None
    return plots
