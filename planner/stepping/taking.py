"""Taking a step in a row of footprints: where it lands, how the feet roll, and the timing of the footprint that it leaves."""

from math import isnan, nan

import numpy as np

from motion.characters.dimensions import Dimensions
from motion.track.footprints import Footprints, Step, outward, place, rise, stand_on, step_length, step_onto, walker_heading
from planner.round.round import Wish
from planner.stepping import timing
from planner.stepping.placing import EDGE, forwardness, landing_share, lay_sole, lay_strike
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit_borrowing

STOPS = 0.3
"""Share of the sole ahead of its middle where a foot presses first when it stops the body. Over the middle alone an upright
body comes to rest only as fast as it would fall; people's toes brake it (Jian, Winter, Ishac, Gilchrist 1993)."""
START_OVERLAP = 0.6
"""Shift of weight before the first step from standing, in pendulum times of the hip's height."""


@jit_borrowing
def stand_at(
    biped: Dimensions, world: WorldArrays, footprints: Footprints, side: int, places: np.ndarray, contact: float, toe_out: float
) -> None:
    """Fills the first two rows: standing at places (2, 3) x, y, heading, the second with foot `side` since `contact` [s].

    toe_out: how far the soles point outward of these headings [rad].
    """
    for i in range(2):
        x, y, heading = places[i, 0], places[i, 1], places[i, 2]
        rock = queries.rock_under(world, x, y, EDGE)
        step = step_onto(side if i == 1 else 1 - side, x, y, heading)
        out = outward(step.side, toe_out)
        place(footprints, i, step, out, lay_sole(biped, world, x, y, heading + out, rock), rock)
        footprints.contact_time[i] = contact - 0.5 * (1 - i)
        footprints.stance_time[i], footprints.step_time[i] = 1.0, 0.5
        footprints.roll[i, 0] = footprints.roll[i, 1] = 0.5
        footprints.nominal_length[i], footprints.facing[i] = biped.leg.nominal_length, 0.0


@jit_borrowing
def take_step(
    biped: Dimensions, world: WorldArrays, footprints: Footprints, n: int, wish: Wish, toe_out: float, before: float = nan
) -> None:
    """Puts the footprint of a wished step at row n, after the rows before, and times the one that it leaves.

    toe_out: how far the sole points outward of the step's heading [rad]; 0 where that is the sole's own. before: the speed
    [m/s] that the step before it is taken to have had; NaN: the one it had.
    """
    step = wish.step
    if step.stands > 0:
        stand_on(footprints, n)
    else:
        rock = queries.rock_under(world, step.x, step.y, EDGE)
        out = outward(step.side, toe_out)
        place(footprints, n, step, out, lay_sole(biped, world, step.x, step.y, step.heading + out, rock), rock)
    _roll(biped, footprints, n)
    time, stance = _timing(biped, footprints, n, wish, speed_before(footprints, n) if isnan(before) else before)
    _set_timing(biped, footprints, n, time, stance)
    footprints.nominal_length[n] *= step.crouch
    footprints.facing[n] = step.facing
    lay_strike(biped, footprints, n)


@jit_borrowing
def _roll(biped: Dimensions, footprints: Footprints, n: int) -> None:
    """Where the support begins on footprint n and ends on n - 1: heel to toe forward, toe to heel backward, else between."""
    ahead, begin = 0.0, 0.5
    if footprints.stands[n]:
        _brake(footprints, n - 1)
    else:
        start, goal = footprints.position[n - 1], footprints.position[n]
        ahead = forwardness(start, goal, footprints.heading[n])
        footprints.roll[n - 1, 1] = 0.5 + 0.5 * forwardness(start, goal, footprints.heading[n - 1])
        begin = landing_share(biped, footprints, n, ahead)
    footprints.roll[n, 0] = begin
    footprints.roll[n, 1] = 0.5 + 0.5 * ahead


@jit_borrowing
def _brake(footprints: Footprints, n: int) -> None:
    """The support on footprint n, after which one stands, begins ahead of its middle on the way that its foot came."""
    if n >= 2 and not footprints.stands[n] and footprints.side[n] == footprints.side[n - 2]:
        came = forwardness(footprints.position[n - 2], footprints.position[n], footprints.heading[n])
        footprints.roll[n, 0] = max(min(0.5 + STOPS * came, 1.0), 0.0)


@jit_borrowing
def _timing(biped: Dimensions, footprints: Footprints, n: int, wish: Wish, before: float) -> tuple[float, float]:
    """(step time, stance time) of footprint n - 1: automatic (paper, section 4.1), but for what is asked for; before: the speed
    of the step before it [m/s]."""
    asked = wish.step
    if asked.stands > 0:
        return _as_asked(asked, asked.stands, asked.stands + START_OVERLAP * timing.hip_pendulum(biped))
    turn = abs(walker_heading(footprints, n) - walker_heading(footprints, n - 1))
    hop = asked.side == footprints.side[n - 1]
    length, last = step_length(footprints, n), step_length(footprints, n - 1)
    running = before > 0 and timing.is_running(biped, last, last / before)
    step, stance = timing.step_timing(biped, length, rise(footprints, n), turn, hop, wish.longest, running, before)
    overlap = footprints.contact_time[n - 2] + footprints.stance_time[n - 2] - footprints.contact_time[n - 1]
    if overlap < 0:  # who comes down from a flight does not stay on one foot for long
        step, stance = timing.after_flight(biped, step, stance)
    longer = max(timing.least_step_time(biped, overlap) - step, 0.0)
    if stance < step:  # a flight: who leaps from a foot pushes with it once the other one has left
        longer = max(longer, overlap + timing.least_push(biped) - stance)
    return _as_asked(asked, step + longer, stance + longer)


@jit_borrowing
def speed_before(footprints: Footprints, n: int) -> float:
    """Speed [m/s] of the step before, to footprint n - 1; 0 where one stood."""
    if n < 3 or footprints.stands[n - 1]:
        return 0.0
    return step_length(footprints, n - 1) / footprints.step_time[n - 2]


@jit_borrowing
def _as_asked(asked: Step, step: float, stance: float) -> tuple[float, float]:
    """Where one of the two times is asked for, or both; a stance that is not keeps its share of the step."""
    if not isnan(asked.stance_time):
        stance = asked.stance_time
    elif not isnan(asked.time):
        stance *= asked.time / step
    return (step if isnan(asked.time) else asked.time), stance


@jit_borrowing
def _set_timing(biped: Dimensions, footprints: Footprints, n: int, step: float, stance: float) -> None:
    """Sets the timing of footprint n - 1, the same as a first guess for n's own, and the leg that the pace asks for."""
    stands = footprints.stands[n]
    if stands:
        footprints.stance_time[n - 2] = footprints.contact_time[n - 1] + step - footprints.contact_time[n - 2]
        footprints.roll[n - 2, 1] = 0.5
    for k in range(n - 1, n + 1):
        footprints.step_time[k], footprints.stance_time[k] = step, stance
    footprints.contact_time[n] = footprints.contact_time[n - 1] + step
    usual = timing.nominal_length(biped, step_length(footprints, n), step, rise(footprints, n))
    footprints.nominal_length[n] = biped.leg.nominal_length if stands else usual
