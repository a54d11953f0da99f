"""Footprints along a way: alternating feet to either side of a polyline, equal steps, turns no sharper than allowed."""

import numpy as np

SMALL_STEP = 0.35
"""Step while turning on the spot, as a share of the preferred step: feet are lifted but the body stays."""


def wrapped(angle: float) -> float:
    """The angle in [-pi, pi)."""
    return (angle + np.pi) % (2 * np.pi) - np.pi


def along(line: np.ndarray, distances: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points (K, 2) and directions (K,) [rad] at these distances along a polyline (P, 2)."""
    pieces = np.hypot(*np.diff(line, axis=0).T)
    at = np.concatenate([[0.0], np.cumsum(pieces)])
    points = np.column_stack([np.interp(distances, at, line[:, k]) for k in (0, 1)])
    ahead = np.column_stack([np.interp(np.minimum(distances + 0.2, at[-1]), at, line[:, k]) for k in (0, 1)])
    behind = np.column_stack([np.interp(np.maximum(distances - 0.2, 0), at, line[:, k]) for k in (0, 1)])
    return points, np.arctan2(*(ahead - behind).T[::-1])


def walk(biped, line: np.ndarray, heading: float, side: int, last_side: int | None) -> list[list[float]]:
    """Footprints [side, x, y, heading] from the start of a polyline (P, 2) to its end.

    The first foot is `side`; `last_side` fixes the last one (None: either). The heading at the start is turned on the spot
    as far as one step allows at a time, then headings follow the line.
    """
    b = biped.record
    length = float(np.hypot(*np.diff(line, axis=0).T).sum())
    prints: list[list[float]] = []
    side, heading = _turn_on_spot(b, line, heading, side, prints)
    count = max(int(np.ceil(length / b.preferred_step - 0.25)), 1)
    if last_side is not None and (side + count - 1) % 2 != last_side:
        count += 1
    points, directions = along(line, np.arange(1, count + 1) * length / count)
    for point, direction in zip(points, directions, strict=True):
        heading += np.clip(wrapped(direction - heading), -b.max_turn, b.max_turn)
        prints.append(beside(b, side, point, heading))
        side = 1 - side
    return prints


def beside(b, side: int, middle, heading: float) -> list[float]:
    """Footprint of foot `side` beside the walker's middle."""
    across = 0.5 * b.step_width if side == 0 else -0.5 * b.step_width
    return [side, middle[0] - across * np.sin(heading), middle[1] + across * np.cos(heading), heading]


def _turn_on_spot(b, line: np.ndarray, heading: float, side: int, prints: list) -> tuple[int, float]:
    direction = along(line, np.array([0.0]))[1][0]
    while abs(wrapped(direction - heading)) > b.max_turn:
        heading += np.clip(wrapped(direction - heading), -b.max_turn, b.max_turn)
        prints.append(beside(b, side, line[0], heading))
        side = 1 - side
    return side, heading
