"""Stops: where walkers go, one place after the other, and whether ways lead there."""

from typing import NamedTuple

import numpy as np

from planner.planner import NoWay, Situation
from planner.stepping.field import BARS, ways_from
from worlds import queries
from worlds.compiled.jit import jit_borrowing
from worlds.errors import InputError
from worlds.world import World


class Stops(NamedTuple):
    """Where C walkers go, and how far they have come."""

    start: np.ndarray  # (C, 2) where each set out [m]
    stops: np.ndarray  # (C, P, 2) places to walk to, one after the other [m]
    again: np.ndarray  # (C,) bool: from the last stop on to the first
    near: np.ndarray  # (C,) a stop on the way is reached within this distance [m]
    reached: np.ndarray  # (C,) how many stops each has reached
    fields: np.ndarray  # (G, rows, columns) ways to goals, float32 (planner.stepping.field)
    cell: np.ndarray  # (1,) edge of their cells [m]
    field: np.ndarray  # (C, P) which of them leads to a stop; -1: the way is straight
    pace: np.ndarray  # (C,) share of its own step that each takes, at most 1
    draw: np.ndarray  # (C, 2) added to the unit vector of its course: toward those with whom it walks

    @staticmethod
    def shared() -> tuple[str, ...]:
        """Columns of all characters together."""
        return "fields", "cell"

    @staticmethod
    def endless() -> tuple[str, ...]:
        """Columns that may hold inf: no way leads from there."""
        return ("fields",)


@jit_borrowing
def stop_of(plans: Stops, c: int, reached: int) -> int:
    """Which stop character c walks to after it has reached so many."""
    stops = plans.stops.shape[1]
    return reached % stops if plans.again[c] else min(reached, stops - 1)


@jit_borrowing
def is_last_stop(plans: Stops, c: int, reached: int) -> bool:
    """Whether the stop that character c walks to is its last."""
    return not plans.again[c] and reached >= plans.stops.shape[1] - 1


def empty_stops(characters: int, stops: int) -> Stops:
    """So many stops of so many characters, all at 0, 0, with no fields."""
    c = characters
    whole, none = np.zeros(c, np.int64), np.full((c, stops), -1, np.int64)
    fields = np.zeros((0, 1, 1), np.float32)
    return Stops(
        np.zeros((c, 2)), np.zeros((c, stops, 2)), np.zeros(c, np.bool_), np.zeros(c), whole, fields, np.ones(1), none,
        np.ones(c), np.zeros((c, 2)),
    )  # fmt: skip


def check_stops(stops: np.ndarray, world: World) -> None:
    """Raises InputError for a stop outside, in a tree, in a wall or in water."""
    for c, p in np.ndindex(stops.shape[:2]):
        x, y = stops[c, p].tolist()
        why = ""
        if queries.border_clearance(world.arrays, x, y) < 0:
            why = f"is outside the world; 0..{world.size[0]:g} by 0..{world.size[1]:g} is allowed"
        elif queries.tree_clearance(world.arrays, x, y) < 0:
            why = "is in a tree"
        elif queries.wall_clearance(world.arrays, x, y) < 0:
            why = "is in a wall"
        elif queries.in_water(world.arrays, x, y):
            why = "is in water"
        if why:
            raise InputError(f"stops.{c}.{p} at ({x:g}, {y:g}): {why}")


def check_ways(plans: Stops, situation: Situation) -> None:
    """Raises NoWay where none leads from where somebody is to its next stop, or on from there; only where ways have fields."""
    stops, rows = plans.stops.shape[1], np.arange(len(plans.stops))
    places = situation.feet.position[:, :, :2].mean(axis=1)
    for p in range(stops + 1):
        to = np.where(plans.again, (plans.reached + p) % stops, np.minimum(plans.reached + p, stops - 1))
        field = plans.field[rows, to]
        known = np.flatnonzero(field >= 0)
        ways = ways_from(plans.fields, plans.cell[0], field[known], places[known]) if len(known) else np.zeros(0)
        for c in known[np.isinf(ways)].tolist():
            (x, y), (u, v), name = places[c].tolist(), plans.stops[c, to[c]].tolist(), situation.characters[c].name
            raise NoWay(
                f"stops.{c}.{to[c]} at ({u:g}, {v:g}): no way for the {name} leads there from ({x:.2f}, {y:.2f}): {BARS}"
            )
        places = plans.stops[rows, to]
