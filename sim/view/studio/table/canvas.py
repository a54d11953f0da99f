"""The two views as canvases: where a place in the world is on the screen, and what place the mouse is at."""

from dataclasses import dataclass, field

import numpy as np

from sim.view.graphics.camera import Camera
from sim.view.window.picking import ground_point
from worlds.world import World

NEAREST, WIDEST = 12.0, 600.0
"""Pixels per metre of the plan at scale 1: least and most."""


@dataclass
class Box:
    """A rectangle of the screen [pixels]."""

    x: float = 0.0
    y: float = 0.0
    width: float = 1.0
    height: float = 1.0

    def holds(self, x: float, y: float) -> bool:
        """Whether a place lies in it."""
        return self.x <= x < self.x + self.width and self.y <= y < self.y + self.height


@dataclass
class Plan:
    """The plan: straight from above, without perspective."""

    box: Box = field(default_factory=Box)
    centre: np.ndarray = field(default_factory=lambda: np.array([6.0, 4.0]))
    zoom: float = 60.0  # pixels per metre
    flat = True

    def project(self, points: np.ndarray) -> np.ndarray:
        """Screen places (N, 2) of points (N, 3) [m]; NaN where they are behind."""
        out = np.empty((len(points), 2))
        out[:, 0] = self.box.x + 0.5 * self.box.width + self.zoom * (points[:, 0] - self.centre[0])
        out[:, 1] = self.box.y + 0.5 * self.box.height - self.zoom * (points[:, 1] - self.centre[1])
        return out

    def ground(self, world: World, x: float, y: float) -> tuple[float, float] | None:
        """The place [m] under a place of the screen."""
        u = (x - self.box.x - 0.5 * self.box.width) / self.zoom + self.centre[0]
        v = -(y - self.box.y - 0.5 * self.box.height) / self.zoom + self.centre[1]
        return float(u), float(v)

    def size_at(self, place: np.ndarray) -> float:
        """Pixels per metre there."""
        return self.zoom

    def pan(self, dx: float, dy: float) -> None:
        """Moves by pixels of a drag."""
        self.centre = self.centre + np.array([-dx, dy]) / self.zoom

    def wheel(self, clicks: float, x: float, y: float, scale: float = 1.0) -> None:
        """Nearer about the mouse."""
        before = self.ground(None, x, y)  # type: ignore[arg-type]
        self.zoom = float(np.clip(self.zoom * 1.15**clicks, NEAREST * scale * 0.25, WIDEST * scale))
        after = self.ground(None, x, y)  # type: ignore[arg-type]
        if before and after:
            self.centre = self.centre + np.array(before) - np.array(after)

    def frame(self, low: np.ndarray, high: np.ndarray, scale: float = 1.0) -> None:
        """Shows all between two corners [m]."""
        self.centre = 0.5 * (low + high)[:2]
        span = np.maximum((high - low)[:2], 1.5)
        self.zoom = float(np.clip(0.94 * min(self.box.width / span[0], self.box.height / span[1]), 4.0 * scale, 260.0 * scale))


@dataclass
class Space:
    """The view in space, as the camera has it."""

    box: Box = field(default_factory=Box)
    camera: Camera = field(default_factory=Camera)
    flat = False
    _matrix: np.ndarray = field(default_factory=lambda: np.eye(4))

    def look(self) -> None:
        """Once a frame: takes the camera as it is."""
        self._matrix = self.camera.matrix(self.box.width / max(self.box.height, 1.0))

    def project(self, points: np.ndarray) -> np.ndarray:
        """Screen places (N, 2) of points (N, 3) [m]; NaN where they are behind."""
        clip = np.column_stack([points, np.ones(len(points))]) @ self._matrix.T
        w = np.where(clip[:, 3] > 0.05, clip[:, 3], np.nan)
        out = np.empty((len(points), 2))
        out[:, 0] = self.box.x + 0.5 * self.box.width * (1 + clip[:, 0] / w)
        out[:, 1] = self.box.y + 0.5 * self.box.height * (1 - clip[:, 1] / w)
        return out

    def ground(self, world: World, x: float, y: float) -> tuple[float, float] | None:
        """The place [m] under a place of the screen; None where the sky is."""
        u, v = 2 * (x - self.box.x) / self.box.width - 1, 1 - 2 * (y - self.box.y) / self.box.height
        return ground_point(world, *self.camera.ray(u, v, self.box.width / max(self.box.height, 1.0)))

    def size_at(self, place: np.ndarray) -> float:
        """Pixels per metre there."""
        away = float(np.linalg.norm(np.asarray(place)[:3] - self.camera.eye))
        return 0.5 * self.box.height / (max(away, 0.1) * np.tan(np.radians(21.0)))

    def pan(self, dx: float, dy: float) -> None:
        """Moves the target over the ground by pixels of a drag."""
        a, s = self.camera.azimuth, self.camera.distance / max(self.box.height, 1.0)
        right, ahead = np.array([-np.sin(a), np.cos(a), 0.0]), np.array([-np.cos(a), -np.sin(a), 0.0])
        self.camera.target = self.camera.target + s * (-dx * right + dy * ahead)

    def wheel(self, clicks: float) -> None:
        """Nearer."""
        self.camera.zoom(clicks)

    def stay_above(self, world: World) -> None:
        """The camera never goes under ground."""
        self.camera.stay_above(world)


Canvas = Plan | Space
