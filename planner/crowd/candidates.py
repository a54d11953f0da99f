"""The steps among which one chooses: directions times lengths, as far as a leg steps in a direction, and standing.

Forward, a step is as long as the preferred one; to the side and back it is SHORTER: lengths lie on an ellipse about the newest
foot's heading (the discs and rings of Seitz & Koster's optimal steps model 2012, with the legs' own reach). The foot turns into
the direction as far as a step allows, and stays as it is for steps aside and back.
"""

from math import cos, hypot, pi, sin, sqrt
from typing import NamedTuple

from motion.arithmetic.angles import wrapped
from motion.characters.dimensions import Dimensions
from planner.crowd.walker import Walker
from planner.stepping import timing
from planner.stepping.beside import Place, beside
from worlds.compiled.jit import jit_borrowing

DIRECTIONS = (0.0, 0.2, -0.2, 0.45, -0.45, 0.75, -0.75, 1.1, -1.1, 1.6, -1.6, 2.3, -2.3, 3.14)
"""Off the wished course [rad]."""
LENGTHS = (1.0, 0.8, 0.62, 0.46, 0.32, 0.2, 0.1)
"""In the longest of a direction."""
SHORTER, TURNS_TO = 0.5, 1.3
"""Steps aside and back, in preferred ones; into directions further off the heading than this [rad] one steps aside."""
CROSSING = 0.4
"""A foot that comes down beside the other one stays on its own side, by so many step widths."""
QUICK = 1.5
"""Longest step time among others, in pendulum times: short steps are quick ones."""
CANDIDATES = len(DIRECTIONS) * len(LENGTHS) + 1
"""How many there are, and the number of standing; 0 is the wish."""


class Candidate(NamedTuple):
    """A step that may be taken."""

    x: float  # middle
    y: float
    heading: float
    foot_x: float
    foot_y: float
    time: float  # it takes [s]


@jit_borrowing
def candidate_to(biped: Dimensions, walker: Walker, middle: Place, heading: float) -> Candidate:
    """The step to a middle, timed as on level ground: rises only make it later."""
    fx, fy = beside(biped, walker.side, middle, heading)
    length, turn = hypot(fx - walker.foot_x, fy - walker.foot_y), abs(heading - walker.heading)
    time, _ = timing.step_timing(biped, length, 0.0, turn, False, QUICK)
    return Candidate(middle[0], middle[1], heading, fx, fy, max(time, timing.least_step_time(biped, walker.overlap)))


@jit_borrowing
def longest(biped: Dimensions, slant: float) -> float:
    """The longest step in a direction that is `slant` off the heading [m]."""
    c, s = cos(slant) / (1.0 if abs(slant) < 0.5 * pi else SHORTER), sin(slant) / SHORTER
    return biped.gait.preferred_step / sqrt(c * c + s * s)


@jit_borrowing
def candidate(biped: Dimensions, walker: Walker, k: int) -> Candidate:
    """Candidate k > 0: LENGTHS of the first direction, then of the next."""
    direction = walker.course + DIRECTIONS[(k - 1) // len(LENGTHS)]
    off, most = wrapped(direction - walker.heading), biped.reach.max_turn
    turn = min(max(off, -most), most) if abs(off) < TURNS_TO else 0.0
    heading = walker.heading + turn
    length = longest(biped, off - turn) * (1 - 0.4 * (turn / most) ** 2) * LENGTHS[(k - 1) % len(LENGTHS)]
    x, y = walker.x + length * cos(direction), walker.y + length * sin(direction)
    return candidate_to(biped, walker, (x, y), heading)


@jit_borrowing
def crosses(biped: Dimensions, walker: Walker, step: Candidate) -> bool:
    """Whether a step sets the foot down on the other side of the other foot, or on it."""
    dx, dy, mean = step.foot_x - walker.foot_x, step.foot_y - walker.foot_y, 0.5 * (walker.heading + step.heading)
    ahead, left = dx * cos(mean) + dy * sin(mean), dy * cos(mean) - dx * sin(mean)
    aside = left if walker.side == 0 else -left
    return aside < (CROSSING if abs(ahead) < biped.foot.length else -0.5) * biped.gait.step_width
