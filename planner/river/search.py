"""A* over (spot, spot before, foot, arrived): the kernel of rock hopping.

`arrived` tells a bank spot that was stepped onto, from which one walks on over land, from one that was walked to, from which
one steps onto the water's rocks. The heuristic, straight distance over the best ratio of distance to cost of any move, never
overestimates, so the first route found costs least.
"""

from heapq import heappop, heappush
from math import atan2, hypot, sin
from typing import NamedTuple

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT
from planner.stepping.timing import step_timing
from worlds.compiled.jit import jit

SHARPEST = 2.2
"""Largest angle between two steps in a row, in units of the character's max_turn: headings turn by half of it."""
LONG, LONG_TURN = 1.3, 1.3
"""The same after a step that is longer than this share of the preferred one: who leaps does not turn much."""
LEAP_EFFORT, HOP_EFFORT, TURN_EFFORT, CLIMB_EFFORT, CROSSING_EFFORT = 0.6, 0.4, 0.3, 0.8, 1.5
"""Seconds that effort is worth: a leap; a hop on one side; a radian of turn; a climb of the hip's height; a foot crossed by
a preferred step."""


class Spots(NamedTuple):
    """K spots, and behind them the start and the goal."""

    place: np.ndarray  # (K + 2, 3) [m]
    rock: np.ndarray  # (K,) -1 on a bank
    walks: np.ndarray  # (K + 1, K + 1) seconds over land from spot or start to spot or goal


class State(NamedTuple):
    """Where a route has come to."""

    spot: int
    before: int  # the spot before, K: none
    foot: int  # that stands on it
    arrived: int  # 1: it was stepped onto, 0: walked to


class Search(NamedTuple):
    """What is known so far, by the states' codes."""

    best: np.ndarray  # least cost [s]
    parent: np.ndarray  # code of the state before, -1 for none
    done: np.ndarray  # bool
    speed: float  # fastest of any move [m/s]


@jit
def slowest_pace(biped: Dimensions) -> float:
    """Seconds per metre of walking on land."""
    stride = biped.gait.preferred_step
    return step_timing(biped, stride, 0.0, 0.0, False)[0] / stride


@jit
def step_cost(biped: Dimensions, length: float, rise: float, turn: float, crossed: float, hop: bool) -> float:
    """Cost of a step or of a hop on the same side [s]: its time, and what its effort is worth."""
    effort = (LEAP_EFFORT if length > biped.reach.max_step else 0.0) + (HOP_EFFORT if hop else 0.0)
    effort += TURN_EFFORT * turn + CLIMB_EFFORT * max(rise, 0.0) / biped.timing.hip_height
    effort += CROSSING_EFFORT * crossed / biped.gait.preferred_step
    return step_timing(biped, length, rise, 0.5 * turn, hop)[0] + effort


@jit
def fastest(biped: Dimensions) -> float:
    """Largest distance per cost [m/s] of any step or walk."""
    best = 1 / slowest_pace(biped)
    for k in range(1, 101):
        length = biped.reach.max_leap * k / 100
        for rise in (0.0, -biped.reach.max_drop):
            for hop in (False, True):
                best = max(best, length / step_cost(biped, length, rise, 0.0, 0.0, hop))
    return best


@jit
def can_step(biped: Dimensions, spots: Spots, i: int, j: int) -> bool:
    """Whether the character's reach allows a step from spot i to spot j, whatever the direction."""
    place, reach = spots.place, biped.reach
    length = hypot(place[j, 0] - place[i, 0], place[j, 1] - place[i, 1])
    rise = place[j, 2] - place[i, 2]
    if spots.rock[i] < 0 and spots.rock[j] < 0 and length < 0.5 * reach.max_step:
        return False
    return biped.foot.width <= length <= reach.max_leap and -reach.max_drop <= rise <= reach.max_rise


@jit
def directed_cost(biped: Dimensions, place: np.ndarray, before: int, i: int, j: int, foot: int, hop: bool) -> float:
    """Cost of a step from spot i, where `foot` stands, to j, coming from `before` (-1: none); place (K, 3).

    The other foot steps, or with `hop` the same one, no farther than a walking step. inf if it would turn too sharply or
    cross the legs too far.
    """
    stride = biped.gait.preferred_step
    dx, dy = place[j, 0] - place[i, 0], place[j, 1] - place[i, 1]
    length = hypot(dx, dy)
    ahead = atan2(dy, dx)
    came = atan2(place[i, 1] - place[before, 1], place[i, 0] - place[before, 0]) if before >= 0 else ahead
    turned = wrapped(ahead - came)
    sharpest = LONG_TURN if length > LONG * stride else SHARPEST
    if abs(turned) > (3.0 if length < 0.6 * stride else sharpest * biped.reach.max_turn):
        return np.inf
    across = length * sin(turned)
    crossed = 0.0 if hop else max(across if foot == LEFT else -across, 0.0)
    if crossed > 0.45 * stride or (hop and length > biped.reach.max_step):
        return np.inf
    return step_cost(biped, length, place[j, 2] - place[i, 2], abs(turned), crossed, hop)


@jit
def find(biped: Dimensions, spots: Spots, start: int, foot: int) -> tuple[np.ndarray, np.ndarray]:
    """Cheapest states (S, 4) as State, and which spots were reached (K + 2,); no states: no way."""
    k, heap = len(spots.rock), [(0.0, 0)]
    heap.clear()
    codes = (k + 2) * (k + 1) * 4
    search = Search(np.full(codes, np.inf), np.full(codes, -1), np.zeros(codes, np.bool_), fastest(biped))
    reached = np.zeros(k + 2, np.bool_)
    near = _near(biped, spots)
    first = _code(k, State(start, k, foot, 1))
    search.best[first] = 0.0
    heappush(heap, (_bound(spots.place, start, search.speed), first))
    while heap:
        _, code = heappop(heap)
        if search.done[code]:
            continue
        search.done[code] = True
        state = _state(k, code)
        reached[state.spot] = True
        if state.spot == k + 1:
            return _path(search.parent, code, k), reached
        if state.arrived and (state.spot == k or spots.rock[state.spot] < 0):
            for j in range(k + 1):
                if np.isfinite(spots.walks[state.spot, j]):
                    for last in range(2):
                        target = State(k + 1 if j == k else j, k, last, 0)
                        _reach(search, heap, spots.place, code, target, spots.walks[state.spot, j])
        elif state.spot < k:
            for j in range(k):
                if near[state.spot, j]:
                    came = state.before if state.before < k else -1
                    for hop in (False, True):
                        cost = directed_cost(biped, spots.place, came, state.spot, j, state.foot, hop)
                        target = State(j, state.spot, state.foot if hop else 1 - state.foot, 1)
                        _reach(search, heap, spots.place, code, target, cost)
    return np.zeros((0, 4), np.int64), reached


@jit
def _near(biped: Dimensions, spots: Spots) -> np.ndarray:
    """(K, K) bool: between which spots the reach allows a step."""
    k = len(spots.rock)
    near = np.zeros((k, k), np.bool_)
    for i in range(k):
        for j in range(k):
            near[i, j] = i != j and can_step(biped, spots, i, j)
    return near


@jit
def _reach(search: Search, heap: list, place: np.ndarray, code: int, target: State, cost: float) -> None:
    """A state is reached from the one of this code, at a cost."""
    following = _code(len(place) - 2, target)
    total = search.best[code] + cost
    if total < search.best[following] - 1e-12:
        search.best[following] = total
        search.parent[following] = code
        heappush(heap, (total + _bound(place, target.spot, search.speed), following))


@jit
def _bound(place: np.ndarray, spot: int, speed: float) -> float:
    goal = place[len(place) - 1]
    return hypot(place[spot, 0] - goal[0], place[spot, 1] - goal[1]) / speed


@jit
def _code(k: int, state: State) -> int:
    return ((state.spot * (k + 1) + state.before) * 2 + state.foot) * 2 + state.arrived


@jit
def _state(k: int, code: int) -> State:
    return State(code // 4 // (k + 1), code // 4 % (k + 1), code // 2 % 2, code % 2)


@jit
def _path(parent: np.ndarray, code: int, k: int) -> np.ndarray:
    count, at = 0, code
    while at >= 0:
        count, at = count + 1, parent[at]
    states = np.empty((count, 4), np.int64)
    for row in range(count - 1, -1, -1):
        state = _state(k, code)
        states[row, 0], states[row, 1], states[row, 2], states[row, 3] = state.spot, state.before, state.foot, state.arrived
        code = parent[code]
    return states
