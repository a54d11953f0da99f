"""Where a foot goes that may not go where it was wished: to the nearest place that is fit for it, or away by chance."""

from math import cos, hypot, inf, sin

from motion.characters.dimensions import Dimensions
from motion.track.footprints import Foot, Step
from planner.round.round import Me, Round, Wish, biped_of, standing, stepping
from planner.stepping import random
from planner.stepping.beside import Place, apart_from, beside, keeps_apart, middle_beside, middle_of
from planner.stepping.footing import FINE, STALLED, is_rough, needs_care, why_not_step
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.compiled.jit import jit_borrowing

SHARES = (1.0, 0.85, 0.7, 0.55, 0.4, 0.25, 0.1, 0.0, -0.2, -0.4)
"""Lengths tried instead of the wished one, in shares of it."""
TURNS = (0.0, 0.2, -0.2, 0.45, -0.45, 0.7, -0.7, 1.0, -1.0)
"""Turns off the wished heading that are tried, in the largest."""
WIDTHS = (1.0, 1.4, 0.8, 1.9)
"""Distances beside the middle that are tried, in the usual one."""
WAIT = 0.3
"""Who finds no place for a foot looks again after this time [s]."""
UNTURNED = 0.1
"""A step that is STALLED gets nobody on that turns it to where it would by less [rad]."""
AWAY = 24
"""Places by chance that are looked at where no step gets on."""


@jit_borrowing
def surely(round: Round, me: Me, middle: Place, heading: float, course: float, goes: bool) -> Wish:
    """A step that brings the walker's middle there, or the nearest to it on which the foot may stand.

    Where the nearest does not get it on, it steps away by chance among rocks and slopes: it would tread on the spot for good.
    Beside a wall alone it waits for others there, or turns.
    """
    biped, foot, side = biped_of(round, me), me.feet.newer, 1 - me.feet.newer.side
    x, y = beside(biped, side, middle, heading)
    if not needs_care(biped, round.world, foot.x, foot.y):
        return stepping(side, (x, y), heading, course, goes)
    strays, on = is_rough(biped, round.world, foot.x, foot.y), _gets_on(biped, foot, middle, heading, heading)
    if (on or not (strays and goes)) and why_not_step(biped, round.world, foot, x, y, heading) == FINE:
        return stepping(side, (x, y), heading, course, goes)
    found, turned = nearest_footing(biped, round.world, foot, middle, heading)
    there = middle_of(biped, side, found, turned)
    if strays and (turned == inf or (on or goes) and not _gets_on(biped, foot, there, turned, heading)):
        found, turned = _away(round, me)
    if turned == inf:
        return standing(me, WAIT)
    return stepping(side, found, turned, course, goes)


@jit_borrowing
def heels_apart(round: Round, me: Me, wish: Wish) -> Wish:
    """The wish of one who is alone, with its foot so much further outward that ankles keep apart, if it may stand there."""
    step, foot = wish.step, me.feet.newer
    if step.stands > 0 or step.side == foot.side:
        return wish
    biped = biped_of(round, me)
    x, y = apart_from(biped, foot, (step.x, step.y), step.heading)
    if (x == step.x and y == step.y) or why_not_step(biped, round.world, foot, x, y, step.heading) != FINE:
        return wish
    apart = Step(step.side, x, y, step.heading, step.time, step.stance_time, step.stands, step.crouch, step.facing)
    return Wish(apart, wish.course, wish.longest, wish.avoids, wish.goes)


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
                aside = (at[0] + width * (fx - at[0]), at[1] + width * (fy - at[1]))
                px, py = apart_from(biped, foot, aside, yaw)
                cost = hypot(px - wx, py - wy) + 0.3 * biped.gait.preferred_step * abs(yaw - heading)
                if cost < least and why_not_step(biped, world, foot, px, py, yaw) == FINE:
                    least, best, turned = cost, (px, py), yaw
    return best, turned


@jit_borrowing
def _gets_on(biped: Dimensions, foot: Foot, middle: Place, turned: float, wished: float) -> bool:
    """Whether a step to there moves the walker who stands on a foot, or turns it to the wished heading."""
    x, y = middle_beside(biped, foot)
    if hypot(middle[0] - x, middle[1] - y) > STALLED * biped.gait.preferred_step:
        return True
    return abs(turned - wished) + UNTURNED < abs(foot.heading - wished)


@jit_borrowing
def _away(round: Round, me: Me) -> tuple[Place, float]:
    """The farthest of places by chance on which the foot may stand, with room for the body: (place, heading); inf: none."""
    biped, world, foot, side = biped_of(round, me), round.world, me.feet.newer, 1 - me.feet.newer.side
    (mx, my), farthest, best, turned = middle_beside(biped, foot), -1.0, (foot.x, foot.y), inf
    margin = min(biped.body.radius, queries.clearance(world, mx, my) - 0.01)
    for k in range(AWAY):
        draw = 3 * (AWAY * me.number + k)
        way = queries.TAU * random.uniform(round.seed, me.c, draw, random.AWAY)
        length = biped.gait.preferred_step * random.uniform(round.seed, me.c, draw + 1, random.AWAY)
        yaw = foot.heading + biped.reach.max_turn * (2 * random.uniform(round.seed, me.c, draw + 2, random.AWAY) - 1)
        at = (mx + length * cos(way), my + length * sin(way))
        x, y = apart_from(biped, foot, beside(biped, side, at, yaw), yaw)
        if length > farthest and keeps_apart(biped, foot, x, y, yaw) and queries.clearance(world, at[0], at[1]) >= margin:
            if why_not_step(biped, world, foot, x, y, yaw) == FINE:
                farthest, best, turned = length, (x, y), yaw
    return best, turned
