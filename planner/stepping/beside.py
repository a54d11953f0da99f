"""Where a walker's feet are beside its middle, half a step width to either side."""

from math import cos, hypot, sin, sqrt

from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, Foot, outward
from worlds.compiled.jit import jit_borrowing

Place = tuple[float, float]
HEELS = 2.4
"""Distance of ankles that stand, in radii of shanks: they come nearer as a foot turns and rolls."""
TOUCH = 1e-9
"""Ankles that are nearer by no more than this are apart [m]."""
TOGETHER = 0.2
"""Feet are together whose walker would be in one place by either, within this share of its preferred step."""
BESIDE, ACROSS = 0.55, -0.2
"""A foot is set down so far to its own side of the other one, in step widths: beside it, and well ahead of it."""


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


@jit_borrowing
def are_together(biped: Dimensions, one: Foot, other: Foot) -> bool:
    """Whether feet are beside each other, or as nearly as shanks let them: those may be wider than a step."""
    (x, y), (u, v) = middle_beside(biped, one), middle_beside(biped, other)
    wider = max(HEELS * biped.leg.shank_radius - biped.gait.step_width, 0.0)
    return hypot(x - u, y - v) <= TOGETHER * biped.gait.preferred_step + wider


@jit_borrowing
def _between_ankles(biped: Dimensions, foot: Foot, x: float, y: float, heading: float) -> Place:
    """From the ankle above a foot to that of the other one there [m]."""
    one, other = sole_heading(biped, foot.side, foot.heading), sole_heading(biped, 1 - foot.side, heading)
    back = biped.foot.ankle_forward
    return x - foot.x + back * (cos(other) - cos(one)), y - foot.y + back * (sin(other) - sin(one))


@jit_borrowing
def shanks_apart(biped: Dimensions, foot: Foot, x: float, y: float, heading: float) -> bool:
    """Whether legs that stand on a foot, and on the other one there, keep apart at their ankles: heels are not put together."""
    dx, dy = _between_ankles(biped, foot, x, y, heading)
    return hypot(dx, dy) >= HEELS * biped.leg.shank_radius - TOUCH


@jit_borrowing
def apart_from(biped: Dimensions, foot: Foot, place: Place, heading: float) -> Place:
    """A place for the other foot, or one so much further outward that shanks keep apart.

    |d + k o| = r with d between the ankles, o outward and r what they need.
    """
    if hypot(place[0] - foot.x, place[1] - foot.y) > HEELS * biped.leg.shank_radius + 2 * abs(biped.foot.ankle_forward):
        return place  # ahead or behind, as nearly always
    dx, dy = _between_ankles(biped, foot, place[0], place[1], heading)
    sign, r = 1.0 if foot.side != LEFT else -1.0, HEELS * biped.leg.shank_radius
    ox, oy = -sign * sin(heading), sign * cos(heading)
    along, square = dx * ox + dy * oy, dx * dx + dy * dy
    if square >= r * r or along < 0:  # across the other foot: that is no place at all
        return place
    k = sqrt(along * along - square + r * r) - along
    return place[0] + k * ox, place[1] + k * oy


@jit_borrowing
def keeps_apart(biped: Dimensions, foot: Foot, x: float, y: float, heading: float) -> bool:
    """Whether a place for the other foot lies on its own side of this one: feet are not set down upon each other."""
    c, s = cos(foot.heading), sin(foot.heading)
    dx, dy = x - foot.x, y - foot.y
    ahead, aside = dx * c + dy * s, dy * c - dx * s
    own = -aside if foot.side == LEFT else aside
    is_beside = own >= (ACROSS if abs(ahead) > 1.2 * biped.foot.length else BESIDE) * biped.gait.step_width
    return is_beside and shanks_apart(biped, foot, x, y, heading)
