"""Where a sole may stand, and how it may come there: the one question of planners, starts, goals, scenes and edits.

A sole stands where all of it is dry and inside the world, no tree, wall or ground reaches up into it, and a preferred step up
the slope rises by no more than the highest step. It comes there from another foot within the reach of a step: not farther than
a leap, no higher than max_rise, no deeper than max_drop, over nothing that is higher than both by more than max_rise.
"""

from math import cos, hypot, inf, sin

from motion.characters.dimensions import Dimensions
from motion.track.footprints import Foot
from planner.round.round import Me, Round, Wish, biped_of, standing, stepping
from planner.stepping.beside import Place, beside, middle_beside, sole_heading
from planner.stepping.placing import EDGE, Ground, lay_sole
from worlds import queries
from worlds.arrays import FLAT, HILLS, SPIRAL_STAIRS, STAIRS, WorldArrays
from worlds.compiled.jit import jit_borrowing

UNDER = 0.02
"""Ground may reach so far into a sole [m]: what a shoe, or a lens, does not show."""
TOE_ROOM, HIGH_SIDE = 0.05, 0.04
"""Room that is left before a sole [m], where ground rises by more than this [m]."""
HILLSIDE = 2.12
"""The steepest slope of hills, in amplitudes per wavelength over a turn (worlds.queries.terrain_height)."""
FINE, TREE, WATER, BORDER, ROCK, STEEP, HIGH, DEEP, FAR, WALL = range(10)
"""Why not."""
WORDS = ("", "is in a tree", "is in water", "is outside the world", "is inside a rock or a riser", "lies on too steep a slope",
         "is too high", "is too deep", "is too far", "is in a wall")  # fmt: skip
"""In words, by their numbers."""
SHARES = (1.0, 0.85, 0.7, 0.55, 0.4, 0.25, 0.1, 0.0, -0.2, -0.4)
"""Lengths tried instead of the wished one, in shares of it."""
TURNS = (0.0, 0.2, -0.2, 0.45, -0.45, 0.7, -0.7, 1.0, -1.0)
"""Turns off the wished heading that are tried, in the largest."""
WIDTHS = (1.0, 1.4, 0.8, 1.9)
"""Distances beside the middle that are tried, in the usual one."""
WAIT = 0.3
"""Who finds no place for a foot looks again after this time [s]."""


@jit_borrowing
def steepest(biped: Dimensions) -> float:
    """The steepest slope that it stands and walks on."""
    return biped.reach.max_rise / biped.gait.preferred_step


@jit_borrowing
def is_gentle(biped: Dimensions, world: WorldArrays) -> bool:
    """Whether no bare ground of the world is too steep, so that nobody needs to look."""
    if world.terrain_kind == HILLS:
        return HILLSIDE * world.terrain[0] * queries.TAU / world.terrain[1] <= steepest(biped)
    return world.terrain_kind == FLAT


@jit_borrowing
def is_bare(world: WorldArrays, x: float, y: float, reach: float) -> bool:
    """Whether no cell of the grid within `reach` [m] lists a rock."""
    if len(world.rocks) == 0:
        return True
    low, high = queries.cell_of(world, x - reach, y - reach), queries.cell_of(world, x + reach, y + reach)
    columns = world.columns
    for row in range(low // columns, high // columns + 1):
        if world.rock_start[row * columns + low % columns] != world.rock_start[row * columns + high % columns + 1]:
            return False
    return True


@jit_borrowing
def _why_not_there(world: WorldArrays, x: float, y: float, sole: float) -> int:
    """What keeps a point of a sole, which is at that height there, from being there."""
    if queries.border_clearance(world, x, y) < 0:
        return BORDER
    if queries.tree_clearance(world, x, y) < 0:
        return TREE
    if queries.wall_clearance(world, x, y) < 0:
        return WALL
    if queries.in_water(world, x, y):
        return WATER
    return ROCK if queries.ground_height(world, x, y) > sole + UNDER else FINE


@jit_borrowing
def under_sole(biped: Dimensions, world: WorldArrays, x: float, y: float, heading: float) -> Ground:
    """The ground on which a sole would lie there."""
    return lay_sole(biped, world, x, y, heading, queries.rock_under(world, x, y, EDGE))


@jit_borrowing
def why_not_stand(biped: Dimensions, world: WorldArrays, x: float, y: float, heading: float) -> int:
    """What keeps a sole from standing there, FINE for nothing."""
    z, nx, ny, nz = under_sole(biped, world, x, y, heading)
    if nx * nx + ny * ny > (steepest(biped) * nz) ** 2:
        return STEEP
    c, s = cos(heading), sin(heading)
    for i in range(-2, 3):
        for j in range(-1, 2):
            ahead, aside = 0.25 * i * biped.foot.length, 0.5 * j * biped.foot.width
            dx, dy = ahead * c - aside * s, ahead * s + aside * c
            why = _why_not_there(world, x + dx, y + dy, z - (nx * dx + ny * dy) / nz)
            if why != FINE:
                return why
    return FINE


@jit_borrowing
def why_not_step(biped: Dimensions, world: WorldArrays, foot: Foot, x: float, y: float, heading: float) -> int:
    """What keeps a foot from being set down there, coming from where the other one stands; FINE for nothing.

    heading: the walker's [rad]; its toes point outward of it.
    """
    if hypot(x - foot.x, y - foot.y) > biped.reach.max_leap:
        return FAR
    sole = sole_heading(biped, 1 - foot.side, heading)
    rise = under_sole(biped, world, x, y, sole)[0] - under_sole(biped, world, foot.x, foot.y, foot.heading)[0]
    if rise > biped.reach.max_rise:
        return HIGH
    if rise < -biped.reach.max_drop:
        return DEEP
    why = ROCK if _strikes(biped, world, x, y, sole) else why_not_stand(biped, world, x, y, sole)
    return HIGH if why == FINE and not _can_be_lifted_over(biped, world, foot, x, y) else why


@jit_borrowing
def _can_be_lifted_over(biped: Dimensions, world: WorldArrays, other: Foot, x: float, y: float) -> bool:
    """Whether nothing between, from beside the other foot on, is higher than both by more than the highest step."""
    begin = beside(biped, 1 - other.side, middle_beside(biped, other), other.heading)
    dx, dy = x - begin[0], y - begin[1]
    far = hypot(dx, dy)
    if is_bare(world, x, y, far) and is_gentle(biped, world):
        return True
    count, wide = int(far / (0.5 * biped.foot.length)) + 1, 0.5 * biped.foot.width / max(far, 1e-9)
    most = biped.reach.max_rise + max(queries.ground_height(world, x, y), queries.ground_height(world, other.x, other.y))
    for k in range(1, count):
        for side in (-wide, wide):
            px, py = begin[0] + k / count * dx - side * dy, begin[1] + k / count * dy + side * dx
            if queries.ground_height(world, px, py) > most:
                return False
    return True


@jit_borrowing
def _strikes(biped: Dimensions, world: WorldArrays, x: float, y: float, heading: float) -> bool:
    """Whether the toe, which straightens and goes ahead when it lifts, strikes a rock's side or a riser."""
    z, nx, ny, nz = under_sole(biped, world, x, y, heading)
    c, s, ahead = cos(heading), sin(heading), 0.5 * biped.foot.length + TOE_ROOM
    for j in range(-1, 2):
        aside = 0.5 * j * biped.foot.width
        dx, dy = ahead * c - aside * s, ahead * s + aside * c
        if queries.ground_height(world, x + dx, y + dy) > z - (nx * dx + ny * dy) / nz + HIGH_SIDE:
            return True
    return False


@jit_borrowing
def level_way(biped: Dimensions, world: WorldArrays, x: float, y: float, course: float, far: float) -> float:
    """Distance [m] that one can go straight on without a wall or a slope that is too high or too deep, at most `far`."""
    if is_gentle(biped, world) and is_bare(world, x, y, far):
        return far
    c, s, grain, done = cos(course), sin(course), 0.3 * biped.gait.preferred_step, 0.0
    height = queries.ground_height(world, x, y)
    while done < far:
        done += grain
        px, py = x + done * c, y + done * s
        ground = queries.ground_height(world, px, py)
        if ground - height > biped.reach.max_rise or height - ground > biped.reach.max_drop:
            return max(done - 2 * grain, 0.0)
        if is_steep(biped, world, px, py):
            return max(done - 2 * grain, 0.0)
        height = ground
    return far


@jit_borrowing
def is_steep(biped: Dimensions, world: WorldArrays, x: float, y: float) -> bool:
    """Whether the bare ground, treads apart, is too steep there."""
    if is_gentle(biped, world) or world.terrain_kind == STAIRS or world.terrain_kind == SPIRAL_STAIRS:
        return False
    return _slope(world, x, y, 0.15 * biped.gait.preferred_step) > steepest(biped)


@jit_borrowing
def _slope(world: WorldArrays, x: float, y: float, around: float) -> float:
    """How steep the bare ground is."""
    dx = queries.terrain_height(world, x + around, y) - queries.terrain_height(world, x - around, y)
    dy = queries.terrain_height(world, x, y + around) - queries.terrain_height(world, x, y - around)
    return hypot(dx, dy) / (2 * around)


@jit_borrowing
def needs_care(biped: Dimensions, world: WorldArrays, x: float, y: float) -> bool:
    """Whether steps from there need to be looked at: elsewhere who keeps off trees, water and the border stands well."""
    if queries.clearance(world, x, y) < biped.body.radius:  # something was put there, or one was set down there
        return True
    return not (is_gentle(biped, world) and is_bare(world, x, y, biped.reach.max_step + biped.foot.length))


@jit_borrowing
def surely(round: Round, me: Me, middle: Place, heading: float, course: float, goes: bool) -> Wish:
    """A step that brings the walker's middle there, or the nearest to it on which the foot may stand; else standing."""
    biped, foot, side = biped_of(round, me), me.feet.newer, 1 - me.feet.newer.side
    x, y = beside(biped, side, middle, heading)
    if not needs_care(biped, round.world, foot.x, foot.y):
        return stepping(side, (x, y), heading, course, goes)
    if why_not_step(biped, round.world, foot, x, y, heading) == FINE:
        return stepping(side, (x, y), heading, course, goes)
    found, turned = nearest_footing(biped, round.world, foot, middle, heading)
    if turned == inf:
        return standing(me, WAIT)
    return stepping(side, found, turned, course, goes)


@jit_borrowing
def nearest_footing(biped: Dimensions, world: WorldArrays, foot: Foot, middle: Place, heading: float) -> tuple[Place, float]:
    """Where the other foot may stand instead, nearest to beside a middle: (place, heading); heading inf: nowhere."""
    (mx, my), side = middle_beside(biped, foot), 1 - foot.side
    wx, wy = beside(biped, side, middle, heading)
    length, least, best, turned = hypot(middle[0] - mx, middle[1] - my), inf, (wx, wy), inf
    length, most = max(length, 0.4 * biped.gait.preferred_step), biped.reach.max_turn
    for turn in TURNS:
        yaw = min(max(heading + turn * most, foot.heading - most), foot.heading + most)
        for share in SHARES:
            at = (mx + share * length * cos(yaw), my + share * length * sin(yaw))
            fx, fy = beside(biped, side, at, yaw)
            for width in WIDTHS:
                px, py = at[0] + width * (fx - at[0]), at[1] + width * (fy - at[1])
                cost = hypot(px - wx, py - wy) + 0.3 * biped.gait.preferred_step * abs(yaw - heading)
                if cost < least and why_not_step(biped, world, foot, px, py, yaw) == FINE:
                    least, best, turned = cost, (px, py), yaw
    return best, turned
