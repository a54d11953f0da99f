"""Steps along a way: alternating feet to either side of a polyline, equal steps, turns no sharper than allowed."""

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.dimensions import Dimensions
from motion.track.footprints import Step
from planner.stepping.beside import Place, beside


def along(line: np.ndarray, distances: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points (K, 2) and directions (K,) [rad] at these distances along a polyline (P, 2)."""
    pieces = np.hypot(*np.diff(line, axis=0).T)
    at = np.concatenate([[0.0], np.cumsum(pieces)])
    points = np.column_stack([np.interp(distances, at, line[:, k]) for k in (0, 1)])
    ahead = np.column_stack([np.interp(np.minimum(distances + 0.2, at[-1]), at, line[:, k]) for k in (0, 1)])
    behind = np.column_stack([np.interp(np.maximum(distances - 0.2, 0), at, line[:, k]) for k in (0, 1)])
    return points, np.arctan2(*(ahead - behind).T[::-1])


def walk(
    biped: Dimensions, line: np.ndarray, heading: float, side: int, last_side: int | None, stride: float = 1.0
) -> list[Step]:  # fmt: skip
    """Steps from the start of a polyline (P, 2) to its end, of `stride` preferred ones.

    The first foot is `side`; `last_side` fixes the last one (None: either). The heading at the start is turned on the spot
    as far as one step allows at a time, then headings follow the line.
    """
    length, most = float(np.hypot(*np.diff(line, axis=0).T).sum()), biped.reach.max_turn
    steps = _turn_on_spot(biped, line, heading, side)
    if steps:
        heading, side = steps[-1].heading, 1 - steps[-1].side
    count = max(int(np.ceil(length / (stride * biped.gait.preferred_step) - 0.25)), 1)
    if last_side is not None and (side + count - 1) % 2 != last_side:
        count += 1
    points, directions = along(line, np.arange(1, count + 1) * length / count)
    for point, direction in zip(points, directions, strict=True):
        heading += float(np.clip(wrapped(direction - heading), -most, most))
        steps.append(step_beside(biped, side, (float(point[0]), float(point[1])), heading))
        side = 1 - side
    return steps


def step_beside(biped: Dimensions, side: int, middle: Place, heading: float) -> Step:
    """The step of foot `side` to beside the walker's middle."""
    return Step(side, *beside(biped, side, middle, heading), heading)


def _turn_on_spot(biped: Dimensions, line: np.ndarray, heading: float, side: int) -> list[Step]:
    """Steps where the line begins, until the walker faces along it as nearly as one step can turn."""
    direction, most, steps = float(along(line, np.array([0.0]))[1][0]), biped.reach.max_turn, []
    while abs(wrapped(direction - heading)) > most:
        heading += float(np.clip(wrapped(direction - heading), -most, most))
        steps.append(step_beside(biped, side, (float(line[0, 0]), float(line[0, 1])), heading))
        side = 1 - side
    return steps
