"""What one walker sees of another: where it is and goes, how it stands, and what it wants."""

from math import hypot, inf
from typing import Any

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from planner.crowd.candidates import QUICK
from planner.crowd.walker import Walker
from planner.round.reservations import COMMITTED, Reservations, place_on_path
from planner.round.round import Round
from planner.stepping.beside import Place
from worlds.compiled.jit import jit_borrowing

NEIGHBOUR = np.dtype(
    [
        ("x", np.float64),  # place when my body rests beside my last footprint, relative to that rest [m]
        ("y", np.float64),
        ("vx", np.float64),  # velocity at which it goes on from there [m/s]
        ("vy", np.float64),
        ("rest_x", np.float64),  # where it comes to rest if it stops, relative to that rest [m]
        ("rest_y", np.float64),
        ("deep", np.float64),  # half axes of its body [m]
        ("wide", np.float64),
        ("face_x", np.float64),  # unit vector in which it faces
        ("face_y", np.float64),
        ("along", np.float64),  # cosine between its aim and mine; 0 where it stays
        ("claim_x", np.float64),  # where it would rest next, relative to my rest [m]; inf: it has no right of way over me
        ("claim_y", np.float64),
        ("rank", np.float64),  # of that claim
    ]
)
LEAST_STEP = 0.1
"""Steps of less than this time [s] tell no velocity."""
ROUNDED = 2e-9
"""Whoever is beyond a bound by this [m] is so however numbers are rounded."""
ALIKE = 0.5
"""The cosine between two wishes from which on they are alike: none of them has the right of way, who is ahead goes ahead."""


class Neighbour:
    """A record of NEIGHBOUR, for the type checker; never made."""

    x: float
    y: float
    vx: float
    vy: float
    rest_x: float
    rest_y: float
    deep: float
    wide: float
    face_x: float
    face_y: float
    along: float
    claim_x: float
    claim_y: float
    rank: float


@jit_borrowing
def see(
    held: Reservations, walker: Walker, aim: Place, rank: float, longer: float, near: np.ndarray, others: Any
) -> None:  # fmt: skip
    """Fills others (K,) with those `near` (K,), as my body comes to rest beside my last footprint.

    Everyone is expected to keep its pace: that of its last step. `aim` and `rank` are mine; of equal ranks the lower number
    goes first. In a queue nobody has the right of way, since all would wait for the one who has waited longest; but who has
    been where it is since before `longer` [s].
    """
    rest = COMMITTED - 1
    for i, j in enumerate(near):
        other, path = others[i], held.path
        span = path[j, rest, 2] - path[j, rest - 1, 2]
        vx = vy = 0.0
        if span > LEAST_STEP:
            vx, vy = (path[j, rest, 0] - path[j, rest - 1, 0]) / span, (path[j, rest, 1] - path[j, rest - 1, 1]) / span
        x, y = place_on_path(held, j, walker.there, rest)
        later = max(walker.there - path[j, rest, 2], 0.0)
        other.x, other.y = x + later * vx - walker.rest_x, y + later * vy - walker.rest_y
        other.vx, other.vy = vx, vy
        other.rest_x, other.rest_y = path[j, rest, 0] - walker.rest_x, path[j, rest, 1] - walker.rest_y
        other.deep, other.wide = held.half[j, 0], held.half[j, 1]
        other.face_x, other.face_y = held.face[j, 0], held.face[j, 1]
        other.along = held.aim[j, 0] * aim[0] + held.aim[j, 1] * aim[1]
        other.rank, other.claim_x, other.claim_y = held.rank[j], inf, inf
        first = other.along < ALIKE and (other.rank > rank or (other.rank == rank and j < walker.c))
        if other.rank > 0 and (first or held.since[j] < longer):
            other.claim_x, other.claim_y = held.claim[j, 0] - walker.rest_x, held.claim[j, 1] - walker.rest_y


@jit_borrowing
def close_by(round: Round, walker: Walker, others: Any, close: Any) -> int:
    """Fills in those of the others whom a step in any direction may come to by spacing, as bounds tell; returns how many.

    Whose way crosses mine lies no further aside than both are wide, and along it no further than one goes in the time gap and a
    step, or than the other goes in a step.
    """
    biped, count = round.bipeds[round.kind[walker.c]], 0
    swing, stride = pendulum_time(biped.timing.hip_height), biped.gait.preferred_step
    time, fastest = QUICK * swing, max(walker.full, hypot(walker.wish_x, walker.wish_y))
    goes = max(fastest * (round.weights[round.kind[walker.c]].gap * swing + time), 0.5 * stride)
    off = hypot(walker.x - walker.rest_x, walker.y - walker.rest_y)  # of my rest beside a step of no length
    off += hypot(walker.foot_x - walker.rest_x, walker.foot_y - walker.rest_y) + biped.gait.step_width
    for i in range(len(others)):
        other = others[i]
        wide = max(walker.deep, walker.wide) + max(other.deep, other.wide)
        far = hypot(wide, max(goes + wide, time * hypot(other.vx, other.vy))) + ROUNDED
        if hypot(other.x, other.y) < far or hypot(other.rest_x, other.rest_y) < far + 0.5 * off:
            close[count] = other
            count += 1
    return count
