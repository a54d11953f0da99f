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

from typing import NamedTuple

from motion.arithmetic.functions import arc_sine, power, turn
from motion.arithmetic.smooth import fade, mix, smoothstep
from motion.arithmetic.triples import Triple, between, entries, plus, unit
from motion.characters.dimensions import Dimensions
from motion.track import foot
from motion.track.footprints import LEFT, Footprints
from worlds.compiled.across import any_of
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, choose, larger, root, smaller

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
    """Where a sole is, standing or swinging."""

    ball: Triple
    heading: Some  # [rad]
    axis: Triple  # unit vector along it, from heel to toe
    normal: Triple
    pitch: Some  # of the foot about its ball, heel up [rad]
    flex: Some  # of the toes against it [rad]


@jit_borrowing
def progress(s: Some, hold: Some, run: Some = 0.0) -> Some:
    """Share of the way at share s of the swing: none for the first and last `hold`, at rest at both ends; later at a `run`."""
    x = smaller(larger((s - hold) / (ARRIVED - 2 * hold), 0.0), 1.0)
    return smoothstep(power(x, mix(LATE_WALK, LATE_RUN, run)))


@jit_inline
def bump(s: Some) -> Some:
    """Share of the lift: 16 s^2 (1 - s)^2, 1 in the middle."""
    return 16 * s * s * (1 - s) * (1 - s)


@jit_borrowing
def swing_time(footprints: Footprints, before: Some, after: Some) -> Some:
    """How long the foot is in the air between two of its footprints [s]."""
    return footprints.contact_time[after] - footprints.contact_time[before] - footprints.stance_time[before]


@jit_inline
def toes_up(footprints: Footprints, before: Some, after: Some, s: Some) -> Some:
    """Pitch, toes up about the heel [rad], or below 0 heel up about the ball, at share s of a swing: a cubic from rest to the
    landing's angle and rate."""
    span = 1 - TOES_UP
    x, falling = larger((s - TOES_UP) / span, 0.0), span * swing_time(footprints, before, after)
    return footprints.strike[after] * smoothstep(x) + falling * foot.strike_rate(footprints, after) * x * x * (1 - x)


@jit_inline
def heel_up(biped: Dimensions, footprints: Footprints, before: Some, after: Some, s: Some) -> Some:
    """Pitch, heel up about the ball [rad], at share s of a swing: a cubic from the leaving's angle and rate to rest."""
    time, left_with = swing_time(footprints, before, after), foot.leaving_angle(biped, footprints, before)
    run = foot.runs(footprints, before)
    end = smaller(mix(PITCH_WALK, PITCH_RUN, run), PITCH_STANCES * footprints.stance_time[before] / time)
    height = footprints.position[after, 2] - footprints.position[before, 2]
    end *= 1 - LEVELS * smoothstep(abs(height) / (HIGH_STEP * biped.leg.nominal_length))
    x = smaller(s / end, 1.0)
    folded = left_with * (fade(x, 1.0) + KICK * run * bump(x))
    return folded + end * time * foot.leaving_rate(biped, footprints, before) * x * (1 - x) * (1 - x)


@jit_borrowing
def share_at(gone: Some, hold: Some, run: Some) -> Some:
    """Share s of the swing at which progress(s, hold, run) is `gone`."""
    _, sine = turn(arc_sine(smaller(larger(1 - 2 * gone, -1.0), 1.0)) / 3)
    return hold + (ARRIVED - 2 * hold) * power(0.5 - sine, 1 / mix(LATE_WALK, LATE_RUN, run))


@jit_borrowing
def room_beside(biped: Dimensions, run: Some) -> Some:
    """How far [m] a swinging foot's middle keeps from that of the other foot when it passes it: both shanks and
    a sole, as a bent leg leans inward. A runner's foot passes high, where the other leg is on its way out to its hip."""
    return (biped.foot.width + 2 * biped.leg.shank_radius) * (1 - run * (1 - HIGH_UP))


@jit_borrowing
def outward(
    biped: Dimensions, footprints: Footprints, before: Some, after: Some, start: Triple, goal: Triple
) -> tuple[Some, Some]:
    """Sideways offset (x, y) [m] in the middle of a swing, so that it keeps its room where it passes the other foot.

    That foot is the one that landed in between, whether it still stands or not.
    """
    between_them = larger(after - 1, 0)
    other, yaw = footprints.position[between_them], 0.5 * (footprints.heading[before] + footprints.heading[after])
    run, share = foot.runs(footprints, before), choose(between_them == before, 0.0, footprints.bow[after])
    x, y = bow(biped, start, goal, (other[0], other[1]), yaw, footprints.side[after], footprints.hold[after], run)
    return share * x, share * y


@jit_borrowing
def bow(
    biped: Dimensions, start: Triple, goal: Triple, other: tuple[Some, Some], yaw: Some, which: Some, hold: Some, run: Some
) -> tuple[Some, Some]:  # fmt: skip
    """That offset for foot `which` on its way from start to goal, heading `yaw` [rad], past the other foot's place."""
    dx, dy = goal[0] - start[0], goal[1] - start[1]
    length2 = dx * dx + dy * dy
    length = root(larger(length2, 1e-6))
    ox, oy = other[0] - start[0], other[1] - start[1]
    u = (ox * dx + oy * dy) / (length * length)
    to_left = (ox * dy - oy * dx) / length
    c, s = turn(yaw)
    ahead = (dx * c + dy * s) / length
    own = choose(which == LEFT, ahead, -ahead) > 0
    side = choose(abs(ahead) < SIDEWAYS, choose(to_left > 0, 1.0, -1.0), choose(own, 1.0, -1.0))
    ends = choose(length2 < 1e-6, 0.0, smaller(1.0, smaller(4 * u, 4 * (1 - u))))
    lack = larger(room_beside(biped, run) - side * to_left, 0.0) * larger(ends, 0.0)
    if not any_of(lack > 0.0):  # mostly
        return 0.0 * lack, 0.0 * lack
    amount = side * smaller(lack, MOST_ROOM * length) / larger(bump(share_at(u, hold, run)), 0.3)
    return -amount * dy / length, amount * dx / length


@jit_inline
def _toss(biped: Dimensions, footprints: Footprints, before: Some, s: Some) -> Some:
    """How much higher [m] the foot goes early in its swing, thrown up by its leaving, before the toes pass near the ground."""
    rolled = larger(2 * footprints.roll[before, 1] - 1, 0.0) * (1 - foot.runs(footprints, before))
    return TOSS * rolled * biped.foot.heel_off_angle * biped.foot.length * bump(smaller(s / TOSS_ENDS, 1.0))


@jit_inline
def sole_at(biped: Dimensions, footprints: Footprints, before: Some, after: Some, s: Some) -> Sole:
    """Where the sole is at share s of the swing from footprint `before` to `after`."""
    start = foot.along_sole(footprints, before, biped.foot.ball_forward, 0.0)
    goal = foot.along_sole(footprints, after, biped.foot.ball_forward, 0.0)
    gone, rise = progress(s, footprints.hold[after], foot.runs(footprints, before)), bump(s)
    ox, oy = outward(biped, footprints, before, after, start, goal)
    aside = (rise * ox, rise * oy, footprints.lift[after] * rise + _toss(biped, footprints, before, s))
    leaving = footprints.heading[before] + foot.pivot(biped.reach.max_turn, footprints, before)
    heading = mix(leaving, footprints.heading[after], gone)
    normal = unit(between(entries(footprints.normal[before]), entries(footprints.normal[after]), gone))
    pitch, up = heel_up(biped, footprints, before, after, s), toes_up(footprints, before, after, s)
    flex = pitch * fade(s, FLEX_FADE)
    ball = plus(between(start, goal, gone), aside)
    return turned_sole(biped, Sole(ball, heading, ball, normal, pitch - up, flex + larger(-up, 0.0)), pitch - flex, up)


@jit_inline
def standing_sole(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> Sole:
    """Where the sole is at share u of the stance on footprint n (motion.track.foot)."""
    ball = foot.along_sole(footprints, n, biped.foot.ball_forward, 0.0)
    heading = footprints.heading[n] + foot.turned_by(biped, footprints, n, u)
    up, pitch = larger(foot.strike_pitch(footprints, n, u), 0.0), foot.heel_up(biped, footprints, n, u)
    return turned_sole(biped, Sole(ball, heading, ball, entries(footprints.normal[n]), pitch - up, pitch), 0.0 * up, up)


@jit_inline
def turned_sole(biped: Dimensions, sole: Sole, toes: Some, up: Some) -> Sole:
    """A sole, with its axis, that is turned toes down by `toes` [rad] about their tip, and toes up by `up` about its heel."""
    tip, reach = 0.5 * biped.foot.length - biped.foot.ball_forward, 0.5 * biped.foot.length + biped.foot.ball_forward
    (c, s), (d, z) = turn(toes), turn(larger(up, 0.0))
    axis = foot.sole_axis(sole.heading, sole.normal)
    ball = foot.on_sole(sole.ball, axis, sole.normal, tip * (1 - c) + reach * (d - 1), tip * s + reach * z)
    return Sole(ball, sole.heading, axis, sole.normal, sole.pitch, sole.flex)


@jit_inline
def point_of_foot(sole: Sole, forward: Some, up: Some, pitch: Some) -> Triple:
    """World point of the foot at (forward of the ball, up), pitched about the ball with the heel rising."""
    c, s = turn(pitch)
    return foot.on_sole(sole.ball, sole.axis, sole.normal, c * forward + s * up, c * up - s * forward)
