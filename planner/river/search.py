"""A* over (spot, spot before, foot, arrived): the kernel of rock hopping.

`arrived` tells a bank spot that was stepped onto, from which one walks on over land, from one that was walked to, from which
one steps onto the water's rocks. The heuristic, straight distance over the best ratio of distance to cost of any move, never
overestimates, so the first route found costs least.
"""

from heapq import heappop, heappush
from math import atan2, hypot, pi, sin

import numpy as np

from planner.stepping.timing import step_timing
from worlds.compiled.jit import jit

SHARPEST = 2.2
"""Largest angle between two steps in a row, in units of the character's max_turn: headings turn by half of it."""
LEAP_EFFORT, HOP_EFFORT, TURN_EFFORT, CLIMB_EFFORT, CROSSING_EFFORT = 0.6, 0.4, 0.3, 0.8, 1.5
"""Seconds that effort is worth: a leap; a hop on one side; a radian of turn; a climb of the hip's height; a foot crossed by
a preferred step."""


@jit
def slowest_pace(b):
    """Seconds per metre of walking on land."""
    return step_timing(b, b.preferred_step, 0.0, 0.0, False)[0] / b.preferred_step


@jit
def step_cost(b, length, rise, turn, crossed, hop):
    """Cost of a step or of a hop on the same side [s]: its time, and what its effort is worth."""
    effort = (LEAP_EFFORT if length > b.max_step else 0.0) + (HOP_EFFORT if hop else 0.0)
    effort += TURN_EFFORT * turn + CLIMB_EFFORT * max(rise, 0.0) / b.hip_height
    effort += CROSSING_EFFORT * crossed / b.preferred_step
    return step_timing(b, length, rise, 0.5 * turn, hop)[0] + effort


@jit
def fastest(b):
    """Largest distance per cost [m/s] of any step or walk."""
    best = 1 / slowest_pace(b)
    for k in range(1, 101):
        length = b.max_leap * k / 100
        for rise in (0.0, -b.max_drop):
            for hop in (False, True):
                best = max(best, length / step_cost(b, length, rise, 0.0, 0.0, hop))
    return best


@jit
def can_step(b, place, rock, i, j):
    """Whether the character's reach allows a step from spot i to spot j, whatever the direction."""
    length = hypot(place[j, 0] - place[i, 0], place[j, 1] - place[i, 1])
    rise = place[j, 2] - place[i, 2]
    if rock[i] < 0 and rock[j] < 0 and length < 0.5 * b.max_step:
        return False
    return b.foot_width <= length <= b.max_leap and -b.max_drop <= rise <= b.max_rise


@jit
def directed_cost(b, place, before, i, j, foot, hop):
    """Cost of a step from spot i, where `foot` stands, to j, coming from `before` (-1: none).

    The other foot steps, or with `hop` the same one, no farther than a walking step. inf if it would turn too sharply or
    cross the legs too far.
    """
    dx, dy = place[j, 0] - place[i, 0], place[j, 1] - place[i, 1]
    length = hypot(dx, dy)
    ahead = atan2(dy, dx)
    came = atan2(place[i, 1] - place[before, 1], place[i, 0] - place[before, 0]) if before >= 0 else ahead
    turned = (ahead - came + pi) % (2 * pi) - pi
    if abs(turned) > (3.0 if length < 0.6 * b.preferred_step else SHARPEST * b.max_turn):
        return np.inf
    across = length * sin(turned)
    crossed = 0.0 if hop else max(across if foot == 0 else -across, 0.0)
    if crossed > 0.45 * b.preferred_step or (hop and length > b.max_step):
        return np.inf
    return step_cost(b, length, place[j, 2] - place[i, 2], abs(turned), crossed, hop)


@jit
def find(b, place, rock, walks, start, foot):
    """Cheapest states (S, 4) of spot, spot before (K: none), foot, arrived; and which spots were reached (K + 2,).

    place (K + 2, 3): the spots, the start, the goal; rock (K,), -1 on a bank; walks (K + 1, K + 1) seconds over land from
    spot or start to spot or goal. No states: no way.
    """
    k = len(rock)
    speed = fastest(b)
    best = np.full((k + 2) * (k + 1) * 4, np.inf)
    parent = np.full(len(best), -1)
    done = np.zeros(len(best), np.bool_)
    reached = np.zeros(k + 2, np.bool_)
    near = np.zeros((k, k), np.bool_)
    for i in range(k):
        for j in range(k):
            near[i, j] = i != j and can_step(b, place, rock, i, j)
    first = _code(k, start, k, foot, 1)
    best[first] = 0.0
    heap = [(_bound(place, start, speed), first)]
    while heap:
        _, code = heappop(heap)
        if done[code]:
            continue
        done[code] = True
        spot, before, foot, arrived = _state(k, code)
        reached[spot] = True
        if spot == k + 1:
            return _path(parent, code, k), reached
        if arrived and (spot == k or rock[spot] < 0):
            for j in range(k + 1):
                if np.isfinite(walks[spot, j]):
                    for last in range(2):
                        target = k + 1 if j == k else j
                        _reach(best, parent, heap, place, speed, k, code, target, k, last, 0, walks[spot, j])
        elif spot < k:
            for j in range(k):
                if near[spot, j]:
                    came = before if before < k else -1
                    for hop in (False, True):
                        cost = directed_cost(b, place, came, spot, j, foot, hop)
                        _reach(best, parent, heap, place, speed, k, code, j, spot, foot if hop else 1 - foot, 1, cost)
    return np.zeros((0, 4), np.int64), reached


@jit
def _reach(best, parent, heap, place, speed, k, code, spot, before, foot, arrived, cost):
    following = _code(k, spot, before, foot, arrived)
    total = best[code] + cost
    if total < best[following] - 1e-12:
        best[following] = total
        parent[following] = code
        heappush(heap, (total + _bound(place, spot, speed), following))


@jit
def _bound(place, spot, speed):
    goal = place[len(place) - 1]
    return hypot(place[spot, 0] - goal[0], place[spot, 1] - goal[1]) / speed


@jit
def _code(k, spot, before, foot, arrived):
    return ((spot * (k + 1) + before) * 2 + foot) * 2 + arrived


@jit
def _state(k, code):
    return code // 4 // (k + 1), code // 4 % (k + 1), code // 2 % 2, code % 2


@jit
def _path(parent, code, k):
    count, at = 0, code
    while at >= 0:
        count, at = count + 1, parent[at]
    states = np.empty((count, 4), np.int64)
    for row in range(count - 1, -1, -1):
        states[row, 0], states[row, 1], states[row, 2], states[row, 3] = _state(k, code)
        code = parent[code]
    return states
