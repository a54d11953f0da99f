"""Bodies are modelled of tapered capsules, (N, 12): end a and its radius, end b and its radius, colour, glow."""

import numpy as np

from motion.arithmetic.rotations import axes_of

COLUMNS = 12
Colour = np.ndarray | tuple[float, float, float]
"""Red, green, blue in 0..1, (3,) or (C, 3)."""


class Clay:
    """Collects capsules of many characters at once: every argument is per character, (C, ...), or one for all.

    Parts that reach less than `smallest` [m] are left out, and those thinner than `thin` [m] go to the clay `thinner`.
    The array is kept from frame to frame and only grows.
    """

    def __init__(self, thinner: "Clay | None" = None) -> None:
        self.thinner, self.thin = thinner, 0.0
        self._rows, self._count = np.empty((1024, COLUMNS), "f4"), 0
        self.smallest: float = 0.0

    def clear(self) -> None:
        """Begins a frame."""
        self._count, self.smallest, self.thin = 0, 0.0, 0.0

    def add(self, a: np.ndarray, ra: float, b: np.ndarray, rb: float, colour: Colour, glow: float = 0.0) -> None:
        """Capsules from a (C, 3) with radius ra to b (C, 3) with radius rb [m]."""
        if self.smallest and len(a) and float(np.linalg.norm(a[0] - b[0])) + ra + rb < self.smallest:
            return
        if self.thinner and max(ra, rb) < self.thin:
            self.thinner.add(a, ra, b, rb, colour, glow)
            return
        end = self._count + len(a)
        if end > len(self._rows):
            self._rows = np.concatenate([self._rows, np.empty((end, COLUMNS), "f4")])
        rows = self._rows[self._count : end]
        rows[:, 0:3], rows[:, 3], rows[:, 4:7], rows[:, 7] = a, ra, b, rb
        rows[:, 8:11], rows[:, 11] = colour, glow
        self._count = end

    def ball(self, a: np.ndarray, radius: float, colour: Colour, glow: float = 0.0) -> None:
        """Spheres at a (C, 3)."""
        self.add(a, radius, a, radius, colour, glow)

    def chain(self, points: list[np.ndarray], radii: list[float], colour: Colour) -> None:
        """Capsules through points, each (C, 3)."""
        for a, b, ra, rb in zip(points, points[1:], radii, radii[1:], strict=False):
            self.add(a, ra, b, rb, colour)

    def rows(self) -> np.ndarray:
        """All capsules (N, 12), until the next `clear`."""
        return self._rows[: self._count]


class Frame:
    """The bodies' frames: places given forward, left, up of the com in units of leg length become world points."""

    def __init__(self, com: np.ndarray, rotation_wxyz: np.ndarray, unit: float) -> None:
        self.forward, self.left, self.up = axes_of(rotation_wxyz)
        self.com, self.unit = com, unit

    def at(self, forward: float, left: float, up: float) -> np.ndarray:
        """World points (C, 3); arguments are numbers or (C,)."""

        def column(v: float) -> np.ndarray:
            return np.reshape(v, (-1, 1)) * self.unit

        return self.com + column(forward) * self.forward + column(left) * self.left + column(up) * self.up
