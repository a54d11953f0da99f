"""The plan view drawn by pygame alone: what is left where there is no OpenGL."""

import itertools
import os

import numpy as np

from sim.stage.cast import Cast
from sim.view.scenery.trail import Trail
from sim.view.window.app import FRAME, App

GRASS, WATER, TREE, STONE = (119, 146, 84), (64, 118, 130), (58, 88, 48), (143, 141, 136)
SOLE, BODY = (70, 62, 41), (250, 245, 230)


def draw_plan(surface, sim: Cast, trail: Trail, centre: np.ndarray, metres: float) -> None:
    """Draws world, footprints and bodies from above, `metres` wide around `centre` (2,), on a pygame surface."""
    import pygame

    size = np.array(surface.get_size())
    scale = size[0] / metres

    def at(places) -> np.ndarray:
        """Pixels (N, 2) of places (N, 2 or more)."""
        return (size / 2 + (np.reshape(places, (len(places), -1))[:, :2] - centre) * (scale, -scale)).astype(int)

    def stamp(places, radius: int, colour) -> None:
        disc = pygame.Surface((2 * radius + 1, 2 * radius + 1), pygame.SRCALPHA)
        pygame.draw.circle(disc, colour, (radius, radius), radius)
        surface.fblits([(disc, corner) for corner in (at(places) - radius).tolist()])

    surface.fill(GRASS)
    for river in sim.world.rivers:
        for a, b in itertools.pairwise(at(river.points)):
            pygame.draw.line(surface, WATER, a.tolist(), b.tolist(), max(int(river.width * scale), 1))
        stamp(river.points, int(river.width / 2 * scale), WATER)
    for things, colour in ((sim.world.rocks, STONE), (sim.world.trees, TREE)):
        for place, thing in zip(at(things), things, strict=True):
            pygame.draw.circle(surface, colour, place.tolist(), max(int(thing[2] * scale), 1))
    trail.look(sim)
    for rows, count in zip(trail.rows, trail.count, strict=True):
        stamp(rows[:count][rows[:count, 7] <= sim.time], max(int(0.05 * scale), 2), SOLE)
    stamp(sim.com(), max(int(0.16 * scale), 3), BODY)


def plan_picture(sim: Cast, size: tuple[int, int]) -> np.ndarray:
    """(height, width, 3) uint8 plan view around the first character."""
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
    import pygame

    surface = pygame.Surface(size)
    draw_plan(surface, sim, Trail(most=400), sim.com()[0, :2], 16.0)
    return np.ascontiguousarray(pygame.surfarray.array3d(surface).swapaxes(0, 1))


class PlanScreen:
    """The window without OpenGL."""

    def __init__(self, pygame, size: tuple[int, int]) -> None:
        self.pygame, self.size = pygame, size
        self.surface = pygame.display.set_mode(size, pygame.RESIZABLE)
        self.trail = Trail(most=400)
        pygame.display.set_caption("Footfall (plan view)")

    def takes(self, event) -> bool:
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
