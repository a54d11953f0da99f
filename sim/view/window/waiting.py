"""The window of a first start: the world from above, and how far the compiler has come. Neither kernels nor OpenGL draw it."""

import os
import re
import threading
import time as clock
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from sim.view.pictures.plan_view import Paper, draw_world
from worlds.compiled.leaving import leave_nothing
from worlds.world import World

Job = Callable[[Callable[[str], None]], None]
"""Something that takes long, and tells how far it has come: "compiling 3 of 8: poses ..."."""
PATIENCE, FRAME = 0.3, 0.05
"""Seconds after which the window opens, and between two of its pictures."""
INK, PAPER, DONE = (238, 238, 232), (24, 27, 32), (255, 189, 76)
USUAL = 12.0
"""Seconds that one of the parts may take: the bar moves on meanwhile, ever more slowly."""


class _Work(threading.Thread):
    """The job, in a thread of its own."""

    def __init__(self, job: Job, tell: Callable[[str], None]) -> None:
        super().__init__(daemon=True)
        self.job, self.tell, self.said, self.since = job, tell, "", clock.monotonic()
        self.fault: BaseException | None = None

    def run(self) -> None:
        """Does it."""
        try:
            self.job(self._hear)
        except BaseException as error:  # raised again where it is waited for
            self.fault = error

    def _hear(self, text: str) -> None:
        self.said, self.since = text, clock.monotonic()
        self.tell(text)

    @property
    def share(self) -> float:
        """How much is done, 0 to 1."""
        found = re.search(r"(\d+) of (\d+)", self.said)
        if found is None:
            return 0.0
        lasts = (clock.monotonic() - self.since) / USUAL
        return (int(found[1]) - 1 + lasts / (1 + lasts)) / int(found[2])


def wait_for(job: Job, tell: Callable[[str], None], world: World | None, size: tuple[int, int]) -> None:
    """Does the job; where that takes long, in a window that shows the world meanwhile. Raises what the job raises."""
    work = _Work(job, tell)
    work.start()
    work.join(PATIENCE)
    if work.is_alive():
        _show(work, world, size)
    if work.fault is not None:
        raise work.fault


def _show(work: _Work, world: World | None, size: tuple[int, int]) -> None:
    import pygame

    pygame.display.init()
    pygame.font.init()
    surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    pygame.display.set_caption("Footfall")
    while work.is_alive():
        for event in pygame.event.get():
            if event.type == pygame.QUIT or (event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE):
                leave_nothing()
                os._exit(0)  # the compiler hears nothing for seconds
            if event.type == pygame.VIDEORESIZE:
                surface = pygame.display.get_surface() or surface
        draw(pygame, surface, world, work.share, work.said)
        pygame.display.flip()
        work.join(FRAME)
    pygame.display.quit()


def draw(pygame: ModuleType, surface: Any, world: World | None, share: float, said: str) -> None:
    """The world from above, and a bar below it."""
    width, height = surface.get_size()
    surface.fill(PAPER)
    if world is not None:
        metres = 1.06 * max(world.size[0], world.size[1] * width / height)
        draw_world(Paper(surface, np.array(world.size) / 2, metres), world)
    tall, edge = max(height // 9, 44), max(width // 40, 12)
    pygame.draw.rect(surface, PAPER, (0, height - tall, width, tall))
    letters = pygame.font.Font(None, max(tall // 2 - 4, 18))
    words = letters.render("Getting ready, once on this machine", True, INK)
    surface.blit(words, (edge, height - tall + 4))
    if said:
        part = letters.render(said.replace(" ...", ""), True, INK)
        if part.get_width() + words.get_width() + 3 * edge < width:
            surface.blit(part, (width - edge - part.get_width(), height - tall + 4))
    bar = pygame.Rect(edge, height - tall // 3, width - 2 * edge, tall // 6)
    pygame.draw.rect(surface, (70, 76, 84), bar, border_radius=bar.height // 2)
    done = bar.copy()
    done.width = max(int(bar.width * share), bar.height)
    pygame.draw.rect(surface, DONE, done, border_radius=bar.height // 2)
