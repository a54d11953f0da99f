"""Posing the legs: feet that stand or swing, and what lies between them and the hips."""

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from motion.arithmetic.smooth import fade, positive, smoothstep
from motion.arithmetic.triples import Triple, dot, minus, norm
from motion.characters.dimensions import Dimensions
from motion.pose import legs, swing
from motion.pose.pose import Hips, Pose, point_of
from motion.track import foot
from motion.track.curve import Track, position_at
from motion.track.footprints import Footprints
from motion.track.heading import body_heading
from motion.track.leg import BENT, FREE_ENDS, OPENS, Lengths, landing_reach, leaving_reach, shortest_over, swing_length
from motion.track.pelvis import pelvis_at
from motion.track.tilt import eased, tilt_of, tilted
from worlds.compiled.jit import jit_borrowing, jit_inline, stack_array

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
_empty_place = stack_array(1, 3)


@jit_borrowing
def footprints_at(footprints: Footprints, leg: int, t: float) -> tuple[int, int]:
    """(last, next) footprint of foot `leg` at time t: it stands on last, or swings from it to next; -1 for none."""
    last, following = -1, -1
    for i in range(len(footprints.side)):
        if footprints.side[i] == leg:
            if footprints.contact_time[i] <= t:
                last = i
            elif following < 0:
                following = i
    return last, following


@jit_inline
def _set(array: np.ndarray, c: int, leg: int, point: Triple) -> None:
    array[c, leg, 0], array[c, leg, 1], array[c, leg, 2] = point


@jit_inline
def _stand(biped: Dimensions, footprints: Footprints, n: int, t: float, pose: Pose, c: int, leg: int) -> float:
    """The foot on footprint n at time t, also where its next one is not known yet; returns its heading."""
    u = foot.stance_share(footprints, n, t)
    up, half = max(foot.strike_pitch(footprints, n, u), 0.0), 0.5 * biped.foot.length
    x, z = foot.about_heel(biped, biped.foot.ball_forward, 0.0, up)
    _set(pose.ball, c, leg, foot.standing_point(biped, footprints, n, u, x, z))
    x, z = foot.about_heel(biped, half, 0.0, up)
    _set(pose.toe, c, leg, foot.standing_point(biped, footprints, n, u, x, z))
    x, z = foot.rolled(biped, footprints, n, u, -half, 0.0)
    _set(pose.heel, c, leg, foot.standing_point(biped, footprints, n, u, x, z))
    _set(pose.ankle, c, leg, foot.stance_ankle(biped, footprints, n, u))
    return footprints.heading[n] + foot.turned_by(biped, footprints, n, u)


@jit_inline
def _fly(
    biped: Dimensions, footprints: Footprints, last: int, following: int, t: float, pose: Pose, c: int, leg: int
) -> tuple[float, float]:
    """The foot on its way from footprint `last` to `following`; returns the share of the swing and its heading."""
    left = footprints.contact_time[last] + footprints.stance_time[last]
    s = min(max((t - left) / (footprints.contact_time[following] - left), 0.0), 1.0)
    sole, ball = swing.sole_at(biped, footprints, last, following, s), biped.foot.ball_forward
    _set(pose.ball, c, leg, sole.ball)
    _set(pose.heel, c, leg, swing.point_of_foot(sole, -0.5 * biped.foot.length - ball, 0.0, sole.pitch))
    _set(pose.toe, c, leg, swing.point_of_foot(sole, 0.5 * biped.foot.length - ball, 0.0, sole.pitch - sole.flex))
    _set(pose.ankle, c, leg, swing.point_of_foot(sole, biped.foot.ankle_forward - ball, biped.foot.ankle_height, sole.pitch))
    return s, sole.heading


@jit_inline
def _move(pose: Pose, c: int, leg: int, share: float, way: Triple) -> None:
    """Moves a swinging foot by a share of a way."""
    for array in (pose.ankle, pose.heel, pose.ball, pose.toe):
        array[c, leg, 0] += share * way[0]
        array[c, leg, 1] += share * way[1]
        array[c, leg, 2] += share * way[2]


@jit_inline
def _carry(biped: Dimensions, hip: Triple, yaw: float, time: float, s: float, pose: Pose, c: int, leg: int) -> None:
    """Lets a foot that swings for long, as the free one in hops on the other leg, hang behind its hip meanwhile."""
    nominal = biped.leg.nominal_length
    long = (time / pendulum_time(nominal) - CARRIED_FROM) / (CARRIED - CARRIED_FROM)
    if long <= 0:
        return
    share = (1 - fade(long, 1.0)) * (1 - fade(min(s, 1 - s), CARRIED_ENDS))
    back, down, ankle = HANGS[0] * nominal, HANGS[1] * nominal, pose.ankle[c, leg]
    up = max(hip[2] - down - ankle[2], 0.0)  # never lower than on its own way: who lands low would push it into the ground
    way = (hip[0] - back * np.cos(yaw) - ankle[0], hip[1] - back * np.sin(yaw) - ankle[1], up)
    _move(pose, c, leg, share, way)


@jit_borrowing
def _kept_back(biped: Dimensions, footprints: Footprints, last: int, following: int) -> tuple[float, float]:
    """Shares of its reach that a swinging leg does not take, as it leaves and as it lands (motion.track.foot)."""
    return 1 - leaving_reach(biped, footprints, last + 1), 1 - landing_reach(biped, footprints, following)


@jit_borrowing
def _stood(biped: Dimensions, track: Track, swings: tuple[int, int], leg: int, t: float) -> float:
    """Length [m] of the leg that stood before a swing, or will stand after it, for a time t near that end of it; else 0.

    The solver keeps it within its reach, but not always: it is a cost. `swings`: the footprints from and to which it swings.
    """
    footprints, curve, (last, following) = track.footprints, track.curve, swings
    left, landed = footprints.contact_time[last] + footprints.stance_time[last], footprints.contact_time[following]
    ends = OPENS * (landed - left)
    then, n, u = (left, last, 1.0) if t < left + ends else (landed, following, 0.0)
    known = curve.time[0] <= then <= curve.time[-1] and (n == last or t >= footprints.contact_time[following - 1])
    if abs(t - then) > ends or not known:
        return 0.0
    place = _empty_place()[0]
    position_at(curve, then, place)
    turn, roll = pelvis_at(biped, footprints, then)
    hip = foot.hip_offset(biped, leg, body_heading(biped, footprints, then) + turn, roll)
    ankle = foot.stance_ankle(biped, footprints, n, u)
    x, y, z = place[0] + hip[0] - ankle[0], place[1] + hip[1] - ankle[1], place[2] + hip[2] - ankle[2]
    return np.sqrt(x * x + y * y + z * z)


@jit_inline
def _keep_in_reach(lengths: Lengths, hip: Triple, s: float, kept: tuple[float, float], pose: Pose, c: int, leg: int) -> None:
    """Draws a swinging foot along the line to its hip, so that its leg is never longer or more bent than it can be."""
    ankle = pose.ankle[c, leg]
    x, y, z = ankle[0] - hip[0], ankle[1] - hip[1], ankle[2] - hip[2]
    length = max(np.sqrt(x * x + y * y + z * z), 1e-6)
    _move(pose, c, leg, swing_length(lengths, length, s, kept) / length - 1, (x, y, z))


@jit_borrowing
def _leans(biped: Dimensions, footprints: Footprints, n: int, u: float, ahead: float) -> float:
    """How a foot may tilt: about its heel below 0, wholly from -1 on; about its ball above 0, wholly from 1 on.

    By how far [m] the hip is ahead of its ankle; but while it rolls down from its heel about that, and from its heel-off on
    about its ball. All of it sets in by and by, so that a leg that is too long all along changes over without a jump.
    """
    lean, begin = min(max(ahead / (PASSES * biped.leg.nominal_length), -1.0), 1.0), 1 - biped.foot.heel_off_fraction
    if footprints.strike[n] > 0:
        lean = min(lean, max(2 * (u - foot.FLAT_BY) / CHANGES - 1, -1.0))
    if foot.leaving_angle(biped, footprints, n) > 0:
        lean = max(lean, min(1 - 2 * (begin - u) / CHANGES, 1.0))
    return lean


@jit_inline
def _tilt(biped: Dimensions, footprints: Footprints, n: int, u: float, hip: Triple, pose: Pose, c: int, leg: int) -> None:
    """Tilts a foot whose leg would be too long, standing or nearly: about its heel while it comes down or the hip is behind it,
    then about its ball. Where the hip passes over it the leg is shortest: it seldom has to."""
    if foot.strike_pitch(footprints, n, u) < 0:  # it comes down about its ball
        return
    full = biped.leg.max_length
    heel, ball, ankle = point_of(pose.heel, c, leg), point_of(pose.ball, c, leg), point_of(pose.ankle, c, leg)
    along = dot(minus(hip, ankle), minus(ball, heel)) / norm(minus(ball, heel))
    lean = _leans(biped, footprints, n, u, along)
    tilt = tilt_of(heel, ball, ankle, hip, full) if lean < 0 else tilt_of(ball, heel, ankle, hip, full)
    if tilt.by == 0:
        return
    tilt = eased(tilt, smoothstep(abs(lean)))
    _set(pose.ankle, c, leg, tilted(tilt, ankle))
    if lean < 0:
        _set(pose.ball, c, leg, tilted(tilt, ball))
        _set(pose.toe, c, leg, tilted(tilt, point_of(pose.toe, c, leg)))
    else:
        _set(pose.heel, c, leg, tilted(tilt, heel))


@jit_inline
def _keep_below(shortest: float, hip: Triple, s: float, pose: Pose, c: int, leg: int) -> None:
    """Lowers a foot that swings past its hip, so that the leg hangs: by l (1 - (h / UNDER_HIP l)^2) at a distance h aside,
    l the shortest leg [m].

    Who steps down from a height sinks to the foot that it left there: drawn along the leg alone, that foot would go over the
    hip, and the knee turn over within a frame. It brushes the edge instead.
    """
    ankle = pose.ankle[c, leg]
    x, y = ankle[0] - hip[0], ankle[1] - hip[1]
    lack = shortest * (1 - (x * x + y * y) / (UNDER_HIP * shortest) ** 2) - (hip[2] - ankle[2])
    lower = positive(lack, (BENT - 1) * shortest)
    if lower > 0:
        _move(pose, c, leg, (1 - fade(min(s, 1 - s), FREE_ENDS)) * lower, (0.0, 0.0, -1.0))


@jit_inline
def _swing(biped: Dimensions, track: Track, leg: int, yaw: float, t: float, pose: Pose, c: int) -> float:
    """A foot in the air; returns its heading."""
    footprints = track.footprints
    last, following = footprints_at(footprints, leg, t)
    if following < 0:
        return _stand(biped, footprints, last, t, pose, c, leg)
    if last < 0:
        return _stand(biped, footprints, following, t, pose, c, leg)
    s, toes = _fly(biped, footprints, last, following, t, pose, c, leg)
    hip = (pose.hip[c, leg, 0], pose.hip[c, leg, 1], pose.hip[c, leg, 2])
    _carry(biped, hip, yaw, swing.swing_time(footprints, last, following), s, pose, c, leg)
    shortest = shortest_over(biped, hip[2] - footprints.position[following - 1, 2] - biped.foot.ankle_height)
    _keep_below(shortest, hip, s, pose, c, leg)
    lengths = Lengths(biped.leg.max_length, shortest, _stood(biped, track, (last, following), leg, t))
    _keep_in_reach(lengths, hip, s, _kept_back(biped, footprints, last, following), pose, c, leg)
    near, u = (last, 1.0) if s < 0.5 else (following, 0.0)
    _tilt(biped, footprints, near, u, hip, pose, c, leg)  # as it does where it stands: else it would jump there
    return toes


@jit_inline
def pose_leg(biped: Dimensions, track: Track, n: int, leg: int, body: Hips, t: float, pose: Pose, c: int) -> None:
    """Poses a leg that footprint n carries, -1 for none."""
    footprints = track.footprints
    yaw, offset = body.yaw, foot.hip_offset(biped, leg, body.yaw + body.turn, body.roll)
    hip = (pose.com[c, 0] + offset[0], pose.com[c, 1] + offset[1], pose.com[c, 2] + offset[2])
    _set(pose.hip, c, leg, hip)
    pose.contact[c, leg] = n >= 0
    if n >= 0:
        u = foot.stance_share(footprints, n, t)
        _set(pose.point_of_support, c, leg, foot.point_of_support(biped, footprints, n, u))
        toes = _stand(biped, footprints, n, t, pose, c, leg)
        _tilt(biped, footprints, n, u, hip, pose, c, leg)
    else:
        pose.point_of_support[c, leg] = np.nan
        toes = _swing(biped, track, leg, yaw, t, pose, c)
    ahead = yaw + KNEE_TURN * np.tanh(WITH_TOES * (toes - yaw) / KNEE_TURN)
    ankle = pose.ankle[c, leg]
    knee, hock = legs.joints(biped, hip, (ankle[0], ankle[1], ankle[2]), (np.cos(ahead), np.sin(ahead), 0.0))
    _set(pose.knee, c, leg, knee)
    _set(pose.hock, c, leg, hock)
