"""Pictures and films without a window, through the same renderer."""

import os
from pathlib import Path

import numpy as np
from PIL import Image

from sim.stage.cast import Cast
from sim.view.graphics.camera import Camera
from sim.view.graphics.gl import NoGL, offscreen_context
from sim.view.graphics.quality import Quality
from sim.view.pictures.renderer import Renderer
from worlds.errors import InputError

FILM_RATE = 30
"""Frames per second of a film."""


class Picture:
    """Renders frames of a simulation in memory, following its first character."""

    def __init__(self, size: tuple[int, int], quality: Quality | None = None) -> None:
        self.ctx = offscreen_context()
        self.renderer = Renderer(self.ctx, quality)
        samples = min(self.renderer.quality.samples, self.ctx.max_samples)
        self.target = self.ctx.framebuffer(
            self.ctx.renderbuffer(size, samples=samples), self.ctx.depth_renderbuffer(size, samples=samples)
        )
        self.resolved = self.ctx.framebuffer(self.ctx.renderbuffer(size))
        self.camera = Camera()
        self.distance = 5.2  # in nominal leg lengths

    def frame(self, sim: Cast, focus: int = 0, time: float | None = None) -> np.ndarray:
        """(height, width, 3) uint8 of a moment [s], by default now: a character, and of those around it a crowd."""
        time = sim.time if time is None else time
        unit = sim.leg(focus)
        self.camera.meet(sim.com(time), focus, self.distance * unit)
        self.camera.target -= (0, 0, 0.25 * unit)
        return self.shoot(sim, focus, time)

    def shoot(self, sim: Cast, focus: int, time: float) -> np.ndarray:
        """(height, width, 3) uint8 as the camera stands."""
        self.renderer.draw(self.target, sim, self.camera, time, focus)
        self.ctx.copy_framebuffer(self.resolved, self.target)
        width, height = self.target.size
        return np.frombuffer(self.resolved.read(), np.uint8).reshape(height, width, 3)[::-1]


def save_image(pixels: np.ndarray, path: str | Path) -> None:
    """Writes a picture, whole or not at all. Raises InputError."""
    path = Path(path)
    temporary = path.with_name(path.name + ".part")
    try:
        format = Image.registered_extensions().get(path.suffix.lower(), "PNG")
        Image.fromarray(pixels).save(temporary, format=format, quality=90)
        os.replace(temporary, path)
    except (OSError, ValueError, KeyError) as error:
        temporary.unlink(missing_ok=True)
        raise InputError(f"{path}: the picture cannot be written: {error}") from None


def render_image(sim: Cast, path: str | Path, size: tuple[int, int]) -> None:
    """A picture of the present moment; without OpenGL, the plan view, and a line that says what would bring 3D."""
    try:
        pixels = Picture(size).frame(sim)
    except NoGL as error:
        import sys

        from sim.view.pictures.plan_view import plan_picture

        print(error, file=sys.stderr)
        pixels = plan_picture(sim, size)
    save_image(pixels, path)


class VideoWriter:
    """A film of a run, 30 frames per simulated second. Needs the extra `video`."""

    def __init__(self, sim: Cast, path: str, size: tuple[int, int]) -> None:
        try:
            import imageio_ffmpeg
        except ImportError:
            raise InputError(f"{path}: films need imageio-ffmpeg: pip install imageio-ffmpeg") from None
        self.sim, self.path = sim, path
        try:
            self.picture = Picture(size)
        except NoGL as error:
            raise InputError(f"{path}: {error}") from None
        self._every = max(sim.tick_rate // FILM_RATE, 1)
        self._writer = imageio_ffmpeg.write_frames(
            path, size, fps=sim.tick_rate / self._every, macro_block_size=2, quality=8, ffmpeg_log_level="error"
        )
        self._writer.send(None)

    def add(self) -> None:
        """After a tick: adds a frame when one is due."""
        if self.sim.ticks % self._every == 0:
            self._writer.send(np.ascontiguousarray(self.picture.frame(self.sim)))

    def close(self) -> None:
        """Ends the film."""
        self._writer.close()
