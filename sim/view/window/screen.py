"""The 3D window: a renderer whose effort adapts to the machine, and the panel."""

import time as clock
from types import ModuleType
from typing import Any

import moderngl
import numpy as np

from sim.view.graphics import gl
from sim.view.graphics.quality import LEVELS, SOFTWARE_LEVEL
from sim.view.pictures.renderer import Renderer
from sim.view.window.app import App
from worlds.compiled.telling import tell

FRAMES, SECONDS = 8, 1.0
"""Before it is judged again, a level is given so many frames and so long [s]; UP times as long before it is raised."""
UP = 5
SOFTWARE = ("llvmpipe", "softpipe", "swrast")


class Screen3D:
    """Draws an App in a pygame window with OpenGL."""

    def __init__(self, pygame: ModuleType, size: tuple[int, int], scale: float = 1.0) -> None:
        self.pygame, self.size = pygame, size
        flags = pygame.OPENGL | pygame.DOUBLEBUF | pygame.RESIZABLE
        for key, value in context_attributes(pygame).items():
            pygame.display.gl_set_attribute(key, value)
        pygame.display.set_mode(size, flags)
        pygame.display.set_caption("Footfall")
        self.ctx = gl.window_context()
        software = any(name in self.ctx.info["GL_RENDERER"] for name in SOFTWARE)
        self.level = SOFTWARE_LEVEL if software else 0
        self.renderer = Renderer(self.ctx, LEVELS[self.level])
        self.panel = _panel(pygame, size, scale)
        self.seconds, self.drawing, self._last = 1 / 30, 0.0, clock.perf_counter()
        self._frames, self._changed = 0, self._last
        self.copy = self.ctx.program(
            vertex_shader="#version 330\nin vec2 c; out vec2 uv; void main(){uv=c*0.5+0.5;gl_Position=vec4(c,0.,1.);}",
            fragment_shader="#version 330\nuniform sampler2D t; in vec2 uv; out vec4 o; void main(){o=texture(t,uv);}",
        )
        self.blow_up = self.ctx.simple_vertex_array(self.copy, self.renderer.corners, "c")
        self._kept: list = []
        self.sheet: moderngl.Framebuffer | None = None
        self.steady = False
        self._target()

    def _target(self) -> None:
        """The picture is drawn at the quality's scale and samples, then blown up."""
        quality = self.renderer.quality = LEVELS[self.level]
        small = (max(int(self.size[0] * quality.scale), 64), max(int(self.size[1] * quality.scale), 64))
        samples = min(quality.samples, self.ctx.max_samples)
        for one in self._kept:
            one.release()
        self.picture = self.ctx.texture(small, 3)
        self.picture.filter = moderngl.LINEAR, moderngl.LINEAR
        self.flat = self.ctx.framebuffer(self.picture)
        colour, depth = self.ctx.renderbuffer(small, 3, samples=samples), self.ctx.depth_renderbuffer(small, samples=samples)
        self.target = self.ctx.framebuffer(colour, depth)
        self._kept = [self.flat, self.target, self.picture, colour, depth]

    def resize(self, size: tuple[int, int]) -> None:
        """The window has another size."""
        self.size = (max(size[0], 64), max(size[1], 64))
        self._target()

    def draw_unseen(self, size: tuple[int, int], level: int) -> None:
        """From now on draws into a sheet of its own, of any size and at one level, instead of the window."""
        if self.sheet is not None:
            self.sheet.release()
        self.sheet, self.steady, self.level = self.ctx.simple_framebuffer(size, 3), True, level
        self.resize(size)

    def pixels(self) -> np.ndarray:
        """(height, width, 3) uint8 of what was drawn last."""
        raw = (self.sheet or self.ctx.screen).read((0, 0, *self.size), 3, alignment=1)
        return np.frombuffer(raw, np.uint8).reshape(self.size[1], self.size[0], 3)[::-1]

    def takes(self, event: Any) -> bool:
        """Whether the panel uses the event."""
        return self.panel is not None and self.panel.takes(event)

    def draw(self, app: App) -> None:
        """One frame."""
        begin = clock.perf_counter()
        app.camera.follow_point(app.sim.com()[app.focus], self.seconds)
        app.camera.stay_above(app.sim.world)
        self.renderer.show_overlays, self.renderer.shown = app.show_overlays, frozenset(app.shown)
        self.renderer.draw(self.target, app.sim, app.camera, app.sim.time, app.focus)
        app.in_view = int(self.renderer.bodies.levels.sum())
        self.ctx.copy_framebuffer(self.flat, self.target)
        (self.sheet or self.ctx.screen).use()
        self.ctx.viewport = (0, 0, *self.size)
        self.ctx.disable(moderngl.DEPTH_TEST | moderngl.CULL_FACE)
        self.picture.use(0)
        self.blow_up.render()
        if self.panel:
            _ = self.ctx.error  # asking forgets: PyOpenGL would take an old one for its own
            self.panel.draw(app, self.size, 0.0 if self.steady else 1 / self.seconds)
        self.pygame.display.flip()
        self._adapt(begin)

    def _adapt(self, begin: float) -> None:
        """A level down where frames take too long and drawing is what takes it, up where there is time to spare."""
        now = clock.perf_counter()
        share = 0.1 if self._frames > FRAMES else 0.4
        self.seconds += share * (min(now - self._last, 0.5) - self.seconds)
        self.drawing += share * (min(now - begin, 0.5) - self.drawing)
        self._last, self._frames = now, self._frames + 1
        lasted = now - self._changed
        if self._frames < FRAMES or lasted < SECONDS or self.steady:
            return
        if self.seconds > LEVELS[self.level].slowest and self.drawing > 0.4 * self.seconds and self.level + 1 < len(LEVELS):
            self._change(1)
        elif self.level > 0 and lasted > UP * SECONDS and self.seconds < 0.55 * LEVELS[self.level - 1].slowest:
            self._change(-1)

    def _change(self, by: int) -> None:
        self.level, self._frames, self._changed = self.level + by, 0, clock.perf_counter()
        self._target()


def context_attributes(pygame: ModuleType) -> dict[int, int]:
    """What is asked for: a core profile of 3.3, forward compatible, since a Mac has no other beyond 2.1."""
    return {
        pygame.GL_CONTEXT_MAJOR_VERSION: 3,
        pygame.GL_CONTEXT_MINOR_VERSION: 3,
        pygame.GL_CONTEXT_PROFILE_MASK: pygame.GL_CONTEXT_PROFILE_CORE,
        pygame.GL_CONTEXT_FLAGS: pygame.GL_CONTEXT_FORWARD_COMPATIBLE_FLAG,
    }


def _panel(pygame: ModuleType, size: tuple[int, int], scale: float) -> Any:
    """The panel, or None where imgui does not run."""
    try:
        from sim.view.window.panel import Panel

        return Panel(pygame, size, scale)
    except Exception as error:  # imgui raises whatever its backend does
        tell(f"no panel: {error}")
        return None
