"""Lengths of a leg: what it likes over a standing foot, what it may have where it lands and leaves, and what in its swing
(section 2.4)."""

from typing import NamedTuple

from motion.arithmetic.functions import exponential
from motion.arithmetic.gravity import GRAVITY
from motion.arithmetic.smooth import fade, mix, smoothstep
from motion.characters.dimensions import Dimensions
from motion.track.footprints import Footprints, rise, step_length
from worlds.compiled.jit import jit_borrowing
from worlds.compiled.lanes import Some, choose, larger, root, smaller

FULL_REACH = 0.9985
"""Share of max_length from which on reach counts: the penalty gives a little, the leg shall not."""
LOADING_ENDS, PUSH_BEGINS = 0.6, 0.75
"""Shares of the stance: until when a leg gives to the load, and from when on it bends to leave."""
CALM, LANDING, LEAVING, LEAST_REACH = 0.2, 0.085, 0.06, 0.94
"""Rate of a leg's length, in sqrt(g l), from which on less than its whole reach is taken; by which share of it less for each
sqrt(g l), where it lands and where it leaves; the least that it has."""
FREE_REACH, FIRM_REACH = 0.93, 0.9985
"""Shares of its full length up to which a swinging leg goes freely: in mid-swing, and near the ends."""
YIELDS = 0.45
"""How much less than its full length a runner's leg is let come to, in what it may reach less: straight knees pop."""
BENT = 1.25
"""Length of a swinging leg, in shortest ones, from which on it resists to be bent more."""
FOLDED, CROUCHED, UPRIGHT = 0.56, 0.6, 2.5
"""Share of its shortest length to which a swinging leg is bent where the hips are low over the ground, as after a leap; their
heights, in shortest legs, up to which that is so, and from which on no more than to the whole."""
FREE_ENDS = 0.25
"""Share of the swing, at either end, over which the first gives way to the second: as far as a standing leg may reach."""
OPEN, OPENS, JUST = 0.0012, 0.12, 2e-4
"""So much more of its length is free at the very ends, and in which share of the swing; or just as much as the leg that stood,
or will stand, is longer than it should be: the foot goes on from where it stood."""


class Lengths(NamedTuple):
    """Of a leg that swings [m]."""

    full: Some
    shortest: Some  # at which it is not bent more
    end: Some  # of the leg that stands at the near end of the swing; 0 where that is not known


@jit_borrowing
def nominal_at(biped: Dimensions, footprints: Footprints, n: Some, u: Some) -> Some:
    """Comfortable virtual leg [m] over footprint n at share u of its stance.

    As long as footprint n says when the leg is straightest; it gives by `loading` when it takes the load, and bends by
    `push_off` when the heel leaves the ground (Winter 1991: the knee flexes twice in a stance).
    """
    v, w = smaller(u / LOADING_ENDS, 1.0), larger((u - PUSH_BEGINS) / (1 - PUSH_BEGINS), 0.0)
    give = choose(footprints.stands[n], 0.0, biped.leg.loading * 6.75 * v * (1 - v) * (1 - v))
    push = biped.leg.push_off * larger(2 * footprints.roll[n, 1] - 1, 0.0) * w * w
    return footprints.nominal_length[n] * (1 - footprints.bounce[n] * give - footprints.bounce[n] * push)


@jit_borrowing
def landing_reach(biped: Dimensions, footprints: Footprints, n: Some) -> Some:
    """Share of its reach that a leg may have when it lands on footprint n.

    A knee next to straight turns fast for little: it snaps where the leg's length l changes its rate v at once. Braking v takes
    v^2 / 2a, so that much of the leg is kept for it.
    """
    return _reach(biped, LANDING, _rate(biped, footprints, n, larger(-rise(footprints, n), 0.0)))


@jit_borrowing
def leaving_reach(biped: Dimensions, footprints: Footprints, n: Some) -> Some:
    """The same of the leg that it leaves for footprint n."""
    return _reach(biped, LEAVING, _rate(biped, footprints, n, larger(rise(footprints, n), 0.0)))


@jit_borrowing
def _reach(biped: Dimensions, less: float, rate: Some) -> Some:
    return larger(1 - less * larger(rate / root(GRAVITY * biped.leg.nominal_length) - CALM, 0.0), LEAST_REACH)


@jit_borrowing
def _rate(biped: Dimensions, footprints: Footprints, n: Some, height: Some) -> Some:
    """How fast [m/s] a leg gets longer before it leaves for footprint n, or shorter once it has landed there.

    Its share of the body's way ahead, as it stands aslant, and of what the body falls or rises: g t / 2 beside a flight of t
    seconds, and the height [m] between the footprints, at twice its mean rate: it falls late in a step, and rises early.
    """
    time = larger(footprints.contact_time[n] - footprints.contact_time[n - 1], 1e-3)
    flight = larger(time - footprints.stance_time[n - 1], 0.0)
    length = step_length(footprints, n)
    slant = smaller(0.5 * length * (1 - flight / time) / biped.leg.nominal_length, 1.0)
    return length / time * slant + (0.5 * GRAVITY * flight + 1.5 * height / time) * root(1 - slant * slant)


@jit_borrowing
def _limited(length: Some, free: Some, full: Some) -> Some:
    """A length that is its own up to `free` and comes smoothly to `full`: free + (full - free) (1 - exp(-x)), x = (length -
    free) / (full - free)."""
    return choose(length <= free, length, free + (full - free) * (1 - exponential((free - length) / (full - free))))


@jit_borrowing
def shortest_over(biped: Dimensions, height: Some) -> Some:
    """Length [m] below which a swinging leg is not bent where its hip is so high [m] above an ankle that stands on the ground.

    That is min_length, but less in a crouch: who lands low would push the foot that swings into the ground.
    """
    upright = smoothstep((height / biped.leg.min_length - CROUCHED) / (UPRIGHT - CROUCHED))
    return biped.leg.min_length * mix(FOLDED, 1.0, upright)


@jit_borrowing
def swing_length(lengths: Lengths, length: Some, s: Some, kept: tuple[Some, Some]) -> Some:
    """Length [m] of a leg at share s of its swing whose foot's way would ask for `length`: neither too long nor too bent."""
    full, shortest, end = lengths
    ends = smaller(s, 1 - s)
    calm, bent = 1 - fade(ends, FREE_ENDS), BENT * shortest
    least = shortest + (bent - shortest) * exponential((length - bent) / (bent - shortest))
    less = kept[0] * smoothstep(1 - 2 * s) + kept[1] * smoothstep(2 * s - 1)
    beyond = end / full - (FIRM_REACH - choose(s < 0.5, kept[0], kept[1]))
    more = larger(OPEN, beyond + JUST) * fade(ends, OPENS)
    near = _limited(length, (FIRM_REACH - less + more) * full, (1 - YIELDS * less + more) * full)
    far = near + calm * (_limited(length, FREE_REACH * full, full) - near)
    return choose(length < bent, length + calm * (least - length), far)
