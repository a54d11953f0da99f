"""The swinging foot: a function of its two footprints, its lift and the share s of the swing that has passed (section 2.5).

The ball goes along the line between the footprints by the quintic 10 x^3 - 15 x^4 + 6 x^5, at rest at both ends, and is raised
by lift * bump(s). Over edges (`hold`) the foot rises before it goes forward and comes down after it has arrived. The pitch
with which the foot left fades, its toes straighten a little sooner. Where the line would come too near to the other foot it
bows outward: a left foot goes by on the left, a right foot on the right, as on the outside of a sharp turn. A foot that rolls
from its heel comes in with the toes up, turned about the heel, and lays the sole down in the last STRIKE of the swing, so that
it is flat, and the toe in place, at the contact.
"""

from math import asin, cos, sin, sqrt
from typing import NamedTuple

from motion.arithmetic.gravity import pendulum_time
from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.track import foot
from motion.track.footprints import LEFT, Footprints
from worlds.compiled.jit import jit_borrowing, jit_inline

HOLD, EDGE_HOLD = 0.04, 0.15
"""Share of the swing, at either end, in which the foot goes only up or down: on smooth ways, and over edges."""
FLEX_FADE = 0.5
"""Share of the swing in which the toes straighten."""
PITCH_FADE = 0.6
"""Share of the swing in which the foot becomes parallel to the ground again."""
SIDEWAYS = 0.3
"""A swing that goes ahead by less than this share of its way passes the other foot on whichever side it is."""
MOST_ROOM = 0.5
"""Largest bow as a share of the way."""
QUICK, CALM = 0.6, 1.2
"""Swing times, in pendulum times of the nominal leg, up to which a foot lands flat, and from which on its heel may strike."""
TOES_UP, STRIKE = 0.45, 0.12
"""Shares of the swing: from when on the toes rise for the heel strike, and how long before its end the sole comes down."""


class Sole(NamedTuple):
    """Where a swinging sole is."""

    ball: Triple
    heading: float  # [rad]
    normal: Triple
    pitch: float  # of the foot about its ball, heel up [rad]
    flex: float  # of the toes against it [rad]


@jit_borrowing
def progress(s: float, hold: float) -> float:
    """Share of the way at share s of the swing: nothing for the first and last `hold`, smooth to the second derivative."""
    s = min(max((s - hold) / (1 - 2 * hold), 0.0), 1.0)
    return s * s * s * (10 - 15 * s + 6 * s * s)


@jit_borrowing
def bump(s: float) -> float:
    """Share of the lift: 16 s^2 (1 - s)^2, 1 in the middle."""
    return 16 * s * s * (1 - s) * (1 - s)


@jit_borrowing
def fade(s: float, end: float) -> float:
    """From 1 at 0 to 0 at `end`, smooth at both."""
    x = min(s / end, 1.0)
    return 1 - x * x * (3 - 2 * x)


@jit_borrowing
def swing_time(footprints: Footprints, before: int, after: int) -> float:
    """How long the foot is in the air between two of its footprints [s]."""
    return footprints.contact_time[after] - footprints.contact_time[before] - footprints.stance_time[before]


@jit_inline
def toes_up(biped: Dimensions, footprints: Footprints, before: int, after: int, s: float) -> float:
    """Pitch, toes up [rad], at share s of a swing: for a landing on the heel, in a swing with time for it."""
    landing = biped.foot.heel_strike_angle * max(1 - 2 * footprints.roll[after, 0], 0.0)
    if landing == 0.0:
        return 0.0
    calm = (swing_time(footprints, before, after) / pendulum_time(biped.leg.nominal_length) - QUICK) / (CALM - QUICK)
    rising = 1 - fade(max(s - TOES_UP, 0.0), 1 - STRIKE - TOES_UP)
    return landing * (1 - fade(max(calm, 0.0), 1.0)) * rising * fade(max(s - 1 + STRIKE, 0.0), STRIKE)


@jit_borrowing
def share_at(gone: float, hold: float) -> float:
    """Share s of the swing at which progress(s, hold) is about `gone`: by the inverse of 3 x^2 - 2 x^3, close to it."""
    return hold + (1 - 2 * hold) * (0.5 - sin(asin(min(max(1 - 2 * gone, -1.0), 1.0)) / 3))


@jit_borrowing
def room_beside(biped: Dimensions) -> float:
    """How far [m] a swinging foot's middle keeps from that of the other foot when it passes it: both shanks and half a sole."""
    return 0.5 * biped.foot.width + 2 * biped.leg.shank_radius


@jit_borrowing
def outward(
    biped: Dimensions, footprints: Footprints, before: int, after: int, start: Triple, goal: Triple
) -> tuple[float, float]:
    """Sideways offset (x, y) [m] in the middle of a swing, so that it keeps its room where it passes the other foot.

    That foot is the one that landed in between, whether it still stands or not.
    """
    dx, dy = goal[0] - start[0], goal[1] - start[1]
    length2 = dx * dx + dy * dy
    if after - 1 == before or length2 < 1e-6:
        return 0.0, 0.0
    other = footprints.position[after - 1]
    u = ((other[0] - start[0]) * dx + (other[1] - start[1]) * dy) / length2
    if u <= 0 or u >= 1:
        return 0.0, 0.0
    length = sqrt(length2)
    to_left = ((other[0] - start[0]) * dy - (other[1] - start[1]) * dx) / length
    yaw = 0.5 * (footprints.heading[before] + footprints.heading[after])
    ahead = (dx * cos(yaw) + dy * sin(yaw)) / length
    side = 1.0 if (footprints.side[after] == LEFT) == (ahead > 0) else -1.0
    if abs(ahead) < SIDEWAYS:
        side = 1.0 if to_left > 0 else -1.0
    lack = max(room_beside(biped) - side * to_left, 0.0)
    ends = min(1.0, 4 * u, 4 * (1 - u))
    amount = side * min(lack * ends, MOST_ROOM * length) / max(bump(share_at(u, footprints.hold[after])), 0.3)
    return -amount * dy / length, amount * dx / length


@jit_inline
def sole_at(biped: Dimensions, footprints: Footprints, before: int, after: int, s: float) -> Sole:
    """Where the sole is at share s of the swing from footprint `before` to `after`."""
    start = foot.along_sole(footprints, before, biped.foot.ball_forward, 0.0)
    goal = foot.along_sole(footprints, after, biped.foot.ball_forward, 0.0)
    gone = progress(s, footprints.hold[after])
    ox, oy = outward(biped, footprints, before, after, start, goal)
    rise = bump(s)
    ball = (
        start[0] + gone * (goal[0] - start[0]) + rise * ox,
        start[1] + gone * (goal[1] - start[1]) + rise * oy,
        start[2] + gone * (goal[2] - start[2]) + footprints.lift[after] * rise,
    )
    heading = footprints.heading[before] + gone * (footprints.heading[after] - footprints.heading[before])
    normal = _normal_between(footprints, before, after, gone)
    up = toes_up(biped, footprints, before, after, s)
    left_with = foot.leaving_angle(biped, footprints.roll[before, 1])
    pitch = left_with * fade(s, PITCH_FADE) - up
    return Sole(_about_heel(biped, ball, heading, normal, up), heading, normal, pitch, left_with * fade(s, FLEX_FADE))


@jit_inline
def _normal_between(footprints: Footprints, before: int, after: int, gone: float) -> Triple:
    """The sole's normal at a share of the way."""
    x = footprints.normal[before, 0] + gone * (footprints.normal[after, 0] - footprints.normal[before, 0])
    y = footprints.normal[before, 1] + gone * (footprints.normal[after, 1] - footprints.normal[before, 1])
    z = footprints.normal[before, 2] + gone * (footprints.normal[after, 2] - footprints.normal[before, 2])
    length = (x * x + y * y + z * z) ** 0.5
    return x / length, y / length, z / length


@jit_inline
def _about_heel(biped: Dimensions, ball: Triple, heading: float, normal: Triple, up: float) -> Triple:
    """The ball of a foot that is turned about its heel by `up` [rad], toes up."""
    reach = 0.5 * biped.foot.length + biped.foot.ball_forward
    return foot.on_sole(ball, foot.sole_axis(heading, normal), normal, reach * (cos(up) - 1), reach * sin(up))


@jit_inline
def point_of_foot(sole: Sole, forward: float, up: float, pitch: float) -> Triple:
    """World point of the foot at (forward of the ball, up), pitched about the ball with the heel rising."""
    c, s = cos(pitch), sin(pitch)
    axis = foot.sole_axis(sole.heading, sole.normal)
    return foot.on_sole(sole.ball, axis, sole.normal, c * forward + s * up, c * up - s * forward)
