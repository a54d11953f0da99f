"""The planned pelvis: how it turns and lists, as a function of the footprints alone, so that the cost knows the pose's hips.

It turns with the foot that is ahead, most at its contact, and lists toward the swinging leg while the weight goes onto the
other: two of the determinants of gait (Saunders, Inman, Eberhart 1953), by which legs get longer where a step needs it.
"""

from math import cos, sin, tanh

import numpy as np

from motion.arithmetic.smooth import smoothstep
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, Footprints
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.tables import newest

WHOLE = 0.5
"""Share of the preferred step from which on the pelvis lists wholly."""


@jit_borrowing
def _ahead(footprints: Footprints, i: int) -> float:
    """How far the left foot is ahead of the right one [m] once footprint i has landed; 0 for a hop."""
    if i < 1 or footprints.side[i] == footprints.side[i - 1]:
        return 0.0
    p, q, heading = footprints.position[i - 1], footprints.position[i], footprints.heading[i]
    way = cos(heading) * (q[0] - p[0]) + sin(heading) * (q[1] - p[1])
    return way if footprints.side[i] == LEFT else -way


@jit_borrowing
def _share(footprints: Footprints, i: int, t: float) -> float:
    """Share of the time to the next contact that has passed since that of footprint i."""
    last = i + 1 >= len(footprints.side)
    time = footprints.step_time[i] if last else footprints.contact_time[i + 1] - footprints.contact_time[i]
    return min(max((t - footprints.contact_time[i]) / max(time, 1e-6), 0.0), 1.0)


@jit_borrowing
def weight_at(footprints: Footprints, t: float) -> float:
    """Over which leg the trunk leans at time t [s]: 1 the left, -1 the right, 0 at contacts and while standing on both."""
    i = newest(footprints.contact_time, t)
    if i < 0 or footprints.stands[i]:
        return 0.0
    x = _share(footprints, i, t)
    return (1.0 if footprints.side[i] == LEFT else -1.0) * 16 * x * x * (1 - x) * (1 - x)


@jit_borrowing
def _turn_at(biped: Dimensions, footprints: Footprints, i: int) -> tuple[float, float]:
    """(turn [rad] at the contact of footprint i, how far its foot is ahead then, in preferred steps)."""
    ahead = _ahead(footprints, i) / biped.gait.preferred_step
    return -biped.body.pelvis_turn * tanh(ahead), abs(ahead)


@jit
def pelvis_turns(biped: Dimensions, footprints: Footprints) -> np.ndarray:
    """What `pelvis_between` asks of each footprint (n, 2), once for many times."""
    turns = np.empty((len(footprints.side), 2))
    _lay_turns(biped, footprints, turns)
    return turns


@jit_borrowing
def _lay_turns(biped: Dimensions, footprints: Footprints, turns: np.ndarray) -> None:
    for i in range(len(turns)):
        turns[i, 0], turns[i, 1] = _turn_at(biped, footprints, i)


@jit_borrowing
def pelvis_between(biped: Dimensions, footprints: Footprints, turns: np.ndarray, t: float) -> tuple[float, float]:
    """pelvis_at, with the footprints' own turns (n, 2) at hand."""
    i = newest(footprints.contact_time, t)
    if i < 0:
        return 0.0, 0.0
    following = min(i + 1, len(footprints.side) - 1)
    return _between(biped, footprints, i, t, (turns[i, 0], turns[i, 1], turns[following, 0]))


@jit_borrowing
def pelvis_at(biped: Dimensions, footprints: Footprints, t: float) -> tuple[float, float]:
    """(turn, list) [rad] at time t [s]: counter-clockwise against the body's heading, and left side up."""
    i = newest(footprints.contact_time, t)
    if i < 0:
        return 0.0, 0.0
    turn, ahead = _turn_at(biped, footprints, i)
    then, _ = _turn_at(biped, footprints, min(i + 1, len(footprints.side) - 1))
    return _between(biped, footprints, i, t, (turn, ahead, then))


@jit_borrowing
def _between(
    biped: Dimensions, footprints: Footprints, i: int, t: float, turns: tuple[float, float, float]
) -> tuple[float, float]:
    """After the contact of footprint i; turns: then, how far it was ahead, and at the next contact."""
    begin, ahead, end = turns
    x = _share(footprints, i, t)
    turn = begin + smoothstep(x) * (end - begin)
    if footprints.stands[i]:
        return turn, 0.0
    y = (1 - x) * (1 - x)
    rise = 45.5625 * x * x * y * y  # 1 at a third of the step, at rest at both ends
    side = 1.0 if footprints.side[i] == LEFT else -1.0
    return turn, side * biped.body.pelvis_drop * min(ahead / WHOLE, 1.0) * rise
