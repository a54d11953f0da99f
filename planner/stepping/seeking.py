"""The place for a foot that is nearest to where it was wanted, over whatever ground: banks and rocks are snapped to.

Candidates are the wanted step shorter, longer and turned, with the foot nearer to the body or farther out, and the nearest
point of every rock in reach. One costs its distance from the wanted place, and more for another heading; the
cheapest is taken on which a sole stands (planner.stepping.footing), with no tree, border or wall in the body's way. Water may
be stepped and leapt over, never into.
"""

from math import ceil, cos, hypot, inf, sin
from typing import NamedTuple

from motion.arithmetic.smooth import mix
from motion.characters.dimensions import Dimensions
from motion.pose import swing
from motion.track.footprints import Feet, Foot
from planner.stepping.beside import Place, apart_from, beside, keeps_apart, middle_beside, middle_of
from planner.stepping.footing import FINE, UNDER, WATER, is_bare, under_sole, why_not_step
from planner.stepping.placing import EDGE
from worlds import queries
from worlds.arrays import FLAT, REACH, WorldArrays
from worlds.compiled.jit import jit_borrowing

SHARES = (1.0, 0.85, 1.15, 0.7, 0.55, 1.3, 0.4, 0.25)
"""Lengths tried, in shares of the wanted one."""
TURNS = (0.0, 0.2, -0.2, 0.45, -0.45, 0.8, -0.8)
"""Turns off the wanted way that are tried, in the largest."""
WIDTHS = (1.0, 1.4, 0.8)
"""Distances beside the middle that are tried, in the usual one."""
ASKEW = 0.3
"""What a radian off the wanted heading costs, in preferred steps."""
WELL_ON = 0.5
"""A foot that snaps to a rock is set down so much of its sole, or of the rock, inside the rock's edge."""
LONG, LONG_LIFT, LIFT = 1.6, 0.2, 0.35
"""A swing over more than so many longest steps is lifted no higher than this share of the leg, any other than the next."""
CLIMBS = 1.5
"""How many metres ahead a metre up or down counts for, of the farthest that the feet may get apart."""
SAMPLES = 20
"""Shares of a swing at which the ground below it is asked for."""
GRAIN = 0.08
"""Distance [m] between the places on a way that are looked at."""


class Wanted(NamedTuple):
    """Where a step is to bring the walker's middle, from where it is."""

    dx: float  # [m]
    dy: float
    heading: float  # [rad]
    follows: bool  # whether the heading turns with the way, where that has to
    farthest: float  # the feet get no farther apart [m]
    tolerance: float  # what a place may cost [m]: beyond that none is taken


class Found(NamedTuple):
    """Where the foot may be set down."""

    x: float  # middle of the sole [m]
    y: float
    heading: float  # [rad]
    cost: float  # inf: nowhere


@jit_borrowing
def may_stand(biped: Dimensions, world: WorldArrays, foot: Foot, x: float, y: float, heading: float) -> bool:
    """Whether the other foot may be set down there: on a rock in water, the sole's middle must lie on the rock."""
    why = why_not_step(biped, world, foot, x, y, heading)
    if why != WATER:
        return why == FINE
    return queries.rock_under(world, x, y, EDGE) >= 0 and _room(world, x, y) > 0.5 * biped.foot.length


@jit_borrowing
def body_passes(biped: Dimensions, world: WorldArrays, begin: Place, end: Place) -> bool:
    """Whether a body gets from one middle to another: past trees and border, over nothing too high; water is none."""
    dx, dy = end[0] - begin[0], end[1] - begin[1]
    margin = min(biped.body.radius, _room(world, begin[0], begin[1])) - 0.01
    low = queries.ground_height(world, begin[0], begin[1])
    top = max(low, queries.ground_height(world, end[0], end[1])) + biped.reach.max_rise
    count = max(int(ceil(hypot(dx, dy) / GRAIN)), 1)
    for k in range(1, count + 1):
        x, y = begin[0] + dx * k / count, begin[1] + dy * k / count
        if _room(world, x, y) < margin or queries.ground_height(world, x, y) > top:
            return False
    return True


@jit_borrowing
def _room(world: WorldArrays, x: float, y: float) -> float:
    """Distance to the nearest tree or wall or to the border [m]."""
    solid = min(queries.tree_clearance(world, x, y), queries.wall_clearance(world, x, y))
    return min(solid, queries.border_clearance(world, x, y))


@jit_borrowing
def _is_good(biped: Dimensions, world: WorldArrays, feet: Feet, wanted: Wanted, x: float, y: float, yaw: float) -> bool:
    """Whether the foot may be set down there in this step."""
    foot = feet.newer
    if hypot(x - foot.x, y - foot.y) > wanted.farthest or not keeps_apart(biped, foot, x, y, yaw):
        return False
    if not may_stand(biped, world, foot, x, y, yaw) or _reckoned(biped, world, foot, x, y, yaw) > wanted.farthest:
        return False
    if not body_passes(biped, world, middle_beside(biped, foot), middle_of(biped, 1 - foot.side, (x, y), yaw)):
        return False
    return world.terrain_kind == FLAT and is_bare(world, foot.x, foot.y, REACH) or _swings(biped, world, feet, x, y, yaw)


@jit_borrowing
def _reckoned(biped: Dimensions, world: WorldArrays, foot: Foot, x: float, y: float, yaw: float) -> float:
    """How long a step counts [m] that goes up or down, too: nobody runs three treads at a time. Slopes do not count."""
    z, nx, ny, nz = under_sole(biped, world, x, y, yaw)
    dx, dy, dz = x - foot.x, y - foot.y, z - under_sole(biped, world, foot.x, foot.y, foot.heading)[0]
    return hypot(dx, dy) + CLIMBS * abs(dx * nx + dy * ny + dz * nz)


@jit_borrowing
def _swings(biped: Dimensions, world: WorldArrays, feet: Feet, x: float, y: float, heading: float) -> bool:
    """Whether a foot comes there without being lifted high, which needs time: much in the way of a long swing is too much."""
    foot, other, length = feet.older, feet.newer, biped.foot.length
    begin, bnx, bny, bnz = under_sole(biped, world, foot.x, foot.y, foot.heading)
    end, enx, eny, enz = under_sole(biped, world, x, y, heading)
    most = (LONG_LIFT if hypot(x - foot.x, y - foot.y) > LONG * biped.reach.max_step else LIFT) * biped.leg.nominal_length
    yaw, side, where = 0.5 * (foot.heading + heading), 1 - other.side, (other.x, other.y)
    start, goal = (foot.x, foot.y, begin), (x, y, end)
    bx, by = swing.bow(biped, start, goal, where, yaw, side, swing.EDGE_HOLD, 0.0)
    for k in range(1, SAMPLES):
        s = k / SAMPLES
        gone, rise = swing.progress(s, swing.EDGE_HOLD), swing.bump(s)
        px, py, z = (
            mix(foot.x, x, gone) + rise * bx,
            mix(foot.y, y, gone) + rise * by,
            mix(begin, end, gone) + most * rise + UNDER,
        )
        now = mix(foot.heading, heading, gone)
        for ahead in (-0.5 * length, 0.0, 0.5 * length):
            for aside in (-0.5 * biped.foot.width, 0.5 * biped.foot.width):
                qx, qy = ahead * cos(now) - aside * sin(now), ahead * sin(now) + aside * cos(now)
                tilt = -mix((bnx * qx + bny * qy) / bnz, (enx * qx + eny * qy) / enz, gone)
                if queries.ground_height(world, px + qx, py + qy) > z + tilt:
                    return False
    return True


@jit_borrowing
def seek(biped: Dimensions, world: WorldArrays, feet: Feet, wanted: Wanted) -> Found:
    """Where the foot that does not stand may go, nearest to where it is wanted."""
    foot, most = feet.newer, biped.reach.max_turn
    (mx, my), side = middle_beside(biped, foot), 1 - foot.side
    askew = ASKEW * biped.gait.preferred_step
    there = beside(biped, side, (mx + wanted.dx, my + wanted.dy), wanted.heading)
    wx, wy = apart_from(biped, foot, there, wanted.heading)
    best = Found(wx, wy, wanted.heading, inf)
    least = wanted.tolerance
    for turn in TURNS:
        c, s = cos(turn * most), sin(turn * most)
        yaw = wanted.heading + (turn * most if wanted.follows else 0.0)
        yaw = min(max(yaw, foot.heading - most), foot.heading + most)
        for share in SHARES:
            at = (mx + share * (c * wanted.dx - s * wanted.dy), my + share * (s * wanted.dx + c * wanted.dy))
            fx, fy = beside(biped, side, at, yaw)
            for width in WIDTHS:
                px, py = apart_from(biped, foot, (mix(at[0], fx, width), mix(at[1], fy, width)), yaw)
                cost = hypot(px - wx, py - wy) + askew * abs(yaw - wanted.heading)
                if cost < least and _is_good(biped, world, feet, wanted, px, py, yaw):
                    best, least = Found(px, py, yaw, cost), cost
    return _on_rocks(biped, world, feet, wanted, best, (wx, wy, least))


@jit_borrowing
def _on_rocks(
    biped: Dimensions, world: WorldArrays, feet: Feet, wanted: Wanted, best: Found, place: tuple[float, float, float]
) -> Found:
    """The best so far, or the nearest point of a rock; place: where the foot is wanted, and what it may cost."""
    wx, wy, least = place
    cell = queries.cell_of(world, feet.newer.x, feet.newer.y)
    for k in range(world.rock_start[cell], world.rock_start[cell + 1]):
        rock = world.rocks[world.rock_index[k]]
        dx, dy, inset = wx - rock[0], wy - rock[1], max(min(0.5 * biped.foot.length, WELL_ON * rock[2]), EDGE)
        share = min(max(rock[2] - inset, 0.0) / max(hypot(dx, dy), 1e-9), 1.0)
        px, py = rock[0] + share * dx, rock[1] + share * dy
        cost = hypot(px - wx, py - wy)
        if cost < least and _is_good(biped, world, feet, wanted, px, py, wanted.heading):
            best, least = Found(px, py, wanted.heading, cost), cost
    return best
