"""The studio's window: space drawn by the renderer into a texture, all else by imgui over it; adapts to the machine."""

from types import ModuleType
from typing import Any

import moderngl
import numpy as np
from imgui_bundle import imgui
from imgui_bundle.python_backends.opengl_backend_programmable import ProgrammablePipelineRenderer

from sim.view import theme
from sim.view.graphics import gl
from sim.view.graphics.quality import LEVELS, SOFTWARE_LEVEL
from sim.view.pictures.renderer import Renderer
from sim.view.studio.desk.desk import Desk
from sim.view.studio.table.canvas import Space
from sim.view.window.screen import SOFTWARE, context_attributes

SLOW, QUICK, FRAMES = 0.026, 0.012, 12
"""Seconds of a frame from which on, and below which, the picture of space is drawn with less or more effort; frames between."""


class StudioScreen:
    """A pygame window with OpenGL and imgui."""

    def __init__(self, pygame: ModuleType, size: tuple[int, int], scale: float) -> None:
        self.pygame, self.size, self.scale = pygame, size, scale
        for key, value in context_attributes(pygame).items():
            pygame.display.gl_set_attribute(key, value)
        try:
            pygame.display.set_mode(size, pygame.OPENGL | pygame.DOUBLEBUF | pygame.RESIZABLE)
        except pygame.error as error:  # a display without OpenGL
            raise gl.NoGL(str(error)) from None
        pygame.display.set_caption("Footfall studio")
        self.ctx = gl.window_context()
        self.software = any(name in self.ctx.info["GL_RENDERER"] for name in SOFTWARE)
        self.level = SOFTWARE_LEVEL if self.software else 0
        self.renderer = Renderer(self.ctx, LEVELS[self.level])
        self.renderer.show_overlays = False
        imgui.create_context()
        imgui.get_io().set_ini_filename("")
        imgui.get_io().display_size = imgui.ImVec2(*size)
        theme.load_letters()
        theme.dress(scale)
        self.backend = ProgrammablePipelineRenderer()
        self._kept: list[Any] = []
        self._for: tuple[int, int, int] = (0, 0, -1)
        self.texture: moderngl.Texture | None = None
        self.sheet: moderngl.Framebuffer | None = None
        self.seconds, self._frames, self.steady = 0.016, 0, False

    def resize(self, size: tuple[int, int]) -> None:
        """The window has another size."""
        self.size = (max(size[0], 64), max(size[1], 64))
        if self.sheet is not None:
            self.draw_unseen()

    def draw_unseen(self) -> None:
        """From now on draws into a sheet of its own, of any size, instead of the window."""
        if self.sheet is not None:
            self.sheet.release()
        self.sheet = self.ctx.simple_framebuffer(self.size, 3)

    def pixels(self) -> np.ndarray:
        """(height, width, 3) uint8 of what was drawn last."""
        shown = self.sheet or self.ctx.screen
        raw = shown.read((0, 0, *self.size), 3, alignment=1)
        return np.frombuffer(raw, np.uint8).reshape(self.size[1], self.size[0], 3)[::-1]

    def picture(self, desk: Desk, space: Space) -> Any:
        """The picture of space, for imgui."""
        quality = LEVELS[self.level]
        small = (max(int(space.box.width * quality.scale), 16), max(int(space.box.height * quality.scale), 16))
        if self._for != (*small, self.level):
            self._make(small)
        assert self.texture is not None
        self.renderer.draw(self._target, desk.show, space.camera, desk.show.moment(desk.playing.time), desk.track)
        self.ctx.copy_framebuffer(self._flat, self._target)
        return imgui.ImTextureRef(self.texture.glo)

    def _make(self, size: tuple[int, int]) -> None:
        for one in self._kept:
            one.release()
        quality = self.renderer.quality = LEVELS[self.level]
        samples = min(quality.samples, self.ctx.max_samples)
        self.texture = self.ctx.texture(size, 3)
        self.texture.filter = moderngl.LINEAR, moderngl.LINEAR
        self._flat = self.ctx.framebuffer(self.texture)
        colour, depth = self.ctx.renderbuffer(size, 3, samples=samples), self.ctx.depth_renderbuffer(size, samples=samples)
        self._target = self.ctx.framebuffer(colour, depth)
        self._kept = [self._flat, self._target, self.texture, colour, depth]
        self._for = (*size, self.level)

    def begin(self, seconds: float) -> None:
        """A new frame of imgui."""
        io = imgui.get_io()
        io.display_size, io.delta_time = imgui.ImVec2(*self.size), max(seconds, 1e-4)
        imgui.new_frame()

    def end(self) -> None:
        """Draws what imgui has, and shows it."""
        imgui.render()
        (self.sheet or self.ctx.screen).use()
        self.ctx.viewport = (0, 0, *self.size)
        self.ctx.clear(*theme.TABLE)
        self.ctx.disable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        _ = self.ctx.error  # asking forgets: PyOpenGL would take an old one for its own
        self.backend.render(imgui.get_draw_data())
        self.pygame.display.flip()

    def adapt(self, seconds: float) -> None:
        """Takes how long a frame was worked on; draws space with less or more effort where that helps."""
        self.seconds += 0.15 * (min(seconds, 0.5) - self.seconds)
        self._frames += 1
        if self._frames < FRAMES or self.steady:
            return
        if self.seconds > SLOW and self.level + 1 < len(LEVELS):
            self.level, self._frames = self.level + 1, 0
        elif self.seconds < QUICK and self.level > (SOFTWARE_LEVEL if self.software else 0) and self._frames > 20 * FRAMES:
            self.level, self._frames = self.level - 1, 0

    def set_scale(self, scale: float) -> None:
        """Draws all letters and handles larger or smaller."""
        self.scale = min(max(scale, 0.6), 4.0)
        theme.dress(self.scale)

    def close(self) -> None:
        """Gives imgui's context back, so that another window may be opened."""
        imgui.destroy_context()
