"""Standing: where a motion begins and ends."""

from math import hypot

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from motion.characters.dimensions import Dimensions
from motion.track import foot
from motion.track.footprints import Footprints
from motion.track.leg import FULL_REACH
from motion.track.pelvis import pelvis_at
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.tables import newest

SETTLES = 2.0
"""Pendulum times after its last step in which a body comes to rest: any force within the cone of its two legs is free, so by
physics alone it would take until it has to. Less after a foot that went less far than FAR: who steps on the spot, as in a
queue, stays between its feet, where it would lean over the one that stands, and into its neighbours."""
FAR = 0.5
"""A foot goes so far, in preferred steps, or further where one walks."""


@jit_borrowing
def above_feet(biped: Dimensions, footprints: Footprints, control: np.ndarray) -> None:
    """Fills control (6,) with the com at rest, balanced over the middles of the last two soles, no leg over its nominal.

    After a hop on one foot it is the last sole alone.
    """
    n, position = len(footprints.side), footprints.position
    older = n - 1 if footprints.side[n - 2] == footprints.side[n - 1] else n - 2
    yaw = 0.5 * (footprints.heading[older] + footprints.facing[older] + footprints.heading[n - 1] + footprints.facing[n - 1])
    turn, roll = pelvis_at(biped, footprints, footprints.contact_time[n - 1])
    control[:] = 0.0
    for axis in range(2):
        control[axis] = 0.5 * (position[older, axis] + position[n - 1, axis])
    control[2] = np.inf
    for i in range(older, n):
        ankle = foot.stance_ankle(biped, footprints, i, 0.0)
        hip = foot.hip_offset(biped, footprints.side[i], yaw + turn, roll)
        x, y = control[0] + hip[0] - ankle[0], control[1] + hip[1] - ankle[1]
        leg = min(footprints.nominal_length[i], FULL_REACH * biped.leg.max_length)
        rise = max(leg**2 - x * x - y * y, 0.0) ** 0.5
        control[2] = min(control[2], ankle[2] - hip[2] + rise)


@jit_borrowing
def _went(biped: Dimensions, footprints: Footprints, n: int) -> float:
    """How far a foot went until it landed as footprint n, in FAR; at most 1, as where that is not known."""
    if n < 2 or footprints.side[n] != footprints.side[n - 2]:
        return 1.0
    x = footprints.position[n, 0] - footprints.position[n - 2, 0]
    y = footprints.position[n, 1] - footprints.position[n - 2, 1]
    return min(hypot(x, y) / (FAR * biped.gait.preferred_step), 1.0)


@jit
def settling(biped: Dimensions, footprints: Footprints, time: np.ndarray, stiffness: float) -> np.ndarray:
    """Springs (P, 5) that hold the com at rest at the times (m + 1,) of a curve from SETTLES after the last step on.

    Sooner after a short one. Each: time [s], place [m], stiffness [1/s/m].
    """
    last, rest, out = len(footprints.side) - 1, np.empty(6), np.empty((len(time), 5))
    while last > 0 and footprints.stands[last]:
        last -= 1
    above_feet(biped, footprints, rest)
    settled = footprints.contact_time[last] + SETTLES * _went(biped, footprints, last) * pendulum_time(biped.leg.nominal_length)
    for i in range(len(time)):
        out[i, 0], out[i, 4] = time[i], stiffness
        for axis in range(3):
            out[i, 1 + axis] = rest[axis]
    return out[newest(time, settled) + 1 :]
