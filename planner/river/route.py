"""A route over rocks: A* over (spot, spot before, foot), from the start over land and rocks to the goal (paper, section 4).

On land a character walks, so land is one move from where it stands to any bank spot or to the goal, as long as the shortest
way; over water it steps from spot to spot. The state holds the spot before, so that turns count exactly. The heuristic is
the straight distance at the fastest speed any move has, so the first route found costs least.
"""

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.dimensions import Dimensions
from motion.track.footprints import RIGHT, Foot, Footprints, Step, walker_headings
from planner.planner import NoWay
from planner.river.crossing import GOAL, START, Country, Crossing
from planner.river.search import State
from planner.stepping import finding, footing, strides
from planner.stepping.beside import Place, middle_of
from worlds import queries

STRIDES = (1.0, 0.75, 0.55, 0.4)
"""Steps over land in preferred ones: as long as the ground allows."""
TURNS = 12
"""At most so many steps turn one on a rock."""
HOP_TURN = 1.5
"""How fast one turns who hops where it stands [rad/s]."""


def path_over_land(country: Country, place: Place, goal: Place) -> list[State]:
    """States of the search from a place on land, on the right foot, to a goal. Raises NoWay."""
    return Crossing(country, place, START, RIGHT, goal).run()


def route(country: Country, feet: Footprints, goal: Place, path: list[State] | None = None) -> list[Step]:
    """Steps to the goal, where both feet end, after the two footprints (2,) that the character stands on. Raises NoWay.

    path: states that somebody else found, of the same country, to go along from where one is.
    """
    character = country.character
    side, place, heading = int(feet.side[1]), feet.position[1], float(walker_headings(feet)[1])
    at = (float(place[0]), float(place[1]))
    crossing = Crossing(country, middle_of(character.biped, side, at, heading), START, side, goal)
    if feet.rock[1] >= 0 and len(crossing.spots.rock):
        offsets = crossing.spots.place[:, :2] - at
        crossing.on_spot = int(np.hypot(*offsets.T).argmin())
    steps = [Step(side, *at, heading)]
    path = path or crossing.run()
    if crossing.on_spot >= 0:
        steps, path = _facing_ahead(crossing, steps, path)
    for before, state in zip(path, path[1:], strict=False):
        _append_move(crossing, before, state, steps)
    last = steps[-1]
    middle = middle_of(character.biped, last.side, (last.x, last.y), last.heading)
    steps.append(strides.step_beside(character.biped, 1 - last.side, middle, last.heading))
    _keep_standing(crossing, steps)
    return steps[1:]


def _facing_ahead(crossing: Crossing, steps: list[Step], path: list[State]) -> tuple[list[Step], list[State]]:
    """Steps on the rock where one stands until one faces where the path leads: nobody leaps backward. Raises NoWay."""
    most = float(crossing.character.biped.reach.max_turn)
    for _ in range(TURNS):
        last, target = steps[-1], path[1]
        x, y = crossing.goal if target.spot == GOAL else crossing.spots.place[target.spot, :2].tolist()
        turn = wrapped(float(np.arctan2(y - last.y, x - last.x)) - last.heading)
        if abs(turn) <= most:
            break
        steps.append(_turned(crossing, last, float(np.clip(turn, -most, most))))
        if steps[-1].side != crossing.foot:  # the way may be another one from the other foot
            crossing.foot = steps[-1].side
            path = crossing.run()
    return steps, path


def _turned(crossing: Crossing, last: Step, turn: float) -> Step:
    """A turn on a rock: the other foot comes beside, or where there is no room for it, a hop where one stands."""
    biped, rocks = crossing.character.biped, crossing.world.arrays.rocks
    middle = middle_of(biped, last.side, (last.x, last.y), last.heading)
    beside = strides.step_beside(biped, 1 - last.side, middle, last.heading + turn)
    x, y, radius, _ = rocks[crossing.spots.rock[crossing.on_spot]]
    if np.hypot(beside.x - x, beside.y - y) <= radius - 0.5 * biped.foot.length - 0.01:
        return beside
    return Step(last.side, last.x, last.y, last.heading + turn, time=abs(turn) / HOP_TURN)


def _keep_standing(crossing: Crossing, steps: list[Step]) -> None:
    """Moves each step onto land on which the foot may not stand to the nearest place on which it may. Raises NoWay."""
    biped, world = crossing.character.biped, crossing.world.arrays
    for k in range(1, len(steps)):
        step, before = steps[k], steps[k - 1]
        foot = Foot(before.side, before.x, before.y, before.heading, 0.0, 0.0)
        why = footing.why_not_step(biped, world, foot, step.x, step.y, step.heading)
        if why == footing.FINE or step.side == before.side or queries.rock_under(world, step.x, step.y, 0.0) >= 0:
            continue
        middle = middle_of(biped, step.side, (step.x, step.y), step.heading)
        (x, y), heading = finding.nearest_footing(biped, world, foot, middle, step.heading)
        if np.isinf(heading):
            place = f"({step.x:.2f}, {step.y:.2f})"
            name = crossing.character.name
            raise NoWay(f"{crossing.world.name}: no way for the {name}: its foot at {place} {footing.WORDS[why]}")
        steps[k] = step._replace(x=x, y=y, heading=heading)


def _append_move(crossing: Crossing, before: State, state: State, steps: list[Step]) -> None:
    biped, last = crossing.character.biped, steps[-1]
    if state.spot == GOAL or not state.arrived:
        target = crossing.goal if state.spot == GOAL else tuple(crossing.spots.place[state.spot, :2].tolist())
        ways = crossing.ways_from(before.spot)
        assert ways is not None  # the search has walked it
        line = ways.polyline(crossing.world, *target)
        line[0] = middle_of(biped, last.side, (last.x, last.y), last.heading)
        wanted = None if state.spot == GOAL else state.foot
        steps += _walked(crossing, line, last, wanted)
        if state.spot != GOAL:
            steps[-1] = steps[-1]._replace(x=target[0], y=target[1])
    else:
        x, y = crossing.spots.place[state.spot, :2].tolist()
        if not before.arrived:  # it was walked to, and lies along the bank
            steps += _turns(biped, last, float(np.arctan2(y - last.y, x - last.x)))
        steps.append(Step(state.foot, x, y, np.nan))
        i = len(steps) - 1
        if before.before >= 0:
            _face(steps, i - 1, i - 2, i)
        _face(steps, i, max(i - 2, 0) if before.before >= 0 else i - 1, i)


def _turns(biped: Dimensions, last: Step, ahead: float) -> list[Step]:
    """Steps on the spot until a step toward `ahead` [rad] turns no further than one may; they end on the same foot again."""
    turn, most, steps = wrapped(ahead - last.heading), float(biped.reach.max_turn), []
    pairs = int(np.ceil(max(abs(turn) - most, 0.0) / (2 * most)))
    for _ in range(pairs):
        each = np.copysign((abs(turn) - most) / (2 * pairs), turn)
        heading = last.heading + each
        middle = middle_of(biped, last.side, (last.x, last.y), heading)
        last = last._replace(heading=heading + each)
        steps += [strides.step_beside(biped, 1 - last.side, middle, heading), last]
    return steps


def _walked(crossing: Crossing, line: np.ndarray, last: Step, wanted: int | None) -> list[Step]:
    """Steps along a line, shorter where the preferred ones would rise or fall too far."""
    biped, world = crossing.character.biped, crossing.world.arrays
    for stride in STRIDES:
        found = strides.walk(biped, line, last.heading, 1 - last.side, wanted, stride)
        why = {
            footing.why_not_step(biped, world, Foot(a.side, a.x, a.y, a.heading, 0.0, 0.0), z.x, z.y, z.heading)
            for a, z in zip([last, *found], found, strict=False)
        }
        if not why & {footing.HIGH, footing.DEEP}:
            break
    return found


def _face(steps: list[Step], i: int, came_from: int, goes_to: int) -> None:
    """Heading of step i: along the way from one footprint to another, unwrapped against the one before."""
    ahead = np.arctan2(steps[goes_to].y - steps[came_from].y, steps[goes_to].x - steps[came_from].x)
    heading = steps[i - 1].heading
    steps[i] = steps[i]._replace(heading=float(heading + wrapped(ahead - heading)))
