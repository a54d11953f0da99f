"""Bodies seen from afar: the plans of `plans`, in a dozen shapes or a handful, limbs stout enough to be seen.

Lengths in units of the nominal leg. What makes a bird, a dinosaur or a human is its outline and how its legs move.
"""

import numpy as np

from sim.view.bodies.clay import Clay, Colour
from sim.view.bodies.dress import Dress
from sim.view.bodies.figure import Figure


def _legs(clay: Clay, figure: Figure, u: float, thigh: Colour, shank: Colour, radii: tuple[float, float, float]) -> None:
    """Thigh and shank, each in the colour that it has from near, and the foot."""
    for side in (0, 1):
        hip, knee, hock, ankle = (joint[:, side] for joint in (figure.hip, figure.knee, figure.hock, figure.ankle))
        clay.add(hip, radii[0] * u, knee, radii[1] * u, thigh)
        clay.add(knee, radii[1] * u, hock, radii[2] * u, thigh)
        if np.abs(hock - ankle).max() > 1e-6:
            clay.add(hock, radii[2] * u, ankle, radii[2] * u, shank)
        clay.add(figure.heel[:, side], radii[2] * u, figure.toe[:, side], 0.7 * radii[2] * u, shank)


def _straight_legs(clay: Clay, figure: Figure, u: float, colour: Colour, radius: float) -> None:
    for side in (0, 1):
        clay.add(figure.hip[:, side], 1.6 * radius * u, figure.ankle[:, side], radius * u, colour)


def human(clay: Clay, dress: Dress, figure: Figure, distant: bool) -> None:
    """Shirt, head with hair, arms, legs."""
    skin, main, second, hair, u = dress.skin, dress.main, dress.second, dress.detail, dress.unit
    chest = figure.chest_frame
    clay.add(chest.at(0, 0, -0.04), 0.15 * u, chest.at(0.01, 0, 0.36), 0.19 * u, main)
    clay.ball(figure.head - 0.02 * u * chest.up, 0.115 * u, skin if not distant else 0.5 * (skin + hair))
    if distant:
        _straight_legs(clay, figure, u, second, 0.065)
        return
    up = figure.head - figure.com
    clay.add(chest.at(-0.02, 0, 0) + up, 0.1 * u, chest.at(0, 0, 0.08) + up, 0.1 * u, hair)
    for side in (0, 1):
        shoulder, elbow, hand = (joint[:, side] for joint in (figure.shoulder, figure.elbow, figure.hand))
        clay.add(shoulder, 0.07 * u, elbow, 0.055 * u, main)
        clay.add(elbow, 0.05 * u, hand, 0.045 * u, skin)
    _legs(clay, figure, u, second, 0.7 * second, (0.11, 0.08, 0.06))


def bird(clay: Clay, dress: Dress, figure: Figure, distant: bool) -> None:
    """Body, tail, neck and head with its beak; legs."""
    skin, main, second, u = dress.skin, dress.main, dress.second, dress.unit
    chest = figure.chest_frame
    girth, slim = dress.look.girth, dress.look.neck
    throat = main if slim >= 1 else skin
    clay.add(chest.at(-0.20, 0, 0.04), 0.20 * girth * u, chest.at(0.18, 0, 0.04), 0.27 * girth * u, main)
    clay.add(figure.tail[:, 0], 0.12 * u, figure.tail[:, -1], 0.07 * u, second)
    clay.add(figure.neck, 0.13 * slim * u, figure.head, 0.12 * slim * u, throat)
    if distant:
        _straight_legs(clay, figure, u, skin, 0.05)
        return
    wing = chest.at(0.12, 0.2 * girth, 0.1), chest.at(-0.36, 0.16 * girth, 0.06)
    clay.add(wing[0], 0.11 * u, wing[1], 0.06 * u, second)
    clay.add(wing[0] - 0.4 * girth * u * chest.left, 0.11 * u, wing[1] - 0.32 * girth * u * chest.left, 0.06 * u, second)
    clay.add(figure.head, 0.135 * u, figure.head + 0.05 * u * chest.forward, 0.125 * u, throat)
    beak = figure.head + u * (0.3 * chest.forward - 0.05 * chest.up)
    clay.add(figure.head + 0.1 * u * chest.forward, 0.06 * u, beak, 0.02 * u, skin)
    _legs(clay, figure, u, main * 0.95 if slim >= 1 else skin, skin, (0.125, 0.055, 0.042))


def dinosaur(clay: Clay, dress: Dress, figure: Figure, distant: bool) -> None:
    """Trunk, the long tail, neck and head; legs."""
    skin, main, second, u = dress.skin, dress.main, dress.second, dress.unit
    chest = figure.chest_frame
    clay.add(chest.at(-0.14, 0, 0.02), 0.215 * u, chest.at(0.34, 0, 0.05), 0.19 * u, main)
    half = figure.tail.shape[1] // 2
    clay.add(figure.tail[:, 0], 0.19 * u, figure.tail[:, -2 if distant else half], (0.05 if distant else 0.09) * u, main)
    clay.add(figure.neck, 0.165 * u, figure.head, 0.13 * u, main)
    clay.add(figure.head, 0.13 * u, figure.head + 0.26 * u * chest.forward, 0.09 * u, main)
    if distant:
        _straight_legs(clay, figure, u, main * 0.92, 0.07)
        return
    clay.add(figure.tail[:, half], 0.09 * u, figure.tail[:, -1], 0.03 * u, main)
    clay.add(chest.at(0.36, 0, 0.23), 0.045 * u, chest.at(-0.12, 0, 0.23), 0.04 * u, second)
    clay.add(chest.at(-0.05, 0, -0.06), 0.17 * u, chest.at(0.32, 0, -0.04), 0.15 * u, skin)
    _legs(clay, figure, u, main, main * 0.92, (0.175, 0.09, 0.06))


FIGURES = {"human": human, "bird": bird, "dinosaur": dinosaur}
"""As plans.PLANS."""
