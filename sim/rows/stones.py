"""Stepping stones, a row of them to every row of a crowd: one call takes a step in each (sim.stage.learning tells why).

Each row has a world of its own: a few stones in the air, and nothing else. Stones follow each other as in ALLSTEPS (Z. Xie,
H. Y. Ling, N. H. Kim, M. van de Panne, SCA 2020): .65 to 1.25 m apart, up to 20 degrees aside, up to 30 degrees up or down,
as far as the reach allows; `level`, 0 to 1, is the share of these ranges. An action is the next footprint: where, whither
and how quickly. The window of the curve (sim.rows.rounds) looks at the stones behind it, so a row is a character like any
other.
"""

from math import atan2, cos, hypot, nan, pi, sin
from typing import Any, NamedTuple

import numpy as np
from numba import prange

from motion.track.footprints import LEFT, RIGHT, Step, feet_before, step_onto
from planner.round.round import UNHURRIED, Wish
from planner.stepping import random
from planner.stepping.beside import beside
from planner.stepping.going_on import acted
from planner.stepping.placing import EDGE, lay_strike
from planner.stepping.taking import take_step
from sim.rows.crowd import REAL, TENTATIVE, shift, stand
from sim.rows.posing import SHARE, WORKERS
from sim.rows.rounds import open_work
from sim.rows.stone_windows import expected, retime
from worlds.arrays import FLAT, WorldArrays
from worlds.compiled.jit import jit, jit_borrowing, jit_parallel
from worlds.compiled.parts import call, handle, take
from worlds.compiled.tables import row

KEPT = 6
"""Stones of a row: under the older and the newer foot, the next one, and three that the window looks at."""
NEXT, IN_VIEW = 2, 2
"""Of those, the first to step on, and how many are seen."""
CLOSE, APART = 0.65, 1.25
ASIDE, STEEP = 20 * pi / 180, 30 * pi / 180
RADIUS, ROOM = 0.2, 0.25
"""Radius of a stone at level 1, and how much more at level 0, in soles' lengths over the human's."""
HEIGHT = 100.0
"""Stones begin so far up [m] that none comes down to the ground."""
AHEAD, REACH = 0.95, 0.6
"""A step goes so far [m], and so much less or more, of a human; others in proportion to their legs."""
ACTIONS = 4
"""How far ahead, how far aside, how far turned, how quickly: each -1 to 1."""
QUICKER = 0.5
"""The quickest step takes 2^-QUICKER of the automatic time, the slowest 2^QUICKER."""
_AWAY, _YAW, _PITCH = range(40, 43)


class Stones(NamedTuple):
    """Stones of N rows."""

    place: np.ndarray  # (N, KEPT, 4) x, y, radius, height of the top [m]
    course: np.ndarray  # (N,) direction in which the last one was laid [rad]
    level: np.ndarray  # (N,) 0 easy, 1 as ALLSTEPS
    seed: np.ndarray  # (N,)
    laid: np.ndarray  # (N,) how many stones have been laid so far


class Outcome(NamedTuple):
    """What a step has come to, of N rows."""

    progress: np.ndarray  # (N,) how much nearer the stone stepped on is to the one behind it than the last [m]
    cost: np.ndarray  # (N,) E of the window: physics and comfort
    miss: np.ndarray  # (N,) how far the footprint was beyond the stone's edge [m]; 0: on it


class Ground(NamedTuple):
    """Where N rows are, what they are to do, and what comes of it."""

    common: WorldArrays
    stones: Stones
    actions: np.ndarray  # (N, ACTIONS) each -1 to 1
    outcome: Outcome


def empty_stones(rows: int) -> Stones:
    """Room for stones."""
    return Stones(np.zeros((rows, KEPT, 4)), np.zeros(rows), np.zeros(rows), np.zeros(rows, np.int64), np.zeros(rows, np.int64))


def void() -> WorldArrays:
    """A world of one cell that lists KEPT stones."""
    nothing, none = np.zeros(2, np.int64), np.zeros(0, np.int64)
    return WorldArrays(
        np.array([-1e5, -1e5, 1e5, 1e5]), FLAT, np.zeros(8), np.zeros((1, 1)), np.zeros((0, 3)), np.zeros((0, 5)),
        np.zeros((KEPT, 4)), 1, nothing, none, nothing, none, np.array([0, KEPT]), np.arange(KEPT), np.zeros((0, 5)),
        nothing, none,
    )  # fmt: skip


def ground_of(rows: int) -> Ground:
    """Room for so many rows."""
    return Ground(void(), empty_stones(rows), np.zeros((rows, ACTIONS)), Outcome(*np.zeros((3, rows))))


_, open_ground, _, GROUND = handle(ground_of(1))


@jit_borrowing
def _world_of(ground: Ground, c: int) -> WorldArrays:
    """The world of row c."""
    w = ground.common
    return WorldArrays(
        w.bounds, w.terrain_kind, w.terrain, w.heights, w.trees, w.banks, ground.stones.place[c], w.columns, w.tree_start,
        w.tree_index, w.bank_start, w.bank_index, w.rock_start, w.rock_index, w.walls, w.wall_start, w.wall_index,
    )  # fmt: skip


@jit_borrowing
def _between(stones: Stones, c: int, purpose: int, low: float, high: float) -> float:
    return low + (high - low) * random.uniform(stones.seed[c], 0, stones.laid[c], purpose)


@jit_borrowing
def _lay_stone(stones: Stones, biped: Any, c: int) -> None:
    """Another stone behind the last of row c, whose oldest is forgotten; scaled to the leg, ALLSTEPS being a human's."""
    place, level, unit = stones.place[c], stones.level[c], biped.leg.nominal_length / 0.9
    for k in range(KEPT - 1):
        for axis in range(4):
            place[k, axis] = place[k + 1, axis]
    middle = 0.5 * (CLOSE + APART) * (0.75 + 0.25 * level)
    away = _between(stones, c, _AWAY, middle - 0.5 * level * (APART - CLOSE), middle + 0.5 * level * (APART - CLOSE)) * unit
    stones.course[c] += level * _between(stones, c, _YAW, -ASIDE, ASIDE)
    rise = away * sin(level * _between(stones, c, _PITCH, -STEEP, STEEP))
    rise = min(max(rise, -0.9 * biped.reach.max_drop), 0.9 * biped.reach.max_rise)
    place[KEPT - 1, 0] = place[KEPT - 2, 0] + away * cos(stones.course[c])
    place[KEPT - 1, 1] = place[KEPT - 2, 1] + away * sin(stones.course[c])
    place[KEPT - 1, 2] = _radius(biped, level)
    place[KEPT - 1, 3] = place[KEPT - 2, 3] + rise
    stones.laid[c] += 1


@jit_borrowing
def _radius(biped: Any, level: float) -> float:
    return (RADIUS + ROOM * (1 - level)) * biped.foot.length / 0.26


@jit_borrowing
def _begin(work_at: int, ground: Ground, c: int, places: np.ndarray) -> None:
    """Row c stands on the first two of new stones; places (2, 3): where it writes x, y, heading of its feet."""
    work, stones = open_work(work_at), ground.stones
    crowd, place = work.crowd, stones.place[c]
    biped = work.round.bipeds[crowd.kind[c]]
    stones.course[c] = 0.0
    for k in range(2):
        x, y = beside(biped, RIGHT if k == 0 else LEFT, (0.0, 0.0), 0.0)
        places[k, 0], places[k, 1], places[k, 2], last = x, y, 0.0, KEPT - 2 + k
        place[last, 0], place[last, 1], place[last, 2], place[last, 3] = x, y, _radius(biped, stones.level[c]), HEIGHT
    for _ in range(KEPT - 2):
        _lay_stone(stones, biped, c)
    stand(crowd, work.round.bipeds, _world_of(ground, c), c, LEFT, places, 0.0, True)


@jit
def begin_rows(work_at: int, ground_at: int, rows: np.ndarray) -> None:
    """The rows (K,) of the Work at an address stand on new stones, from now on at time 0 of their own."""
    places = np.empty((2, 3))
    for c in rows:
        _begin(work_at, open_ground(ground_at), c, places)


@jit_borrowing
def _wish(step: Step) -> Wish:
    return Wish(step, step.heading, UNHURRIED, False, False)


@jit_borrowing
def _timed(step: Step, time: float) -> Step:
    return Step(step.side, step.x, step.y, step.heading, time, nan, 0.0, 1.0, 0.0)


@jit_borrowing
def _expected(place: np.ndarray, k: int, side: int) -> Step:
    """The step onto stone k, as the window expects it: along the way."""
    dx, dy = place[k, 0] - place[k - 1, 0], place[k, 1] - place[k - 1, 1]
    return step_onto(side, place[k, 0], place[k, 1], atan2(dy, dx))


@jit_borrowing
def _step(optimise: int, work_at: int, ground: Ground, c: int) -> None:
    """Row c takes the step of its action; one that would land beside the next stone is not taken.

    How high the foot swings is left open: it costs a third of a step, and neither what is seen nor the reward asks for it.
    """
    work, place = open_work(work_at), ground.stones.place[c]
    crowd, world, action, out = work.crowd, _world_of(ground, c), ground.actions[c], ground.outcome
    biped, footprints = work.round.bipeds[crowd.kind[c]], row(crowd.footprints, c)
    foot = feet_before(footprints, crowd.real[c]).newer
    step = acted(biped, foot, action, AHEAD, REACH)
    beyond = hypot(step.x - place[NEXT, 0], step.y - place[NEXT, 1]) - (place[NEXT, 2] - EDGE)
    out.miss[c], out.progress[c], out.cost[c] = max(beyond, 0.0), 0.0, 0.0
    if not beyond <= 0:
        return
    behind = hypot(foot.x - place[NEXT + 1, 0], foot.y - place[NEXT + 1, 1])
    out.progress[c] = behind - hypot(step.x - place[NEXT + 1, 0], step.y - place[NEXT + 1, 1])
    if crowd.real[c] == REAL:
        shift(crowd, c)
    n = crowd.real[c]
    was = expected(footprints, n - 1)
    crowd.number[c] += 1
    take_step(biped, world, footprints, n, _wish(step), 0.0)
    time = footprints.step_time[n - 1] * 2 ** (-QUICKER * action[3])
    take_step(biped, world, footprints, n, _wish(_timed(step, time)), 0.0)
    lay_strike(biped, footprints, n)
    for k in range(1, TENTATIVE + 1):
        side = step.side if k % 2 == 0 else 1 - step.side
        take_step(biped, world, footprints, n + k, _wish(_expected(place, NEXT + k, side)), 0.0)
    retime(row(crowd.window, c), crowd.points[c], was, expected(footprints, n - 1))
    crowd.real[c], crowd.standing[c] = n + 1, False
    call(optimise, work_at, c)
    out.cost[c] = crowd.window_cost[c, 0]
    _lay_stone(ground.stones, biped, c)


@jit_borrowing
def _step_some(optimise: int, work_at: int, ground_at: int, rows: np.ndarray, counter: np.ndarray) -> None:
    """Share after share, until none is left."""
    begin = take(counter) * SHARE
    while begin < len(rows):
        for k in range(begin, min(begin + SHARE, len(rows))):
            _step(optimise, work_at, open_ground(ground_at), rows[k])
        begin = take(counter) * SHARE


@jit_parallel
def step_rows(optimise: int, work_at: int, ground_at: int, rows: np.ndarray) -> None:
    """The rows (K,) each take the step of their action; optimise: where stone_windows.optimise_stones lies."""
    counter = np.zeros(1, np.int64)
    for _ in prange(WORKERS):
        _step_some(optimise, work_at, ground_at, rows, counter)
