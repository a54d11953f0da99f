"""Bodies of all characters in view, each in the detail that can be seen: culled, posed, modelled, kind by kind."""

import numpy as np

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from motion.motion import bones_of
from motion.pose.pose import Pose
from motion.pose.skeleton import skeleton_of
from sim.stage.cast import Cast
from sim.view.bodies import figures, plans
from sim.view.bodies.clay import Clay
from sim.view.bodies.dress import Dress, colours_of
from sim.view.bodies.figure import figure_of_bones
from sim.view.graphics import detail
from worlds.compiled.tables import picked

SHADOW = 1.0
"""Bodies this far [m] outside the view are drawn too: their shadows reach into it."""
SMALLEST = 0.09
"""Parts that reach less than this, in units of the nominal leg, are left out of a REDUCED body."""
THIN = 0.1
"""Parts of a REDUCED body with less than this radius, in the same units, are flat shapes turned to the eye."""


class Bodies:
    """The clay of a cast: `fine` for bodies that are near, `coarse`, and `flat` for those far away."""

    def __init__(self) -> None:
        self.fine, self.flat = Clay(), Clay()
        self.coarse = Clay(thinner=self.flat)
        self.levels = np.zeros(4, np.int64)
        """Bodies drawn in the last frame, by level of detail."""
        self._kinds: list[Character] = []

    def model(self, sim: Cast, time: float, view: np.ndarray, height: int) -> None:
        """Fills the clay with who is in the view (4, 4), world to clip space, of a screen `height` pixels high."""
        if self._kinds is not sim.kinds:
            self._meet(sim)
        for clay in (self.fine, self.coarse, self.flat):
            clay.clear()
        self.com = sim.com(time)
        rows = np.flatnonzero(detail.in_view(view, self.com, self._reach + SHADOW) & sim.present(time))
        level = detail.level_of(detail.pixels(view, self.com[rows], self._tall[rows], height))
        pose = sim.snapshot(time, rows)
        self.levels[:] = np.bincount(level, minlength=4)
        kind = self._kind[rows]
        for k in range(len(self._kinds)):
            for each in np.unique(level[kind == k]):
                some = np.flatnonzero((kind == k) & (level == each))
                self._add(sim, time, k, int(each), rows[some], picked(pose, some))

    def _add(self, sim: Cast, time: float, k: int, level: int, rows: np.ndarray, pose: Pose) -> None:
        """Models characters `rows` in their poses, all of kind k and of one level."""
        clay = self.fine if level == detail.FULL else self.coarse if level == detail.REDUCED else self.flat
        character, unit = self._kinds[k], float(self._kinds[k].biped.leg.nominal_length)
        reduced = unit if level == detail.REDUCED else 0.0
        clay.smallest, clay.thin = SMALLEST * reduced, THIN * reduced
        dress = Dress(character.look, unit, **{key: colour[rows] for key, colour in self._colours.items()})
        bones = sim.shaped(bones_of(character, pose, self._skeletons[k]), rows, time)
        figure = figure_of_bones(character, bones, self._skeletons[k])
        if level in (detail.FULL, detail.REDUCED):
            plans.PLANS[character.look.plan](clay, dress, figure)
        else:
            figures.FIGURES[character.look.plan](clay, dress, figure, level == detail.DISTANT)
        for clay in (self.fine, self.coarse, self.flat):
            clay.smallest, clay.thin = 0.0, 0.0

    def _meet(self, sim: Cast) -> None:
        """What stays the same from frame to frame: kinds, sizes and colours."""
        self._kinds, self._kind = sim.kinds, sim.kind
        self._skeletons = [skeleton_of(character) for character in self._kinds]
        self._reach = np.array([_reach(character.biped) for character in self._kinds])[self._kind]
        self._tall = 1.9 * np.array([float(character.biped.leg.nominal_length) for character in self._kinds])[self._kind]
        self._colours = colours_of([self._kinds[k] for k in self._kind], sim.seed)


def _reach(biped: Dimensions) -> float:
    """Radius of a sphere about the com that holds the body [m]."""
    body, leg = biped.body, biped.leg
    tail, head = abs(body.tail_forward) + body.tail_length, np.hypot(body.head_forward, body.head_up)
    legs = leg.max_length + abs(leg.hip_up) + biped.foot.length
    return float(max(1.5 * leg.nominal_length, legs, tail, head + 0.5 * leg.nominal_length))


def outline(character: Character) -> np.ndarray:
    """(Q, 3, 2) triangles of the character's footprint, forward and left of the sole's middle [m]."""
    half, wide = 0.5 * character.biped.foot.length, 0.5 * character.biped.foot.width
    if character.look.plan == "human":
        return np.concatenate([_oval(-0.6 * half, 0, 0.42 * half, 0.62 * wide), _oval(0.3 * half, 0, 0.7 * half, wide)])
    ball = -0.35 * half
    parts = [_oval(ball, 0, 0.3 * half, 0.4 * wide)]
    for k in (-1, 0, 1):
        tip = (half if k == 0 else 0.72 * half, k * wide)
        w = 0.15 * wide
        parts.append(np.array([[(ball, -w), tip, (ball, w)]]))
    return np.concatenate(parts)


def _oval(x: float, y: float, a: float, biped: float, sides: int = 9) -> np.ndarray:
    angles = np.linspace(0, 2 * np.pi, sides + 1)
    rim = np.stack([x + a * np.cos(angles), y + biped * np.sin(angles)], axis=1)
    middle = np.broadcast_to((x, y), rim[:-1].shape)
    return np.stack([middle, rim[:-1], rim[1:]], axis=1)
