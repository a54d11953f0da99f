"""Where a sole may stand, and how it may come there: the one question of planners, starts, goals, scenes and edits.

A sole stands where all of it is dry and inside the world, no tree, wall or ground reaches up into it, and a preferred step up
the slope rises by no more than the highest step. It comes there from another foot within the reach of a step: not farther than
a leap, no higher than max_rise, no deeper than max_drop, over nothing that is higher than both by more than max_rise.
"""

from math import cos, hypot, inf, pi, sin

from motion.characters.dimensions import Dimensions
from motion.track.footprints import Foot
from planner.stepping.beside import beside, middle_beside, sole_heading
from planner.stepping.placing import EDGE, Ground, lay_sole
from worlds import queries
from worlds.arrays import FLAT, HILLS, SPIRAL_STAIRS, STAIRS, WorldArrays
from worlds.compiled.jit import jit_borrowing

UNDER = 0.02
"""Ground may reach so far into a sole [m]: what a shoe, or a lens, does not show."""
TOE_ROOM, HEEL_ROOM, HIGH_SIDE = 0.05, 0.02, 0.04
"""Room that is left before a sole and behind it [m], where ground rises by more than this [m]."""
HILLSIDE = 2.12
"""The steepest slope of hills, in amplitudes per wavelength over a turn (worlds.queries.terrain_height)."""
STALLED = 0.15
"""Who gets on by less than this share of its preferred step does not get on."""
FINE, TREE, WATER, BORDER, ROCK, STEEP, HIGH, DEEP, FAR, WALL = range(10)
"""Why not."""
WORDS = ("", "is in a tree", "is in water", "is outside the world", "is inside a rock or a riser", "lies on too steep a slope",
         "is too high", "is too deep", "is too far", "is in a wall")  # fmt: skip
"""In words, by their numbers."""


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
    """Whether the toe, which straightens and goes ahead when it lifts, strikes a rock's side or a riser, or the heel that
    comes down behind."""
    z, nx, ny, nz = under_sole(biped, world, x, y, heading)
    c, s, half = cos(heading), sin(heading), 0.5 * biped.foot.length
    for ahead in (half + TOE_ROOM, -half - HEEL_ROOM):
        for j in range(-1, 2):
            aside = 0.5 * j * biped.foot.width
            dx, dy = ahead * c - aside * s, ahead * s + aside * c
            if queries.ground_height(world, x + dx, y + dy) > z - (nx * dx + ny * dy) / nz + HIGH_SIDE:
                return True
    return False


@jit_borrowing
def beside_rocks(biped: Dimensions, world: WorldArrays, x: float, y: float, far: float) -> float:
    """Distance to the nearest rock that rises from the bare ground there by more than the highest step [m], negative on one,
    at most `far`."""
    low, high = queries.cell_of(world, x - far, y - far), queries.cell_of(world, x + far, y + far)
    columns, nearest = world.columns, far
    top = queries.terrain_height(world, x, y) + biped.reach.max_rise
    for row in range(low // columns, high // columns + 1):
        begin, end = row * columns + low % columns, row * columns + high % columns
        for k in range(world.rock_start[begin], world.rock_start[end + 1]):
            rock = world.rocks[world.rock_index[k]]
            if rock[3] > top:
                nearest = min(nearest, hypot(x - rock[0], y - rock[1]) - rock[2])
    return nearest


@jit_borrowing
def is_footing(biped: Dimensions, world: WorldArrays, x: float, y: float) -> bool:
    """Whether a sole may stand there with one heading or another, where a rock makes that doubtful."""
    if queries.rock_under(world, x, y, 0.0) < 0:
        return True
    fine = 0
    for k in range(4):
        fine += why_not_stand(biped, world, x, y, 0.25 * pi * k) == FINE
    return fine > 0


@jit_borrowing
def level_way(biped: Dimensions, world: WorldArrays, x: float, y: float, course: float, far: float) -> float:
    """Distance [m] that one can go straight on without a wall or a slope that is too high or too deep, at most `far`.

    Rocks beside the way are too high for the feet, which go half a step's width to either side of it.
    """
    if is_gentle(biped, world) and is_bare(world, x, y, far):
        return far
    c, s, grain, done = cos(course), sin(course), 0.3 * biped.gait.preferred_step, 0.0
    height, aside = queries.ground_height(world, x, y), 0.5 * (biped.gait.step_width + biped.foot.width)
    while done < far:
        done += grain
        px, py = x + done * c, y + done * s
        ground = queries.ground_height(world, px, py)
        left, right = _rock_top(world, px - aside * s, py + aside * c), _rock_top(world, px + aside * s, py - aside * c)
        highest = max(ground, left, right)
        if highest - height > biped.reach.max_rise or height - ground > biped.reach.max_drop:
            return max(done - 2 * grain, 0.0)
        if is_steep(biped, world, px, py):
            return max(done - 2 * grain, 0.0)
        height = ground
    return far


@jit_borrowing
def _rock_top(world: WorldArrays, x: float, y: float) -> float:
    """Height of a rock's top there [m]; -inf where none is."""
    rock = queries.rock_under(world, x, y, 0.0)
    return world.rocks[rock, 3] if rock >= 0 else -inf


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
    return is_rough(biped, world, x, y)


@jit_borrowing
def is_rough(biped: Dimensions, world: WorldArrays, x: float, y: float) -> bool:
    """Whether rocks or slopes lie within a step."""
    return not (is_gentle(biped, world) and is_bare(world, x, y, biped.reach.max_step + biped.foot.length))
