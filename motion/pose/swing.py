"""The swinging foot: a function of its two footprints, its lift and the share s of the swing that has passed (section 2.5).

The ball goes along the line between the footprints by the quintic 10 x^3 - 15 x^4 + 6 x^5, at rest at both ends, and is raised
by lift * bump(s). Over edges (`hold`) the foot rises before it goes forward and comes down after it has arrived. The pitch
with which the foot left fades, its toes straighten a little sooner. Where the line would come too near to the other foot it
bows outward: a left foot goes by on the left, a right foot on the right, as on the outside of a sharp turn. A foot that rolls
from its heel comes in with the toes up, turned about the heel, and lays the sole down in the last STRIKE of the swing, so that
it is flat, and the toe in place, at the contact.
"""

from math import asin, cos, sin, sqrt

from motion.track import foot
from worlds.compiled.jit import jit_borrowing, jit_inline

GRAVITY = 9.81
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
"""Swing times, in pendulum times sqrt(l / g), up to which a foot lands flat, and from which on it may strike with the heel."""
TOES_UP, STRIKE = 0.45, 0.12
"""Shares of the swing: from when on the toes rise for the heel strike, and how long before its end the sole comes down."""


@jit_borrowing
def way(s, hold):
    """Share of the way at share s of the swing: nothing for the first and last `hold`, smooth to the second derivative."""
    s = min(max((s - hold) / (1 - 2 * hold), 0.0), 1.0)
    return s * s * s * (10 - 15 * s + 6 * s * s)


@jit_borrowing
def bump(s):
    """Share of the lift: 16 s^2 (1 - s)^2, 1 in the middle."""
    return 16 * s * s * (1 - s) * (1 - s)


@jit_borrowing
def fade(s, end):
    """From 1 at 0 to 0 at `end`, smooth at both."""
    x = min(s / end, 1.0)
    return 1 - x * x * (3 - 2 * x)


@jit_inline
def toes_up(b, track, n, m, s):
    """Pitch, toes up [rad], at share s of the swing from n to m: for a landing on the heel, in a swing with time for it."""
    landing = b.heel_strike_angle * max(1 - 2 * track.roll[m, 0], 0.0)
    if landing == 0.0:
        return 0.0
    swing_time = track.contact_time[m] - track.contact_time[n] - track.stance_time[n]
    calm = (swing_time / sqrt(b.nominal_length / GRAVITY) - QUICK) / (CALM - QUICK)
    rising = 1 - fade(max(s - TOES_UP, 0.0), 1 - STRIKE - TOES_UP)
    return landing * (1 - fade(max(calm, 0.0), 1.0)) * rising * fade(max(s - 1 + STRIKE, 0.0), STRIKE)


@jit_borrowing
def share_at(w, hold):
    """Share s of the swing at which way(s, hold) is about w: by the inverse of 3 x^2 - 2 x^3, close to the quintic's."""
    return hold + (1 - 2 * hold) * (0.5 - sin(asin(min(max(1 - 2 * w, -1.0), 1.0)) / 3))


@jit_borrowing
def room_beside(b):
    """How far [m] a swinging foot's middle keeps from that of the other foot when it passes it: both shanks and half a sole."""
    return 0.5 * b.foot_width + 2 * b.shank_radius


@jit_borrowing
def outward(b, track, n, m, start, goal):
    """Sideways offset (x, y) [m] in the middle of the swing from n to m, so that it keeps its room where it passes the other
    foot. That foot is the one that landed in between, whether it still stands or not."""
    dx, dy = goal[0] - start[0], goal[1] - start[1]
    length2 = dx * dx + dy * dy
    if m - 1 == n or length2 < 1e-6:
        return 0.0, 0.0
    other = track.position[m - 1]
    u = ((other[0] - start[0]) * dx + (other[1] - start[1]) * dy) / length2
    if u <= 0 or u >= 1:
        return 0.0, 0.0
    length = sqrt(length2)
    to_left = ((other[0] - start[0]) * dy - (other[1] - start[1]) * dx) / length
    yaw = 0.5 * (track.heading[n] + track.heading[m])
    ahead = (dx * cos(yaw) + dy * sin(yaw)) / length
    side = 1.0 if (track.side[m] == 0) == (ahead > 0) else -1.0
    if abs(ahead) < SIDEWAYS:
        side = 1.0 if to_left > 0 else -1.0
    lack = max(room_beside(b) - side * to_left, 0.0)
    ends = min(1.0, 4 * u, 4 * (1 - u))
    amount = side * min(lack * ends, MOST_ROOM * length) / max(bump(share_at(u, track.hold[m])), 0.3)
    return -amount * dy / length, amount * dx / length


@jit_inline
def sole_at(b, track, n, m, s):
    """Where the sole is at share s of the swing from footprint n to m.

    Returns (ball (3), heading, normal (3), pitch of the foot, flex of the toes against it).
    """
    start = foot.along_sole(track.position[n], track.heading[n], track.normal[n], b.ball_forward, 0.0)
    goal = foot.along_sole(track.position[m], track.heading[m], track.normal[m], b.ball_forward, 0.0)
    w = way(s, track.hold[m])
    ox, oy = outward(b, track, n, m, start, goal)
    rise = bump(s)
    ball = (
        start[0] + w * (goal[0] - start[0]) + rise * ox,
        start[1] + w * (goal[1] - start[1]) + rise * oy,
        start[2] + w * (goal[2] - start[2]) + track.lift[m] * rise,
    )
    heading = track.heading[n] + w * (track.heading[m] - track.heading[n])
    nx = track.normal[n, 0] + w * (track.normal[m, 0] - track.normal[n, 0])
    ny = track.normal[n, 1] + w * (track.normal[m, 1] - track.normal[n, 1])
    nz = track.normal[n, 2] + w * (track.normal[m, 2] - track.normal[n, 2])
    length = (nx * nx + ny * ny + nz * nz) ** 0.5
    normal = (nx / length, ny / length, nz / length)
    up = toes_up(b, track, n, m, s)
    left_with = foot.leaving_angle(b, track.roll[n, 1])
    pitch = left_with * fade(s, PITCH_FADE) - up
    return _about_heel(b, ball, heading, normal, up), heading, normal, pitch, left_with * fade(s, FLEX_FADE)


@jit_inline
def _about_heel(b, ball, heading, normal, up):
    """The ball of a foot that is turned about its heel by `up` [rad], toes up."""
    reach = 0.5 * b.foot_length + b.ball_forward
    f = foot.sole_axis(heading, normal)
    x, z = reach * (cos(up) - 1), reach * sin(up)
    return (
        ball[0] + x * f[0] + z * normal[0],
        ball[1] + x * f[1] + z * normal[1],
        ball[2] + x * f[2] + z * normal[2],
    )


@jit_inline
def point_of_foot(b, ball, heading, normal, forward, up, pitch):
    """World point of the foot at (forward of the ball, up), pitched about the ball with the heel rising."""
    f = foot.sole_axis(heading, normal)
    c, s = cos(pitch), sin(pitch)
    x, z = c * forward + s * up, c * up - s * forward
    return (
        ball[0] + x * f[0] + z * normal[0],
        ball[1] + x * f[1] + z * normal[1],
        ball[2] + x * f[2] + z * normal[2],
    )
