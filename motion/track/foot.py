"""The standing foot: where it presses, how it rolls, where its ankle is (paper, section 2.4).

The point of support moves linearly from heel to toe over the stance. In the last `heel_off_fraction` of it the foot
pitches about the ball: the toe segment stays flat, so the toe does not move, while heel and ankle rise and go forward.
All of it is a function of u, the share of the stance that has passed.
"""

from math import cos, sin

from worlds.compiled.jit import jit_borrowing


@jit_borrowing
def hip_offset(b, leg, yaw):
    """Hip relative to the com, in the world, for a body heading yaw [rad]."""
    return hip_toward(b, leg, cos(yaw), sin(yaw))


@jit_borrowing
def hip_toward(b, leg, c, s):
    """hip_offset for a body heading whose cosine and sine are c and s."""
    side = b.hip_side if leg == 0 else -b.hip_side
    return c * b.hip_forward - s * side, s * b.hip_forward + c * side, b.hip_up


@jit_borrowing
def sole_axis(heading, normal):
    """Unit vector along the sole, from heel to toe, in the plane of `normal` (3,) and above the heading."""
    c, s = cos(heading), sin(heading)
    rise = -(normal[0] * c + normal[1] * s) / normal[2]
    length = (1 + rise * rise) ** 0.5
    return c / length, s / length, rise / length


@jit_borrowing
def along_sole(position, heading, normal, forward, up):
    """Point `forward` [m] of the sole's middle along the foot and `up` along the normal."""
    f = sole_axis(heading, normal)
    return (
        position[0] + forward * f[0] + up * normal[0],
        position[1] + forward * f[1] + up * normal[1],
        position[2] + forward * f[2] + up * normal[2],
    )


@jit_borrowing
def point_of_support(b, track, n, u):
    """Where footprint n presses at share u of its stance."""
    share = track.roll[n, 0] + u * (track.roll[n, 1] - track.roll[n, 0])
    return along_sole(track.position[n], track.heading[n], track.normal[n], (share - 0.5) * b.foot_length, 0.0)


@jit_borrowing
def heel_off_angle(b, roll_end, u):
    """Pitch of the foot about its ball [rad] at share u: zero until heel-off, then smoothly up to leaving_angle."""
    begin = 1 - b.heel_off_fraction
    if u <= begin:
        return 0.0
    s = (u - begin) / b.heel_off_fraction
    return leaving_angle(b, roll_end) * s * s * (3 - 2 * s)


@jit_borrowing
def leaving_angle(b, roll_end):
    """Pitch of the foot when it leaves: heel_off_angle off the toe, none off the middle or the heel."""
    return b.heel_off_angle * max(2 * roll_end - 1, 0.0)


@jit_borrowing
def about_ball(b, forward, up, pitch):
    """Coordinates (forward of the middle, up) of a point of the foot pitched about the ball, heel rising."""
    if pitch == 0.0:  # most of a stance
        return forward, up
    x = forward - b.ball_forward
    c, s = cos(pitch), sin(pitch)
    return b.ball_forward + c * x + s * up, c * up - s * x


@jit_borrowing
def stance_ankle(b, track, n, u):
    """Ankle of the foot on footprint n at share u of its stance."""
    x, z = about_ball(b, b.ankle_forward, b.ankle_height, heel_off_angle(b, track.roll[n, 1], u))
    return along_sole(track.position[n], track.heading[n], track.normal[n], x, z)
