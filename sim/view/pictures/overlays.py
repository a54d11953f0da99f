"""The paper's overlays as clay that glows: COM curve by phase, tangents, orientation handles, timing daggers."""

import numpy as np

from motion.track import phases
from motion.track.curve import evaluate
from sim.stage.cast import Cast
from sim.view.bodies.clay import Clay

TANGENT, HANDLE, DAGGER = (0.15, 0.80, 0.25), (0.98, 0.80, 0.25), (0.88, 0.10, 0.10)
PIECES = 6
"""Straight pieces drawn per segment."""


def overlays(clay: Clay, sim: Cast, character: int) -> None:
    """Curve, tangents, handles and daggers of one character."""
    curve = sim.curve(character)
    time, control = curve.time, curve.control
    size = sim.leg(character)
    for i, (left, right) in enumerate(curve.support[:-1]):
        ts = np.linspace(time[i], time[i + 1], PIECES + 1)
        points, scratch = np.empty((len(ts), 3)), np.empty((2, 3))
        for k, t in enumerate(ts):
            evaluate(curve, min(t, time[i + 1] - 1e-9), points[k], scratch[0], scratch[1])
        colour = phases.COLOURS[phases.phase_of(left, right)]
        clay.add(points[:-1], 0.011 * size, points[1:], 0.011 * size, colour, 1.0)
    if len(control):
        clay.ball(control[:, :3], 0.022 * size, TANGENT, 1.0)
        clay.add(control[:, :3], 0.006 * size, control[:, :3] + 0.12 * control[:, 3:], 0.006 * size, TANGENT, 1.0)
    _feet(clay, sim, character, size)


def _feet(clay: Clay, sim: Cast, character: int, size: float) -> None:
    """A handle along each footprint's heading, and a dagger whose height is its stance time."""
    track = sim.track(character)
    ahead = np.stack([np.cos(track.heading), np.sin(track.heading), np.zeros_like(track.heading)], axis=1)
    up = np.array([0.0, 0.0, 0.012 * size])
    place = track.position + up
    clay.add(place, 0.008 * size, place + 0.28 * size * ahead, 0.008 * size, HANDLE, 1.0)
    top = np.clip(track.stance_time, 0, 1.5)[:, None] * np.array([0.0, 0.0, 0.5 * size])
    clay.add(place, 0.002 * size, place + top, 0.014 * size, DAGGER, 1.0)
