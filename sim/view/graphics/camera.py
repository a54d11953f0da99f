"""The camera: follows, orbits, zooms, or looks straight down."""

from dataclasses import dataclass, field

import numpy as np

from worlds.queries import terrain_height
from worlds.world import World

NEAR, FAR = 0.1, 400.0
FARTHEST = 120.0
"""The camera goes no farther away than this [m]."""
CROWD, CROWD_AWAY = 250, 4.5
"""Characters that the first picture of a crowd shows, the nearest."""
STRAIGHT_DOWN, HIGHEST = 1.5533, 1.4
"""Elevations [rad] of the plan view, and up to which the camera goes to stay above the ground."""
HIGHER = 1.6
"""The plan view is so many times as far away."""
WAY = (0.25, 0.45, 0.65, 0.85, 1.0)
"""Shares of the way to the eye at which the ground below is asked for."""
FIELD_OF_VIEW = np.radians(42.0)


@dataclass
class Camera:
    """Looks at `target` from `distance` [m] at azimuth and elevation [rad]; plan: from straight above."""

    target: np.ndarray = field(default_factory=lambda: np.array([0.0, 0.0, 0.6]))
    distance: float = 6.0
    azimuth: float = -2.2
    elevation: float = 0.32
    plan: bool = False
    follow: bool = True
    lift: float = 0.0
    """The elevation that it has at least, so as to stay above the ground [rad]."""

    def follow_point(self, point: np.ndarray, seconds: float) -> None:
        """Moves the target toward a point, smoothly; only what is drawn depends on it."""
        if self.follow:
            self.target += (point - self.target) * (1 - np.exp(-4 * seconds))

    def orbit(self, dx: float, dy: float) -> None:
        """Turns by pixels of a drag."""
        self.azimuth -= 0.006 * dx
        self.elevation = float(np.clip(self.elevation + 0.006 * dy, 0.02, 1.5))

    def frame(self, centre: np.ndarray, radius: float, nearest: float) -> None:
        """Looks at all within `radius` [m] of the centre, from no nearer than `nearest` [m]; from afar it looks down."""
        self.target = np.array(centre, float)
        self.distance = float(np.clip(0.7 * radius / np.tan(FIELD_OF_VIEW / 2), nearest, FARTHEST))
        if self.distance > 2 * nearest:
            self.elevation = max(self.elevation, 0.65)

    def meet(self, com: np.ndarray, focus: int, nearest: float) -> None:
        """Looks at a character as `frame` does; where there are others, com (C, 3), from so far that CROWD of them are seen.

        It stays near enough, CROWD_AWAY times nearest, to see how they walk.
        """
        away = np.sort(np.linalg.norm(com - com[focus], axis=1))
        self.frame(com[focus], float(away[: CROWD + 1][-1]), nearest)
        self.distance = min(self.distance, CROWD_AWAY * nearest)

    def zoom(self, clicks: float) -> None:
        """Nearer for positive clicks of the wheel."""
        self.distance = float(np.clip(self.distance * 0.88**clicks, 1.2, FARTHEST))

    @property
    def eye(self) -> np.ndarray:
        """Where the camera is [m]."""
        elevation = STRAIGHT_DOWN if self.plan else max(self.elevation, self.lift)
        c = np.cos(elevation)
        toward = np.array([c * np.cos(self.azimuth), c * np.sin(self.azimuth), np.sin(elevation)])
        return self.target + self.away * toward

    @property
    def away(self) -> float:
        """How far the eye is from what it looks at [m]."""
        return (HIGHER if self.plan else 1.0) * self.distance

    def stay_above(self, world: World) -> None:
        """Goes up where it would be under ground, or a hill would hide what it looks at; comes down again behind it."""
        self.lift = 0.0
        while self.lift < HIGHEST and self._is_low(world):
            self.lift = max(self.lift, self.elevation) + 0.03

    def _is_low(self, world: World) -> bool:
        """Whether the ground comes near the way from what it looks at to the eye."""
        eye, (width, depth) = self.eye, world.size
        for share in WAY:
            x, y, z = self.target + share * (eye - self.target)
            if 0 <= x <= width and 0 <= y <= depth and z < terrain_height(world.arrays, x, y) + 0.3 * share:
                return True
        return bool(eye[2] < 0.3 * (world.terrain == "flat"))

    def matrix(self, aspect: float) -> np.ndarray:
        """World to clip space, (4, 4), for column vectors."""
        return perspective(aspect) @ look_at(self.eye, self.target)

    def ray(self, x: float, y: float, aspect: float) -> tuple[np.ndarray, np.ndarray]:
        """Origin and direction through x, y in -1..1 (y up)."""
        back = np.linalg.inv(self.matrix(aspect)) @ np.array([x, y, 1.0, 1.0])
        direction = back[:3] / back[3] - self.eye
        return self.eye, direction / np.linalg.norm(direction)


def perspective(aspect: float) -> np.ndarray:
    """OpenGL's perspective projection."""
    f = 1 / np.tan(FIELD_OF_VIEW / 2)
    depth = NEAR - FAR
    return np.array([
        [f / aspect, 0, 0, 0], [0, f, 0, 0], [0, 0, (NEAR + FAR) / depth, 2 * NEAR * FAR / depth], [0, 0, -1, 0]
    ])  # fmt: skip


def orthographic(half: float, depth: float) -> np.ndarray:
    """A box of +-half by +-half, from 0 to depth ahead."""
    return np.array([[1 / half, 0, 0, 0], [0, 1 / half, 0, 0], [0, 0, -2 / depth, -1], [0, 0, 0, 1]])


def look_at(eye: np.ndarray, target: np.ndarray) -> np.ndarray:
    """World to camera; z up."""
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    rotation = np.array([right, np.cross(right, forward), -forward])
    out = np.eye(4)
    out[:3, :3], out[:3, 3] = rotation, -rotation @ eye
    return out
