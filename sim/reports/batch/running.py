"""One run of a batch: simulated, measured, and its rows of the table."""

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from planner.planner import NoWay
from sim.files.recording import Recorder, Recording
from sim.reports.batch.plan import Job
from sim.reports.measure import measure
from sim.stage.making import make_simulation
from sim.stage.run import run
from worlds.errors import InputError

Row = dict[str, Any]


class Ran(NamedTuple):
    """What a run has come to."""

    rows: list[Row]  # one for each character; a single one with `error` where it could not be done
    recording: Recording | None


def simulate(job: Job) -> Ran:
    """Does a run. One that cannot be done, as a river without a way across, says so in its row."""
    head: Row = {"level": Path(job.level).stem, "seed": job.seed}
    try:
        sim = make_simulation(job.level, job.character, job.characters, job.seed, job.task == "river")
    except (InputError, NoWay) as error:
        return Ran([{**head, "error": str(error)}], None)
    recorder = Recorder(sim)
    recorder.capture()
    summary = run(sim, job.seconds, recorder.capture, quiet=True)
    recording = recorder.recording()
    report = measure(recording)
    whole = {key: summary[key] for key in ("seconds", "reached_goal", "seconds_to_goal")}
    rows = [{**head, "character": c, **whole, "error": None, **flat(figures)} for c, figures in enumerate(report["characters"])]
    return Ran(rows, recording)


def flat(figures: dict, prefix: str = "") -> Row:
    """Figures within figures by names like gait.speed; numbers, words and truths only."""
    row: Row = {}
    for key, value in figures.items():
        if isinstance(value, dict):
            row |= flat(value, f"{prefix}{key}.")
        elif value is None or isinstance(value, bool | int | float | str):
            row[prefix + key] = value
        elif isinstance(value, np.generic):
            row[prefix + key] = value.item()
    return row
