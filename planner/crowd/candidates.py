"""The steps among which one chooses: one in each direction, as long as is asked, up to what a leg steps in it.

Forward, a step is as long as the preferred one; to the side and back it is SHORTER: lengths lie on an ellipse about the newest
foot's heading (the discs and rings of Seitz & Koster's optimal steps model 2012, with the legs' own reach). The foot turns into
the direction as far as a step allows, and stays as it is for steps aside and back.

Which of them are free is the hard guarantee, whatever a step costs: its sole keeps off all that the others hold, and its body
comes to rest, and on its way is, where it touches nobody (bodies that are too close already come no closer; who has stood for
long squeezes by).
"""

from math import atan2, cos, hypot, inf, pi, sin, sqrt
from typing import Any, NamedTuple

import numpy as np

from motion.arithmetic.angles import wrapped
from motion.characters.dimensions import Dimensions
from motion.track.footprints import Foot
from planner.crowd.bodies import gap_between
from planner.crowd.walker import Walker, squeeze
from planner.round import reservations
from planner.round.round import Round
from planner.round.soles import Sole, sole_of
from planner.stepping import timing
from planner.stepping.beside import Place, beside, sole_heading
from planner.stepping.footing import FINE, why_not_step
from planner.stepping.steering import free_way, open_ahead
from worlds import queries
from worlds.compiled.jit import jit_borrowing, jit_inline

DIRECTIONS = (0.0, 0.2, -0.2, 0.45, -0.45, 0.75, -0.75, 1.1, -1.1, 1.6, -1.6, 2.3, -2.3, 3.14)
"""Off the wished course [rad]."""
SHORTER, TURNS_TO = 0.5, 1.3
"""Steps aside and back, in preferred ones; into directions further off the heading than this [rad] one steps aside."""
CROSSING = 0.4
"""A foot that comes down beside the other one stays on its own side, by so many step widths."""
QUICK = 1.3
"""Longest step time among others, in pendulum times: short steps are quick ones."""

FOOT_MARGIN = 0.01
"""Room kept between soles [m]."""
GRAZE = 0.25
"""Bodies may come so much closer, in half depths, than they should, or are, on their way to where they are not too close."""
APART = 1e-9
"""Bodies that are further apart than the largest axes of both by this [m] do not touch, however numbers are rounded."""
LOOKS = 4
"""Moments of a step at which bodies are looked at."""


class Candidate(NamedTuple):
    """A step that may be taken."""

    x: float  # middle
    y: float
    heading: float
    foot_x: float
    foot_y: float
    time: float  # it takes [s]


CANDIDATE = np.dtype([(name, np.float64) for name in Candidate._fields])


class Bearing(NamedTuple):
    """One of the directions, and what all steps in it share."""

    ahead_x: float  # its unit vector
    ahead_y: float
    heading: float  # of the foot [rad]
    turn: float  # how far that is off the last one's [rad]
    aside_x: float  # from the middle to the foot [m]
    aside_y: float
    longest: float  # step [m]


@jit_borrowing
def _time(biped: Dimensions, walker: Walker, fx: float, fy: float, turn: float) -> float:
    """How long a step takes that sets the foot down there [s], as on level ground: rises only make it later."""
    time = timing.level_time(biped, hypot(fx - walker.foot_x, fy - walker.foot_y), turn, QUICK)
    return max(time, timing.least_step_time(biped, walker.overlap))


@jit_borrowing
def candidate_to(biped: Dimensions, walker: Walker, middle: Place, heading: float) -> Candidate:
    """The step to a middle."""
    fx, fy = beside(biped, walker.side, middle, heading)
    return Candidate(middle[0], middle[1], heading, fx, fy, _time(biped, walker, fx, fy, abs(heading - walker.heading)))


@jit_borrowing
def longest(biped: Dimensions, slant: float) -> float:
    """The longest step in a direction that is `slant` off the heading [m]."""
    c, s = cos(slant) / (1.0 if abs(slant) < 0.5 * pi else SHORTER), sin(slant) / SHORTER
    return biped.gait.preferred_step / sqrt(c * c + s * s)


@jit_borrowing
def bearing_of(biped: Dimensions, walker: Walker, aside: float) -> Bearing:
    """A direction so far off the course [rad]. The foot turns into it, if it is before one or that turns to the course, too."""
    direction, most = walker.course + aside, biped.reach.max_turn
    off = wrapped(direction - walker.heading)
    back = off * wrapped(walker.course - walker.heading) > 0 and abs(aside) < TURNS_TO
    turned = min(max(off, -most), most) if abs(off) < TURNS_TO or back else 0.0
    heading, far = walker.heading + turned, longest(biped, off - turned) * (1 - 0.4 * (turned / most) ** 2)
    aside_x, aside_y = beside(biped, walker.side, (0.0, 0.0), heading)
    return Bearing(cos(direction), sin(direction), heading, abs(heading - walker.heading), aside_x, aside_y, far)


@jit_borrowing
def candidate(biped: Dimensions, walker: Walker, to: Bearing, length: float) -> Candidate:
    """A step of a length [m]."""
    x, y = walker.x + length * to.ahead_x, walker.y + length * to.ahead_y
    fx, fy = x + to.aside_x, y + to.aside_y
    return Candidate(x, y, to.heading, fx, fy, _time(biped, walker, fx, fy, to.turn))


@jit_inline
def rest_after(walker: Walker, step: Candidate) -> Place:
    """Where the body comes to rest after a step: between the feet."""
    return 0.5 * (walker.foot_x + step.foot_x), 0.5 * (walker.foot_y + step.foot_y)


@jit_inline
def keep(record: Any, step: Candidate) -> None:
    """Fills in a record of CANDIDATE with a step."""
    record.x, record.y, record.heading = step.x, step.y, step.heading
    record.foot_x, record.foot_y, record.time = step.foot_x, step.foot_y, step.time


@jit_inline
def candidate_in(record: Any) -> Candidate:
    """The step that a record of CANDIDATE holds."""
    return Candidate(record.x, record.y, record.heading, record.foot_x, record.foot_y, record.time)


@jit_borrowing
def crosses(biped: Dimensions, walker: Walker, step: Candidate) -> bool:
    """Whether a step sets the foot down on the other side of the other foot, or on it."""
    dx, dy, mean = step.foot_x - walker.foot_x, step.foot_y - walker.foot_y, 0.5 * (walker.heading + step.heading)
    ahead, left = dx * cos(mean) + dy * sin(mean), dy * cos(mean) - dx * sin(mean)
    aside = left if walker.side == 0 else -left
    return aside < (CROSSING if abs(ahead) < biped.foot.length else -0.5) * biped.gait.step_width


@jit_borrowing
def is_open(round: Round, walker: Walker, step: Candidate) -> bool:
    """Whether a step keeps off trees, walls and water."""
    world, length = round.world, hypot(step.x - walker.x, step.y - walker.y)
    biped = round.bipeds[round.kind[walker.c]]
    if length > 0 and (walker.careful or length > walker.room - walker.margin):
        course = atan2(step.y - walker.y, step.x - walker.x)
        if queries.clearance(world, step.x, step.y) < walker.margin:
            return False
        if free_way(biped, world, walker.x, walker.y, course, walker.margin - 0.01, length) < length:
            return False
    if walker.careful:
        foot = Foot(1 - walker.side, walker.foot_x, walker.foot_y, walker.heading, 0.0, 0.0)
        return why_not_step(biped, world, foot, step.foot_x, step.foot_y, step.heading) == FINE
    return True


@jit_borrowing
def part_open(round: Round, walker: Walker, far: float) -> float:
    """The share of half a disc `far` [m] deep ahead on my course that is open between walls; no less than what I take."""
    w, biped = walker, round.bipeds[round.kind[walker.c]]
    return open_ahead(biped, round.world, w.x, w.y, w.course, w.room, far, 1.5 * w.wide / max(far, w.wide))


@jit_borrowing
def _gap_to(held: reservations.Reservations, walker: Walker, j: int, time: float, at: Place, face: Place) -> float:
    """The gap between j's body at a time [s] and mine at a place [m], facing in the direction of that unit vector.

    inf: they are too far apart to touch, whichever way they face.
    """
    jx, jy = reservations.place_on_path(held, j, time, reservations.COMMITTED - 1)
    mine, px, py = (walker.deep, walker.wide), jx - at[0], jy - at[1]
    its, looks = (held.half[j, 0], held.half[j, 1]), (held.face[j, 0], held.face[j, 1])
    largest = max(mine[0], mine[1]) + max(its[0], its[1]) + APART
    return gap_between(mine, face, its, looks, px, py) if px * px + py * py < largest * largest else inf


@jit_inline
def _keeps_off(
    held: reservations.Reservations, walker: Walker, j: int, step: Candidate, sole: Sole, rest: Place, turned: Place, far: float
) -> bool:  # fmt: skip
    """Whether a step keeps off all that j holds: it comes to rest at a place [m], turned so. Nobody beyond `far` [m] counts."""
    if not reservations.foot_is_free(held, j, sole, FOOT_MARGIN, walker.time + step.time):
        return False
    last, reach = held.path[j, reservations.COMMITTED - 1], far + max(held.half[j, 0], held.half[j, 1])
    if abs(last[0] - rest[0]) > reach or abs(last[1] - rest[1]) > reach:
        return True
    face = (walker.face_x, walker.face_y)
    dx, dy = last[0] - rest[0], last[1] - rest[1]
    off = max(hypot(dx, dy), APART)
    least = min(_gap_to(held, walker, j, inf, (walker.rest_x, walker.rest_y), face), -squeeze(walker, dx / off, dy / off))
    if _gap_to(held, walker, j, inf, rest, turned) < least:
        return False
    for k in range(1, LOOKS + 1):
        s = k / LOOKS
        x, y = walker.rest_x + s * (rest[0] - walker.rest_x), walker.rest_y + s * (rest[1] - walker.rest_y)
        if _gap_to(held, walker, j, walker.there + s * step.time, (x, y), face) < least - GRAZE * walker.deep:
            return False
    return True


@jit_borrowing
def is_free(round: Round, walker: Walker, near: np.ndarray, step: Candidate) -> bool:
    """Whether a step keeps off all that the others hold; where bodies are too close already, it may part them.

    Who is in the way becomes the first of those near: it is in the way of the next step that is tried, too.
    """
    held = round.reservations
    rest = rest_after(walker, step)
    heading = sole_heading(round.bipeds[round.kind[walker.c]], walker.side, step.heading)
    sole = sole_of(held.sole, walker.c, step.foot_x, step.foot_y, heading)
    facing = 0.5 * (walker.heading + step.heading)
    turned = (cos(facing), sin(facing))
    far = walker.wide + hypot(rest[0] - walker.rest_x, rest[1] - walker.rest_y) + walker.full * step.time
    for i in range(len(near)):
        if not _keeps_off(held, walker, near[i], step, sole, rest, turned, far):
            near[0], near[i] = near[i], near[0]
            return False
    return True


@jit_borrowing
def may_be_taken(round: Round, walker: Walker, near: np.ndarray, step: Candidate) -> bool:
    """Whether a step is one that legs can take, and free of trees, walls, water and others."""
    biped = round.bipeds[round.kind[walker.c]]
    return not crosses(biped, walker, step) and is_open(round, walker, step) and is_free(round, walker, near, step)
