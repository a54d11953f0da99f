"""Films of a run: frames are handed to ffmpeg, which writes beside the film; it takes its place when it is complete."""

import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from sim.files.outputs import Part
from sim.stage.cast import Cast
from sim.stage.run import Bar
from sim.view.graphics.gl import NoGL
from sim.view.graphics.quality import Quality
from sim.view.pictures.offscreen import Picture
from worlds.compiled import leaving
from worlds.errors import InputError

QUALITY = Quality(1024, 4, 4)
"""As the contact sheets: a larger map of shadows takes a tenth more of the time, and moving pictures do not show it."""
RATE = 30
"""Frames per second of a film."""
_H264 = (
    "-c:v",
    "libx264",
    "-preset",
    "veryfast",
    "-crf",
    "10",
    "-pix_fmt",
    "yuv420p",
    "-vf",
    "scale=trunc(iw/2)*2:trunc(ih/2)*2",
)
_VP9 = ("-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "realtime", "-cpu-used", "5", "-pix_fmt", "yuv420p")
KINDS = {
    ".mp4": ("mp4", _H264), ".m4v": ("mp4", _H264), ".mov": ("mov", _H264), ".mkv": ("matroska", _H264),
    ".avi": ("avi", _H264), ".webm": ("webm", _VP9), ".gif": ("gif", ()),
}  # fmt: skip
"""How ffmpeg calls the kinds of films, by the endings of their names, and how it makes them."""


def ffmpeg_for(path: str) -> str:
    """Where ffmpeg is. Raises InputError where there is none, or no such kind of film."""
    if Path(path).suffix.lower() not in KINDS:
        raise InputError(f"{path}: a film's name must end in {', '.join(KINDS)}")
    try:
        import imageio_ffmpeg

        return imageio_ffmpeg.get_ffmpeg_exe()
    except (ImportError, RuntimeError) as error:
        raise InputError(f"{path}: films need ffmpeg: pip install imageio-ffmpeg ({error})") from None


class Film:
    """A film of a run, 30 frames per simulated second, whole or not at all. Needs the extra `video`."""

    def __init__(self, sim: Cast, path: str, size: tuple[int, int]) -> None:
        """Raises InputError where no film can be made."""
        self.sim, self.path = sim, path
        ffmpeg = ffmpeg_for(path)
        try:
            self.picture = Picture(size, QUALITY)
        except NoGL as error:
            raise InputError(f"{path}: {error}") from None
        self._every, self._fault, self._frames = max(round(sim.tick_rate / RATE), 1), "", 0
        self._part = Part(path)
        self._said = tempfile.TemporaryFile()  # noqa: SIM115 (ffmpeg writes to it for as long as this lives)
        kind, how = KINDS[Path(path).suffix.lower()]
        raw = ("-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{size[0]}x{size[1]}", "-r", str(sim.tick_rate / self._every))
        self._ffmpeg = subprocess.Popen(
            [ffmpeg, "-y", "-loglevel", "error", *raw, "-i", "-", "-an", *how, "-f", kind, str(self._part.path)],
            stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=self._said,
            start_new_session=os.name == "posix",  # Ctrl-C is ours: the film is ended when we have given it all
        )  # fmt: skip
        leaving.remember(self, self._ffmpeg.kill)

    def add(self) -> None:
        """After a tick: adds a frame when one is due."""
        if self.sim.ticks % self._every == 0:
            self._write()

    def go_on(self, ticks: int) -> None:
        """Films this moment, and so many ticks from now on; tells how much is done."""
        self.add()
        bar = Bar()
        for k in range(ticks):
            self.sim.tick()
            self.add()
            if k % 30 == 0 or k == ticks - 1:
                bar.show((k + 1) / ticks)
        bar.end()

    def _write(self) -> None:
        """A frame of now; where ffmpeg has ended, `close` says so, and the run goes on for its other results."""
        if self._fault or self._ffmpeg.stdin is None:
            return
        try:
            self._ffmpeg.stdin.write(np.ascontiguousarray(self.picture.frame(self.sim)).data)
            self._frames += 1
        except OSError as error:
            self._fault = str(error)

    def close(self) -> None:
        """Ends the film, which is now in its place. Raises InputError where there is none."""
        if not self._frames:
            self._write()
        status = self._end()
        if self._fault or status:
            self._part.drop()
            raise InputError(f"{self.path}: the film could not be made: {self._words() or self._fault}")
        self._part.keep()

    def _end(self) -> int:
        try:
            if self._ffmpeg.stdin is not None:
                self._ffmpeg.stdin.close()
        except OSError as error:
            self._fault = str(error)
        status = self._ffmpeg.wait()
        leaving.forget(self)
        return status

    def _words(self) -> str:
        """What ffmpeg has said last."""
        self._said.seek(0)
        lines = self._said.read().decode("utf-8", "replace").strip().splitlines()
        return lines[-1] if lines else ""
