"""Pictures without a window, through the same renderer."""

from pathlib import Path

import numpy as np
from PIL import Image

from sim.files import outputs
from sim.stage.cast import Cast
from sim.view.graphics.camera import Camera
from sim.view.graphics.gl import NoGL, offscreen_context
from sim.view.graphics.quality import Quality
from sim.view.pictures.renderer import Renderer
from worlds.compiled.telling import tell
from worlds.errors import InputError

ENDINGS = {
    ".png": "PNG", ".jpg": "JPEG", ".jpeg": "JPEG", ".webp": "WEBP", ".bmp": "BMP", ".gif": "GIF", ".tif": "TIFF",
    ".tiff": "TIFF", ".ppm": "PPM", ".pdf": "PDF",
}  # fmt: skip
"""Kinds of pictures by the endings of their names."""


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
        """(height, width, 3) uint8 of a moment [s], by default now: the site, or a character and those around it."""
        time = sim.time if time is None else time
        unit = sim.leg(focus)
        if (site := sim.site) is not None:
            self.camera.frame(site.middle, site.radius, self.distance * unit)
        else:
            self.camera.meet(sim.com(time), focus, self.distance * unit)
            self.camera.target -= (0, 0, 0.25 * unit)
        return self.shoot(sim, focus, time)

    def cut_out(self, sim: Cast, time: float) -> np.ndarray:
        """(height, width, 4) uint8 of the first character at a moment [s], without what is around it: transparent there."""
        self.renderer.alone = True
        unit = sim.leg(0)
        self.camera.frame(sim.com(time)[0] - (0, 0, 0.25 * unit), 0.0, self.distance * unit)
        self.renderer.draw(self.target, sim, self.camera, time, 0)
        self.ctx.copy_framebuffer(self.resolved, self.target)
        width, height = self.target.size
        pixels = np.frombuffer(self.resolved.read(components=4), np.uint8).reshape(height, width, 4)[::-1].astype(float)
        pixels[..., :3] /= np.maximum(pixels[..., 3:] / 255, 1e-3)  # edges were mixed with nothing
        return np.clip(np.round(pixels), 0, 255).astype(np.uint8)

    def shoot(self, sim: Cast, focus: int, time: float) -> np.ndarray:
        """(height, width, 3) uint8 as the camera stands."""
        self.renderer.draw(self.target, sim, self.camera, time, focus)
        self.ctx.copy_framebuffer(self.resolved, self.target)
        width, height = self.target.size
        return np.frombuffer(self.resolved.read(), np.uint8).reshape(height, width, 3)[::-1]


def save_image(pixels: np.ndarray, path: str | Path) -> None:
    """Writes a picture, whole or not at all. Raises InputError."""
    try:
        with outputs.whole(path) as temporary:
            Image.fromarray(pixels).save(temporary, format=kind_of(path), quality=90)
    except (ValueError, KeyError) as error:
        raise (
            error if isinstance(error, InputError) else InputError(f"{path}: the picture cannot be written: {error}")
        ) from None


def kind_of(path: str | Path) -> str:
    """The kind of picture that a name asks for; PNG where it has no ending. Raises InputError for unknown ones."""
    ending = Path(path).suffix.lower()
    if ending and ending not in ENDINGS:
        raise InputError(f"{path}: a picture's name must end in {', '.join(ENDINGS)}")
    return ENDINGS.get(ending, "PNG")


def render_image(sim: Cast, path: str | Path, size: tuple[int, int]) -> None:
    """A picture of the present moment; without OpenGL, the plan view, and a line that says what would bring 3D."""
    try:
        pixels = Picture(size).frame(sim)
    except NoGL as error:
        from sim.view.pictures.plan_view import plan_picture

        tell(str(error))
        pixels = plan_picture(sim, size)
    save_image(pixels, path)
