"""The body plans: human, bird, dinosaur, shaped around figures of one kind. Lengths in units of the nominal leg."""

import numpy as np

from sim.view.bodies.clay import Clay, Colour, Frame
from sim.view.bodies.dress import Dress
from sim.view.bodies.feet import CLAW, long_legs, shoe, toes
from sim.view.bodies.figure import Figure

EYE, WHITE = (0.08, 0.07, 0.07), (0.97, 0.97, 0.94)


def _eyes(clay: Clay, head: Frame, forward: float, side: float, up: float, size: float, white: bool = True) -> None:
    for k in (1, -1):
        place = head.at(forward, k * side, up)
        if white:
            clay.ball(place, size, WHITE)
        clay.ball(place + size * 0.62 * head.forward + k * 0.35 * size * head.left, size * 0.62, EYE)


def human(clay: Clay, dress: Dress, figure: Figure) -> None:
    """A person in shirt, trousers and shoes."""
    skin, main, second, hair, u = dress.skin, dress.main, dress.second, dress.detail, dress.unit
    pelvis, chest, head = figure.pelvis_frame, figure.chest_frame, figure.head_frame
    clay.add(pelvis.at(0, 0.055, -0.06), 0.115 * u, pelvis.at(0, -0.055, -0.06), 0.115 * u, second)
    clay.add(pelvis.at(0, 0, 0.0), 0.122 * u, chest.at(0.01, 0, 0.2), 0.125 * u, main)
    clay.add(chest.at(0.01, 0, 0.2), 0.128 * u, chest.at(0.012, 0, 0.34), 0.135 * u, main)
    between = 0.5 * (figure.shoulder[:, 0] + figure.shoulder[:, 1])
    inner = [between + 0.46 * (figure.shoulder[:, k] - between) for k in (0, 1)]
    clay.add(inner[0], 0.112 * u, inner[1], 0.112 * u, main)
    clay.add(figure.neck + 0.0 * u * chest.up, 0.058 * u, 0.35 * figure.neck + 0.65 * figure.head, 0.05 * u, skin)
    _human_head(clay, head, u, skin, hair)
    for side in (0, 1):
        shoulder, elbow, hand = (joint[:, side] for joint in (figure.shoulder, figure.elbow, figure.hand))
        clay.add(shoulder, 0.064 * u, elbow, 0.046 * u, main)
        clay.add(elbow, 0.044 * u, hand, 0.033 * u, skin)
        clay.add(hand, 0.036 * u, hand + 0.19 * (hand - elbow), 0.03 * u, skin)
        hip, knee, ankle = (joint[:, side] for joint in (figure.hip, figure.knee, figure.ankle))
        clay.add(hip, 0.105 * u, knee, 0.072 * u, second)
        calf = knee + 0.32 * (ankle - knee)
        clay.add(knee, 0.070 * u, calf, 0.068 * u, second)
        clay.add(calf, 0.068 * u, ankle, 0.046 * u, second)
        shoe(clay, figure, side, u, np.array([0.42, 0.20, 0.14]))


def _human_head(clay: Clay, head: Frame, u: float, skin: np.ndarray, hair: Colour) -> None:
    clay.add(head.at(0.005, 0, -0.035), 0.087 * u, head.at(-0.01, 0, 0.04), 0.102 * u, skin)
    clay.add(head.at(-0.045, 0, 0.02), 0.100 * u, head.at(-0.03, 0, 0.085), 0.098 * u, hair)
    clay.add(head.at(0.09, 0, -0.002), 0.016 * u, head.at(0.107, 0, -0.02), 0.022 * u, skin * 0.95)
    for side in (1, -1):
        clay.ball(head.at(0.078, side * 0.037, 0.022), 0.017 * u, EYE)
        clay.ball(head.at(-0.015, side * 0.098, -0.005), 0.024 * u, skin * 0.95)


def _neck_of(figure: Figure, chest: Frame, head: Frame, u: float, reach: float) -> list[np.ndarray]:
    """A neck that leaves the chest forward and enters the head from below: points of a Bezier curve."""
    base, end = figure.neck, figure.head
    a = base + reach * u * (0.8 * chest.forward + 0.45 * chest.up)
    biped = end - reach * u * (0.95 * head.up + 0.10 * head.forward)
    s = np.linspace(0, 1, 6)[:, None, None]
    return list((1 - s) ** 3 * base + 3 * s * (1 - s) ** 2 * a + 3 * s * s * (1 - s) * biped + s**3 * end)


def bird(clay: Clay, dress: Dress, figure: Figure) -> None:
    """A round bird with wings, a comb and a fan of a tail; `crest` and `beak` of its [body] vary it."""
    skin, main, second, u = dress.skin, dress.main, dress.second, dress.unit
    chest, head = figure.chest_frame, figure.head_frame
    girth = dress.look.girth
    clay.add(chest.at(-0.20, 0, 0.02), 0.20 * girth * u, chest.at(0.16, 0, 0.06), 0.265 * girth * u, main)
    clay.ball(chest.at(0.20, 0, 0.0), 0.235 * girth * u, main * 1.04)
    for side, wing in zip((1, -1), figure.wing_frames, strict=True):
        out = side * 0.23 * girth
        clay.add(wing.at(0, 0, 0), 0.11 * u, wing.at(-0.40, -0.13 * out, -0.06), 0.06 * u, second)
        clay.add(wing.at(-0.22, 0, -0.04), 0.07 * u, wing.at(-0.54, -0.3 * out, -0.04), 0.025 * u, second * 0.85)
    _fan(clay, figure, chest, u, second)
    slim = dress.look.neck
    radii = [0.17 * u, 0.12 * slim * u, 0.09 * slim * u, 0.08 * slim * u, 0.082 * slim * u, 0.09 * slim * u]
    clay.chain(_neck_of(figure, chest, head, u, 0.2), radii, main if slim >= 1 else skin)
    _bird_head(clay, dress, head, u, main if slim >= 1 else skin)
    thighs = main * 0.95 if slim >= 1 else skin
    long_legs(clay, figure, u, (0.125, 0.05, 0.032, 0.03), thighs, skin)
    toes(clay, figure, u, skin, 0.024, 0.6)


def _fan(clay: Clay, figure: Figure, chest: Frame, u: float, colour: Colour) -> None:
    tail = figure.tail
    for spread in (-0.13, 0.0, 0.13):
        points = [tail[:, k] + spread * u * k / 6 * chest.left - 0.2 * abs(spread) * u * k / 6 * chest.up for k in (0, 3, 6)]
        clay.chain(points, [0.10 * u, 0.07 * u, 0.035 * u], colour)


def _bird_head(clay: Clay, dress: Dress, head: Frame, u: float, throat: Colour) -> None:
    clay.add(head.at(-0.03, 0, 0.02), 0.135 * u, head.at(0.03, 0, 0.02), 0.122 * u, throat)
    clay.add(head.at(0.10, 0, 0.0), 0.062 * u, head.at(0.10 + 0.22 * dress.look.beak, 0, -0.045), 0.012 * u, dress.skin * 0.95)
    if dress.look.crest:
        for k, height in enumerate((0.20, 0.23, 0.18)):
            base = 0.03 - 0.06 * k
            clay.add(head.at(base, 0, 0.12), 0.03 * u, head.at(base - 0.07, 0, height), 0.022 * u, dress.detail)
    _eyes(clay, head, 0.055, 0.09, 0.055, 0.042 * u)


def dinosaur(clay: Clay, dress: Dress, figure: Figure) -> None:
    """A theropod: balanced tail, ridge of scales, small arms with claws."""
    skin, main, second, u = dress.skin, dress.main, dress.second, dress.unit
    pelvis, chest, head = figure.pelvis_frame, figure.chest_frame, figure.head_frame
    clay.add(pelvis.at(-0.14, 0, 0.03), 0.215 * u, chest.at(0.34, 0, 0.07), 0.195 * u, main)
    clay.add(pelvis.at(-0.05, 0, -0.04), 0.19 * u, chest.at(0.32, 0, -0.01), 0.165 * u, skin)
    tail = [figure.tail[:, k] for k in range(figure.tail.shape[1])]
    clay.chain(tail, [u * r for r in (0.20, 0.155, 0.118, 0.088, 0.062, 0.04, 0.018)], main)
    for k in range(4):
        clay.add(chest.at(0.36 - 0.16 * k, 0, 0.20), 0.055 * u, chest.at(0.31 - 0.16 * k, 0, 0.275), 0.012 * u, second)
    for k in range(1, 5):
        size = 1 - 0.18 * k
        top = tail[k] + (0.15 - 0.028 * k) * u * chest.up
        clay.add(top, 0.045 * size * u, top + 0.07 * size * u * (chest.up - 0.6 * chest.forward), 0.01 * u, second)
    clay.chain(_neck_of(figure, chest, head, u, 0.13), [u * r for r in (0.185, 0.155, 0.135, 0.12, 0.113, 0.115)], main)
    _dinosaur_head(clay, head, u, skin, main)
    for side in (0, 1):
        arm = [joint[:, side] for joint in (figure.shoulder, figure.elbow, figure.hand)]
        clay.chain(arm, [0.052 * u, 0.037 * u, 0.026 * u], main)
        for k in (-1, 1):
            claw = arm[2] + 0.05 * u * chest.forward - 0.03 * u * chest.up + k * 0.02 * u * chest.left
            clay.add(arm[2], 0.02 * u, claw, 0.006 * u, CLAW)
    long_legs(clay, figure, u, (0.175, 0.085, 0.05, 0.045), main, main * 0.92)
    toes(clay, figure, u, main * 0.92, 0.04, 0.5)


def _dinosaur_head(clay: Clay, head: Frame, u: float, skin: Colour, main: np.ndarray) -> None:
    clay.add(head.at(-0.03, 0, 0.01), 0.125 * u, head.at(0.22, 0, -0.015), 0.082 * u, main)
    clay.add(head.at(0.0, 0, -0.055), 0.085 * u, head.at(0.21, 0, -0.075), 0.055 * u, skin)
    for side in (1, -1):
        clay.ball(head.at(0.28, side * 0.03, 0.015), 0.018 * u, EYE)
        clay.ball(head.at(0.05, side * 0.075, 0.095), 0.05 * u, main * 0.9)
    _eyes(clay, head, 0.075, 0.092, 0.085, 0.034 * u)


PLANS = {"human": human, "bird": bird, "dinosaur": dinosaur}
"""Body plans by the name that a character file gives."""
