"""Knees of two links keep apart: where one shank would pass too near to the other, both legs turn about their lines from hip to
ankle, knees outward, so that no foot moves.

Let w be the vector from the right shank to the left one where they are nearest, and s what of it points to the left. They lack
R - s, R the room they need; less, the farther one is before or above the other there. Turning leg i by phi_i moves its knee by
b_i phi_i to its outside, b_i being how far the knee is off that line, ahead; the point in question by as much less as it is
further down the shank. The least turns that do are phi_i = b_i lack / (b_l^2 + b_r^2). A leg that is straight has hardly any
knee to turn: LEAST keeps that from turning far, and MOST all of them.
"""

from math import cos, sin, tanh

from motion.arithmetic.segments import gap
from motion.arithmetic.smooth import fade
from motion.arithmetic.triples import Triple, cross, dot, minus, plus, times, unit
from motion.characters.dimensions import Dimensions
from motion.pose.pose import Pose, point_of
from motion.track.footprints import LEFT, RIGHT
from worlds.compiled.jit import jit_borrowing, jit_inline

SPARE, BESIDE = 0.35, 2.0
"""Room between shanks beyond their radii, and how far before or above each other they need none, in two radii."""
LEAST, MOST = 0.05, 0.5
"""Distance of a knee from its leg's line [m] below which it turns less; most that a leg turns [rad]."""
LOWEST = 0.5
"""Share of the shank down to which the knee makes up for what is lacking there."""


@jit_inline
def _lack(room: float, left: Triple, away: Triple) -> float:
    """How much farther apart [m] shanks have to be, by the vector between them."""
    aside = dot(away, left)
    past = dot(away, away) - aside * aside
    soft = 0.25 * room
    lack = room - aside
    if lack <= -soft:
        return 0.0
    lack = lack if lack > soft else (lack + soft) ** 2 / (4 * soft)
    return lack * fade(past**0.5, BESIDE * room)


@jit_inline
def _off_line(pose: Pose, c: int, leg: int) -> tuple[Triple, Triple]:
    """Unit vector up a leg's line, and the knee's way off it."""
    hip, ankle = point_of(pose.hip, c, leg), point_of(pose.ankle, c, leg)
    up, thigh = unit(minus(hip, ankle)), minus(point_of(pose.knee, c, leg), hip)
    return up, minus(thigh, times(dot(thigh, up), up))


@jit_inline
def _turn(pose: Pose, c: int, leg: int, up: Triple, off: Triple, by: float) -> None:
    """Turns a leg about its line by [rad], left seen from above."""
    by = MOST * tanh(by / MOST)
    way = plus(times(cos(by) - 1, off), times(sin(by), cross(up, off)))
    for k in range(3):
        pose.knee[c, leg, k] += way[k]


@jit_borrowing
def keep_apart(biped: Dimensions, yaw: float, pose: Pose, c: int) -> None:
    """Turns the legs of character c, whose body heads `yaw` [rad], as far as their shanks need."""
    if biped.leg.metatarsus > 0:  # their knees are carried ahead beside the body, and their hocks behind
        return
    room, left = 2 * (1 + SPARE) * biped.leg.shank_radius, (-sin(yaw), cos(yaw), 0.0)
    away, x, y = gap(
        point_of(pose.knee, c, LEFT),
        point_of(pose.ankle, c, LEFT),
        point_of(pose.knee, c, RIGHT),
        point_of(pose.ankle, c, RIGHT),
    )
    lack = _lack(room, left, away)
    if lack == 0:
        return
    up_l, off_l = _off_line(pose, c, LEFT)
    up_r, off_r = _off_line(pose, c, RIGHT)
    b_l, b_r = dot(cross(up_l, off_l), left), dot(cross(up_r, off_r), left)
    share = lack / (b_l * b_l + b_r * b_r + LEAST * LEAST) / max(1 - max(x, y), LOWEST)
    _turn(pose, c, LEFT, up_l, off_l, b_l * share)
    _turn(pose, c, RIGHT, up_r, off_r, -b_r * share)
