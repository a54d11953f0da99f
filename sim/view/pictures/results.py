"""What is left of a run: recording, film, picture and saved state, in a window as without one."""

import itertools
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from sim.files import outputs
from sim.files.recording import Recorder
from sim.files.saving import save
from sim.files.studio.runs.walked import document_of_cast
from sim.files.studio.writing import write_scene
from sim.stage.cast import Cast
from sim.stage.simulation import Simulation
from worlds.compiled.telling import tell


class Wanted(NamedTuple):
    """The files that a run is to leave, by the options that name them."""

    record: str | None = None
    screenshot: str | None = None
    video: str | None = None
    save: str | None = None
    scene: str | None = None
    size: tuple[int, int] = (960, 540)

    def check(self) -> None:
        """Before anything else is done: raises InputError where one of them cannot be written."""
        outputs.check({f"--{name}": getattr(self, name) for name in self._fields[:-1]})
        if self.video is not None:
            from sim.view.pictures.film import ffmpeg_for

            ffmpeg_for(self.video)
        if self.screenshot is not None:
            from sim.view.pictures.offscreen import kind_of

            kind_of(self.screenshot)


class Names(NamedTuple):
    """What the files are called that a run has read."""

    level: str | None = None
    kinds: tuple[str, ...] = ()


NAMELESS = Names()


class Results:
    """Collects them while a run goes on. A recording replays the same ticks, so it holds each of them."""

    def __init__(self, wanted: Wanted, sim: Cast, names: Names = NAMELESS) -> None:
        """names: of what a scene of the run names. Raises InputError where a film cannot be made."""
        self.wanted, self.sim, self.names = wanted, sim, names
        self.done: list[str] = []
        self.faults: list[str] = []
        self._record, self._asked, self._film = wanted.record, wanted.record, None
        self._recorder: Recorder | None = None
        if wanted.video:
            from sim.view.pictures.film import Film

            self._film = Film(sim, wanted.video, wanted.size)
        self._begin(sim)

    def _begin(self, sim: Cast) -> None:
        self.sim, self._ticks = sim, sim.ticks - 1
        if self.wanted.scene:
            sim.keep_footprints()
        if self._record:
            self._recorder = Recorder(sim, self._folder())
            self._capture(self._recorder)
        self._ticks = sim.ticks

    def _folder(self) -> Path | None:
        """Where a long recording lies until it is written: on the disk that it is written to."""
        folder = Path(self._record or "").absolute().parent
        return None if str(folder).startswith(outputs.AS_SUCH) or str(folder) == "/dev" else folder

    def record_to(self, path: str | None) -> None:
        """From now on the run is recorded there; None: no longer. What was recorded before is written."""
        if path == self._asked:
            return
        self._end_recording()
        self._asked = self._record = path
        if path:
            self._recorder = Recorder(self.sim, self._folder())
            self._ticks = self.sim.ticks - 1

    def follow(self, sim: Cast) -> None:
        """Takes the ticks that have passed: poses are functions of time, so they can be asked for afterwards."""
        if sim is not self.sim:
            self._next_part(sim)
            return
        if self._recorder:
            self._capture(self._recorder)
        if self._film and sim.ticks > self._ticks:
            self._film.add()
        self._ticks = sim.ticks

    def _capture(self, recorder: Recorder) -> None:
        try:
            for tick in range(self._ticks + 1, self.sim.ticks + 1):
                recorder.capture(tick / self.sim.tick_rate)
        except OSError as error:
            self._end_recording()
            self.faults.append(f"{self._record}: the recording ends at {self.sim.time:.1f} s: {error.strerror}")
            tell(f"footfall: {self.faults[-1]}")
            self._record = None

    def _end_recording(self) -> None:
        """Writes what has been recorded."""
        recorder, path, self._recorder = self._recorder, self._record, None
        if recorder and path:
            self._write({path: lambda: recorder.save(path)})

    def _next_part(self, sim: Cast) -> None:
        """Another simulation runs from now on: the recording so far is written, and another one begins beside it."""
        self._end_recording()
        if self._record:
            first = Path(str(self._asked))
            parts = (first.with_name(f"{first.stem}.{k}{first.suffix}") for k in itertools.count(2))
            self._record = str(next(path for path in parts if not path.exists() and str(path) not in self.done))
            tell(f"Starting over: the recording so far is written, and its next part will be {self._record}")
        self._begin(sim)

    def end(self, sim: Cast) -> None:
        """Writes everything; one that cannot be written does not keep the others from it, and is said."""
        if self._film:
            self._write({self._film.path: self._film.close})
        self._end_recording()
        jobs: dict[str, Callable[[], None]] = {}
        wanted = self.wanted
        if wanted.screenshot:
            from sim.view.pictures.offscreen import render_image

            jobs[wanted.screenshot] = lambda: render_image(sim, str(wanted.screenshot), wanted.size)
        if wanted.save and isinstance(sim, Simulation):
            jobs[wanted.save] = lambda: save(sim, str(wanted.save))
        if wanted.scene:
            jobs[wanted.scene] = lambda: write_scene(document_of_cast(sim, 0, *self.names), str(wanted.scene))
        self._write(jobs)

    def _write(self, jobs: dict[str, Callable[[], None]]) -> None:
        done, faults = outputs.write_all(jobs)
        self.done += done
        self.faults += faults
        for fault in faults:
            tell(f"footfall: {fault}")
