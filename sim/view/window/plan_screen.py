"""The window without OpenGL: the plan view, drawn by pygame alone."""

from types import ModuleType
from typing import Any

import numpy as np

from sim.view.pictures.plan_view import draw_plan
from sim.view.scenery.trail import Trail
from sim.view.window.app import FRAME, App


class PlanScreen:
    """The window without OpenGL."""

    def __init__(self, pygame: ModuleType, size: tuple[int, int]) -> None:
        self.pygame, self.size = pygame, size
        self.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
        self.trail = Trail(most=400)
        pygame.display.set_caption("Footfall (plan view)")

    def takes(self, event: Any) -> bool:
        """No panel, so no event is taken."""
        return False

    def resize(self, size: tuple[int, int]) -> None:
        """The window has another size."""
        self.size = size

    def draw(self, app: App) -> None:
        """One frame."""
        app.camera.plan = True
        app.camera.follow_point(app.sim.com()[app.focus], FRAME)
        draw_plan(self.surface, app.sim, self.trail, np.asarray(app.camera.target[:2]), 3.0 * app.camera.distance)
        self.pygame.display.flip()
