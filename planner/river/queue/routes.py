"""The routes of crossers: what each goes along, how far it is, and whom it goes behind."""

from math import hypot
from typing import Any, NamedTuple

import numpy as np

from motion.characters.character import Character
from motion.characters.dimensions import Dimensions
from motion.track.footprints import STEP, Step
from worlds import queries
from worlds.arrays import WorldArrays
from worlds.world import World

STRADDLES = 0.9
"""Feet no farther apart than this, in nominal legs, can be waited on."""


class Routes(NamedTuple):
    """The routes of C characters, R footprints at most."""

    at: np.ndarray  # (C,) the footprint of the route that was taken last
    waits: np.ndarray  # (C,) bool: others hold what comes next
    length: np.ndarray  # (C,) footprints, with the two that it began on
    steps: Any  # (C, R) records of STEP
    stops: np.ndarray  # (C, R) bool: one can wait on this footprint and the one before
    ashore: np.ndarray  # (C,) from which footprint on all lie on land
    turn: np.ndarray  # (C,) who has a lesser one goes first
    walks: np.ndarray  # (C,) bool: ashore, among others: around them, and the route only tells the way
    ends: np.ndarray  # (C, 2) where each is to come to rest [m]
    goal: np.ndarray  # (C, 2) the world's goal when that was decided [m]
    parked: np.ndarray  # (C,) bool: it makes room, and crosses later (planner.river.queue.parking)
    aside: np.ndarray  # (C, 2) where it goes to make room [m]
    idle: np.ndarray  # (C,) for so many looks nobody has gone on


def empty_routes(characters: int, steps: int) -> Routes:
    """Routes of no step."""
    c = characters
    return Routes(
        at=np.ones(c, np.int64),
        waits=np.zeros(c, np.bool_),
        length=np.full(c, 2),
        steps=np.zeros((c, max(steps, 2)), STEP),
        stops=np.ones((c, max(steps, 2)), np.bool_),
        ashore=np.ones(c, np.int64),
        turn=np.arange(c),
        walks=np.zeros(c, np.bool_),
        ends=np.zeros((c, 2)),
        goal=np.zeros((c, 2)),
        parked=np.zeros(c, np.bool_),
        aside=np.zeros((c, 2)),
        idle=np.zeros(c, np.int64),
    )


def stops_of(steps: list[Step], biped: Dimensions) -> list[bool]:
    """On which footprints of a route, with the ones before, one can wait: two feet, not too far apart."""
    most = STRADDLES * float(biped.leg.nominal_length)
    pairs = zip(steps, steps[1:], strict=False)
    return [True, *(a.side != z.side and hypot(z.x - a.x, z.y - a.y) <= most for a, z in pairs)]


def put_route(plans: Routes, world: World, character: Character, c: int, steps: list[Step]) -> None:
    """Character c begins to go along these steps, the first two of which it stands on."""
    plans.steps[c, : len(steps)] = np.array(steps, STEP)
    plans.at[c], plans.length[c], plans.ashore[c] = 1, len(steps), ashore_of(world, steps)
    plans.stops[c, : len(steps)] = stops_of(steps, character.biped)
    plans.waits[c] = plans.walks[c] = plans.parked[c] = False


def ashore_of(world: World, steps: list[Step]) -> int:
    """From which footprint of a route on all, and all the ways between them, lie on land; at the last, if none do."""
    for k in range(len(steps) - 1, 0, -1):
        if is_wet(world.arrays, steps[k - 1], steps[k]):
            return min(k + 1, len(steps) - 1)
    return 1


def is_wet(world: WorldArrays, a: Step, z: Step) -> bool:
    """Whether a step leads off a rock, or over water."""
    water = (queries.in_water(world, a.x + s * (z.x - a.x), a.y + s * (z.y - a.y)) for s in (0.0, 0.25, 0.5, 0.75))
    return queries.rock_under(world, a.x, a.y, 0.0) >= 0 or any(water)
