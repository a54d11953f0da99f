"""Walking to places: everyone goes to its own, one after the other, around whatever stands in the way."""

from math import atan2, cos, hypot, sin

import numpy as np

from motion.characters.character import Character
from planner.modes.stops import Stops, check_stops, check_ways, empty_stops, is_last_stop, stop_of
from planner.planner import Situation, as_numbers
from planner.round.kernel import Compiled
from planner.round.round import Me, Round, Wish, biped_of
from planner.stepping.arriving import arrive, drawn, is_content, look_down, sees, walk_down, walk_on
from planner.stepping.beside import Place, middle_beside
from planner.stepping.field import fields_to, for_all
from planner.stepping.finding import surely
from planner.stepping.steering import Onward, free_way, lengthened, room_at
from worlds import queries
from worlds.arrays import STAIRS, WorldArrays
from worlds.compiled.jit import jit_borrowing
from worlds.errors import InputError
from worlds.limits import LONGEST, number
from worlds.world import World

ABEAM = 0.7
"""Whom others hinder has passed a stop on the way once the cosine between its direction and the leg to it is below this."""


@jit_borrowing
def is_there(round: Round, me: Me, reached: int, middle: Place) -> bool:
    """Whether the walker has come to the stop that it walks to after so many, or past it on its way."""
    plans, c = round.plans, me.c
    stop = stop_of(plans, c, reached)
    goal = plans.stops[c, stop, 0], plans.stops[c, stop, 1]
    if is_last_stop(plans, c, reached):
        return is_content(round, me, middle, goal)
    far = hypot(goal[0] - middle[0], goal[1] - middle[1])
    return far < plans.near[c] or _is_past(round, me, reached, middle, ABEAM if me.hindered > 0 else 0.0)


@jit_borrowing
def _is_past(round: Round, me: Me, reached: int, middle: Place, abeam: float) -> bool:
    """Whether the stop lies behind, or more to the side than `abeam` (a cosine), and the way to the next one is free.

    Whom others have pushed past a stop, or kept off it, does not make for it across their way: that would block a gap.
    """
    plans, c, (x, y) = round.plans, me.c, middle
    stop, from_x, from_y = stop_of(plans, c, reached), plans.start[c, 0], plans.start[c, 1]
    if reached > 0:
        before = stop_of(plans, c, reached - 1)
        from_x, from_y = plans.stops[c, before, 0], plans.stops[c, before, 1]
    stop_x, stop_y = plans.stops[c, stop, 0], plans.stops[c, stop, 1]
    leg_x, leg_y, to_x, to_y = stop_x - from_x, stop_y - from_y, stop_x - x, stop_y - y
    if to_x * leg_x + to_y * leg_y >= abeam * hypot(to_x, to_y) * hypot(leg_x, leg_y):
        return False
    then = stop_of(plans, c, reached + 1)
    dx, dy = plans.stops[c, then, 0] - x, plans.stops[c, then, 1] - y
    far, margin = hypot(dx, dy), room_at(biped_of(round, me), round.world, x, y)
    return free_way(biped_of(round, me), round.world, x, y, atan2(dy, dx), margin, far) >= far


@jit_borrowing
def _straight(round: Round, me: Me, middle: Place, stop: Place, draw: Place) -> Onward:
    """A step straight on to a stop, or beside that way toward those with whom one walks."""
    if draw[0] != 0 or draw[1] != 0:
        far = hypot(stop[0] - middle[0], stop[1] - middle[1])
        course = drawn(draw, atan2(stop[1] - middle[1], stop[0] - middle[0]))
        stop = (middle[0] + far * cos(course), middle[1] + far * sin(course))
    return walk_on(biped_of(round, me), round.world, middle, me.feet.newer.heading, stop, round.seed, (me.c, me.number))


@jit_borrowing
def _tread_by_tread(world: WorldArrays, middle: Place, on: Onward) -> Onward:
    """The step, which on straight stairs is no longer than a tread where it would take two (Fruin 1971: people take one)."""
    if world.terrain_kind != STAIRS:
        return on
    rise, run = world.terrain[1], world.terrain[2]
    here, there = queries.terrain_height(world, middle[0], middle[1]), queries.terrain_height(world, on.x, on.y)
    if abs(there - here) < 1.5 * rise:
        return on
    return lengthened(on, middle, min(run / max(hypot(on.x - middle[0], on.y - middle[1]), 1e-9), 1.0))


@jit_borrowing
def step_to_stop(round: Round, me: Me) -> Wish:
    """The next step to the stop that comes next; a stop that was come to counts as reached once a real step is planned."""
    biped, foot, plans = biped_of(round, me), me.feet.newer, round.plans
    middle, reached = middle_beside(biped, foot), plans.reached[me.c]
    round.intents.ahead[me.c, 0] = round.intents.ahead[me.c, 1] = 0.0
    if me.real and not is_last_stop(plans, me.c, reached) and is_there(round, me, reached, middle):
        reached += 1
        plans.reached[me.c] = reached
    there = is_there(round, me, reached, middle)
    if there and is_last_stop(plans, me.c, reached):
        return arrive(round, me, middle)
    at = stop_of(plans, me.c, reached + there)
    stop = (plans.stops[me.c, at, 0], plans.stops[me.c, at, 1])
    field, draw = plans.field[me.c, at], (plans.draw[me.c, 0], plans.draw[me.c, 1])
    if field >= 0 and not sees(round, me, middle, stop):
        way = look_down(biped, round.world, middle, plans.fields[field], plans.cell[0], stop)
        round.intents.ahead[me.c, 0], round.intents.ahead[me.c, 1] = way.ahead_x, way.ahead_y
        on = walk_down(round, me, middle, way.course, draw)
    else:
        on = _straight(round, me, middle, stop, draw)
    on = _tread_by_tread(round.world, middle, on)
    if plans.pace[me.c] < 1:
        on = lengthened(on, middle, plans.pace[me.c])
    return surely(round, me, (on.x, on.y), on.heading, on.course, True)


def _next_step(round: Round, me: Me) -> Wish:
    return step_to_stop(round, me)


_PLANNING = Compiled(_next_step, empty_stops(1, 1))


class WalkTo:
    """Characters that walk to places, and stay at the last or begin `again`.

    starts (C, 3): x, y, heading [m, rad]. stops (C, P, 2): P places of each [m]. near [m]: how close is close enough on the
    way; whoever was pushed past a place, with a free way to the next one, has reached it too. The last place is reached more
    closely, unless others stand on it. Ways lead around walls, water and trees.
    """

    name = "WalkTo"
    planning = _PLANNING

    def __init__(self, starts: object, stops: object, again: bool = False, near: float = 0.5) -> None:
        self.places, self.stops = as_numbers(starts, "starts"), as_numbers(stops, "stops")
        count, places = self.stops.shape[0], self.stops.shape[1] if self.stops.ndim == 3 else 0
        if not places or self.stops.shape[2] != 2 or self.places.shape != (count, 3):
            raise InputError(f"starts {self.places.shape}, stops {self.stops.shape}: (C, 3) and (C, P, 2), P > 0, are needed")
        self.near = number(near, "near", 0.0, LONGEST)
        if not isinstance(again, bool | np.bool_):
            raise InputError(f"again = {again!r}: true or false is needed")
        self.again = bool(again)

    def starts(self, world: World, characters: list[Character], seed: int) -> np.ndarray:
        """(C, 3) x, y, heading."""
        return self.places

    def prepare(self, situation: Situation) -> Stops:
        """Plans for all; a stop that was reached stays reached.

        Raises InputError for stops where nobody can be, NoWay for one to which no way leads.
        """
        if situation.before is None:
            check_stops(self.stops, situation.world)
        plans = empty_stops(len(situation.characters), 1)
        plans.again[:], plans.near[:] = self.again, self.near
        reached = plans.reached if situation.before is None else situation.before.reached
        everyone = for_all([one.biped for one in situation.characters])
        fields, cell, which = fields_to(situation.world, everyone, self.stops.reshape(-1, 2))
        plans = plans._replace(
            start=self.places[:, :2].copy(), stops=self.stops, reached=reached, fields=fields, cell=np.array([cell]),
            field=which.reshape(self.stops.shape[:2]),
        )  # fmt: skip
        check_ways(plans, situation)
        return plans

    def check_plans(self, plans: Stops, characters: int) -> None:
        """Whether plans from a file are of these stops. Raises ValueError."""
        same = np.array_equal(plans.stops, self.stops) and np.array_equal(plans.start, self.places[:, :2])
        rows = plans.field
        same &= rows.shape == self.stops.shape[:2] and -1 <= rows.min() <= rows.max() < len(plans.fields) and plans.cell[0] > 0
        same &= plans.fields.ndim == 3 and min(plans.fields.shape[1:]) > 0
        if not same or len(self.places) != characters or not 0 <= plans.reached.min() <= plans.reached.max() < 2**53:
            raise ValueError("plans: other stops than the planner's, or more reached than can be")

    def values(self) -> dict:
        """What it was made with."""
        return {"starts": self.places.tolist(), "stops": self.stops.tolist(), "again": self.again, "near": self.near}
