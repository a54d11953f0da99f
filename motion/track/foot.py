"""The standing foot: where it presses, how it rolls and turns, where its ankle is (paper, section 2.4).

The point of support moves linearly from heel to toe over the stance. A foot that lands on its heel turns about it until the
sole is down (FLAT_BY); one that lands on its ball, downstairs or backward, comes down about that. In the last
`heel_off_fraction` of the stance it pitches about the ball: the toe segment stays flat, so the toe does not move, while heel
and ankle rise and go forward. Where the next footprint turns by more than the character likes, the foot also pivots on the
ball, or it would be twisted off its knee. All of it is a function of u, the share of the stance that has passed, and as smooth
as the swing before and after it (motion.pose.swing).
"""

from motion.arithmetic.functions import turn
from motion.arithmetic.smooth import smoothstep
from motion.arithmetic.triples import Triple, pick
from motion.characters.dimensions import Dimensions
from motion.track.footprints import Footprints, walker_heading
from worlds.compiled.across import any_of, isnt
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, choose, larger, root, smaller

RUN_DUTY, WALK_DUTY = 0.4, 0.55
"""Duty factors up to which a stride is a run, and from which on it is a walk."""
WALKING_RATE, RUNNING_RATE, RUNNERS_LESS = 3.0, 1.4, 0.26
"""Slope of the heel-off at its end, walking and running, and the share by which a runner's foot leaves less pitched."""
FLAT_BY = 0.22
"""Share of the stance by which a foot that has landed on its heel lies flat."""
PIVOTS = 1.4
"""How far a foot pivots, in what the next footprint turns beyond what the character likes: the body turns on meanwhile."""


@jit_borrowing
def hip_offset(biped: Dimensions, leg: int, yaw: Some, roll: Some) -> Triple:
    """Hip relative to the com, in the world, for a pelvis heading yaw, its left side up by roll [rad] (motion.track.pelvis)."""
    return hip_toward(biped, leg, turn(yaw), turn(roll))


@jit_borrowing
def hip_toward(biped: Dimensions, leg: int, heading: tuple[Some, Some], roll: tuple[Some, Some]) -> Triple:
    """hip_offset for a pelvis whose heading and roll have these (cosine, sine)."""
    wide, up = (1 - 2 * leg) * biped.leg.hip_side, biped.leg.hip_up
    forward, side = biped.leg.hip_forward, roll[0] * wide - roll[1] * up
    return (
        heading[0] * forward - heading[1] * side,
        heading[1] * forward + heading[0] * side,
        roll[1] * wide + roll[0] * up,
    )


@jit_borrowing
def sole_axis(heading: Some, normal: Some) -> Triple:
    """Unit vector along the sole, from heel to toe, in the plane of `normal` (3,) and above the heading [rad]."""
    c, s = turn(heading)
    rise = -(normal[0] * c + normal[1] * s) / normal[2]
    scale = 1 / root(1 + rise * rise)
    return c * scale, s * scale, rise * scale


@jit_inline
def on_sole(place: Some, axis: Some, normal: Some, forward: Some, up: Some) -> Triple:
    """The point `forward` [m] of a place along a sole's axis, and `up` along its normal; all (3,)."""
    return (
        place[0] + forward * axis[0] + up * normal[0],
        place[1] + forward * axis[1] + up * normal[1],
        place[2] + forward * axis[2] + up * normal[2],
    )


@jit_borrowing
def along_sole(footprints: Footprints, n: Some, forward: Some, up: Some) -> Triple:
    """Point `forward` [m] of the middle of footprint n along the foot and `up` along its normal."""
    normal = footprints.normal[n]
    return on_sole(footprints.position[n], sole_axis(footprints.heading[n], normal), normal, forward, up)


@jit_borrowing
def pivot(most: Some, footprints: Footprints, n: Some) -> Some:
    """How far [rad] the foot on footprint n has turned about its ball when it leaves; `most`: max_turn of the character."""
    after = smaller(n + 1, len(footprints.side) - 1)
    by = walker_heading(footprints, after) - walker_heading(footprints, n)
    beyond = abs(by) - most
    turns = (beyond > 0) & (footprints.side[after] != footprints.side[n]) & isnt(footprints.stands[after])
    return choose(turns, choose(by > 0, PIVOTS, -PIVOTS) * beyond * beyond / (beyond + 0.05), 0.0)


@jit_borrowing
def turned_by(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> Some:
    """How far [rad] it has by share u of its stance: from the heel-off on."""
    return pivot(biped.reach.max_turn, footprints, n) * smoothstep((u - 1) / biped.foot.heel_off_fraction + 1)


@jit_borrowing
def standing_point(biped: Dimensions, footprints: Footprints, n: Some, u: Some, forward: Some, up: Some) -> Triple:
    """along_sole of a foot that has turned about its ball by share u of its stance."""
    by, ball, normal = turned_by(biped, footprints, n, u), biped.foot.ball_forward, footprints.normal[n]
    place = along_sole(footprints, n, forward, up)
    if not any_of(by != 0.0):  # nearly always
        return place
    axis = sole_axis(footprints.heading[n] + by, normal)
    return pick(by != 0.0, on_sole(along_sole(footprints, n, ball, 0.0), axis, normal, forward - ball, up), place)


@jit_borrowing
def stance_share(footprints: Footprints, n: Some, t: Some) -> Some:
    """Share u of the stance on footprint n that has passed at time t [s]."""
    return smaller(larger((t - footprints.contact_time[n]) / footprints.stance_time[n], 0.0), 1.0)


@jit_borrowing
def pressing_at(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> Some:
    """How far forward of the middle [m] footprint n presses at share u of its stance."""
    begin = footprints.roll[n, 0]
    return (begin + u * (footprints.roll[n, 1] - begin) - 0.5) * biped.foot.length


@jit_borrowing
def point_of_support(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> Triple:
    """Where footprint n presses at share u of its stance."""
    return standing_point(biped, footprints, n, u, pressing_at(biped, footprints, n, u), 0.0)


@jit_borrowing
def strike_pitch(footprints: Footprints, n: Some, u: Some) -> Some:
    """How far the toes are up [rad] at share u of the stance on footprint n: the sole comes down about the heel.

    Below zero the heel is up, and comes down about the ball. From `strike` at the contact, where it falls already, to none at
    FLAT_BY: (1 - x)^2 (1 + x).
    """
    x = smaller(u / FLAT_BY, 1.0)
    return footprints.strike[n] * (1 - x) * (1 - x) * (1 + x)


@jit_borrowing
def strike_rate(footprints: Footprints, n: Some) -> Some:
    """How fast the sole comes down at the contact [rad/s]."""
    return footprints.strike[n] / (FLAT_BY * footprints.stance_time[n])


@jit_borrowing
def runs(footprints: Footprints, n: Some) -> Some:
    """How much of a run the stance on footprint n belongs to, by its duty factor: 0 walking, 1 running."""
    duty = 0.5 * footprints.stance_time[n] / larger(footprints.step_time[n], 1e-6)
    return smoothstep((WALK_DUTY - duty) / (WALK_DUTY - RUN_DUTY))


@jit_borrowing
def heel_off_angle(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> Some:
    """Pitch of the foot about its ball [rad] at share u: zero until heel-off, then up to leaving_angle, walking ever faster."""
    begin = 1 - biped.foot.heel_off_fraction
    x, rate = larger((u - begin) / biped.foot.heel_off_fraction, 0.0), _end_rate(footprints, n)
    return leaving_angle(biped, footprints, n) * x * x * (3 - rate + (rate - 2) * x)


@jit_borrowing
def _end_rate(footprints: Footprints, n: Some) -> Some:
    """Slope of the heel-off at its end, as x^3 has 3: a runner's foot leaves before it has rolled so far, the knee folds it."""
    return WALKING_RATE + runs(footprints, n) * (RUNNING_RATE - WALKING_RATE)


@jit_borrowing
def leaving_angle(biped: Dimensions, footprints: Footprints, n: Some) -> Some:
    """Pitch of the foot when it leaves: heel_off_angle off the toe, less running, none off the middle or the heel."""
    return biped.foot.heel_off_angle * larger(2 * footprints.roll[n, 1] - 1, 0.0) * (1 - RUNNERS_LESS * runs(footprints, n))


@jit_borrowing
def leaving_rate(biped: Dimensions, footprints: Footprints, n: Some) -> Some:
    """How fast the foot on footprint n pitches when it leaves [rad/s]."""
    time = biped.foot.heel_off_fraction * footprints.stance_time[n]
    return _end_rate(footprints, n) * leaving_angle(biped, footprints, n) / time


@jit_borrowing
def heel_up(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> Some:
    """How far the heel is up about the ball [rad] at share u of the stance, of a foot that is not down on its heel alone."""
    strike = strike_pitch(footprints, n, u)
    return choose(strike == 0.0, heel_off_angle(biped, footprints, n, u), larger(-strike, 0.0))


@jit_borrowing
def ankle_of(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> tuple[Some, Some]:
    """Ankle (forward of the middle, up) of the foot on footprint n at share u of its stance."""
    toes, heel = larger(strike_pitch(footprints, n, u), 0.0), heel_up(biped, footprints, n, u)
    pitch, forward, up = heel - toes, biped.foot.ankle_forward, biped.foot.ankle_height
    if not any_of(pitch != 0.0):  # most of a stance
        return forward, up
    pivot = choose(toes > 0.0, -0.5 * biped.foot.length, biped.foot.ball_forward)
    (c, s), x = turn(pitch), forward - pivot
    return pivot + c * x + s * up, c * up - s * x


@jit_borrowing
def stance_ankle(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> Triple:
    """Ankle of the foot on footprint n at share u of its stance."""
    forward, up = ankle_of(biped, footprints, n, u)
    return standing_point(biped, footprints, n, u, forward, up)
