"""Posing the legs: feet that stand or swing, and what lies between them and the hips.

Standing and swinging are both worked out, and chosen between: of characters side by side some stand and some swing.
"""

from typing import NamedTuple

from motion.arithmetic.functions import levelled, turn
from motion.arithmetic.gravity import pendulum_time
from motion.arithmetic.smooth import fade, positive, smoothstep
from motion.arithmetic.triples import Triple, dot, minus, norm, pick, plus, times
from motion.characters.dimensions import Dimensions
from motion.pose import legs, swing
from motion.pose.pose import Hips
from motion.pose.swing import Sole
from motion.track import foot
from motion.track.curve import Track, place_at
from motion.track.footprints import Footprints
from motion.track.heading import body_heading
from motion.track.leg import (
    BENT,
    FREE_ENDS,
    OPENS,
    Lengths,
    landing_reach,
    leaving_reach,
    nominal_at,
    shortest_over,
    swing_length,
)
from motion.track.pelvis import pelvis_at
from motion.track.tilt import eased, tilt_of, tilted
from worlds.compiled.across import any_of, isnt
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, choose, larger, smaller
from worlds.compiled.tables import newest

KNEE_TURN, WITH_TOES = 1.0, 0.65
"""Legs bend toward the toes, by this share of their turn from the body, but no farther than so much [rad], so that knees keep
apart and no foot is twisted off its knee."""
CARRIED_FROM, CARRIED = 4.0, 5.5
"""Swing times, in pendulum times, from which on a foot is carried with the body, and from which on wholly."""
CARRIED_ENDS, HANGS = 0.35, (0.3, 0.72)
"""Share of the swing, at either end, over which that sets in; where the ankle hangs, back and down from the hip, in legs."""
UNDER_HIP = 1.2
"""Distance aside of its hip, in shortest legs, from which on a swinging ankle may be as high as the hip."""
PASSES, CHANGES = 0.044, 0.1
"""Way of the hip past a standing foot, in nominal legs, and share of its stance, over which it changes from tilting about the
heel to about the ball."""


class Step(NamedTuple):
    """What a foot does at a time: it stands on footprint `last`, or is on its way from there to `following`."""

    last: Some
    following: Some
    stands: Some  # whether it is in its stance
    swings: Some  # whether it is on its way; neither: its next footprint is not known
    s: Some  # share of the swing that has passed


class Foot(NamedTuple):
    """Its joints."""

    heel: Triple
    ball: Triple
    ankle: Triple
    toe: Triple


class Leg(NamedTuple):
    """A leg, and what it does."""

    hip: Triple
    knee: Triple
    hock: Triple
    foot: Foot
    support: Triple  # where it presses, if it stands
    stands: Some
    comfort: Some  # what it costs (paper, section 2.4)


@jit_borrowing
def footprints_at(footprints: Footprints, leg: int, t: Some) -> tuple[Some, Some]:
    """(last, next) footprint of foot `leg` at time t: it stands on last, or swings from it to next; -1 for none."""
    side, end = footprints.side, len(footprints.side)
    last = newest(footprints.contact_time, t)
    following = last + 1
    seeks = (last >= 0) & (side[larger(last, 0)] != leg)
    while any_of(seeks):
        last = choose(seeks, last - 1, last)
        seeks = (last >= 0) & (side[larger(last, 0)] != leg)
    seeks = (following < end) & (side[smaller(following, end - 1)] != leg)
    while any_of(seeks):
        following = choose(seeks, following + 1, following)
        seeks = (following < end) & (side[smaller(following, end - 1)] != leg)
    return last, choose(following < end, following, -1)


@jit_borrowing
def _step_at(footprints: Footprints, leg: int, t: Some) -> Step:
    last, following = footprints_at(footprints, leg, t)
    before, after = larger(last, 0), larger(following, 0)
    left = footprints.contact_time[before] + footprints.stance_time[before]
    stands = (last >= 0) & (t < left)
    s = smaller(larger((t - left) / (footprints.contact_time[after] - left), 0.0), 1.0)
    swings = isnt(stands) & (last >= 0) & (following >= 0)
    return Step(choose(last >= 0, last, after), choose(following >= 0, after, before), stands, swings, s)


@jit_inline
def _pick_sole(truth: Some, yes: Sole, no: Sole) -> Sole:
    return Sole(
        pick(truth, yes.ball, no.ball), choose(truth, yes.heading, no.heading), pick(truth, yes.axis, no.axis),
        pick(truth, yes.normal, no.normal), choose(truth, yes.pitch, no.pitch), choose(truth, yes.flex, no.flex),
    )  # fmt: skip


@jit_inline
def _foot_of(biped: Dimensions, sole: Sole) -> Foot:
    ball, half, pitch = biped.foot.ball_forward, 0.5 * biped.foot.length, sole.pitch
    return Foot(
        swing.point_of_foot(sole, -half - ball, 0.0, pitch),
        sole.ball,
        swing.point_of_foot(sole, biped.foot.ankle_forward - ball, biped.foot.ankle_height, pitch),
        swing.point_of_foot(sole, half - ball, 0.0, pitch - sole.flex),
    )


@jit_inline
def _moved(foot: Foot, share: Some, way: Triple) -> Foot:
    """A foot that has gone a share of a way."""
    by = times(share, way)
    return Foot(plus(foot.heel, by), plus(foot.ball, by), plus(foot.ankle, by), plus(foot.toe, by))


@jit_inline
def _pick_foot(truth: Some, yes: Foot, no: Foot) -> Foot:
    return Foot(
        pick(truth, yes.heel, no.heel), pick(truth, yes.ball, no.ball), pick(truth, yes.ankle, no.ankle),
        pick(truth, yes.toe, no.toe),
    )  # fmt: skip


@jit_borrowing
def _carry(biped: Dimensions, hip: Triple, yaw: Some, time: Some, s: Some, foot: Foot) -> Foot:
    """Lets a foot that swings for long, as the free one in hops on the other leg, hang behind its hip meanwhile."""
    nominal, ankle = biped.leg.nominal_length, foot.ankle
    long = (time / pendulum_time(nominal) - CARRIED_FROM) / (CARRIED - CARRIED_FROM)
    if not any_of(long > 0.0):
        return foot
    share = (1 - fade(long, 1.0)) * (1 - fade(smaller(s, 1 - s), CARRIED_ENDS))
    back, down, (c, z) = HANGS[0] * nominal, HANGS[1] * nominal, turn(yaw)
    up = larger(hip[2] - down - ankle[2], 0.0)  # never lower than on its own way: who lands low would push it into the ground
    return _moved(foot, share, (hip[0] - back * c - ankle[0], hip[1] - back * z - ankle[1], up))


@jit_borrowing
def _stood(biped: Dimensions, track: Track, step: Step, leg: int, t: Some) -> Some:
    """Length [m] of the leg that stood before a swing, or will stand after it, for a time t near that end of it; else 0.

    The solver keeps it within its reach, but not always: it is a cost.
    """
    footprints, curve, last, following = track.footprints, track.curve, step.last, step.following
    left, landed = footprints.contact_time[last] + footprints.stance_time[last], footprints.contact_time[following]
    ends = OPENS * (landed - left)
    leaves = t < left + ends
    then, n, u = choose(leaves, left, landed), choose(leaves, last, following), choose(leaves, 1.0, 0.0)
    known = (then >= curve.time[0]) & (then <= curve.time[len(curve.time) - 1])
    known = known & ((n == last) | (t >= footprints.contact_time[larger(following - 1, 0)]))
    near = step.swings & known & (abs(t - then) <= ends)
    if not any_of(near):
        return 0.0 * then
    by, roll = pelvis_at(biped, footprints, then)
    hip = plus(place_at(curve, then), foot.hip_offset(biped, leg, body_heading(biped, footprints, then) + by, roll))
    return choose(near, norm(minus(hip, foot.stance_ankle(biped, footprints, n, u))), 0.0)


@jit_borrowing
def _leans(biped: Dimensions, footprints: Footprints, n: Some, u: Some, ahead: Some) -> Some:
    """How a foot may tilt: about its heel below 0, wholly from -1 on; about its ball above 0, wholly from 1 on.

    By how far [m] the hip is ahead of its ankle; but while it rolls down from its heel about that, and from its heel-off on
    about its ball. All of it sets in by and by, so that a leg that is too long all along changes over without a jump.
    """
    lean = smaller(larger(ahead / (PASSES * biped.leg.nominal_length), -1.0), 1.0)
    down, off = larger(2 * (u - foot.FLAT_BY) / CHANGES - 1, -1.0), 1 - biped.foot.heel_off_fraction
    lean = choose(footprints.strike[n] > 0.0, smaller(lean, down), lean)
    rises = smaller(1 - 2 * (off - u) / CHANGES, 1.0)
    return choose(foot.leaving_angle(biped, footprints, n) > 0.0, larger(lean, rises), lean)


@jit_borrowing
def _tilt(biped: Dimensions, footprints: Footprints, step: Step, u: Some, hip: Triple, feet: Foot) -> Foot:
    """Tilts a foot whose leg would be too long, standing or nearly: about its heel while it comes down or the hip is behind it,
    then about its ball. Where the hip passes over it the leg is shortest: it seldom has to."""
    lands = step.swings & (step.s >= 0.5)
    n, v = choose(lands, step.following, step.last), choose(lands, 0.0, choose(step.swings, 1.0, u))
    free = (step.stands | step.swings) & (foot.strike_pitch(footprints, n, v) >= 0.0)  # else it comes down about its ball
    along = minus(feet.ball, feet.heel)
    lean = _leans(biped, footprints, n, v, dot(minus(hip, feet.ankle), along) / norm(along))
    heel = lean < 0.0
    tilt = tilt_of(pick(heel, feet.heel, feet.ball), pick(heel, feet.ball, feet.heel), feet.ankle, hip, biped.leg.max_length)
    if not any_of(free & (tilt.by > 0.0)):
        return feet
    tilt = eased(tilt, choose(free, smoothstep(abs(lean)), 0.0))
    return Foot(
        pick(heel, feet.heel, tilted(tilt, feet.heel)),
        pick(heel, tilted(tilt, feet.ball), feet.ball),
        tilted(tilt, feet.ankle),
        pick(heel, tilted(tilt, feet.toe), feet.toe),
    )


@jit_borrowing
def _keep_below(shortest: Some, hip: Triple, s: Some, foot: Foot) -> Foot:
    """Lowers a foot that swings past its hip, so that the leg hangs: by l (1 - (h / UNDER_HIP l)^2) at a distance h aside,
    l the shortest leg [m].

    Who steps down from a height sinks to the foot that it left there: drawn along the leg alone, that foot would go over the
    hip, and the knee turn over within a frame. It brushes the edge instead.
    """
    x, y, far = foot.ankle[0] - hip[0], foot.ankle[1] - hip[1], UNDER_HIP * shortest
    lack = shortest * (1 - (x * x + y * y) / (far * far)) - (hip[2] - foot.ankle[2])
    lower = positive(lack, (BENT - 1) * shortest)
    return _moved(foot, (1 - fade(smaller(s, 1 - s), FREE_ENDS)) * lower, (0.0, 0.0, -1.0))


@jit_borrowing
def _keep_in_reach(lengths: Lengths, hip: Triple, s: Some, kept: tuple[Some, Some], foot: Foot) -> Foot:
    """Draws a swinging foot along the line to its hip, so that its leg is never longer or more bent than it can be."""
    way = minus(foot.ankle, hip)
    length = larger(norm(way), 1e-6)
    return _moved(foot, swing_length(lengths, length, s, kept) / length - 1, way)


@jit_borrowing
def _kept(biped: Dimensions, track: Track, step: Step, leg: int, hip: Triple, at: tuple[Some, float], foot: Foot) -> Foot:
    """A swinging foot where its leg can be; at: the body's heading, and the time."""
    footprints, s, (yaw, t) = track.footprints, step.s, at
    foot = _carry(biped, hip, yaw, swing.swing_time(footprints, step.last, step.following), s, foot)
    ground = footprints.position[larger(step.following - 1, 0), 2]
    shortest = shortest_over(biped, hip[2] - ground - biped.foot.ankle_height)
    foot = _keep_below(shortest, hip, s, foot)
    lengths = Lengths(biped.leg.max_length, shortest, _stood(biped, track, step, leg, t))
    left, landed = larger(smaller(step.last + 1, len(footprints.side) - 1), 1), larger(step.following, 1)
    kept = (1 - leaving_reach(biped, footprints, left), 1 - landing_reach(biped, footprints, landed))
    return _keep_in_reach(lengths, hip, s, kept, foot)


@jit_borrowing
def pose_leg(biped: Dimensions, track: Track, leg: int, com: Triple, body: Hips, t: float) -> Leg:
    """The leg of a body whose centre of mass is there."""
    footprints, yaw, step = track.footprints, body.yaw, _step_at(track.footprints, leg, t)
    hip = plus(com, foot.hip_offset(biped, leg, yaw + body.turn, body.roll))
    n, u = step.last, foot.stance_share(footprints, step.last, t)
    sole = swing.standing_sole(biped, footprints, n, u)
    sole = _pick_sole(step.swings, swing.sole_at(biped, footprints, n, step.following, step.s), sole)
    joints = _foot_of(biped, sole)
    joints = _pick_foot(step.swings, _kept(biped, track, step, leg, hip, (yaw, t), joints), joints)
    joints = _tilt(biped, footprints, step, u, hip, joints)
    c, s = turn(yaw + KNEE_TURN * levelled(WITH_TOES * (sole.heading - yaw) / KNEE_TURN))
    knee, hock = legs.joints(biped, hip, joints.ankle, (c, s, 0.0 * s))
    lacks = norm(minus(hip, joints.ankle)) - nominal_at(biped, footprints, n, u)
    comfort = choose(step.stands, biped.leg.comfort_weight * lacks * lacks, 0.0)
    return Leg(hip, knee, hock, joints, foot.point_of_support(biped, footprints, n, u), step.stands, comfort)
