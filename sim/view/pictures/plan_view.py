"""The plan view drawn by pygame alone: what is left where there is no OpenGL."""

import itertools
from typing import Any

import numpy as np

from sim.stage.cast import Cast
from sim.view.scenery.trail import Trail
from worlds.world import World

Colour = tuple[int, int, int]

GRASS, WATER, TREE, STONE, PLASTER = (119, 146, 84), (64, 118, 130), (58, 88, 48), (143, 141, 136), (214, 203, 182)
SOLE, BODY, FLAG = (70, 62, 41), (250, 245, 230), (255, 158, 31)


class Paper:
    """A surface of pygame as a map."""

    def __init__(self, surface: Any, centre: np.ndarray, metres: float) -> None:
        """metres: what is `metres` wide around the centre (2,) [m]."""
        self.surface, self.centre, self.size = surface, centre, np.array(surface.get_size())
        self.scale = self.size[0] / metres

    def at(self, places: Any) -> np.ndarray:
        """Pixels (N, 2) of places (N, 2 or more); of none where there are none."""
        places = np.array([place[:2] for place in places], float).reshape(-1, 2)
        return (self.size / 2 + (places - self.centre) * (self.scale, -self.scale)).astype(int)

    def stamp(self, places: Any, radius: int, colour: Colour) -> None:
        """Discs of so many pixels."""
        import pygame

        disc = pygame.Surface((2 * radius + 1, 2 * radius + 1), pygame.SRCALPHA)
        pygame.draw.circle(disc, colour, (radius, radius), radius)
        self.surface.fblits([(disc, corner) for corner in (self.at(places) - radius).tolist()])


def draw_world(paper: Paper, world: World) -> None:
    """Draws what stands and flows."""
    import pygame

    surface, scale = paper.surface, paper.scale
    surface.fill(GRASS)
    rivers = [(river.points, river.width, WATER) for river in world.rivers]
    for points, width, colour in [*rivers, *((wall.points, wall.thickness, PLASTER) for wall in world.walls)]:
        for a, b in itertools.pairwise(paper.at(points)):
            pygame.draw.line(surface, colour, a.tolist(), b.tolist(), max(int(width * scale), 1))
        paper.stamp(points, int(width / 2 * scale), colour)
    for things, colour in ((world.rocks, STONE), (world.trees, TREE)):
        for place, thing in zip(paper.at(things), things, strict=True):
            pygame.draw.circle(surface, colour, place.tolist(), max(int(thing[2] * scale), 1))
    if world.goal is not None:
        pygame.draw.circle(surface, FLAG, paper.at([world.goal])[0].tolist(), max(int(world.goal_radius * scale), 4), 3)


def draw_plan(surface: Any, sim: Cast, trail: Trail, centre: np.ndarray, metres: float) -> None:
    """Draws world, footprints and bodies from above, `metres` wide around `centre` (2,), on a pygame surface."""
    paper = Paper(surface, centre, metres)
    draw_world(paper, sim.world)
    trail.look(sim)
    for rows, count in zip(trail.rows, trail.count, strict=True):
        paper.stamp(rows[:count][rows[:count, 7] <= sim.time], max(int(0.05 * paper.scale), 2), SOLE)
    paper.stamp(sim.com()[sim.present()], max(int(0.16 * paper.scale), 3), BODY)


def plan_picture(sim: Cast, size: tuple[int, int]) -> np.ndarray:
    """(height, width, 3) uint8 plan view around the first character."""
    import pygame

    surface = pygame.Surface(size)
    draw_plan(surface, sim, Trail(most=400), sim.com()[0, :2], 16.0)
    return np.ascontiguousarray(pygame.surfarray.array3d(surface).swapaxes(0, 1))
