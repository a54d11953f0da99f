"""The standing foot: where it presses, how it rolls, where its ankle is (paper, section 2.4).

The point of support moves linearly from heel to toe over the stance. In the last `heel_off_fraction` of it the foot
pitches about the ball: the toe segment stays flat, so the toe does not move, while heel and ankle rise and go forward.
All of it is a function of u, the share of the stance that has passed.
"""

from math import cos, sin
from typing import Any

from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, Footprints
from worlds.compiled.jit import jit_borrowing, jit_inline


@jit_borrowing
def hip_offset(biped: Dimensions, leg: int, yaw: float) -> Triple:
    """Hip relative to the com, in the world, for a body heading yaw [rad]."""
    return hip_toward(biped, leg, cos(yaw), sin(yaw))


@jit_borrowing
def hip_toward(biped: Dimensions, leg: int, cosine: float, sine: float) -> Triple:
    """hip_offset for a body heading of that cosine and sine."""
    side = biped.leg.hip_side if leg == LEFT else -biped.leg.hip_side
    return cosine * biped.leg.hip_forward - sine * side, sine * biped.leg.hip_forward + cosine * side, biped.leg.hip_up


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
    return along_sole(footprints, n, pressing_at(biped, footprints, n, u), 0.0)


@jit_borrowing
def heel_off_angle(biped: Dimensions, roll_end: float, u: float) -> float:
    """Pitch of the foot about its ball [rad] at share u: zero until heel-off, then smoothly up to leaving_angle."""
    begin = 1 - biped.foot.heel_off_fraction
    if u <= begin:
        return 0.0
    s = (u - begin) / biped.foot.heel_off_fraction
    return leaving_angle(biped, roll_end) * s * s * (3 - 2 * s)


@jit_borrowing
def leaving_angle(biped: Dimensions, roll_end: float) -> float:
    """Pitch of the foot when it leaves: heel_off_angle off the toe, none off the middle or the heel."""
    return biped.foot.heel_off_angle * max(2 * roll_end - 1, 0.0)


@jit_borrowing
def about_ball(biped: Dimensions, forward: float, up: float, pitch: float) -> tuple[float, float]:
    """Coordinates (forward of the middle, up) of a point of the foot pitched about the ball, heel rising."""
    if pitch == 0.0:  # most of a stance
        return forward, up
    ball = biped.foot.ball_forward
    x = forward - ball
    c, s = cos(pitch), sin(pitch)
    return ball + c * x + s * up, c * up - s * x


@jit_borrowing
def ankle_of(biped: Dimensions, roll_end: float, u: float) -> tuple[float, float]:
    """Ankle (forward of the middle, up) of a foot that rolls to `roll_end`, at share u of its stance."""
    return about_ball(biped, biped.foot.ankle_forward, biped.foot.ankle_height, heel_off_angle(biped, roll_end, u))


@jit_borrowing
def stance_ankle(biped: Dimensions, footprints: Footprints, n: int, u: float) -> Triple:
    """Ankle of the foot on footprint n at share u of its stance."""
    forward, up = ankle_of(biped, footprints.roll[n, 1], u)
    return along_sole(footprints, n, forward, up)
