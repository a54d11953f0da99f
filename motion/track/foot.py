"""The standing foot: where it presses, how it rolls and turns, where its ankle is (paper, section 2.4).

The point of support moves linearly from heel to toe over the stance. A foot that lands on its heel turns about it until the
sole is down (FLAT_BY); one that lands on its ball, downstairs or backward, comes down about that. In the last
`heel_off_fraction` of the stance it pitches about the ball: the toe segment stays flat, so the toe does not move, while heel
and ankle rise and go forward. Where the next footprint turns by more than the character likes, the foot also pivots on the
ball, or it would be twisted off its knee. All of it is a function of u, the share of the stance that has passed, and as smooth
as the swing before and after it (motion.pose.swing).
"""

from math import cos, sin
from typing import Any

from motion.arithmetic.smooth import smoothstep
from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, Footprints, walker_heading
from worlds.compiled.jit import jit_borrowing, jit_inline

RUN_DUTY, WALK_DUTY = 0.4, 0.55
"""Duty factors up to which a stride is a run, and from which on it is a walk."""
WALKING_RATE, RUNNING_RATE, RUNNERS_LESS = 3.0, 1.4, 0.26
"""Slope of the heel-off at its end, walking and running, and the share by which a runner's foot leaves less pitched."""
FLAT_BY = 0.22
"""Share of the stance by which a foot that has landed on its heel lies flat."""
PIVOTS = 1.4
"""How far a foot pivots, in what the next footprint turns beyond what the character likes: the body turns on meanwhile."""


@jit_borrowing
def hip_offset(biped: Dimensions, leg: int, yaw: float, roll: float) -> Triple:
    """Hip relative to the com, in the world, for a pelvis heading yaw, its left side up by roll [rad] (motion.track.pelvis)."""
    return hip_toward(biped, leg, (cos(yaw), sin(yaw)), (cos(roll), sin(roll)))


@jit_borrowing
def hip_toward(biped: Dimensions, leg: int, heading: tuple[float, float], roll: tuple[float, float]) -> Triple:
    """hip_offset for a pelvis whose heading and roll have these (cosine, sine)."""
    wide, up = biped.leg.hip_side if leg == LEFT else -biped.leg.hip_side, biped.leg.hip_up
    forward, side = biped.leg.hip_forward, roll[0] * wide - roll[1] * up
    return (
        heading[0] * forward - heading[1] * side,
        heading[1] * forward + heading[0] * side,
        roll[1] * wide + roll[0] * up,
    )


@jit_borrowing
def sole_axis(heading: float, normal: Any) -> Triple:
    """Unit vector along the sole, from heel to toe, in the plane of `normal` (3,) and above the heading [rad]."""
    c, s = cos(heading), sin(heading)
    rise = -(normal[0] * c + normal[1] * s) / normal[2]
    length = (1 + rise * rise) ** 0.5
    return c / length, s / length, rise / length


@jit_inline
def on_sole(place: Any, axis: Any, normal: Any, forward: float, up: float) -> Triple:
    """The point `forward` [m] of a place along a sole's axis, and `up` along its normal; all (3,)."""
    return (
        place[0] + forward * axis[0] + up * normal[0],
        place[1] + forward * axis[1] + up * normal[1],
        place[2] + forward * axis[2] + up * normal[2],
    )


@jit_borrowing
def along_sole(footprints: Footprints, n: int, forward: float, up: float) -> Triple:
    """Point `forward` [m] of the middle of footprint n along the foot and `up` along its normal."""
    normal = footprints.normal[n]
    return on_sole(footprints.position[n], sole_axis(footprints.heading[n], normal), normal, forward, up)


@jit_borrowing
def pivot(most: float, footprints: Footprints, n: int) -> float:
    """How far [rad] the foot on footprint n has turned about its ball when it leaves; `most`: max_turn of the character."""
    if n + 1 >= len(footprints.side) or footprints.side[n + 1] == footprints.side[n] or footprints.stands[n + 1]:
        return 0.0
    turn = walker_heading(footprints, n + 1) - walker_heading(footprints, n)
    beyond = abs(turn) - most
    if beyond <= 0:
        return 0.0
    return (1.0 if turn > 0 else -1.0) * PIVOTS * beyond * beyond / (beyond + 0.05)


@jit_borrowing
def turned_by(biped: Dimensions, footprints: Footprints, n: int, u: float) -> float:
    """How far [rad] it has by share u of its stance: from the heel-off on."""
    x = (u - 1) / biped.foot.heel_off_fraction + 1
    return pivot(biped.reach.max_turn, footprints, n) * smoothstep(x) if x > 0 else 0.0


@jit_borrowing
def standing_point(biped: Dimensions, footprints: Footprints, n: int, u: float, forward: float, up: float) -> Triple:
    """along_sole of a foot that has turned about its ball by share u of its stance."""
    turn, ball, normal = turned_by(biped, footprints, n, u), biped.foot.ball_forward, footprints.normal[n]
    if turn == 0.0:  # nearly always
        return along_sole(footprints, n, forward, up)
    axis = sole_axis(footprints.heading[n] + turn, normal)
    return on_sole(along_sole(footprints, n, ball, 0.0), axis, normal, forward - ball, up)


@jit_borrowing
def stance_share(footprints: Footprints, n: int, t: float) -> float:
    """Share u of the stance on footprint n that has passed at time t [s]."""
    return min(max((t - footprints.contact_time[n]) / footprints.stance_time[n], 0.0), 1.0)


@jit_borrowing
def pressing_at(biped: Dimensions, footprints: Footprints, n: int, u: float) -> float:
    """How far forward of the middle [m] footprint n presses at share u of its stance."""
    share = footprints.roll[n, 0] + u * (footprints.roll[n, 1] - footprints.roll[n, 0])
    return (share - 0.5) * biped.foot.length


@jit_borrowing
def point_of_support(biped: Dimensions, footprints: Footprints, n: int, u: float) -> Triple:
    """Where footprint n presses at share u of its stance."""
    return standing_point(biped, footprints, n, u, pressing_at(biped, footprints, n, u), 0.0)


@jit_borrowing
def strike_pitch(footprints: Footprints, n: int, u: float) -> float:
    """How far the toes are up [rad] at share u of the stance on footprint n: the sole comes down about the heel.

    Below zero the heel is up, and comes down about the ball. From `strike` at the contact, where it falls already, to none at
    FLAT_BY: (1 - x)^2 (1 + x).
    """
    if u >= FLAT_BY:
        return 0.0
    x = u / FLAT_BY
    return footprints.strike[n] * (1 - x) * (1 - x) * (1 + x)


@jit_borrowing
def strike_rate(footprints: Footprints, n: int) -> float:
    """How fast the sole comes down at the contact [rad/s]."""
    return footprints.strike[n] / (FLAT_BY * footprints.stance_time[n])


@jit_borrowing
def runs(footprints: Footprints, n: int) -> float:
    """How much of a run the stance on footprint n belongs to, by its duty factor: 0 walking, 1 running."""
    duty = 0.5 * footprints.stance_time[n] / max(footprints.step_time[n], 1e-6)
    return smoothstep((WALK_DUTY - duty) / (WALK_DUTY - RUN_DUTY))


@jit_borrowing
def heel_off_angle(biped: Dimensions, footprints: Footprints, n: int, u: float) -> float:
    """Pitch of the foot about its ball [rad] at share u: zero until heel-off, then up to leaving_angle, walking ever faster."""
    begin = 1 - biped.foot.heel_off_fraction
    if u <= begin:
        return 0.0
    x, rate = (u - begin) / biped.foot.heel_off_fraction, _end_rate(footprints, n)
    return leaving_angle(biped, footprints, n) * x * x * (3 - rate + (rate - 2) * x)


@jit_borrowing
def _end_rate(footprints: Footprints, n: int) -> float:
    """Slope of the heel-off at its end, as x^3 has 3: a runner's foot leaves before it has rolled so far, the knee folds it."""
    return WALKING_RATE + runs(footprints, n) * (RUNNING_RATE - WALKING_RATE)


@jit_borrowing
def leaving_angle(biped: Dimensions, footprints: Footprints, n: int) -> float:
    """Pitch of the foot when it leaves: heel_off_angle off the toe, less running, none off the middle or the heel."""
    return biped.foot.heel_off_angle * max(2 * footprints.roll[n, 1] - 1, 0.0) * (1 - RUNNERS_LESS * runs(footprints, n))


@jit_borrowing
def leaving_rate(biped: Dimensions, footprints: Footprints, n: int) -> float:
    """How fast the foot on footprint n pitches when it leaves [rad/s]."""
    time = biped.foot.heel_off_fraction * footprints.stance_time[n]
    return _end_rate(footprints, n) * leaving_angle(biped, footprints, n) / time


@jit_borrowing
def about_ball(biped: Dimensions, forward: float, up: float, pitch: float) -> tuple[float, float]:
    """Coordinates (forward of the middle, up) of a point of the foot pitched about the ball, heel rising."""
    return _about(biped.foot.ball_forward, forward, up, pitch)


@jit_borrowing
def about_heel(biped: Dimensions, forward: float, up: float, pitch: float) -> tuple[float, float]:
    """The same of a foot pitched about its heel, toes rising."""
    return _about(-0.5 * biped.foot.length, forward, up, -pitch)


@jit_borrowing
def _about(pivot: float, forward: float, up: float, pitch: float) -> tuple[float, float]:
    if pitch == 0.0:  # most of a stance
        return forward, up
    c, s, x = cos(pitch), sin(pitch), forward - pivot
    return pivot + c * x + s * up, c * up - s * x


@jit_borrowing
def rolled(biped: Dimensions, footprints: Footprints, n: int, u: float, forward: float, up: float) -> tuple[float, float]:
    """Coordinates (forward of the middle, up) of a point behind the ball, at share u of the stance on footprint n."""
    toes_up = strike_pitch(footprints, n, u)
    if toes_up > 0.0:
        return about_heel(biped, forward, up, toes_up)
    if toes_up < 0.0:
        return about_ball(biped, forward, up, -toes_up)
    return about_ball(biped, forward, up, heel_off_angle(biped, footprints, n, u))


@jit_borrowing
def ankle_of(biped: Dimensions, footprints: Footprints, n: int, u: float) -> tuple[float, float]:
    """Ankle (forward of the middle, up) of the foot on footprint n at share u of its stance."""
    return rolled(biped, footprints, n, u, biped.foot.ankle_forward, biped.foot.ankle_height)


@jit_borrowing
def stance_ankle(biped: Dimensions, footprints: Footprints, n: int, u: float) -> Triple:
    """Ankle of the foot on footprint n at share u of its stance."""
    forward, up = ankle_of(biped, footprints, n, u)
    return standing_point(biped, footprints, n, u, forward, up)
