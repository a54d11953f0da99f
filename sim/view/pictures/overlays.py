"""The paper's overlays as clay that glows: COM curve by phase, tangents, orientation handles, timing daggers."""

import numpy as np

from motion.track import phases
from motion.track.curve import Curve, evaluate
from sim.stage.cast import Cast
from sim.view.bodies.clay import Clay
from worlds.queries import ground_height
from worlds.world import World

TANGENT, HANDLE, DAGGER = (0.15, 0.80, 0.25), (0.98, 0.80, 0.25), (0.88, 0.10, 0.10)
GOAL, TENTATIVE = (1.0, 0.62, 0.12), (0.98, 0.95, 0.85)
RING, POLE, CLOTH, OUTLINE = 48, 1.9, 14, 14
"""Pieces of the goal's ring, the height of its flag [m], pieces of its cloth, and of the outline of a sole."""
NAMES = ("curve", "tangents", "headings", "daggers", "next steps")
OVERLAYS = frozenset(NAMES)
"""What can be shown over one character."""
PIECES = 6
"""Straight pieces drawn per segment."""


def overlays(clay: Clay, sim: Cast, character: int, shown: frozenset[str] = OVERLAYS) -> None:
    """What is `shown` of one character."""
    curve, size = sim.curve(character), sim.leg(character)
    if "curve" in shown:
        _curve(clay, curve, size)
    if "tangents" in shown and len(curve.control):
        control = curve.control
        clay.ball(control[:, :3], 0.022 * size, TANGENT, 1.0)
        clay.add(control[:, :3], 0.006 * size, control[:, :3] + 0.12 * control[:, 3:], 0.006 * size, TANGENT, 1.0)
    _feet(clay, sim, character, shown)
    if "next steps" in shown:
        _tentative(clay, sim, character)


def _curve(clay: Clay, curve: Curve, size: float) -> None:
    """The curve of the centre of mass, in the colours of its phases."""
    time = curve.time
    for i, (left, right) in enumerate(curve.support[:-1]):
        ts = np.linspace(time[i], time[i + 1], PIECES + 1)
        points, scratch = np.empty((len(ts), 3)), np.empty((2, 3))
        for k, t in enumerate(ts):
            evaluate(curve, min(t, time[i + 1] - 1e-9), points[k], scratch[0], scratch[1])
        colour = phases.COLOURS[phases.phase_of(left, right)]
        clay.add(points[:-1], 0.011 * size, points[1:], 0.011 * size, colour, 1.0)


def goal(clay: Clay, world: World) -> None:
    """The goal: a ring on the ground as wide as it reaches, and a flag in its middle."""
    if world.goal is None:
        return
    (x, y), radius = world.goal, world.goal_radius
    angles = np.linspace(0, 2 * np.pi, RING + 1)
    ring = np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles), np.zeros(RING + 1)], axis=1)
    ring[:, 2] = [ground_height(world.arrays, float(u), float(v)) + 0.02 for u, v in ring[:, :2]]
    clay.add(ring[:-1], 0.03, ring[1:], 0.03, GOAL, 0.6)
    foot = np.array([[x, y, ground_height(world.arrays, x, y)]])
    up = np.array([0.0, 0.0, 1.0])
    clay.add(foot, 0.02, foot + POLE * up, 0.012, (0.9, 0.9, 0.88), 0.3)
    for k in range(CLOTH):
        hoist = foot + (POLE - 0.04 - 0.34 * k / CLOTH) * up
        clay.add(hoist, 0.02, hoist + [0.5 * (1 - abs(2 * k / CLOTH - 1)) + 0.02, 0.06, 0.0], 0.02, GOAL, 0.6)


def _tentative(clay: Clay, sim: Cast, character: int) -> None:
    """The outlines of the footprints that a character means to lay next, pale."""
    prints, foot, size = sim.tentative(character), sim.characters[character].biped.foot, sim.leg(character)
    corners = np.linspace(0, 2 * np.pi, OUTLINE + 1)
    for place, heading in zip(prints.position, prints.heading, strict=True):
        ahead, aside = 0.5 * foot.length * np.cos(corners), 0.5 * foot.width * np.sin(corners)
        c, s = np.cos(heading), np.sin(heading)
        ring = place + np.stack([ahead * c - aside * s, ahead * s + aside * c, np.full(OUTLINE + 1, 0.012 * size)], axis=1)
        clay.add(ring[:-1], 0.007 * size, ring[1:], 0.007 * size, TENTATIVE, 0.9)


def _feet(clay: Clay, sim: Cast, character: int, shown: frozenset[str]) -> None:
    """A handle along each footprint's heading, and a dagger whose height is its stance time."""
    track, size = sim.track(character), sim.leg(character)
    ahead = np.stack([np.cos(track.heading), np.sin(track.heading), np.zeros_like(track.heading)], axis=1)
    up = np.array([0.0, 0.0, 0.012 * size])
    place = track.position + up
    if "headings" in shown:
        clay.add(place, 0.008 * size, place + 0.28 * size * ahead, 0.008 * size, HANDLE, 1.0)
    top = np.clip(track.stance_time, 0, 1.5)[:, None] * np.array([0.0, 0.0, 0.5 * size])
    if "daggers" in shown:
        clay.add(place, 0.002 * size, place + top, 0.014 * size, DAGGER, 1.0)
