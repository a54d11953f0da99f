"""The shards of a batch: a recording and its rows, side by side, each whole or not there.

A run is done once its rows are there; they are written after its recording. So whatever ends a batch, at whatever moment, what
is there is right, and the rest is done when it goes on.
"""

import json
from collections.abc import Iterable
from pathlib import Path

from sim.files import archive, outputs
from sim.files.recording import Recording
from sim.reports.batch.plan import Job
from sim.reports.batch.running import Ran, Row

FOLDER = "shards"
LEFT_OVER = ".footfall-*.part"


class Shards:
    """A folder of shards."""

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder) / FOLDER

    def prepare(self) -> None:
        """Makes the folder, and takes away what an ended batch has left half-written."""
        self.folder.mkdir(parents=True, exist_ok=True)
        for path in self.folder.glob(LEFT_OVER):
            path.unlink(missing_ok=True)

    def recording_of(self, job: Job) -> Path:
        """Where the recording of a run is."""
        return self.folder / f"{job.name}.npz"

    def _rows_of(self, job: Job) -> Path:
        return self.folder / f"{job.name}.json"

    def write(self, job: Job, ran: Ran) -> None:
        """The recording, then the rows. Raises InputError where they cannot be written."""
        if ran.recording is not None:
            self._write_recording(job, ran.recording)
        self.write_rows(job, ran.rows)

    def _write_recording(self, job: Job, recording: Recording) -> None:
        archive.write(self.recording_of(job), recording.arrays, recording.meta)

    def write_bytes(self, job: Job, recording: bytes | None, rows: list[Row]) -> None:
        """What was made elsewhere."""
        if recording is not None:
            with outputs.whole(self.recording_of(job)) as part:
                part.write_bytes(recording)
        self.write_rows(job, rows)

    def write_rows(self, job: Job, rows: list[Row]) -> None:
        """The rows of a run: it is done."""
        with outputs.whole(self._rows_of(job)) as part:
            part.write_text(json.dumps({"plan": job.plan, "rows": rows}), "utf-8")

    def rows(self, job: Job) -> list[Row] | None:
        """The rows of a run that is done; None for others."""
        try:
            kept = json.loads(self._rows_of(job).read_text("utf-8"))
            return kept["rows"] if kept["plan"] == job.plan else None
        except (OSError, ValueError, KeyError, TypeError):
            return None

    def undone(self, jobs: Iterable[Job]) -> list[Job]:
        """The runs that are still to be done."""
        return [job for job in jobs if self.rows(job) is None]
