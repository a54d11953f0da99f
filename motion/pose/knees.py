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

from typing import NamedTuple

from motion.arithmetic.functions import levelled, turn
from motion.arithmetic.smooth import fade, positive
from motion.arithmetic.triples import Triple, cross, dot, minus, pick, plus, times, unit
from motion.characters.dimensions import Dimensions
from worlds.compiled.across import any_of
from worlds.compiled.jit import jit_borrowing, jit_inline
from worlds.compiled.lanes import Some, choose, larger, root

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


class Shank(NamedTuple):
    """The joints of a leg; one of two links has its hock at its ankle."""

    hip: Triple
    knee: Triple
    hock: Triple
    ankle: Triple


@jit_inline
def _lack(room: Some, left: Triple, away: Triple) -> Some:
    """How much farther apart [m] two points have to be, by the vector between them."""
    aside = dot(away, left)
    past = root(larger(dot(away, away) - aside * aside, 0.0))
    return positive(room - aside, SOFT * room) * fade(past, BESIDE * room)


@jit_inline
def _at(upper: Triple, lower: Triple, share: float) -> Triple:
    """A point of a link."""
    return plus(times(1 - share, upper), times(share, lower))


@jit_inline
def _below(leg: Shank, three: Some) -> tuple[Triple, Triple, Triple]:
    """Three points of what is below the knee."""
    return (
        pick(three, _at(leg.knee, leg.hock, 0.5), leg.knee),
        pick(three, leg.hock, _at(leg.knee, leg.ankle, ALONG[1])),
        pick(three, _at(leg.hock, leg.ankle, 0.5), _at(leg.knee, leg.ankle, ALONG[2])),
    )


@jit_borrowing
def _lacking(room: Some, aside: Triple, left: Shank, right: Shank, three: Some) -> Some:
    """How much farther apart [m] the joints have to be."""
    fourth, fifth, ours, theirs = 0.0 * room, 0.0 * room, _below(left, three), _below(right, three)
    for i in range(3):
        for j in range(3):
            moves = choose(three, min(BESIDE_HOCK[i], BESIDE_HOCK[j]), min(MOVES[i], MOVES[j]))
            lack = _lack(room, aside, minus(ours[i], theirs[j])) / moves
            square = lack * lack
            fourth, fifth = fourth + square * square, fifth + square * square * lack
    return choose(fourth > 0.0, fifth / fourth, 0.0)


@jit_inline
def _most(leg: Shank, way: Triple) -> Some:
    """How far the joints below the hip are that way, at most."""
    return larger(larger(dot(leg.knee, way), dot(leg.hock, way)), dot(leg.ankle, way))


@jit_inline
def _off_line(top: Triple, up: Triple, joint: Triple) -> Triple:
    """A joint's way off a line through `top`, whose direction is `up`."""
    way = minus(joint, top)
    return minus(way, times(dot(way, up), up))


@jit_inline
def _turned(top: Triple, up: Triple, joint: Triple, by: Some) -> Triple:
    """A joint that is turned about that line by [rad], left seen from above."""
    off, (c, s) = _off_line(top, up, joint), turn(by)
    return plus(joint, plus(times(c - 1, off), times(s, cross(up, off))))


@jit_borrowing
def keep_apart(biped: Dimensions, yaw: Some, left: Shank, right: Shank) -> tuple[Shank, Shank]:
    """The legs of a body that heads `yaw` [rad], their knees, or the hocks of three links, as far out as they need."""
    room, (c, s) = 2 * (1 + SPARE) * biped.leg.shank_radius, turn(yaw)
    aside = (-s, c, 0.0 * s)
    if not any_of(-_most(left, times(-1.0, aside)) - _most(right, aside) <= (1 + SOFT) * room):  # nearly every step
        return left, right
    three = biped.leg.metatarsus > 0.0
    lack = _lacking(room, aside, left, right, three)
    if not any_of(lack > 0.0):
        return left, right
    return _parted(biped, lack, aside, left, right)


@jit_borrowing
def _parted(biped: Dimensions, lack: Some, aside: Triple, left: Shank, right: Shank) -> tuple[Shank, Shank]:
    """The legs farther apart by so much [m]."""
    three = biped.leg.metatarsus > 0.0
    top_l, top_r = pick(three, left.knee, left.hip), pick(three, right.knee, right.hip)
    bend_l, bend_r = pick(three, left.hock, left.knee), pick(three, right.hock, right.knee)
    up_l, up_r = unit(minus(top_l, left.ankle)), unit(minus(top_r, right.ankle))
    b_l = dot(cross(up_l, _off_line(top_l, up_l, bend_l)), aside)
    b_r = dot(cross(up_r, _off_line(top_r, up_r, bend_r)), aside)
    least = LEAST * biped.leg.nominal_length
    share = lack / (b_l * b_l + b_r * b_r + least * least)
    bend_l = _turned(top_l, up_l, bend_l, MOST * levelled(b_l * share / MOST))
    bend_r = _turned(top_r, up_r, bend_r, MOST * levelled(-b_r * share / MOST))
    return _bent(left, three, lack > 0.0, bend_l), _bent(right, three, lack > 0.0, bend_r)


@jit_inline
def _bent(leg: Shank, three: Some, turns: Some, joint: Triple) -> Shank:
    """A leg whose knee, or hock of three links, is that joint, if it turns."""
    knee = pick(turns, pick(three, leg.knee, joint), leg.knee)
    return Shank(leg.hip, knee, pick(turns, pick(three, joint, leg.hock), leg.hock), leg.ankle)
