"""The body plans: human, bird, dinosaur, shaped around a pose of one kind. Lengths in units of the nominal leg."""

import numpy as np

from motion.characters.biped import Biped
from motion.pose.pose import Pose
from sim.view.bodies.clay import Clay, Frame
from sim.view.bodies.feet import CLAW, long_legs, shoe, toes

EYE, WHITE = (0.08, 0.07, 0.07), (0.97, 0.97, 0.94)


def _colours(biped: Biped):
    return [np.array(biped.body.get(key, (0.7, 0.7, 0.7))) for key in ("skin", "main", "second", "detail")]


def _frames(biped: Biped, pose: Pose) -> tuple[Frame, Frame, Frame, float]:
    """Frames of pelvis and chest about the com, of the head about its middle, and the unit [m]."""
    u = float(biped.record.nominal_length)
    pelvis = Frame(pose.com, pose.pelvis_rotation_wxyz, u)
    return pelvis, Frame(pose.com, pose.chest_rotation_wxyz, u), Frame(pose.head, pose.head_rotation_wxyz, u), u


def _eyes(clay: Clay, head: Frame, forward: float, side: float, up: float, size: float, white: bool = True) -> None:
    for k in (1, -1):
        place = head.at(forward, k * side, up)
        if white:
            clay.ball(place, size, WHITE)
        clay.ball(place + size * 0.62 * head.forward + k * 0.35 * size * head.left, size * 0.62, EYE)


def human(clay: Clay, biped: Biped, pose: Pose) -> None:
    """A person in shirt, trousers and shoes."""
    skin, main, second, hair = _colours(biped)
    pelvis, chest, head, u = _frames(biped, pose)
    clay.add(pelvis.at(0, 0.055, -0.06), 0.115 * u, pelvis.at(0, -0.055, -0.06), 0.115 * u, second)
    clay.add(pelvis.at(0, 0, 0.0), 0.122 * u, chest.at(0.01, 0, 0.2), 0.125 * u, main)
    clay.add(chest.at(0.01, 0, 0.2), 0.128 * u, chest.at(0.012, 0, 0.34), 0.135 * u, main)
    between = 0.5 * (pose.shoulder[:, 0] + pose.shoulder[:, 1])
    inner = [between + 0.46 * (pose.shoulder[:, k] - between) for k in (0, 1)]
    clay.add(inner[0], 0.112 * u, inner[1], 0.112 * u, main)
    clay.add(pose.neck + 0.0 * u * chest.up, 0.058 * u, 0.35 * pose.neck + 0.65 * pose.head, 0.05 * u, skin)
    _human_head(clay, head, u, skin, hair)
    for side in (0, 1):
        shoulder, elbow, hand = (joint[:, side] for joint in (pose.shoulder, pose.elbow, pose.hand))
        clay.add(shoulder, 0.064 * u, elbow, 0.046 * u, main)
        clay.add(elbow, 0.044 * u, hand, 0.033 * u, skin)
        clay.add(hand, 0.036 * u, hand + 0.19 * (hand - elbow), 0.03 * u, skin)
        hip, knee, ankle = (joint[:, side] for joint in (pose.hip, pose.knee, pose.ankle))
        clay.add(hip, 0.105 * u, knee, 0.072 * u, second)
        calf = knee + 0.32 * (ankle - knee)
        clay.add(knee, 0.070 * u, calf, 0.068 * u, second)
        clay.add(calf, 0.068 * u, ankle, 0.046 * u, second)
        shoe(clay, pose, side, u, np.array([0.42, 0.20, 0.14]))


def _human_head(clay: Clay, head: Frame, u: float, skin, hair) -> None:
    clay.add(head.at(0.005, 0, -0.035), 0.087 * u, head.at(-0.01, 0, 0.04), 0.102 * u, skin)
    clay.add(head.at(-0.045, 0, 0.02), 0.100 * u, head.at(-0.03, 0, 0.085), 0.098 * u, hair)
    clay.add(head.at(0.09, 0, -0.002), 0.016 * u, head.at(0.107, 0, -0.02), 0.022 * u, skin * 0.95)
    for side in (1, -1):
        clay.ball(head.at(0.078, side * 0.037, 0.022), 0.017 * u, EYE)
        clay.ball(head.at(-0.015, side * 0.098, -0.005), 0.024 * u, skin * 0.95)


def _neck_of(pose: Pose, chest: Frame, head: Frame, u: float, reach: float) -> list[np.ndarray]:
    """A neck that leaves the chest forward and enters the head from below: points of a Bezier curve."""
    base, end = pose.neck, pose.head
    a = base + reach * u * (0.8 * chest.forward + 0.45 * chest.up)
    b = end - reach * u * (0.95 * head.up + 0.10 * head.forward)
    s = np.linspace(0, 1, 6)[:, None, None]
    return list((1 - s) ** 3 * base + 3 * s * (1 - s) ** 2 * a + 3 * s * s * (1 - s) * b + s**3 * end)


def bird(clay: Clay, biped: Biped, pose: Pose) -> None:
    """A round bird with wings, a comb and a fan of a tail; `crest` and `beak` of its [body] vary it."""
    skin, main, second, detail = _colours(biped)
    _, chest, head, u = _frames(biped, pose)
    girth = float(biped.body.get("girth", 1.0))
    clay.add(chest.at(-0.20, 0, 0.02), 0.20 * girth * u, chest.at(0.16, 0, 0.06), 0.265 * girth * u, main)
    clay.ball(chest.at(0.20, 0, 0.0), 0.235 * girth * u, main * 1.04)
    for side in (1, -1):
        out = 0.23 * girth
        clay.add(chest.at(0.12, side * out, 0.10), 0.11 * u, chest.at(-0.28, side * 0.87 * out, 0.04), 0.06 * u, second)
        clay.add(chest.at(-0.10, side * out, 0.06), 0.07 * u, chest.at(-0.42, side * 0.7 * out, 0.06), 0.025 * u, second * 0.85)
    _fan(clay, pose, chest, u, second)
    slim = float(biped.body.get("neck", 1.0))
    radii = [0.17 * u, 0.12 * slim * u, 0.09 * slim * u, 0.08 * slim * u, 0.082 * slim * u, 0.09 * slim * u]
    clay.chain(_neck_of(pose, chest, head, u, 0.2), radii, main if slim >= 1 else skin)
    _bird_head(clay, biped, head, u, skin, main if slim >= 1 else skin, detail)
    _thighs = main * 0.95 if slim >= 1 else skin
    long_legs(clay, pose, u, (0.125, 0.05, 0.032, 0.03), _thighs, skin)
    toes(clay, pose, u, skin, 0.024, 0.6)


def _fan(clay: Clay, pose: Pose, chest: Frame, u: float, colour) -> None:
    tail = pose.tail
    for spread in (-0.13, 0.0, 0.13):
        points = [tail[:, k] + spread * u * k / 6 * chest.left - 0.2 * abs(spread) * u * k / 6 * chest.up for k in (0, 3, 6)]
        clay.chain(points, [0.10 * u, 0.07 * u, 0.035 * u], colour)


def _bird_head(clay: Clay, biped: Biped, head: Frame, u: float, skin, main, comb) -> None:
    clay.add(head.at(-0.03, 0, 0.02), 0.135 * u, head.at(0.03, 0, 0.02), 0.122 * u, main)
    beak = float(biped.body.get("beak", 1.0))
    clay.add(head.at(0.10, 0, 0.0), 0.062 * u, head.at(0.10 + 0.22 * beak, 0, -0.045), 0.012 * u, skin * 0.95)
    if biped.body.get("crest", True):
        for k, height in enumerate((0.20, 0.23, 0.18)):
            base = 0.03 - 0.06 * k
            clay.add(head.at(base, 0, 0.12), 0.03 * u, head.at(base - 0.07, 0, height), 0.022 * u, comb)
    _eyes(clay, head, 0.055, 0.09, 0.055, 0.042 * u)


def dinosaur(clay: Clay, biped: Biped, pose: Pose) -> None:
    """A theropod: balanced tail, ridge of scales, small arms with claws."""
    skin, main, second, _ = _colours(biped)
    pelvis, chest, head, u = _frames(biped, pose)
    clay.add(pelvis.at(-0.14, 0, 0.03), 0.215 * u, chest.at(0.34, 0, 0.07), 0.195 * u, main)
    clay.add(pelvis.at(-0.05, 0, -0.04), 0.19 * u, chest.at(0.32, 0, -0.01), 0.165 * u, skin)
    tail = [pose.tail[:, k] for k in range(pose.tail.shape[1])]
    clay.chain(tail, [u * r for r in (0.20, 0.155, 0.118, 0.088, 0.062, 0.04, 0.018)], main)
    for k in range(4):
        clay.add(chest.at(0.36 - 0.16 * k, 0, 0.20), 0.055 * u, chest.at(0.31 - 0.16 * k, 0, 0.275), 0.012 * u, second)
    for k in range(1, 5):
        size = 1 - 0.18 * k
        top = tail[k] + (0.15 - 0.028 * k) * u * chest.up
        clay.add(top, 0.045 * size * u, top + 0.07 * size * u * (chest.up - 0.6 * chest.forward), 0.01 * u, second)
    clay.chain(_neck_of(pose, chest, head, u, 0.13), [u * r for r in (0.185, 0.155, 0.135, 0.12, 0.113, 0.115)], main)
    _dinosaur_head(clay, head, u, skin, main)
    for side in (0, 1):
        arm = [joint[:, side] for joint in (pose.shoulder, pose.elbow, pose.hand)]
        clay.chain(arm, [0.052 * u, 0.037 * u, 0.026 * u], main)
        for k in (-1, 1):
            claw = arm[2] + 0.05 * u * chest.forward - 0.03 * u * chest.up + k * 0.02 * u * chest.left
            clay.add(arm[2], 0.02 * u, claw, 0.006 * u, CLAW)
    long_legs(clay, pose, u, (0.175, 0.085, 0.05, 0.045), main, main * 0.92)
    toes(clay, pose, u, main * 0.92, 0.04, 0.5)


def _dinosaur_head(clay: Clay, head: Frame, u: float, skin, main) -> None:
    clay.add(head.at(-0.03, 0, 0.01), 0.125 * u, head.at(0.22, 0, -0.015), 0.082 * u, main)
    clay.add(head.at(0.0, 0, -0.055), 0.085 * u, head.at(0.21, 0, -0.075), 0.055 * u, skin)
    for side in (1, -1):
        clay.ball(head.at(0.28, side * 0.03, 0.015), 0.018 * u, EYE)
        clay.ball(head.at(0.05, side * 0.075, 0.095), 0.05 * u, main * 0.9)
    _eyes(clay, head, 0.075, 0.092, 0.085, 0.034 * u)


PLANS = {"human": human, "bird": bird, "dinosaur": dinosaur}
"""Body plans by the name that a character file gives."""
