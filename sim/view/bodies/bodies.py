"""Bodies of all characters in view, each in the detail that can be seen: culled, posed, modelled, kind by kind."""

from dataclasses import replace

import numpy as np

from motion.characters.biped import Biped
from motion.pose.pose import Pose
from sim.stage.cast import Cast
from sim.view.bodies import figures, plans
from sim.view.bodies.clay import Clay
from sim.view.graphics import detail

SHADOW = 1.0
"""Bodies this far [m] outside the view are drawn too: their shadows reach into it."""
SMALLEST = 0.09
"""Parts that reach less than this, in units of the nominal leg, are left out of a REDUCED body."""
THIN = 0.1
"""Parts of a REDUCED body with less than this radius, in the same units, are flat shapes turned to the eye."""
BRIGHTNESS, HUE = 0.16, {"human": 0.5}
"""By how much characters of one kind differ in brightness, and in the hue of their first two colours [turns]: people dress."""
LITTLE = 0.025
"""Difference in hue of all others [turns]."""
COLOURS = ("main", "second", "skin", "detail")


class Bodies:
    """The clay of a cast: `fine` for bodies that are near, `coarse`, and `flat` for those far away."""

    def __init__(self) -> None:
        self.fine, self.flat = Clay(), Clay()
        self.coarse = Clay(thinner=self.flat)
        self.levels = np.zeros(4, np.int64)
        """Bodies drawn in the last frame, by level of detail."""
        self._sim: Cast | None = None

    def model(self, sim: Cast, time: float, view: np.ndarray, height: int) -> None:
        """Fills the clay with who is in the view (4, 4), world to clip space, of a screen `height` pixels high."""
        if self._sim is not sim:
            self._meet(sim)
        for clay in (self.fine, self.coarse, self.flat):
            clay.clear()
        self.com = sim.com(time)
        rows = np.flatnonzero(detail.in_view(view, self.com, self._reach + SHADOW))
        level = detail.level_of(detail.pixels(view, self.com[rows], self._tall[rows], height))
        pose = sim.snapshot(time, rows)
        self.levels[:] = np.bincount(level, minlength=4)
        kind = sim.crowd.kind[rows]
        for k, biped in enumerate(self._bipeds):
            for each in np.unique(level[kind == k]):
                self._add(biped, int(each), np.flatnonzero((kind == k) & (level == each)), rows, pose)

    def _add(self, biped: Biped, level: int, some: np.ndarray, rows: np.ndarray, pose: Pose) -> None:
        """Models `some` of the rows of a pose, all of one kind and level."""
        clay = self.fine if level == detail.FULL else self.coarse if level == detail.REDUCED else self.flat
        unit = float(biped.record.nominal_length) if level == detail.REDUCED else 0.0
        clay.smallest, clay.thin = SMALLEST * unit, THIN * unit
        dressed = replace(biped, body=biped.body | {key: self._colours[key][rows[some]] for key in COLOURS})
        plan, part = biped.body.get("plan", "human"), Pose(*(array[some] for array in pose))
        if level in (detail.FULL, detail.REDUCED):
            plans.PLANS.get(plan, plans.human)(clay, dressed, part)
        else:
            figures.FIGURES.get(plan, figures.human)(clay, dressed, part, level == detail.DISTANT)
        for clay in (self.fine, self.coarse, self.flat):
            clay.smallest, clay.thin = 0.0, 0.0

    def _meet(self, sim: Cast) -> None:
        """What stays the same from frame to frame: kinds, sizes and colours."""
        self._sim, kind = sim, sim.crowd.kind
        self._bipeds = kinds_of(sim)
        self._reach = np.array([_reach(biped) for biped in self._bipeds])[kind]
        self._tall = 1.9 * np.array([float(biped.record.nominal_length) for biped in self._bipeds])[kind]
        self._colours = _colours([self._bipeds[k] for k in kind], sim.seed)


def _colours(bipeds: list[Biped], seed: int) -> dict[str, np.ndarray]:
    """COLOURS of each character, (C, 3): its file's, varied by chance; the first one's are just those."""
    chance = np.random.Generator(np.random.Philox(key=seed)).uniform(-1, 1, (len(bipeds), 1 + len(COLOURS)))
    chance[0] = 0.0
    hue = 2 * np.pi * np.array([HUE.get(biped.body.get("plan", "human"), LITTLE) for biped in bipeds]) * chance[:, 0]
    colours = {}
    for k, key in enumerate(COLOURS):
        own = np.array([biped.body.get(key, (0.7, 0.7, 0.7)) for biped in bipeds])
        turned = _turned(own, hue) if k < 2 else own
        colours[key] = np.clip(turned * (1 + BRIGHTNESS * chance[:, 1 + k : 2 + k]), 0, 1)
    return colours


def _turned(colour: np.ndarray, hue: np.ndarray) -> np.ndarray:
    """Colours (C, 3) turned about the grey axis by hue (C,) [rad]."""
    c, s = np.cos(hue)[:, None], np.sin(hue)[:, None] / np.sqrt(3)
    r, g, b = colour.T
    return c * colour + (1 - c) * colour.mean(axis=1, keepdims=True) + s * np.column_stack([b - g, r - b, g - r])


def kinds_of(sim: Cast) -> list[Biped]:
    """One character of each kind, in the order of the crowd's kinds."""
    first = np.unique(sim.crowd.kind, return_index=True)[1]
    return [sim.characters[c] for c in first]


def _reach(biped: Biped) -> float:
    """Radius of a sphere about the com that holds the body [m]."""
    b = biped.record
    tail, head = abs(b.tail_forward) + b.tail_length, np.hypot(b.head_forward, b.head_up)
    return float(max(1.5 * b.nominal_length, b.max_length + abs(b.hip_up) + b.foot_length, tail, head + 0.5 * b.nominal_length))


def outline(biped: Biped) -> np.ndarray:
    """(Q, 3, 2) triangles of the character's footprint, forward and left of the sole's middle [m]."""
    b = biped.record
    half, wide = 0.5 * b.foot_length, 0.5 * b.foot_width
    if biped.body.get("plan", "human") == "human":
        return np.concatenate([_oval(-0.6 * half, 0, 0.42 * half, 0.62 * wide), _oval(0.3 * half, 0, 0.7 * half, wide)])
    ball = -0.35 * half
    parts = [_oval(ball, 0, 0.3 * half, 0.4 * wide)]
    for k in (-1, 0, 1):
        tip = (half if k == 0 else 0.72 * half, k * wide)
        w = 0.15 * wide
        parts.append(np.array([[(ball, -w), tip, (ball, w)]]))
    return np.concatenate(parts)


def _oval(x: float, y: float, a: float, b: float, sides: int = 9) -> np.ndarray:
    angles = np.linspace(0, 2 * np.pi, sides + 1)
    rim = np.stack([x + a * np.cos(angles), y + b * np.sin(angles)], axis=1)
    middle = np.broadcast_to((x, y), rim[:-1].shape)
    return np.stack([middle, rim[:-1], rim[1:]], axis=1)
