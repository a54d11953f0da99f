"""Bodies seen from afar: the plans of `plans`, in a dozen shapes or a handful, limbs stout enough to be seen.

Lengths in units of the nominal leg. What makes a bird, a dinosaur or a human is its outline and how its legs move.
"""

import numpy as np

from motion.characters.biped import Biped
from motion.pose.pose import Pose
from sim.view.bodies.clay import Clay, Frame


def _frame(biped: Biped, pose: Pose) -> tuple[Frame, float]:
    u = float(biped.record.nominal_length)
    return Frame(pose.com, pose.chest_rotation_wxyz, u), u


def _colours(biped: Biped):
    return [np.array(biped.body.get(key, (0.7, 0.7, 0.7))) for key in ("skin", "main", "second", "detail")]


def _legs(clay: Clay, pose: Pose, u: float, thigh, shank, radii: tuple[float, float, float]) -> None:
    """Thigh and shank, each in the colour that it has from near, and the foot."""
    for side in (0, 1):
        hip, knee, hock, ankle = (joint[:, side] for joint in (pose.hip, pose.knee, pose.hock, pose.ankle))
        clay.add(hip, radii[0] * u, knee, radii[1] * u, thigh)
        clay.add(knee, radii[1] * u, hock, radii[2] * u, thigh)
        if np.abs(hock - ankle).max() > 1e-6:
            clay.add(hock, radii[2] * u, ankle, radii[2] * u, shank)
        clay.add(pose.heel[:, side], radii[2] * u, pose.toe[:, side], 0.7 * radii[2] * u, shank)


def _straight_legs(clay: Clay, pose: Pose, u: float, colour, radius: float) -> None:
    for side in (0, 1):
        clay.add(pose.hip[:, side], 1.6 * radius * u, pose.ankle[:, side], radius * u, colour)


def human(clay: Clay, biped: Biped, pose: Pose, distant: bool) -> None:
    """Shirt, head with hair, arms, legs."""
    skin, main, second, hair = _colours(biped)
    chest, u = _frame(biped, pose)
    clay.add(chest.at(0, 0, -0.04), 0.15 * u, chest.at(0.01, 0, 0.36), 0.19 * u, main)
    clay.ball(pose.head - 0.02 * u * chest.up, 0.115 * u, skin if not distant else 0.5 * (skin + hair))
    if distant:
        _straight_legs(clay, pose, u, second, 0.065)
        return
    clay.add(chest.at(-0.02, 0, 0) + pose.head - pose.com, 0.1 * u, chest.at(0, 0, 0.08) + pose.head - pose.com, 0.1 * u, hair)
    for side in (0, 1):
        shoulder, elbow, hand = (joint[:, side] for joint in (pose.shoulder, pose.elbow, pose.hand))
        clay.add(shoulder, 0.07 * u, elbow, 0.055 * u, main)
        clay.add(elbow, 0.05 * u, hand, 0.045 * u, skin)
    _legs(clay, pose, u, second, 0.7 * second, (0.11, 0.08, 0.06))


def bird(clay: Clay, biped: Biped, pose: Pose, distant: bool) -> None:
    """Body, tail, neck and head with its beak; legs."""
    skin, main, second, _ = _colours(biped)
    chest, u = _frame(biped, pose)
    girth, slim = float(biped.body.get("girth", 1.0)), float(biped.body.get("neck", 1.0))
    throat = main if slim >= 1 else skin
    clay.add(chest.at(-0.20, 0, 0.04), 0.20 * girth * u, chest.at(0.18, 0, 0.04), 0.27 * girth * u, main)
    clay.add(pose.tail[:, 0], 0.12 * u, pose.tail[:, -1], 0.07 * u, second)
    clay.add(pose.neck, 0.13 * slim * u, pose.head, 0.12 * slim * u, throat)
    if distant:
        _straight_legs(clay, pose, u, skin, 0.05)
        return
    wing = chest.at(0.12, 0.2 * girth, 0.1), chest.at(-0.36, 0.16 * girth, 0.06)
    clay.add(wing[0], 0.11 * u, wing[1], 0.06 * u, second)
    clay.add(wing[0] - 0.4 * girth * u * chest.left, 0.11 * u, wing[1] - 0.32 * girth * u * chest.left, 0.06 * u, second)
    clay.add(pose.head, 0.135 * u, pose.head + 0.05 * u * chest.forward, 0.125 * u, throat)
    clay.add(
        pose.head + 0.1 * u * chest.forward, 0.06 * u, pose.head + u * (0.3 * chest.forward - 0.05 * chest.up), 0.02 * u, skin
    )
    _legs(clay, pose, u, main * 0.95 if slim >= 1 else skin, skin, (0.125, 0.055, 0.042))


def dinosaur(clay: Clay, biped: Biped, pose: Pose, distant: bool) -> None:
    """Trunk, the long tail, neck and head; legs."""
    skin, main, second, _ = _colours(biped)
    chest, u = _frame(biped, pose)
    clay.add(chest.at(-0.14, 0, 0.02), 0.215 * u, chest.at(0.34, 0, 0.05), 0.19 * u, main)
    half = pose.tail.shape[1] // 2
    clay.add(pose.tail[:, 0], 0.19 * u, pose.tail[:, -2 if distant else half], (0.05 if distant else 0.09) * u, main)
    clay.add(pose.neck, 0.165 * u, pose.head, 0.13 * u, main)
    clay.add(pose.head, 0.13 * u, pose.head + 0.26 * u * chest.forward, 0.09 * u, main)
    if distant:
        _straight_legs(clay, pose, u, main * 0.92, 0.07)
        return
    clay.add(pose.tail[:, half], 0.09 * u, pose.tail[:, -1], 0.03 * u, main)
    clay.add(chest.at(0.36, 0, 0.23), 0.045 * u, chest.at(-0.12, 0, 0.23), 0.04 * u, second)
    clay.add(chest.at(-0.05, 0, -0.06), 0.17 * u, chest.at(0.32, 0, -0.04), 0.15 * u, skin)
    _legs(clay, pose, u, main, main * 0.92, (0.175, 0.09, 0.06))


FIGURES = {"human": human, "bird": bird, "dinosaur": dinosaur}
"""As plans.PLANS."""
