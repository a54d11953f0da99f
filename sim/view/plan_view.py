"""The plan view drawn by pygame alone: what is left where there is no OpenGL."""

import os

import numpy as np

from sim.cast import Cast

GRASS, WATER, TREE, STONE, LEFT, RIGHT = (
    (119, 146, 84),
    (64, 118, 130),
    (58, 88, 48),
    (143, 141, 136),
    (214, 70, 200),
    (205, 45, 40),
)


def draw_plan(surface, sim: Cast, centre: np.ndarray, metres: float) -> None:
    """Draws world, footprints and bodies from above, `metres` wide around `centre` (2,), on a pygame surface."""
    import pygame

    width, height = surface.get_size()
    scale = width / metres

    def at(p):
        return int(width / 2 + (p[0] - centre[0]) * scale), int(height / 2 - (p[1] - centre[1]) * scale)

    surface.fill(GRASS)
    for river in sim.world.rivers:
        for a, b in zip(river.points, river.points[1:], strict=False):
            pygame.draw.line(surface, WATER, at(a), at(b), max(int(river.width * scale), 1))
        for p in river.points:
            pygame.draw.circle(surface, WATER, at(p), int(river.width / 2 * scale))
    for things, colour in ((sim.world.rocks, STONE), (sim.world.trees, TREE)):
        for thing in things:
            pygame.draw.circle(surface, colour, at(thing), max(int(thing[2] * scale), 1))
    log = sim.footprints.arrays(sim.crowd, last=400)
    for place, side in zip(log["footprint_position"], log["footprint_side"], strict=True):
        pygame.draw.circle(surface, RIGHT if side else LEFT, at(place), max(int(0.05 * scale), 2))
    for com in sim.snapshot().com:
        pygame.draw.circle(surface, (250, 245, 230), at(com), max(int(0.16 * scale), 3))


def plan_picture(sim: Cast, size: tuple[int, int]) -> np.ndarray:
    """(height, width, 3) uint8 plan view around the first character."""
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
    import pygame

    surface = pygame.Surface(size)
    draw_plan(surface, sim, sim.snapshot().com[0, :2], 16.0)
    return np.ascontiguousarray(pygame.surfarray.array3d(surface).swapaxes(0, 1))
