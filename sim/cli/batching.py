"""`batch`: many levels and seeds, into shards and one table; killed, it goes on where it was."""

import json
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from sim.cli import stopping
from sim.cli.status import DONE
from sim.reports.batch import cluster, processes
from sim.reports.batch.plan import Job, keep, plan_of
from sim.reports.batch.shards import Shards
from sim.reports.batch.table import write_table
from sim.stage.warmup import warm_up
from worlds.compiled.telling import tell
from worlds.errors import InputError

LOCK = ".lock"


def batch(options: Any) -> int:
    """Simulates what is not there yet, then writes the table."""
    plan = plan_of(options.level, options.seeds, options.task, options.character, options.characters, options.seconds)
    folder = Path(options.out).resolve()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"--out {options.out}: cannot be made: {error.strerror}") from None
    with _alone(folder):
        keep(plan, folder)
        shards, jobs = Shards(folder), plan.jobs()
        shards.prepare()
        undone = shards.undone(jobs)
        if len(undone) < len(jobs):
            tell(f"{len(jobs) - len(undone)} of {len(jobs)} runs are there; going on")
        if undone:
            warm_up(options.task, tell, options.characters)
            with stopping.between_ticks():
                _run(options, undone, shards, folder, _Progress(len(jobs), len(undone)))
        path = write_table([row for job in jobs for row in shards.rows(job) or []], folder)
    faults = sum("error" in row and row["error"] is not None for job in jobs for row in shards.rows(job) or [])
    _say(options, path, len(jobs), faults)
    return DONE


def _run(options: Any, undone: list[Job], shards: Shards, folder: Path, done: Callable[[Job], None]) -> None:
    count = options.jobs or processes.processors()
    if options.engine == "ray":
        cluster.run_jobs(undone, shards, count, done, stopping.asked)
    else:
        processes.run_jobs(undone, folder, count, done, stopping.asked)


class _Progress:
    """A line for each run that is done."""

    def __init__(self, all_of_them: int, undone: int) -> None:
        self.all, self.done = all_of_them, all_of_them - undone

    def __call__(self, job: Job) -> None:
        self.done += 1
        tell(f"{self.done} of {self.all}: {Path(job.level).stem}, seed {job.seed}")


def _say(options: Any, path: Path, runs: int, faults: int) -> None:
    if options.json:
        print(json.dumps({"runs": runs, "faults": faults, "table": str(path)}))
        return
    print(f"{runs} runs" + (f", {faults} of them could not be done (column error)" if faults else ""))
    print(f"wrote {path}" + ("" if path.suffix == ".parquet" else "; with pyarrow (the extra `batch`) it were Parquet"))


@contextmanager
def _alone(folder: Path) -> Iterator[None]:
    """Nobody else works in the folder meanwhile; whoever is killed leaves it free. Raises InputError."""
    with open(folder / LOCK, "wb") as file:
        if os.name == "posix":
            import fcntl

            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                raise InputError(f"--out {folder}: another batch works there; wait for it, or give another folder") from None
        yield
