"""The swinging foot: a function of its two footprints, its lift and the share s of the swing that has passed (section 2.5).

A foot leaves by rolling over its toes, and lands as it will roll on: position and velocity of all of its points are those of
the stance before and after it (motion.track.foot). Turns are laid over one way:

    way     the flat foot's, along the line between the footprints by 3 x^2 - 2 x^3, raised by lift * bump(s)
    pitch   of the foot, heel up: from the angle and with the rate at which it left, to none at PITCH_WALK
    toes    straighten within FLEX_FADE; until then the foot turns about their tip, so that they clear the ground
    strike  toes up about the heel, or heel up about the ball, from TOES_UP on, to the angle and rate with which the sole comes
            down after the contact

At a run the way is later (x a power of s), and the pitch higher (KICK) and longer: the shank folds. Over edges (`hold`) the
foot rises before it goes forward and comes down after it has arrived. Where the line would come too near to the other foot it
bows outward: a left foot goes by on the left, a right foot on the right, as on the outside of a sharp turn; less where a rock
is in its way there.
"""

from math import asin, cos, sin, sqrt
from typing import NamedTuple

from motion.arithmetic.smooth import fade, smoothstep
from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.track import foot
from motion.track.footprints import LEFT, Footprints
from worlds.compiled.jit import jit_borrowing, jit_inline

HOLD, EDGE_HOLD = 0.0, 0.15
"""Share of the swing, at either end, in which the foot goes only up or down: on smooth ways, and over edges."""
FLEX_FADE = 0.4
"""Share of the swing in which the toes straighten."""
PITCH_WALK, PITCH_RUN = 0.75, 0.93
"""Share of the swing in which the foot becomes parallel to the ground again."""
PITCH_STANCES = 2.5
"""The same in times of the stance before, at most: who carries a foot for long lets it hang flat."""
HIGH_STEP, LEVELS = 0.4, 0.4
"""Height between its footprints, in nominal legs, at which a foot is level sooner, and by which share: toes clear edges."""
LATE_WALK, LATE_RUN = 1.07, 1.55
"""How late a foot goes ahead: a power of the share of the swing."""
KICK = 0.85
"""How far a runner's shank folds the foot up behind, in angles with which it leaves."""
ARRIVED = 0.96
"""Share of the swing in which the foot comes to above its footprint."""
TOSS, TOSS_ENDS = 0.16, 0.46
"""Height of the foot early in a walker's swing, in the arc that its heel has risen by; until which share of the swing."""
SIDEWAYS = 0.3
"""A swing that goes ahead by less than this share of its way passes the other foot on whichever side it is."""
MOST_ROOM = 0.5
"""Largest bow as a share of the way."""
HIGH_UP = 0.5
"""Share of that room which a runner's foot needs."""
TOES_UP = 0.6
"""Share of the swing from which on the toes rise for a landing on the heel."""


class Sole(NamedTuple):
    """Where a swinging sole is."""

    ball: Triple
    heading: float  # [rad]
    normal: Triple
    pitch: float  # of the foot about its ball, heel up [rad]
    flex: float  # of the toes against it [rad]


@jit_borrowing
def progress(s: float, hold: float, run: float = 0.0) -> float:
    """Share of the way at share s of the swing: none for the first and last `hold`, at rest at both ends; later at a `run`."""
    x = min(max((s - hold) / (ARRIVED - 2 * hold), 0.0), 1.0)
    return smoothstep(x ** (LATE_WALK + run * (LATE_RUN - LATE_WALK)))


@jit_borrowing
def bump(s: float) -> float:
    """Share of the lift: 16 s^2 (1 - s)^2, 1 in the middle."""
    return 16 * s * s * (1 - s) * (1 - s)


@jit_borrowing
def swing_time(footprints: Footprints, before: int, after: int) -> float:
    """How long the foot is in the air between two of its footprints [s]."""
    return footprints.contact_time[after] - footprints.contact_time[before] - footprints.stance_time[before]


@jit_inline
def toes_up(footprints: Footprints, before: int, after: int, s: float) -> float:
    """Pitch, toes up about the heel [rad], or below 0 heel up about the ball, at share s of a swing: a cubic from rest to the
    landing's angle and rate."""
    if footprints.strike[after] == 0.0 or s <= TOES_UP:
        return 0.0
    span = 1 - TOES_UP
    x, falling = (s - TOES_UP) / span, span * swing_time(footprints, before, after) * foot.strike_rate(footprints, after)
    return footprints.strike[after] * smoothstep(x) + falling * x * x * (1 - x)


@jit_inline
def heel_up(biped: Dimensions, footprints: Footprints, before: int, after: int, s: float) -> float:
    """Pitch, heel up about the ball [rad], at share s of a swing: a cubic from the leaving's angle and rate to rest."""
    time, left_with = swing_time(footprints, before, after), foot.leaving_angle(biped, footprints, before)
    run = foot.runs(footprints, before)
    end = min(PITCH_WALK + run * (PITCH_RUN - PITCH_WALK), PITCH_STANCES * footprints.stance_time[before] / time)
    height = footprints.position[after, 2] - footprints.position[before, 2]
    end *= 1 - LEVELS * smoothstep(abs(height) / (HIGH_STEP * biped.leg.nominal_length))
    if left_with == 0.0 or s >= end:
        return 0.0
    x = s / end
    folded = left_with * (fade(x, 1.0) + KICK * run * bump(x))
    return folded + end * time * foot.leaving_rate(biped, footprints, before) * x * (1 - x) * (1 - x)


@jit_borrowing
def share_at(gone: float, hold: float, run: float) -> float:
    """Share s of the swing at which progress(s, hold, run) is `gone`."""
    x = 0.5 - sin(asin(min(max(1 - 2 * gone, -1.0), 1.0)) / 3)
    return hold + (ARRIVED - 2 * hold) * max(x, 0.0) ** (1 / (LATE_WALK + run * (LATE_RUN - LATE_WALK)))


@jit_borrowing
def room_beside(biped: Dimensions, run: float) -> float:
    """How far [m] a swinging foot's middle keeps from that of the other foot when it passes it: both shanks and
    a sole, as a bent leg leans inward. A runner's foot passes high, where the other leg is on its way out to its hip."""
    return (biped.foot.width + 2 * biped.leg.shank_radius) * (1 - run * (1 - HIGH_UP))


@jit_borrowing
def outward(
    biped: Dimensions, footprints: Footprints, before: int, after: int, start: Triple, goal: Triple
) -> tuple[float, float]:
    """Sideways offset (x, y) [m] in the middle of a swing, so that it keeps its room where it passes the other foot.

    That foot is the one that landed in between, whether it still stands or not.
    """
    if after - 1 == before:
        return 0.0, 0.0
    other, yaw = footprints.position[after - 1], 0.5 * (footprints.heading[before] + footprints.heading[after])
    run = foot.runs(footprints, before)
    x, y = bow(biped, start, goal, (other[0], other[1]), yaw, footprints.side[after], footprints.hold[after], run)
    return footprints.bow[after] * x, footprints.bow[after] * y


@jit_borrowing
def bow(
    biped: Dimensions, start: Triple, goal: Triple, other: tuple[float, float], yaw: float, which: int, hold: float, run: float
) -> tuple[float, float]:  # fmt: skip
    """That offset for foot `which` on its way from start to goal, heading `yaw` [rad], past the other foot's place."""
    dx, dy = goal[0] - start[0], goal[1] - start[1]
    length2 = dx * dx + dy * dy
    if length2 < 1e-6:
        return 0.0, 0.0
    u = ((other[0] - start[0]) * dx + (other[1] - start[1]) * dy) / length2
    if u <= 0 or u >= 1:
        return 0.0, 0.0
    length = sqrt(length2)
    to_left = ((other[0] - start[0]) * dy - (other[1] - start[1]) * dx) / length
    ahead = (dx * cos(yaw) + dy * sin(yaw)) / length
    side = 1.0 if (which == LEFT) == (ahead > 0) else -1.0
    if abs(ahead) < SIDEWAYS:
        side = 1.0 if to_left > 0 else -1.0
    lack = max(room_beside(biped, run) - side * to_left, 0.0)
    ends = min(1.0, 4 * u, 4 * (1 - u))
    amount = side * min(lack * ends, MOST_ROOM * length) / max(bump(share_at(u, hold, run)), 0.3)
    return -amount * dy / length, amount * dx / length


@jit_inline
def _toss(biped: Dimensions, footprints: Footprints, before: int, s: float) -> float:
    """How much higher [m] the foot goes early in its swing, thrown up by its leaving, before the toes pass near the ground."""
    if s >= TOSS_ENDS:
        return 0.0
    rolled = max(2 * footprints.roll[before, 1] - 1, 0.0) * (1 - foot.runs(footprints, before))
    return TOSS * rolled * biped.foot.heel_off_angle * biped.foot.length * bump(s / TOSS_ENDS)


@jit_inline
def sole_at(biped: Dimensions, footprints: Footprints, before: int, after: int, s: float) -> Sole:
    """Where the sole is at share s of the swing from footprint `before` to `after`."""
    start = foot.along_sole(footprints, before, biped.foot.ball_forward, 0.0)
    goal = foot.along_sole(footprints, after, biped.foot.ball_forward, 0.0)
    gone = progress(s, footprints.hold[after], foot.runs(footprints, before))
    ox, oy = outward(biped, footprints, before, after, start, goal)
    rise = bump(s)
    ball = (
        start[0] + gone * (goal[0] - start[0]) + rise * ox,
        start[1] + gone * (goal[1] - start[1]) + rise * oy,
        start[2] + gone * (goal[2] - start[2]) + footprints.lift[after] * rise + _toss(biped, footprints, before, s),
    )
    leaving = footprints.heading[before] + foot.pivot(biped.reach.max_turn, footprints, before)
    heading = leaving + gone * (footprints.heading[after] - leaving)
    normal = _normal_between(footprints, before, after, gone)
    pitch, up = heel_up(biped, footprints, before, after, s), toes_up(footprints, before, after, s)
    flex = pitch * fade(s, FLEX_FADE)
    ball = _turned(biped, ball, heading, normal, pitch - flex, max(up, 0.0))
    return Sole(ball, heading, normal, pitch - up, flex + max(-up, 0.0))


@jit_inline
def _normal_between(footprints: Footprints, before: int, after: int, gone: float) -> Triple:
    """The sole's normal at a share of the way."""
    x = footprints.normal[before, 0] + gone * (footprints.normal[after, 0] - footprints.normal[before, 0])
    y = footprints.normal[before, 1] + gone * (footprints.normal[after, 1] - footprints.normal[before, 1])
    z = footprints.normal[before, 2] + gone * (footprints.normal[after, 2] - footprints.normal[before, 2])
    length = (x * x + y * y + z * z) ** 0.5
    return x / length, y / length, z / length


@jit_inline
def _turned(biped: Dimensions, ball: Triple, heading: float, normal: Triple, toes: float, up: float) -> Triple:
    """The ball of a foot whose toes point down by `toes` [rad] about their tip, and which is turned by `up` about its heel."""
    tip, reach = 0.5 * biped.foot.length - biped.foot.ball_forward, 0.5 * biped.foot.length + biped.foot.ball_forward
    forward, rise = tip * (1 - cos(toes)) + reach * (cos(up) - 1), tip * sin(toes) + reach * sin(up)
    return foot.on_sole(ball, foot.sole_axis(heading, normal), normal, forward, rise)


@jit_inline
def point_of_foot(sole: Sole, forward: float, up: float, pitch: float) -> Triple:
    """World point of the foot at (forward of the ball, up), pitched about the ball with the heel rising."""
    c, s = cos(pitch), sin(pitch)
    axis = foot.sole_axis(sole.heading, sole.normal)
    return foot.on_sole(sole.ball, axis, sole.normal, c * forward + s * up, c * up - s * forward)
