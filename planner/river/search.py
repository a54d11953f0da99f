"""A* over (spot, spot before, foot, arrived) and over cells of land: the kernel of rock hopping.

`arrived` tells a bank spot that was stepped onto, from which one walks on over land, from one that was walked to, from which
one steps onto the water's rocks. Whoever walks is in a cell of land, wherever it came from: so ways from all banks to all
others are looked for at once, and cost no more than those from one. The heuristic, straight distance over the best ratio of
distance to cost of any move, never overestimates, and a state that is reached for less is looked at again, so the first route
found costs least.
"""

from heapq import heappop, heappush
from math import hypot
from typing import NamedTuple

import numpy as np

from motion.characters.dimensions import Dimensions
from planner.river.grid import NEAR, SPACING, Grid, may_go
from planner.river.moves import Spots, can_step, directed_cost, fastest, slowest_pace
from worlds.compiled.jit import jit


class Beside(NamedTuple):
    """Which spots belong to a cell of land: a chain."""

    first: np.ndarray  # (cells,) -1: none
    following: np.ndarray  # (K + 2,) the one behind a spot; -1: none


class State(NamedTuple):
    """Where a route has come to."""

    spot: int
    before: int  # the spot before, K: none
    foot: int  # that stands on it
    arrived: int  # 1: it was stepped onto, 0: walked to


class Search(NamedTuple):
    """What is known so far, by codes: those of states, and behind them those of cells."""

    best: np.ndarray  # least cost [s]
    parent: np.ndarray  # code of the state before, -1 for none
    speed: float  # fastest of any move [m/s]


@jit
def find(biped: Dimensions, spots: Spots, land: Grid, start: int, foot: int) -> tuple[np.ndarray, np.ndarray]:
    """Cheapest states (S, 4) as State, and which spots were reached (K + 2,); no states: no way."""
    k, heap, states = len(spots.rock), [(0.0, 0)], _states(len(spots.rock))
    heap.clear()
    size = states + land.free.size
    search = Search(np.full(size, np.inf), np.full(size, -1, np.int32), fastest(biped))
    reached, beside, pace = np.zeros(k + 2, np.bool_), _beside(spots, land), slowest_pace(biped)
    near = _near(biped, spots)
    first = _code(k, State(start, k, foot, 1))
    search.best[first] = 0.0
    heappush(heap, (_bound(spots.place, start, search.speed), first))
    while heap:
        bound, code = heappop(heap)
        if code >= states:
            if bound <= search.best[code] + _bound_of_cell(spots.place, land, code - states, search.speed):
                _walk(search, heap, spots, land, beside, code - states, pace)
            continue
        state = _state(k, code)
        if bound > search.best[code] + _bound(spots.place, state.spot, search.speed):
            continue
        reached[state.spot] = True
        if state.spot == k + 1:
            return _path(search.parent, code, k), reached
        if state.arrived and (state.spot == k or spots.rock[state.spot] < 0):
            if spots.cell[state.spot, 0] >= 0:
                cell = spots.cell[state.spot, 0] * land.free.shape[1] + spots.cell[state.spot, 1]
                _reach_cell(search, heap, spots.place, land, code, cell, 0.0)
        elif state.spot < k:
            for j in range(k):
                if near[state.spot, j]:
                    _step(biped, search, heap, spots, code, j)
    return np.zeros((0, 4), np.int64), reached


@jit
def _step(biped: Dimensions, search: Search, heap: list, spots: Spots, code: int, j: int) -> None:
    """From the state of a code to spot j: with the other foot, or by a hop."""
    k, state = len(spots.rock), _state(len(spots.rock), code)
    came = state.before if state.before < k else -1
    for hop in (False, True):
        cost = directed_cost(biped, spots.place, came, state.spot, j, state.foot, hop)
        _reach(search, heap, spots.place, code, State(j, state.spot, state.foot if hop else 1 - state.foot, 1), cost)


@jit
def _walk(search: Search, heap: list, spots: Spots, land: Grid, beside: Beside, cell: int, pace: float) -> None:
    """From a cell of land on: to those around it, and onto the spots that belong to it, on either foot."""
    rows, columns = land.free.shape
    k, i, j = len(spots.rock), cell // columns, cell % columns
    code, spot = _states(k) + cell, beside.first[cell]
    while spot >= 0:
        for last in range(2):
            _reach(search, heap, spots.place, code, State(spot, k, last, 0), 0.0)
        spot = beside.following[spot]
    for row in range(max(i - 1, 0), min(i + 2, rows)):
        for column in range(max(j - 1, 0), min(j + 2, columns)):
            if may_go(land, i, j, row, column):
                far = ((row - i) ** 2 + (column - j) ** 2) ** 0.5 * SPACING
                _reach_cell(search, heap, spots.place, land, code, row * columns + column, far * pace)


@jit
def _beside(spots: Spots, land: Grid) -> Beside:
    """Which banks, and whether the goal, belong to which cells."""
    k = len(spots.rock)
    beside = Beside(np.full(land.free.size, -1, np.int32), np.full(k + 2, -1, np.int32))
    for spot in range(k + 2):
        if spots.cell[spot, 0] >= 0 and (spot == k + 1 or (spot < k and spots.rock[spot] < 0)):
            cell = spots.cell[spot, 0] * land.free.shape[1] + spots.cell[spot, 1]
            beside.following[spot], beside.first[cell] = beside.first[cell], spot
    return beside


@jit
def _reach_cell(search: Search, heap: list, place: np.ndarray, land: Grid, code: int, cell: int, cost: float) -> None:
    """A cell of land is reached from the state or cell of this code, at a cost [s]."""
    following, total = _states(len(place) - 2) + cell, search.best[code] + cost
    if total < search.best[following] - 1e-12:
        search.best[following] = total
        search.parent[following] = code
        heappush(heap, (total + _bound_of_cell(place, land, cell, search.speed), following))


@jit
def _bound_of_cell(place: np.ndarray, land: Grid, cell: int, speed: float) -> float:
    """Seconds from a cell to the goal at least; the goal lies up to NEAR beside its own."""
    goal, columns = place[len(place) - 1], land.free.shape[1]
    x, y = (cell % columns + 0.5) * SPACING, (cell // columns + 0.5) * SPACING
    return max(hypot(x - goal[0], y - goal[1]) - NEAR, 0.0) / speed


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
def _states(k: int) -> int:
    """How many codes states of k spots have."""
    return (k + 2) * (k + 1) * 4


@jit
def _code(k: int, state: State) -> int:
    return ((state.spot * (k + 1) + state.before) * 2 + state.foot) * 2 + state.arrived


@jit
def _state(k: int, code: int) -> State:
    return State(code // 4 // (k + 1), code // 4 % (k + 1), code // 2 % 2, code % 2)


@jit
def _path(parent: np.ndarray, code: int, k: int) -> np.ndarray:
    """(S, 4) the states that lead to the one of this code; cells of land are left out."""
    count, at = 0, code
    while at >= 0:
        count, at = count + (at < _states(k)), parent[at]
    states, row = np.empty((count, 4), np.int64), count
    while code >= 0:
        if code < _states(k):
            row -= 1
            state = _state(k, code)
            states[row, 0], states[row, 1], states[row, 2], states[row, 3] = state.spot, state.before, state.foot, state.arrived
        code = parent[code]
    return states
