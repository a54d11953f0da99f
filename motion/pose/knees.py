"""Legs keep apart: where one would pass too near to the other below the knee, knees turn outward about the line from hip to
ankle, and hocks of three links about that from knee to ankle, so that no foot moves. (Three links as one, about the line from
the hip, would turn their knees inward, which are on its other side: shanks crossed.)

Let w be the vector from a point of the right leg to one of the left, and s what of it points to the left. They lack R - s, R
the room they need; less, the farther one is before or above the other. A point between the joint that bends most and an end
moves less than the joint, by a share m. Of pairs of points that lack l_i / m the legs lack sum l^5 / sum l^4: nearly the most,
but smooth, as the nearest points are not. Turning leg i by phi_i moves its joint by b_i phi_i to its outside, b_i being how far
the joint is off its line, ahead. The least turns that do are phi_i = b_i lack / (b_l^2 + b_r^2). A leg that is straight has
hardly any joint to turn: LEAST keeps that from turning far, and MOST all of them.
"""

from math import cos, inf, sin, sqrt, tanh
from typing import NamedTuple

import numpy as np

from motion.arithmetic.smooth import fade, positive
from motion.arithmetic.triples import Triple, cross, dot, minus, plus, times, unit
from motion.characters.dimensions import Dimensions
from motion.track.footprints import LEFT, RIGHT
from worlds.compiled.jit import jit_borrowing, jit_inline

SPARE, BESIDE = 0.3, 2.0
"""Room between shanks beyond their radii, and how far before or above each other they need none, in two radii."""
SOFT = 0.15
"""How gradually a lack of room sets in, in rooms."""
LEAST, MOST = 0.055, 0.5
"""Distance of a joint from its line, in nominal legs, below which it turns less; most that a leg turns [rad]."""
ALONG = (0.0, 0.35, 0.7)
"""Where points of a shank above the ankle are looked at, in shares from the knee."""
MOVES, BESIDE_HOCK = (1.0, 0.65, 0.5), (0.5, 1.0, 0.5)
"""By how much of their joint's way they count to move; the same half way before a hock, at it and behind it."""


class Legs(NamedTuple):
    """The joints (2, 3) of both legs: LEFT, RIGHT. A leg of two links has its hock at its ankle."""

    hip: np.ndarray
    knee: np.ndarray
    hock: np.ndarray
    ankle: np.ndarray


@jit_inline
def _lack(room: float, left: Triple, away: Triple) -> float:
    """How much farther apart [m] two points have to be, by the vector between them."""
    aside = dot(away, left)
    past = sqrt(max(dot(away, away) - aside * aside, 0.0))
    return positive(room - aside, SOFT * room) * fade(past, BESIDE * room)


@jit_inline
def _point(joints: np.ndarray, leg: int) -> Triple:
    return joints[leg, 0], joints[leg, 1], joints[leg, 2]


@jit_inline
def _between(upper: np.ndarray, lower: np.ndarray, leg: int, share: float) -> Triple:
    """A point of a link."""
    return plus(times(1 - share, _point(upper, leg)), times(share, _point(lower, leg)))


@jit_borrowing
def _below(legs: Legs, three: bool, leg: int, k: int) -> Triple:
    """Point k of 0, 1, 2 of what is below the knee."""
    if not three:
        return _between(legs.knee, legs.ankle, leg, ALONG[k])
    return _between(legs.knee, legs.hock, leg, 0.5 + 0.5 * k) if k < 2 else _between(legs.hock, legs.ankle, leg, 0.5)


@jit_borrowing
def _lacking(room: float, left: Triple, legs: Legs, three: bool) -> float:
    """How much farther apart [m] the joints have to be."""
    fourth, fifth, moves = 0.0, 0.0, BESIDE_HOCK if three else MOVES
    for i in range(3):
        for j in range(3):
            lack = _lack(room, left, minus(_below(legs, three, LEFT, i), _below(legs, three, RIGHT, j)))
            lack /= min(moves[i], moves[j])
            fourth, fifth = fourth + lack**4, fifth + lack**5
    return fifth / fourth if fourth > 0 else 0.0


@jit_borrowing
def _are_apart(room: float, left: Triple, legs: Legs) -> bool:
    """Whether all of a leg below the knee is so far to the left of all of the other: as in nearly every step."""
    left_most, right_most = inf, -inf
    for joint in (legs.knee, legs.hock, legs.ankle):
        left_most, right_most = min(left_most, dot(_point(joint, LEFT), left)), max(right_most, dot(_point(joint, RIGHT), left))
    return left_most - right_most > (1 + SOFT) * room


@jit_inline
def _up(top: np.ndarray, ankle: np.ndarray, leg: int) -> Triple:
    """Unit vector up the line about which a leg turns."""
    return unit(minus(_point(top, leg), _point(ankle, leg)))


@jit_inline
def _off_line(top: np.ndarray, up: Triple, joint: np.ndarray, leg: int) -> Triple:
    """A joint's way off that line, whose direction is `up`."""
    way = minus(_point(joint, leg), _point(top, leg))
    return minus(way, times(dot(way, up), up))


@jit_inline
def _turn(top: np.ndarray, up: Triple, joint: np.ndarray, leg: int, by: float) -> None:
    """Turns a joint about that line by [rad], left seen from above."""
    off = _off_line(top, up, joint, leg)
    way = plus(times(cos(by) - 1, off), times(sin(by), cross(up, off)))
    for k in range(3):
        joint[leg, k] += way[k]


@jit_borrowing
def keep_apart(biped: Dimensions, yaw: float, legs: Legs) -> None:
    """Moves the knees, or the hocks of three links, of a body that heads `yaw` [rad] as far as they need."""
    room, left = 2 * (1 + SPARE) * biped.leg.shank_radius, (-sin(yaw), cos(yaw), 0.0)
    if _are_apart(room, left, legs):
        return
    three = biped.leg.metatarsus > 0
    lack = _lacking(room, left, legs, three)
    if lack == 0:
        return
    top, bends = (legs.knee, legs.hock) if three else (legs.hip, legs.knee)
    ups = (_up(top, legs.ankle, LEFT), _up(top, legs.ankle, RIGHT))
    b_l = dot(cross(ups[LEFT], _off_line(top, ups[LEFT], bends, LEFT)), left)
    b_r = dot(cross(ups[RIGHT], _off_line(top, ups[RIGHT], bends, RIGHT)), left)
    share = lack / (b_l * b_l + b_r * b_r + (LEAST * biped.leg.nominal_length) ** 2)
    for leg, turn in ((LEFT, b_l * share), (RIGHT, -b_r * share)):
        _turn(top, ups[leg], bends, leg, MOST * tanh(turn / MOST))
