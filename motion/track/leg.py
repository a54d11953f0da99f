"""The leg over a standing foot: how long it likes to be, and how long it may be where it lands and leaves (section 2.4)."""

from motion.arithmetic.gravity import GRAVITY
from motion.characters.dimensions import Dimensions
from motion.track.footprints import Footprints, rise, step_length
from worlds.compiled.jit import jit_borrowing

FULL_REACH = 0.9985
"""Share of max_length from which on reach counts: the penalty gives a little, the leg shall not."""
LOADING_ENDS, PUSH_BEGINS = 0.6, 0.75
"""Shares of the stance: until when a leg gives to the load, and from when on it bends to leave."""
CALM, LANDING, LEAVING, LEAST_REACH = 0.2, 0.085, 0.06, 0.94
"""Rate of a leg's length, in sqrt(g l), from which on less than its whole reach is taken; by which share of it less for each
sqrt(g l), where it lands and where it leaves; the least that it has."""


@jit_borrowing
def nominal_at(biped: Dimensions, footprints: Footprints, n: int, u: float) -> float:
    """Comfortable virtual leg [m] over footprint n at share u of its stance.

    As long as footprint n says when the leg is straightest; it gives by `loading` when it takes the load, and bends by
    `push_off` when the heel leaves the ground (Winter 1991: the knee flexes twice in a stance).
    """
    v, w = u / LOADING_ENDS, (u - PUSH_BEGINS) / (1 - PUSH_BEGINS)
    give = biped.leg.loading * 6.75 * v * (1 - v) * (1 - v) if v < 1 and not footprints.stands[n] else 0.0
    push = biped.leg.push_off * max(2 * footprints.roll[n, 1] - 1, 0.0) * w * w if w > 0 else 0.0
    return footprints.nominal_length[n] * (1 - footprints.bounce[n] * give - footprints.bounce[n] * push)


@jit_borrowing
def landing_reach(biped: Dimensions, footprints: Footprints, n: int) -> float:
    """Share of its reach that a leg may have when it lands on footprint n.

    A knee next to straight turns fast for little: it snaps where the leg's length l changes its rate v at once. Braking v takes
    v^2 / 2a, so that much of the leg is kept for it.
    """
    return _reach(biped, LANDING, _rate(biped, footprints, n, max(-rise(footprints, n), 0.0)))


@jit_borrowing
def leaving_reach(biped: Dimensions, footprints: Footprints, n: int) -> float:
    """The same of the leg that it leaves for footprint n."""
    return _reach(biped, LEAVING, _rate(biped, footprints, n, max(rise(footprints, n), 0.0)))


@jit_borrowing
def _reach(biped: Dimensions, less: float, rate: float) -> float:
    return max(1 - less * max(rate / (GRAVITY * biped.leg.nominal_length) ** 0.5 - CALM, 0.0), LEAST_REACH)


@jit_borrowing
def _rate(biped: Dimensions, footprints: Footprints, n: int, height: float) -> float:
    """How fast [m/s] a leg gets longer before it leaves for footprint n, or shorter once it has landed there.

    Its share of the body's way ahead, as it stands aslant, and of what the body falls or rises: g t / 2 beside a flight of t
    seconds, and the height [m] between the footprints, at twice its mean rate: it falls late in a step, and rises early.
    """
    time = max(footprints.contact_time[n] - footprints.contact_time[n - 1], 1e-3)
    flight = max(time - footprints.stance_time[n - 1], 0.0)
    length = step_length(footprints, n)
    slant = min(0.5 * length * (1 - flight / time) / biped.leg.nominal_length, 1.0)
    return length / time * slant + (0.5 * GRAVITY * flight + 1.5 * height / time) * (1 - slant * slant) ** 0.5
