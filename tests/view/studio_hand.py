"""A hand for tests of the studio: what it does are events, as a window sends them."""

import numpy as np


class Hand:
    """Mouse and keys."""

    def __init__(self, studio, pygame):
        self.studio, self.pygame, self.desk = studio, pygame, studio.desk
        self.place = (0, 0)

    def frames(self, count=1):
        for _ in range(count):
            self.studio.frame(1 / 60)

    def key(self, name, mod=0):
        pg = self.pygame
        code = pg.key.key_code(name)
        for kind in (pg.KEYDOWN, pg.KEYUP):
            text = name if len(name) == 1 and not mod else ""
            self.studio.handle(pg.event.Event(kind, key=code, mod=mod, unicode=text))
        self.frames()

    def move(self, x, y):
        self.place = (int(x), int(y))
        self.studio.handle(self.pygame.event.Event(self.pygame.MOUSEMOTION, pos=self.place, rel=(1, 1), buttons=(0, 0, 0)))
        self.frames()

    def press(self, button=1):
        self.studio.handle(self.pygame.event.Event(self.pygame.MOUSEBUTTONDOWN, pos=self.place, button=button))
        self.frames()

    def release(self, button=1):
        self.studio.handle(self.pygame.event.Event(self.pygame.MOUSEBUTTONUP, pos=self.place, button=button))
        self.frames()

    def click(self, x, y, button=1):
        self.move(x, y), self.press(button), self.release(button)

    def drag(self, start, end, steps=6):
        self.move(*start), self.press()
        for share in np.linspace(0, 1, steps + 1)[1:]:
            self.move(*(np.array(start) + share * (np.array(end) - np.array(start))))
        self.release()

    def on_plan(self, x, y):
        """Where a place of the world is in the plan."""
        return self.studio.views.plan.project(np.array([[x, y, 0.0]]))[0]
