"""The planned pelvis: how it turns and lists, as a function of the footprints alone, so that the cost knows the pose's hips.

It turns with the foot that is ahead, most at its contact, and lists toward the swinging leg while the weight goes onto the
other: two of the determinants of gait (Saunders, Inman, Eberhart 1953), by which legs get longer where a step needs it.
"""

import numpy as np

from motion.arithmetic.functions import levelled, turn
from motion.arithmetic.smooth import smoothstep
from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, Footprints
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.lanes import Some, choose, larger, smaller
from worlds.compiled.tables import newest

WHOLE = 0.5
"""Share of the preferred step from which on the pelvis lists wholly."""


@jit_borrowing
def _ahead(footprints: Footprints, i: Some) -> Some:
    """How far the left foot is ahead of the right one [m] once footprint i has landed; 0 for a hop."""
    before = larger(i - 1, 0)
    p, q = footprints.position[before], footprints.position[i]
    c, s = turn(footprints.heading[i])
    way = c * (q[0] - p[0]) + s * (q[1] - p[1])
    side = footprints.side[i]
    return choose(side == footprints.side[before], 0.0, choose(side == LEFT, way, -way))


@jit_borrowing
def _share(footprints: Footprints, i: Some, t: Some) -> Some:
    """Share of the time to the next contact that has passed since that of footprint i."""
    after, begin = smaller(i + 1, len(footprints.side) - 1), footprints.contact_time[i]
    time = choose(after == i, footprints.step_time[i], footprints.contact_time[after] - begin)
    return smaller(larger((t - begin) / larger(time, 1e-6), 0.0), 1.0)


@jit_borrowing
def weight_at(footprints: Footprints, t: Some) -> Some:
    """Over which leg the trunk leans at time t [s]: 1 the left, -1 the right, 0 at contacts and while standing on both."""
    n = newest(footprints.contact_time, t)
    i = larger(n, 0)
    x = _share(footprints, i, t)
    weight = 16 * x * x * (1 - x) * (1 - x)
    return choose(footprints.stands[i] | (n < 0), 0.0, choose(footprints.side[i] == LEFT, weight, -weight))


@jit_borrowing
def _turn_at(biped: Dimensions, footprints: Footprints, i: Some) -> tuple[Some, Some]:
    """(turn [rad] at the contact of footprint i, how far its foot is ahead then, in preferred steps)."""
    ahead = _ahead(footprints, i) / biped.gait.preferred_step
    return -biped.body.pelvis_turn * levelled(ahead), abs(ahead)


@jit
def pelvis_turns(biped: Dimensions, footprints: Footprints, begin: float) -> np.ndarray:
    """What `pelvis_after` asks of each footprint (n, 2), once for many times, none of which is before `begin` [s]."""
    turns = np.empty((len(footprints.side), 2))
    _lay_turns(biped, footprints, max(newest(footprints.contact_time, begin), 0), turns)
    return turns


@jit_borrowing
def _lay_turns(biped: Dimensions, footprints: Footprints, first: int, turns: np.ndarray) -> None:
    for i in range(first, len(turns)):
        turns[i, 0], turns[i, 1] = _turn_at(biped, footprints, i)


@jit_borrowing
def pelvis_at(biped: Dimensions, footprints: Footprints, t: Some) -> tuple[Some, Some]:
    """(turn, list) [rad] at time t [s]: counter-clockwise against the body's heading, and left side up."""
    n = newest(footprints.contact_time, t)
    i = larger(n, 0)
    begin, ahead = _turn_at(biped, footprints, i)
    then, _ = _turn_at(biped, footprints, smaller(i + 1, len(footprints.side) - 1))
    found, roll = pelvis_after(biped, footprints, i, t, (begin, ahead, then))
    return choose(n >= 0, found, 0.0), choose(n >= 0, roll, 0.0)


@jit_borrowing
def pelvis_after(biped: Dimensions, footprints: Footprints, i: Some, t: Some, turns: Triple) -> tuple[Some, Some]:
    """pelvis_at between the contact of footprint i and the next; turns: then, how far it was ahead, and at the next contact."""
    begin, ahead, end = turns
    x = _share(footprints, i, t)
    found = begin + smoothstep(x) * (end - begin)
    y = (1 - x) * (1 - x)
    rise = 45.5625 * x * x * y * y  # 1 at a third of the step, at rest at both ends
    roll = choose(footprints.side[i] == LEFT, 1.0, -1.0) * biped.body.pelvis_drop * smaller(ahead / WHOLE, 1.0) * rise
    return found, choose(footprints.stands[i], 0.0, roll)
