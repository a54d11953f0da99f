"""The three body plans, shaped around a pose. Lengths are in units of the character's nominal leg."""

import numpy as np

from motion.biped import Biped
from motion.pose import Pose
from sim.view.clay import Clay, Frame

EYE, WHITE, CLAW = (0.08, 0.07, 0.07), (0.97, 0.97, 0.94), (0.25, 0.22, 0.18)


def model(clay: Clay, biped: Biped, pose: Pose, rows: np.ndarray) -> None:
    """Adds the bodies of the characters `rows` (of one kind) to the clay."""
    unit = float(biped.record.nominal_length)
    frame = Frame(pose.com[rows], pose.body_rotation_wxyz[rows], unit)
    plans = {"human": _human, "bird": _bird, "dinosaur": _dinosaur}
    plans.get(biped.body.get("plan", "human"), _human)(clay, biped, pose, rows, frame)


def _colours(biped: Biped):
    return [np.array(biped.body.get(key, (0.7, 0.7, 0.7))) for key in ("skin", "main", "second")]


def _swing(pose: Pose, rows, frame: Frame) -> np.ndarray:
    """(C, 2) how far each ankle is ahead of the com, in leg lengths: what arms swing against and tails sway with."""
    offset = pose.ankle[rows] - pose.com[rows][:, None]
    return np.einsum("cfk,ck->cf", offset, frame.forward) / frame.unit


def _eyes(clay: Clay, frame: Frame, forward, left, up, size: float, white: bool = True) -> None:
    for side in (1, -1):
        place = frame.at(forward, left[0] + side * left[1], up)
        if white:
            clay.ball(place, size, WHITE)
        clay.ball(place + size * 0.62 * frame.forward + side * 0.35 * size * frame.left, size * 0.62, EYE)


def _human(clay: Clay, biped: Biped, pose: Pose, rows, f: Frame) -> None:
    skin, main, second = _colours(biped)
    u, ahead = f.unit, _swing(pose, rows, f)
    twist = 0.05 * (ahead[:, 0] - ahead[:, 1])
    clay.add(f.at(0, 0.055, -0.06), 0.115 * u, f.at(0, -0.055, -0.06), 0.115 * u, second)
    clay.add(f.at(0, 0, 0.0), 0.125 * u, f.at(0.01, 0, 0.22), 0.13 * u, main)
    clay.add(f.at(0.01 - twist, 0.09, 0.36), 0.115 * u, f.at(0.01 + twist, -0.09, 0.36), 0.115 * u, main)
    clay.add(f.at(0.01, 0, 0.2), 0.13 * u, f.at(0.01, 0, 0.36), 0.135 * u, main)
    clay.add(f.at(0.0, 0, 0.46), 0.052 * u, f.at(0.03, 0, 0.57), 0.048 * u, skin)
    clay.add(f.at(0.035, 0, 0.62), 0.088 * u, f.at(0.02, 0, 0.70), 0.103 * u, skin)
    clay.add(f.at(-0.015, 0, 0.68), 0.100 * u, f.at(-0.0, 0, 0.745), 0.098 * u, (0.25, 0.17, 0.12))
    clay.add(f.at(0.12, 0, 0.655), 0.016 * u, f.at(0.137, 0, 0.638), 0.022 * u, skin * 0.95)
    for side in (1, -1):
        clay.ball(f.at(0.108, side * 0.037, 0.68), 0.017 * u, EYE)
    for foot, side in ((0, 1), (1, -1)):
        angle = 0.75 * ahead[:, 1 - foot]
        bend = angle + 0.25 + 0.35 * np.clip(angle, 0, None)
        shoulder = f.at(0.01 - side * twist, side * 0.21, 0.375)
        sx, sz = np.sin(angle), -np.cos(angle)
        ex, ez = sx + np.sin(bend), sz - np.cos(bend)
        elbow = f.at(0.01 + 0.33 * sx, side * 0.245, 0.375 + 0.33 * sz)
        hand = f.at(0.01 + 0.33 * sx + 0.28 * (ex - sx), side * 0.235, 0.375 + 0.33 * sz + 0.28 * (ez - sz))
        clay.add(shoulder, 0.062 * u, elbow, 0.046 * u, main)
        clay.add(elbow, 0.044 * u, hand, 0.034 * u, skin)
        clay.ball(hand, 0.045 * u, skin)
        hip, knee, ankle = (joint[rows][:, foot] for joint in (pose.hip, pose.knee, pose.ankle))
        clay.add(hip, 0.105 * u, knee, 0.072 * u, second)
        clay.add(knee, 0.070 * u, ankle, 0.047 * u, second)
        _shoe(clay, pose, rows, foot, u)


def _shoe(clay: Clay, pose: Pose, rows, foot: int, u: float) -> None:
    shoe = np.array([0.42, 0.20, 0.14])
    ankle, heel, ball, toe = (joint[rows][:, foot] for joint in (pose.ankle, pose.heel, pose.ball, pose.toe))
    up = np.array([0, 0, 0.04 * u])
    inside = 0.82 * heel + 0.18 * ball
    clay.add(inside + up, 0.048 * u, ball + up * 0.9, 0.048 * u, shoe)
    clay.add(ball + up * 0.9, 0.048 * u, 0.25 * ball + 0.75 * toe + up * 0.75, 0.034 * u, shoe)
    clay.add(ankle, 0.048 * u, inside + up, 0.05 * u, shoe)


def _bird(clay: Clay, biped: Biped, pose: Pose, rows, f: Frame) -> None:
    skin, main, second = _colours(biped)
    u, ahead = f.unit, _swing(pose, rows, f)
    bob = 0.10 * (ahead[:, 0] + ahead[:, 1])
    clay.add(f.at(-0.20, 0, 0.02), 0.20 * u, f.at(0.16, 0, 0.06), 0.27 * u, main)
    clay.ball(f.at(0.20, 0, 0.0), 0.235 * u, main * 1.04)
    for spread in (-0.10, 0.0, 0.10):
        clay.add(f.at(-0.32, spread * 0.6, 0.08), 0.10 * u, f.at(-0.66, spread * 1.5, 0.26 - abs(spread)), 0.035 * u, second)
    for side in (1, -1):
        clay.add(f.at(0.12, side * 0.23, 0.10), 0.11 * u, f.at(-0.28, side * 0.20, 0.04), 0.06 * u, second)
        clay.add(f.at(-0.10, side * 0.23, 0.06), 0.07 * u, f.at(-0.42, side * 0.16, 0.06), 0.025 * u, second * 0.85)
    neck = [
        f.at(0.28, 0, 0.14),
        f.at(0.42 + 0.4 * bob, 0, 0.34),
        f.at(0.40 + 0.8 * bob, 0, 0.56),
        f.at(0.46 + bob, 0, 0.70),
    ]
    clay.chain(neck, [0.15 * u, 0.095 * u, 0.085 * u, 0.09 * u], main)
    clay.add(f.at(0.45 + bob, 0, 0.74), 0.135 * u, f.at(0.50 + bob, 0, 0.74), 0.125 * u, main)
    clay.add(f.at(0.58 + bob, 0, 0.72), 0.062 * u, f.at(0.80 + bob, 0, 0.675), 0.012 * u, skin)
    for k, height in enumerate((0.92, 0.95, 0.90)):
        base = 0.50 - 0.06 * k + bob
        clay.add(f.at(base, 0, 0.84), 0.03 * u, f.at(base - 0.07, 0, height), 0.022 * u, (0.82, 0.20, 0.15))
    _eyes(clay, f, 0.53 + bob, (0.0, 0.09), 0.775, 0.042 * u)
    _long_legs(clay, biped, pose, rows, u, (0.125, 0.05, 0.032, 0.03), main * 0.95, skin)
    _toes(clay, pose, rows, f, u, skin, 0.024, 0.6)


def _dinosaur(clay: Clay, biped: Biped, pose: Pose, rows, f: Frame) -> None:
    skin, main, second = _colours(biped)
    u, ahead = f.unit, _swing(pose, rows, f)
    sway = ahead[:, 0] - ahead[:, 1]
    clay.add(f.at(-0.14, 0, 0.03), 0.215 * u, f.at(0.34, 0, 0.07), 0.195 * u, main)
    clay.add(f.at(-0.05, 0, -0.04), 0.19 * u, f.at(0.32, 0, -0.01), 0.165 * u, skin)
    tail = [f.at(-0.14 - 0.235 * k, 0.028 * k * k * 0.35 * sway * (0.6 if k else 0), 0.04 + 0.022 * k) for k in range(7)]
    clay.chain(tail, [u * r for r in (0.20, 0.155, 0.118, 0.088, 0.062, 0.04, 0.018)], main)
    for k in range(7):
        x = 0.36 - 0.17 * k
        clay.add(
            f.at(x, 0, 0.20 - 0.006 * k * k * (k > 3)),
            0.055 * u,
            f.at(x - 0.05, 0, 0.275 - 0.016 * k * (k > 2)),
            0.012 * u,
            second,
        )
    neck = [f.at(0.36, 0, 0.12), f.at(0.52, 0.02 * sway, 0.28), f.at(0.60, 0.03 * sway, 0.42)]
    clay.chain(neck, [0.17 * u, 0.115 * u, 0.11 * u], main)
    clay.add(f.at(0.62, 0.03 * sway, 0.45), 0.125 * u, f.at(0.86, 0.03 * sway, 0.425), 0.082 * u, main)
    clay.add(f.at(0.64, 0.03 * sway, 0.385), 0.085 * u, f.at(0.85, 0.03 * sway, 0.365), 0.055 * u, skin)
    for side in (1, -1):
        clay.ball(f.at(0.92, 0.03 * sway + side * 0.03, 0.455), 0.018 * u, EYE)
        shoulder, elbow = f.at(0.36, side * 0.16, -0.03), f.at(0.38, side * 0.19, -0.16)
        hand = f.at(0.49, side * 0.16, -0.20 + 0.03 * side * sway)
        clay.chain([shoulder, elbow, hand], [0.05 * u, 0.037 * u, 0.026 * u], main)
        for k in (-1, 1):
            clay.add(hand, 0.02 * u, hand + 0.05 * u * f.forward - 0.03 * u * f.up + k * 0.02 * u * f.left, 0.006 * u, CLAW)
    _eyes(clay, f, 0.70, (0.03 * sway, 0.095), 0.52, 0.034 * u)
    _long_legs(clay, biped, pose, rows, u, (0.175, 0.085, 0.05, 0.045), main, main * 0.92)
    _toes(clay, pose, rows, f, u, main * 0.92, 0.04, 0.5)


def _long_legs(clay: Clay, biped: Biped, pose: Pose, rows, u: float, radii, thigh, shank) -> None:
    for foot in (0, 1):
        hip, knee, hock, ankle = (joint[rows][:, foot] for joint in (pose.hip, pose.knee, pose.hock, pose.ankle))
        clay.add(hip, radii[0] * u, knee, radii[1] * u, thigh)
        clay.add(knee, radii[1] * u, hock, radii[2] * u, thigh)
        clay.add(hock, radii[2] * u, ankle, radii[3] * u, shank)


def _toes(clay: Clay, pose: Pose, rows, f: Frame, u: float, colour, radius: float, spread: float) -> None:
    """Three toes forward and one back, with claws; the outer ones bend with the middle one."""
    up = np.array([0, 0, radius * u])
    for foot in (0, 1):
        ankle, heel, ball, toe = (joint[rows][:, foot] for joint in (pose.ankle, pose.heel, pose.ball, pose.toe))
        along = toe - ball
        side = np.cross(along, np.array([0.0, 0.0, 1.0]))
        clay.add(ankle, 1.25 * radius * u, ball + up, radius * u, colour)
        for k in (-1, 0, 1):
            tip = ball + (0.86 if k else 1.0) * along + k * spread * side
            joint = ball + 0.55 * (tip - ball)
            clay.chain([ball + up, joint + up, tip + 0.6 * up], [radius * u, 0.9 * radius * u, 0.5 * radius * u], colour)
            clay.add(tip + 0.6 * up, 0.5 * radius * u, tip + 0.18 * (tip - ball) + 0.2 * up, 0.12 * radius * u, CLAW)
        clay.add(ankle, radius * u, heel + 0.5 * up, 0.45 * radius * u, colour)


def outline(biped: Biped) -> np.ndarray:
    """(Q, 3, 2) triangles of the character's footprint, forward and left of the sole's middle [m]."""
    b = biped.record
    half, wide = 0.5 * b.foot_length, 0.5 * b.foot_width
    if biped.body.get("plan", "human") == "human":
        return np.concatenate([_oval(-0.6 * half, 0, 0.42 * half, 0.62 * wide), _oval(0.3 * half, 0, 0.7 * half, wide)])
    ball = -0.35 * half
    parts = [_oval(ball, 0, 0.3 * half, 0.4 * wide)]
    for k in (-1, 0, 1):
        tip = (half if k == 0 else 0.72 * half, k * wide)
        w = 0.15 * wide
        parts.append(np.array([[(ball, -w), tip, (ball, w)]]))
    return np.concatenate(parts)


def _oval(x: float, y: float, a: float, b: float, sides: int = 12) -> np.ndarray:
    angles = np.linspace(0, 2 * np.pi, sides + 1)
    rim = np.stack([x + a * np.cos(angles), y + b * np.sin(angles)], axis=1)
    middle = np.broadcast_to((x, y), rim[:-1].shape)
    return np.stack([middle, rim[:-1], rim[1:]], axis=1)
