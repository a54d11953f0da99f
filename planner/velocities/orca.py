"""A second model of walking among others: optimal reciprocal collision avoidance (ORCA; van den Berg, Guy, Lin & Manocha 2011).

Each other one forbids half a plane of velocities: what is left avoids it for HORIZON, if it does its half of evading, too. Of
the velocities that all leave, the one nearest to the wished one is taken; where none is left, the one that breaks the worst of
them least. A step at that velocity follows; that it is free remains the hard guarantee, so it may become shorter, or none.

It knows bodies as discs, no walls, no side and no right of way.
"""

from math import atan2, hypot, inf, sqrt
from typing import Any

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.arithmetic.gravity import pendulum_time
from motion.characters.dimensions import Dimensions
from planner.crowd.candidates import QUICK, Candidate, bearing_of, candidate, may_be_taken
from planner.crowd.choosing import LEAST, SHORTER_BY, STANDING
from planner.crowd.neighbour import NEIGHBOUR, see
from planner.crowd.walker import Walker
from planner.round.round import Round
from planner.velocities.program import Place, best
from worlds.compiled.jit import jit, jit_borrowing

HORIZON = 2.0
"""Others are avoided for so many swings: with 6 of them a throng of 2 per square metre walks at two thirds of the speed."""
STILL = 0.01
"""Slower than this one stands [m/s]; else no step is shorter than the shortest: throngs that stand would never set out."""


@jit_borrowing
def evasion(p: Place, w: Place, radius: float, horizon: float, soon: float) -> tuple[float, float, float, float]:
    """(x, y) the least change of my velocity against another's, w, after which we keep apart for `horizon` [s], or part within
    `soon` [s] where we overlap; and (x, y) the border beyond which we do. p: from me to the other [m]; radius: of both [m]."""
    (px, py), square = p, p[0] * p[0] + p[1] * p[1]
    time = horizon if square > radius * radius else soon
    wx, wy = w[0] - px / time, w[1] - py / time
    far, along = hypot(wx, wy), wx * px + wy * py
    if square <= radius * radius or (along < 0 and along * along > radius * radius * far * far):
        nx, ny = (wx / far, wy / far) if far > 0 else (-1.0, 0.0)  # beyond the disc about p / time
        return (radius / time - far) * nx, (radius / time - far) * ny, ny, -nx
    leg, left = sqrt(square - radius * radius), 1.0 if px * wy - py * wx > 0 else -1.0  # beyond a side of the cone
    dx, dy = left * (px * leg - left * py * radius) / square, left * (left * px * radius + py * leg) / square
    slide = w[0] * dx + w[1] * dy
    return slide * dx - w[0], slide * dy - w[1], dx, dy


@jit_borrowing
def _forbid(walker: Walker, others: Any, mine: Place, times: Place, planes: np.ndarray) -> None:
    """Fills in the half-plane that each of the others leaves (planner.velocities.program); mine: my velocity [m/s]."""
    for i in range(len(others)):
        other = others[i]
        radius = sqrt(walker.deep * walker.wide) + sqrt(other.deep * other.wide)
        p, w = (other.x, other.y), (mine[0] - other.vx, mine[1] - other.vy)
        ux, uy, planes[i, 2], planes[i, 3] = evasion(p, w, radius, times[0], times[1])
        planes[i, 0], planes[i, 1] = mine[0] + 0.5 * ux, mine[1] + 0.5 * uy


@jit_borrowing
def _step_at(round: Round, biped: Dimensions, walker: Walker, near: np.ndarray, velocity: Place) -> Candidate:
    """The step at a velocity [m/s], or as much of it as is free."""
    speed, least = hypot(velocity[0], velocity[1]), LEAST * biped.gait.preferred_step
    to = bearing_of(biped, walker, wrapped(atan2(velocity[1], velocity[0]) - walker.course))
    length = min(speed * QUICK * pendulum_time(biped.timing.hip_height), to.longest)
    length = max(min(speed * candidate(biped, walker, to, length).time, length), least if speed > STILL else 0.0)
    while length >= least:
        step = candidate(biped, walker, to, length)
        if may_be_taken(round, walker, near, step):
            return step
        length *= SHORTER_BY
    return STANDING


@jit
def choose(round: Round, walker: Walker, wished: Candidate, left: float, near: np.ndarray) -> Candidate:
    """The step at the velocity that is left nearest to the wished one; its time is 0 where that is to stand."""
    c, held, biped = walker.c, round.reservations, round.bipeds[round.kind[walker.c]]
    others, myself, planes = np.empty(len(near), NEIGHBOUR), np.empty(1, NEIGHBOUR), np.empty((len(near), 4))
    see(held, walker, (0.0, 0.0), 0.0, -inf, near, others)
    see(held, walker, (0.0, 0.0), 0.0, -inf, np.array([c]), myself)
    swing, wish = pendulum_time(biped.timing.hip_height), (0.0, 0.0)
    if wished.time > 0:
        wish = ((wished.x - walker.x) / wished.time, (wished.y - walker.y) / wished.time)
    times = (HORIZON * swing, QUICK * swing)
    _forbid(walker, others, (myself[0].vx, myself[0].vy), times, planes)
    vx, vy = best(planes, walker.full, wish, np.empty_like(planes))
    if vx == wish[0] and vy == wish[1] and wished.time > 0 and may_be_taken(round, walker, near, wished):
        return wished
    return _step_at(round, biped, walker, near, (vx, vy))
