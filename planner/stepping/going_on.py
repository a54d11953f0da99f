"""Going on as one went: the guess of the next step where nothing better is known."""

from math import cos, sin

from motion.characters.dimensions import Dimensions
from motion.track.footprints import Feet, Step, step_onto
from planner.stepping.beside import beside, middle_beside
from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def going_on(biped: Dimensions, feet: Feet) -> Step:
    """The other foot goes as far as this one went, turned as it turned."""
    older, newer = feet.older, feet.newer
    (x, y), was = middle_beside(biped, newer), middle_beside(biped, older)
    turn, dx, dy = newer.heading - older.heading, x - was[0], y - was[1]
    c, s = cos(turn), sin(turn)
    middle = (x + c * dx - s * dy, y + s * dx + c * dy)
    fx, fy = beside(biped, older.side, middle, newer.heading + turn)
    return step_onto(older.side, fx, fy, newer.heading + turn)
