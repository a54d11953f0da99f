"""Knees of two links keep apart: where one shank would pass too near to the other, both legs turn about their lines from hip to
ankle, knees outward, so that no foot moves.

Let w be the vector from a point of the right shank to one of the left, and s what of it points to the left. They lack R - s, R
the room they need; less, the farther one is before or above the other, and 1 - x of it a knee makes up for, x the share of the
shank at which the points are. Of pairs of points that lack l_i the shanks lack sum l^5 / sum l^4: nearly the most, but smooth,
as the nearest points are not. Turning leg i by phi_i moves its knee by b_i phi_i to its outside, b_i being how far the knee is
off that line, ahead. The least turns that do are phi_i = b_i lack / (b_l^2 + b_r^2). A leg that is straight has hardly any
knee to turn: LEAST keeps that from turning far, and MOST all of them.
"""

from math import cos, sin, sqrt, tanh

import numpy as np

from motion.arithmetic.smooth import fade
from motion.arithmetic.triples import Triple, cross, dot, minus, plus, times, unit
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, RIGHT
from worlds.compiled.jit import jit_borrowing, jit_inline

SPARE, BESIDE = 0.3, 2.0
"""Room between shanks beyond their radii, and how far before or above each other they need none, in two radii."""
SOFT = 0.15
"""How gradually a lack of room sets in, in rooms."""
LEAST, MOST = 0.05, 0.5
"""Distance of a knee from its leg's line [m] below which it turns less; most that a leg turns [rad]."""
SHARES, LOWEST = (0.0, 0.35, 0.7), 0.5
"""Where points of a shank are looked at, and the share down to which the knee makes up for what is lacking there."""


@jit_inline
def _lack(room: float, left: Triple, away: Triple) -> float:
    """How much farther apart [m] two points have to be, by the vector between them."""
    aside, soft = dot(away, left), SOFT * room
    lack = room - aside
    if lack <= -soft:
        return 0.0
    past = sqrt(max(dot(away, away) - aside * aside, 0.0))
    return (lack if lack > soft else (lack + soft) ** 2 / (4 * soft)) * fade(past, BESIDE * room)


@jit_inline
def _point(joints: np.ndarray, leg: int) -> Triple:
    return joints[leg, 0], joints[leg, 1], joints[leg, 2]


@jit_inline
def _down(knee: np.ndarray, ankle: np.ndarray, leg: int, share: float) -> Triple:
    """The point of a shank at a share of it, from the knee."""
    return plus(times(1 - share, _point(knee, leg)), times(share, _point(ankle, leg)))


@jit_borrowing
def _lacking(room: float, left: Triple, knee: np.ndarray, ankle: np.ndarray) -> float:
    """How much farther apart [m] the knees have to be."""
    fourth, fifth = 0.0, 0.0
    for x in SHARES:
        for y in SHARES:
            away = minus(_down(knee, ankle, LEFT, x), _down(knee, ankle, RIGHT, y))
            lack = _lack(room, left, away) / max(1 - max(x, y), LOWEST)
            fourth, fifth = fourth + lack**4, fifth + lack**5
    return fifth / fourth if fourth > 0 else 0.0


@jit_inline
def _off_line(hip: Triple, knee: Triple, ankle: Triple) -> tuple[Triple, Triple]:
    """Unit vector up a leg's line, and the knee's way off it."""
    up, thigh = unit(minus(hip, ankle)), minus(knee, hip)
    return up, minus(thigh, times(dot(thigh, up), up))


@jit_inline
def _turn(knee: np.ndarray, up: Triple, off: Triple, by: float) -> None:
    """Turns a leg's knee (3,) about its line by [rad], left seen from above."""
    by = MOST * tanh(by / MOST)
    way = plus(times(cos(by) - 1, off), times(sin(by), cross(up, off)))
    for k in range(3):
        knee[k] += way[k]


@jit_borrowing
def keep_apart(biped: Dimensions, yaw: float, hip: np.ndarray, knee: np.ndarray, ankle: np.ndarray) -> None:
    """Moves the knees of a body that heads `yaw` [rad] as far as its shanks need. Joints (2, 3): LEFT, RIGHT."""
    if biped.leg.metatarsus > 0:  # their knees are carried ahead beside the body, and their hocks behind
        return
    room, left = 2 * (1 + SPARE) * biped.leg.shank_radius, (-sin(yaw), cos(yaw), 0.0)
    inner = min(dot(_point(knee, LEFT), left), dot(_point(ankle, LEFT), left))
    if inner - max(dot(_point(knee, RIGHT), left), dot(_point(ankle, RIGHT), left)) > (1 + SOFT) * room:
        return  # as in nearly every step
    lack = _lacking(room, left, knee, ankle)
    if lack == 0:
        return
    up_l, off_l = _off_line(_point(hip, LEFT), _point(knee, LEFT), _point(ankle, LEFT))
    up_r, off_r = _off_line(_point(hip, RIGHT), _point(knee, RIGHT), _point(ankle, RIGHT))
    b_l, b_r = dot(cross(up_l, off_l), left), dot(cross(up_r, off_r), left)
    share = lack / (b_l * b_l + b_r * b_r + LEAST * LEAST)
    _turn(knee[LEFT], up_l, off_l, b_l * share)
    _turn(knee[RIGHT], up_r, off_r, -b_r * share)
