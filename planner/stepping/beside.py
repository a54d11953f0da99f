"""Where a walker's feet are beside its middle, half a step width to either side."""

from math import cos, sin

from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, Foot, outward
from worlds.compiled.jit import jit_borrowing

Place = tuple[float, float]


@jit_borrowing
def _aside(biped: Dimensions, side: int, x: float, y: float, heading: float, sign: float) -> Place:
    across = sign * 0.5 * biped.gait.step_width if side == LEFT else -sign * 0.5 * biped.gait.step_width
    return x - across * sin(heading), y + across * cos(heading)


@jit_borrowing
def beside(biped: Dimensions, side: int, middle: Place, heading: float) -> Place:
    """Where foot `side` of a walker stands whose middle is there [m]."""
    return _aside(biped, side, middle[0], middle[1], heading, 1.0)


@jit_borrowing
def sole_heading(biped: Dimensions, side: int, heading: float) -> float:
    """Where the sole of foot `side` points of a walker with that heading [rad]."""
    return heading + outward(side, biped.gait.toe_out)


@jit_borrowing
def middle_of(biped: Dimensions, side: int, place: Place, heading: float) -> Place:
    """Middle of the walker whose foot `side` stands at a place [m]."""
    return _aside(biped, side, place[0], place[1], heading, -1.0)


@jit_borrowing
def middle_beside(biped: Dimensions, foot: Foot) -> Place:
    """Middle of the walker who stands on a foot."""
    return middle_of(biped, foot.side, (foot.x, foot.y), foot.heading)
