"""Legs of three links, toes, and shoes, around the joints of a figure."""

import numpy as np

from sim.view.bodies.clay import Clay, Colour
from sim.view.bodies.figure import Figure

CLAW = (0.25, 0.22, 0.18)


def long_legs(clay: Clay, figure: Figure, u: float, radii: tuple[float, ...], thigh: Colour, shank: Colour) -> None:
    """Thigh, shank and metatarsus; radii at hip, knee, hock and ankle."""
    for foot in (0, 1):
        hip, knee, hock, ankle = (joint[:, foot] for joint in (figure.hip, figure.knee, figure.hock, figure.ankle))
        clay.add(hip, radii[0] * u, knee, radii[1] * u, thigh)
        clay.add(knee, radii[1] * u, hock, radii[2] * u, thigh)
        clay.add(hock, radii[2] * u, ankle, radii[3] * u, shank)


def toes(clay: Clay, figure: Figure, u: float, colour: Colour, radius: float, spread: float) -> None:
    """Three toes forward and one back, with claws; the outer ones bend with the middle one."""
    up = np.array([0, 0, radius * u])
    for foot in (0, 1):
        ankle, heel, ball, toe = (joint[:, foot] for joint in (figure.ankle, figure.heel, figure.ball, figure.toe))
        along = toe - ball
        side = np.cross(along, np.array([0.0, 0.0, 1.0]))
        clay.add(ankle, 1.25 * radius * u, ball + up, radius * u, colour)
        for k in (-1, 0, 1):
            tip = ball + (0.86 if k else 1.0) * along + k * spread * side
            joint = ball + 0.55 * (tip - ball)
            clay.chain([ball + up, joint + up, tip + 0.6 * up], [radius * u, 0.9 * radius * u, 0.5 * radius * u], colour)
            clay.add(tip + 0.6 * up, 0.5 * radius * u, tip + 0.18 * (tip - ball) + 0.2 * up, 0.12 * radius * u, CLAW)
        clay.add(ankle, radius * u, heel + 0.5 * up, 0.45 * radius * u, colour)


def shoe(clay: Clay, figure: Figure, foot: int, u: float, colour: Colour) -> None:
    """A foot in a shoe that bends at the ball."""
    ankle, heel, ball, toe = (joint[:, foot] for joint in (figure.ankle, figure.heel, figure.ball, figure.toe))
    up = np.array([0, 0, 0.04 * u])
    inside = 0.82 * heel + 0.18 * ball
    clay.add(inside + up, 0.048 * u, ball + up * 0.9, 0.048 * u, colour)
    clay.add(ball + up * 0.9, 0.048 * u, 0.25 * ball + 0.75 * toe + up * 0.75, 0.034 * u, colour)
    clay.add(ankle, 0.048 * u, inside + up, 0.05 * u, colour)
