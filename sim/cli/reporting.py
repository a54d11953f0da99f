"""`measure`, `timing`, `literature` and `bench`: figures, as words, numbers or pictures."""

import json
import os
from pathlib import Path
from types import ModuleType
from typing import Any

from motion.characters.character import character_names, load_character
from planner.round.weights import MODELS, NUMBERS, PEOPLE, Weights
from sim.files import outputs
from sim.files.recording import load_recording
from sim.reports import literature, measured, timings
from sim.reports import verify as verifying
from sim.reports.cycles import people_of
from sim.reports.measure import measure
from sim.reports.throngs import ablation, weighing
from worlds.compiled.telling import tell
from worlds.errors import InputError
from worlds.errors.wording import nearest


def measured_run(options: Any) -> None:
    """The quality of a recorded run."""
    recording = load_recording(options.recording)
    _check_plot(options.plot)
    report = measure(recording)
    if options.plot:
        _plots().plot_run(recording, options.character_index, options.plot, options.between)
        _say_plot(options)
    print(json.dumps(report) if options.json else measured.in_words(report))


def timing(options: Any) -> None:
    """The automatic timing as a table, numbers or a figure."""
    _check_plot(options.plot)
    characters = [load_character(name) for name in ([options.character] if options.character else character_names())]
    tables = {character.name: timings.timing_table(character) for character in characters}
    if options.plot:
        _plots().plot_timings(tables, options.plot)
        _say_plot(options)
    if options.json or not options.plot:
        print(json.dumps(tables) if options.json else timings.in_words(tables))


def people(options: Any) -> None:
    """The human beside people; a figure that does not fit is no error of the command."""
    _check_plot(options.plot)
    curves = people_of(options.curves) if options.curves else {}
    rows = literature.compare() + (literature.compare_with(curves) if curves else [])
    if options.plot:
        _plots().plot_strides(literature.strides(), curves, options.plot)
        _say_plot(options)
    print(json.dumps(literature.as_dict(rows)) if options.json else literature.in_words(rows))


def bench(options: Any) -> None:
    """Speed against other solvers."""
    from sim.bench import report
    from sim.reports import flows

    _check_plot(options.plot)
    if options.only not in (None, *report.PARTS):
        raise InputError(f"--only {options.only}: there are {', '.join(report.PARTS)}")
    if options.plot and options.only not in (None, "crowd"):
        raise InputError(f"--plot draws crowds, and --only {options.only} measures none: leave one of them out")
    results = report.run(options.quick, flows.ring, options.only)
    if options.plot:
        _plots().plot_crowds(results["crowd"], options.plot)
        _say_plot(options)
    print(json.dumps(results) if options.json else report.in_words(results))


def verified(options: Any) -> None:
    """A line for each case; a figure that does not fit is no error of the command."""
    if options.ablation:
        for line in ablation.table():
            print(line, flush=True)
        return
    weights, folder, found = _weights(options.without, options.model), _folder(options.trajectories), []
    if options.case is not None and options.case not in verifying.numbers():
        known = ", ".join(str(number) for number in verifying.numbers())
        raise InputError(f"--case {options.case}: of the RiMEA tests there are {known}")
    album = _album(options.pictures)
    for row in verifying.verify(options.quick and options.case is None, folder, weights, options.case, album and album.take):
        found.append(row)
        if not options.json:
            print(verifying.in_words(row), flush=True)
    if album and not options.quick and options.case is None:
        album.weigh(weighing.weighed(weights))
    for path in album.draw() if album else []:
        tell(f"wrote {path.resolve()}")
    fits = sum(row.fits for row in found)
    told = {"cases": [verifying.as_dict(row) for row in found], "fits": fits}
    print(json.dumps(told) if options.json else f"{fits} of {len(found)} fit")


def _check_plot(path: str | None) -> None:
    """Before any work is done: raises InputError where the figure could not be drawn or written."""
    outputs.check({"--plot": path})
    if path is not None:
        _plots().writable_kind(path)


def _say_plot(options: Any) -> None:
    """Where the figure is."""
    tell(f"wrote {os.path.abspath(options.plot)}")


def _plots(option: str = "--plot") -> ModuleType:
    """sim.reports.plots, where there is matplotlib; option: that which asks for it."""
    try:
        from sim.reports import plots
    except ImportError as error:
        raise InputError(f"{option}: figures need matplotlib (pip install matplotlib, or the extra `plots`): {error}") from None
    return plots


def _weights(without: str | None, model: str) -> Weights:
    """Those of people, for a model, one of them left out. Raises InputError where there is none of that name."""
    if model not in MODELS:
        raise InputError(f"--model {model}: {', '.join(MODELS)} are allowed{nearest(model, MODELS)}")
    weights = PEOPLE._replace(model=model)
    if without is None:
        return weights
    if without not in NUMBERS:
        raise InputError(f"--without {without}: {', '.join(NUMBERS)} are allowed{nearest(without, NUMBERS)}")
    if without in ablation.SCALES:
        raise InputError(f"--without {without}: is a scale, no term; its term is {ablation.SCALES[without]}")
    return weights.of(without, 0.0)


def _album(wanted: str | None) -> Any:
    """What draws crowds into a folder, where there is matplotlib; None where no pictures are asked for."""
    if wanted is not None:
        _plots("--pictures")
    folder = _folder(wanted, "--pictures")
    if folder is None:
        return None
    from sim.reports.pictures.album import Album

    return Album(folder)


def _folder(wanted: str | None, option: str = "--trajectories") -> Path | None:
    """The folder, made where it is missing. Raises InputError."""
    if wanted is None:
        return None
    try:
        Path(wanted).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{option} {wanted}: cannot be made: {error.strerror}") from None
    return Path(wanted)
