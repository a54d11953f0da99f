"""Laying a sole on the ground, and lifting the foot over what lies between two footprints."""

from math import cos, sin, sqrt
from typing import Any

import numpy as np

from motion.arithmetic.gravity import froude_number, pendulum_time
from motion.arithmetic.smooth import fade, mix, smoothstep
from motion.characters.dimensions import Dimensions
from motion.pose import swing
from motion.track import foot
from motion.track.footprints import Footprints, out_of_plane
from worlds import queries
from worlds.arrays import FLAT, SPIRAL_STAIRS, STAIRS, WorldArrays
from worlds.compiled.beside.places import load_wide, store_some
from worlds.compiled.beside.wide import WIDE
from worlds.compiled.jit import jit_borrowing, stack_array

SAMPLES = 61
"""Shares of the swing at which the ground below the foot is asked for."""
LEVEL_SAMPLES = 11
"""The same on level ground, where only the foot itself, pitched, reaches below its line."""
SHORT = 0.15
"""A step shorter than this [m] does not roll over the whole foot."""
HIGH = 1.6
"""A lift above this many clearances has an edge to go over."""
MOST_RISES = 3
"""No lift is above so many of the highest steps: whatever lies between needs no more."""
ROUGH = 0.16
"""Clearance on ground that is not level, in foot lengths, where the gait's own is less: there one lifts the feet."""
RIM = 0.02
"""Rocks count as so much wider [m] in the middle of a swing: one that lies between two of the samples is not missed. Not where
the foot goes only up or down: it may stand beside a rock as near as it likes."""
EDGE = 0.02
"""A rock carries a sole whose middle lies at least this far [m] from the rock's edge."""
QUICK, CALM = 0.6, 1.2
"""Swing times, in pendulum times of the nominal leg, up to which a foot lands flat, and from which on its heel may strike."""
FOREFOOT = (0.06, 0.16)
"""Drops below the sole's plane, in hip heights, from which on one lands less on the heel, and from which on on the ball."""
RUNNERS_STRIKE = 0.65
"""Share by which the toes are less up when a runner lands."""
Ground = tuple[float, float, float, float]
"""Height of the ground [m] and its normal."""


@jit_borrowing
def lay_sole(biped: Dimensions, world: WorldArrays, x: float, y: float, heading: float, rock: int) -> Ground:
    """The ground under a sole whose middle is at x, y: a rock's flat top, or what it rests on of the terrain.

    On sloping ground the sole takes the slope between its ends and its sides, raised until no end is in the ground.
    """
    if rock >= 0:
        return world.rocks[rock, 3], 0.0, 0.0, 1.0
    if world.terrain_kind == FLAT:
        return 0.0, 0.0, 0.0, 1.0
    c, s = cos(heading), sin(heading)
    half, wide = 0.5 * biped.foot.length, 0.5 * biped.foot.width
    toe = queries.terrain_height(world, x + half * c, y + half * s)
    heel = queries.terrain_height(world, x - half * c, y - half * s)
    left = queries.terrain_height(world, x - wide * s, y + wide * c)
    right = queries.terrain_height(world, x + wide * s, y - wide * c)
    middle = queries.terrain_height(world, x, y)
    if world.terrain_kind == STAIRS or world.terrain_kind == SPIRAL_STAIRS:  # treads
        return max(max(toe, heel), middle), 0.0, 0.0, 1.0
    along, across = (toe - heel) / (2 * half), (left - right) / (2 * wide)
    dx, dy = along * c - across * s, along * s + across * c
    length = sqrt(dx * dx + dy * dy + 1)
    return max(middle, 0.5 * (toe + heel)), -dx / length, -dy / length, 1 / length


@jit_borrowing
def forwardness(start: Any, goal: Any, heading: float) -> float:
    """How far the step between two places goes along the heading: 1 forward, -1 backward, 0 sideways or on the spot."""
    dx, dy = goal[0] - start[0], goal[1] - start[1]
    length = sqrt(dx * dx + dy * dy)
    share = (dx * cos(heading) + dy * sin(heading)) / max(length, SHORT)
    return min(max(1.25 * share, -1.0), 1.0)


@jit_borrowing
def landing_share(biped: Dimensions, footprints: Footprints, n: int, forward: float) -> float:
    """Where on the sole the support on footprint n begins: at the heel of a step forward, at the toe of one backward.

    After a drop, as on stairs, at the ball; down a slope, where both footprints lie in one plane, still at the heel.
    """
    drop = -out_of_plane(footprints, n)
    ball, begin = 0.5 + biped.foot.ball_forward / biped.foot.length, 0.5 - 0.5 * forward
    deep = smoothstep((drop / biped.timing.hip_height - FOREFOOT[0]) / (FOREFOOT[1] - FOREFOOT[0]))
    return mix(begin, max(ball, begin), deep)


@jit_borrowing
def lay_strike(biped: Dimensions, footprints: Footprints, n: int) -> None:
    """Sets how far the toes are up when footprint n is landed on: on its heel, in a swing with time for it; runners hardly.

    Who lands before the middle of the sole has the heel up as much.
    """
    before = _before(footprints, n)
    footprints.strike[n] = 0.0
    if footprints.stands[n] or footprints.side[before] != footprints.side[n]:
        return
    time = swing.swing_time(footprints, before, n)
    calm = (time / pendulum_time(biped.leg.nominal_length) - QUICK) / (CALM - QUICK)
    angle = biped.foot.heel_strike_angle * min(max(1 - 2 * footprints.roll[n, 0], -1.0), 1.0)
    running = 1 - RUNNERS_STRIKE * foot.runs(footprints, before)
    footprints.strike[n] = angle * running * (1 - fade(max(calm, 0.0), 1.0))


@jit_borrowing
def _before(footprints: Footprints, n: int) -> int:
    """The footprint that the foot of footprint n leaves; 0 where none is known."""
    before = n - 1
    while before > 0 and footprints.side[before] != footprints.side[n]:
        before -= 1
    return before


@jit_borrowing
def lay_swing(biped: Dimensions, world: WorldArrays, footprints: Footprints, n: int) -> None:
    """Sets lift, hold and bow of the swing that arrives at footprint n, after the ground between.

    Over edges the foot goes up first: smooth ways go with little hold; where that needs a high lift, as on stairs, more hold
    needs less. Where no leg folds so far, as it bows into the side of a rock, it does not bow.
    """
    before = _before(footprints, n)
    lay_strike(biped, footprints, n)
    footprints.bow[n] = 1.0
    lift, hold = _least_lift(biped, world, footprints, before, n)
    if lift > biped.timing.hip_height - biped.leg.min_length:
        footprints.bow[n] = 0.0
        straight, straight_hold = _least_lift(biped, world, footprints, before, n)
        if straight < lift:
            lift, hold = straight, straight_hold
        else:
            footprints.bow[n] = 1.0
    footprints.hold[n] = hold
    footprints.lift[n] = lift + biped.gait.run_lift * foot.runs(footprints, before) * _pace(biped, footprints, before, n)


@jit_borrowing
def _least_lift(biped: Dimensions, world: WorldArrays, footprints: Footprints, before: int, n: int) -> tuple[float, float]:
    """(lift [m], hold) of a swing."""
    smooth = _lift(biped, world, footprints, before, n, swing.HOLD)
    if smooth <= HIGH * biped.gait.clearance:
        return smooth, swing.HOLD
    held = _lift(biped, world, footprints, before, n, swing.EDGE_HOLD)
    if held > 0.9 * smooth and smooth < MOST_RISES * biped.reach.max_rise:
        return smooth, swing.HOLD
    return held, swing.EDGE_HOLD


@jit_borrowing
def _pace(biped: Dimensions, footprints: Footprints, before: int, after: int) -> float:
    """Froude number of the stride between two footprints, at most 1."""
    p, q = footprints.position[before], footprints.position[after]
    length = sqrt((q[0] - p[0]) ** 2 + (q[1] - p[1]) ** 2)
    time = footprints.contact_time[after] - footprints.contact_time[before]
    return min(froude_number(length, time, biped.timing.hip_height), 1.0)


@jit_borrowing
def is_level(biped: Dimensions, world: WorldArrays, footprints: Footprints, before: int, after: int) -> bool:
    """Whether the ground below a swing is flat, without a rock: no cell that it crosses lists one."""
    if world.terrain_kind != FLAT:
        return False
    p, q = footprints.position[before], footprints.position[after]
    bow = swing.outward(biped, footprints, before, after, (p[0], p[1], p[2]), (q[0], q[1], q[2]))
    x, y = abs(bow[0]) + biped.foot.length, abs(bow[1]) + biped.foot.length
    low = queries.cell_of(world, min(p[0], q[0]) - x, min(p[1], q[1]) - y)
    high = queries.cell_of(world, max(p[0], q[0]) + x, max(p[1], q[1]) + y)
    columns = world.columns
    for row in range(low // columns, high // columns + 1):
        begin, end = row * columns + low % columns, row * columns + high % columns
        if world.rock_start[begin] != world.rock_start[end + 1]:
            return False
    return True


@jit_borrowing
def _below(world: WorldArrays, x: float, y: float, rim: float, highest: float) -> float:
    """Height of the ground [m] where rocks are wider by `rim`, but for those above `highest`: feet go by beside them."""
    rock, height = queries.rock_under(world, x, y, -rim), queries.terrain_height(world, x, y)
    if rock >= 0 and world.rocks[rock, 3] > highest:
        return queries.ground_height(world, x, y)
    return max(height, world.rocks[rock, 3]) if rock >= 0 else height


@jit_borrowing
def _depth(biped: Dimensions, world: WorldArrays, footprints: Footprints, n: int) -> float:
    """How far the ground reaches into the sole of a footprint, at its heel, ball and toe [m]."""
    deep, half = 0.0, 0.5 * biped.foot.length
    for forward in (-half, biped.foot.ball_forward, half):
        p = foot.along_sole(footprints, n, forward, 0.0)
        deep = max(deep, queries.ground_height(world, p[0], p[1]) - p[2])
    return deep


_empty_points = stack_array(9, WIDE)
_UPWARD = np.arange(float(WIDE))


@jit_borrowing
def _lay_points(
    biped: Dimensions, footprints: Footprints, before: int, after: int, first: int, samples: int, points: np.ndarray
) -> None:
    """Where heel, ball and toe are at WIDE samples of a swing, from one on: points (9, WIDE), three coordinates of each."""
    back, ahead = -0.5 * biped.foot.length - biped.foot.ball_forward, 0.5 * biped.foot.length - biped.foot.ball_forward
    sole = swing.sole_at(biped, footprints, before, after, (first + load_wide(_UPWARD, (0,))) / samples)
    heel, toe = swing.point_of_foot(sole, back, 0.0, sole.pitch), swing.point_of_foot(sole, ahead, 0.0, sole.pitch - sole.flex)
    for n, point in enumerate((heel, sole.ball, toe)):
        for axis in range(3):
            store_some(points, (3 * n + axis, 0), point[axis], WIDE)


@jit_borrowing
def _lift(biped: Dimensions, world: WorldArrays, footprints: Footprints, before: int, after: int, hold: float) -> float:
    """Lift [m] with which heel, ball and toe clear the ground below by the gait's clearance at mid-swing.

    A sole that stands in the ground a little, on a crest, leaves it and comes to it as deep: no lift helps there.
    """
    most, points = MOST_RISES * biped.reach.max_rise, _empty_points()
    footprints.lift[after], footprints.hold[after] = 0.0, hold
    level = is_level(biped, world, footprints, before, after)
    lift = clearance = biped.gait.clearance if level else max(biped.gait.clearance, ROUGH * biped.foot.length)
    samples = LEVEL_SAMPLES if level else SAMPLES
    highest = max(footprints.position[before, 2], footprints.position[after, 2]) + biped.reach.max_rise
    deep = 0.0 if level else max(_depth(biped, world, footprints, before), _depth(biped, world, footprints, after))
    run = foot.runs(footprints, before)
    for k in range(1, samples):
        lane = (k - 1) % WIDE
        if lane == 0:
            _lay_points(biped, footprints, before, after, k, samples, points)
        rise = swing.bump(k / samples)
        rim = RIM * rise if not level and 0 < swing.progress(k / samples, hold, run) < 1 else 0.0
        for n in range(0, 9, 3):
            ground = 0.0 if level else _below(world, points[n, lane], points[n + 1, lane], rim, highest)
            lack = ground + clearance * rise - points[n + 2, lane] - (1 - rise) * deep
            lift = max(lift, min(lack / rise, most))
    return lift
