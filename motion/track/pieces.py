"""Phases of support in pieces of a curve: how many, how long, and how much comfort counts in each.

A single stance comes in SINGLE pieces, as its force rises, holds or dips, and falls; longer phases in more, a flight in one.
Comfort counts most where the legs of people are straightest, and little where they have work to do: beside a flight, on steep
ways.
"""

from typing import NamedTuple

import numpy as np

from motion.arithmetic.gravity import pendulum_time
from motion.arithmetic.smooth import smoothstep
from motion.characters.dimensions import Dimensions
from motion.track import phases
from motion.track.footprints import Footprints, rise
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.tables import newest

SINGLE = 3
"""Pieces of a single stance: its force can rise, hold or dip, and fall."""
SPRINGY = 0.25
"""Share of comfort that counts in a stance beside a flight: there the leg is a spring, and gives as physics asks."""
MIDDLE = 4.5
"""The same in the middle of a walker's single stance on land, where people's legs are straightest."""
ROCKY, STEEP, GIVES = 0.6, 0.12, 0.35
"""The same on rocks, where legs give so that the body keeps its pace. Where legs lift or lower the body in a step by STEEP of
their length or more, GIVES is the most everywhere."""
SWITCH = 0.005
"""Time [s] in which the force changes, at least, from one leg to another that takes over at once or nearly so."""
SPLIT = 0.01
"""Shorter phases [s] are one piece: pieces of a millisecond are so stiff that a solver takes hundreds of iterations."""
FULL_FLIGHT, BRIEF = 0.12, 0.3
"""From this time [s] on a flight changes all that it does beside it; one half as long counts this share: as costs are norms, a
flight is ballistic or not, and with less weight it comes to be so more slowly as it grows."""
NEAR = 0.12
"""A flight so far away [s] no longer counts."""
PIECE = 0.45
"""Length of a piece of a long double stance, in pendulum times."""


class Cut(NamedTuple):
    """A time in m pieces."""

    time: np.ndarray  # (m + 1,) of their ends [s]
    support: np.ndarray  # (m, 2) footprints that carry the left and the right leg, -1 for none
    share: np.ndarray  # (m,) of comfort that counts


class Fineness(NamedTuple):
    """How finely phases are cut."""

    steady: bool  # their number depends on times only for the briefest, so that none begins with a jump
    rough: float  # single stances from this time on come in one piece each, but for those beside a flight [s]


@jit_borrowing
def fineness(footprints: Footprints, steady: bool, rough: int) -> Fineness:
    """Of a curve of which so many of the last steps are rough."""
    newest = len(footprints.side) - 1
    return Fineness(steady, footprints.contact_time[newest - rough] if 0 < rough <= newest else np.inf)


@jit_borrowing
def flies(support: np.ndarray, i: int) -> bool:
    """Whether phase i is a flight."""
    return 0 <= i < len(support) and phases.phase_of(support[i, 0], support[i, 1]) == phases.FLIGHT


@jit_borrowing
def _steep(biped: Dimensions, footprints: Footprints, support: np.ndarray, i: int) -> float:
    """How steep the way is in phase i, 0 to 1."""
    n = max(support[i, 0], support[i, 1])
    if n < 0:
        return 0.0
    climb = abs(rise(footprints, n)) if n > 0 else 0.0
    if n + 1 < len(footprints.side):
        climb = max(climb, abs(rise(footprints, n + 1)))
    return smoothstep(climb / (STEEP * biped.leg.nominal_length))


@jit_borrowing
def _on_rock(footprints: Footprints, support: np.ndarray, i: int) -> bool:
    """Whether a foot stands on a rock in phase i."""
    left, right = support[i, 0], support[i, 1]
    return (left >= 0 and footprints.rock[left] >= 0) or (right >= 0 and footprints.rock[right] >= 0)


@jit_borrowing
def _switch(time: np.ndarray, support: np.ndarray, i: int) -> float:
    """How long before the end of phase i [s] the force may begin to change: SWITCH where one foot takes over from another at
    once, less by the overlap or the flight between them; 0: it has time for that there, or no reason to change."""
    if i + 1 >= len(support) or max(support[i, 0], support[i, 1]) < 0 or min(support[i, 0], support[i, 1]) >= 0:
        return 0.0
    before, after = phases.phase_of(support[i, 0], support[i, 1]), phases.phase_of(support[i + 1, 0], support[i + 1, 1])
    room = SWITCH
    if after >= phases.DOUBLE_STANCE:
        room -= time[i + 2] - time[i + 1]
    long = time[i + 1] - time[i] > 4 * SWITCH
    return room if before != after and long and room > phases.SHORTEST_PHASE else 0.0


@jit_borrowing
def flown(time: np.ndarray, support: np.ndarray, i: int, steady: bool) -> float:
    """How much of a flight phase i is, 0 to 1; steady: a brief one is less of it, so that none begins with a jump."""
    return _flown_for(time[i + 1] - time[i], steady) if flies(support, i) else 0.0


@jit_borrowing
def _flown_for(seconds: float, steady: bool) -> float:
    if seconds <= phases.SHORTEST_PHASE:
        return 0.0
    return min(seconds / FULL_FLIGHT, 1.0) if steady else 1.0


@jit_borrowing
def _flown_next(time: np.ndarray, support: np.ndarray, i: int, way: int, steady: bool) -> float:
    """How much of a flight comes before (way -1) or after (1) phase i.

    Steady: one beyond a brief phase counts, too, the less the longer that is, or two feet that leave at once would stand
    otherwise than two of which one leaves a moment later.
    """
    most, k, edge = 0.0, i + way, time[i] if way < 0 else time[i + 1]
    while 0 <= k < len(support):
        near = 1 - abs((time[k + 1] if way < 0 else time[k]) - edge) / NEAR
        if near <= 0 or (k != i + way and not steady):
            break
        most = max(most, near * flown(time, support, k, steady))
        k += way
    return most


@jit_borrowing
def _flown_beside(footprints: Footprints, time: np.ndarray, support: np.ndarray, i: int, steady: bool) -> float:
    """The more of a flight of what is before and after phase i, also beyond the first and the last one."""
    before, after = _flown_next(time, support, i, -1, steady), _flown_next(time, support, i, 1, steady)
    if i == 0 and not flies(support, 0):
        n = newest(footprints.contact_time, time[0] - phases.SHORTEST_PHASE)
        before = _flown_for(time[0] - _left(footprints, n), steady) if n >= 0 else 0.0
    if i + 1 == len(support) and not flies(support, i):
        n = newest(footprints.contact_time, time[-1] - phases.SHORTEST_PHASE)
        last = n + 1 >= len(footprints.side) or footprints.contact_time[n + 1] <= time[-1] + phases.SHORTEST_PHASE
        after = 0.0 if last else _flown_for(footprints.contact_time[n + 1] - max(_left(footprints, n), time[-1]), steady)
    return max(before, after)


@jit_borrowing
def _left(footprints: Footprints, n: int) -> float:
    """When the last foot has left [s] of those that stand up to footprint n."""
    left = footprints.contact_time[n] + footprints.stance_time[n]
    return max(left, footprints.contact_time[n - 1] + footprints.stance_time[n - 1]) if n > 0 else left


@jit
def in_pieces(biped: Dimensions, footprints: Footprints, time: np.ndarray, support: np.ndarray, fine: Fineness) -> Cut:
    """Phases in equal pieces: a single stance in SINGLE, as its force rises and falls; others by their time, a flight in one.

    Beside a flight there are more, and comfort counts less. Where one foot takes over at once, the force of a steady one may
    change within SWITCH.
    """
    counts = np.ones((len(support), 2), np.int64)
    beside = np.empty(len(support))
    for i in range(len(support)):
        beside[i] = _flown_beside(footprints, time, support, i, fine.steady)
    total = _count_pieces(biped, Cut(time, support, beside), fine, counts)
    cut = Cut(np.empty(total + 1), np.empty((total, 2), np.int64), np.ones(total))
    _lay_pieces(biped, footprints, Cut(time, support, beside), fine.steady, counts, cut)
    return cut


@jit_borrowing
def _count_pieces(biped: Dimensions, whole: Cut, fine: Fineness, counts: np.ndarray) -> int:
    """Fills counts (m, 2) of ones: equal pieces of each phase, and whether one of SWITCH follows them. Returns their sum."""
    unit, total = PIECE * pendulum_time(biped.leg.nominal_length), 0
    time, support, beside = whole
    for i in range(len(support)):
        pieces, rough = int(round((time[i + 1] - time[i]) / unit)), time[i] > fine.rough - phases.SHORTEST_PHASE
        if fine.steady and time[i + 1] - time[i] < SPLIT:
            counts[i, 0] = 1
        elif fine.steady and not flies(support, i):
            counts[i, 0] = SINGLE if min(support[i, 0], support[i, 1]) >= 0 else 2 * SINGLE
        elif beside[i] > 0 and not flies(support, i):
            counts[i, 0] = min(max(2 * pieces, SINGLE), 2 * SINGLE)
        elif phases.phase_of(support[i, 0], support[i, 1]) == phases.DOUBLE_STANCE:
            counts[i, 0] = min(max(pieces, 1), SINGLE)
        elif not flies(support, i):
            counts[i, 0] = 1 if rough else SINGLE
        counts[i, 1] = 1 if fine.steady and _switch(time, support, i) > 0 else 0
        total += counts[i, 0] + counts[i, 1]
    return total


@jit_borrowing
def _lay_pieces(biped: Dimensions, footprints: Footprints, whole: Cut, steady: bool, counts: np.ndarray, cut: Cut) -> None:
    """Fills cut with the pieces of whole phases, of which `share` tells how much of a flight is beside them."""
    time, support, n = whole.time, whole.support, 0
    for i in range(len(support)):
        count = counts[i, 0]
        single = min(support[i, 0], support[i, 1]) < 0 and not flies(support, i)
        rocky, steep = _on_rock(footprints, support, i), _steep(biped, footprints, support, i)
        for k in range(count + counts[i, 1]):
            cut.time[n] = (
                time[i] + k * (time[i + 1] - time[i]) / count if k < count else time[i + 1] - _switch(time, support, i)
            )
            cut.support[n, 0], cut.support[n, 1] = support[i, 0], support[i, 1]
            cut.share[n] = _share(whole.share[i], rocky, _middle(k, count, steady) if single else 0.0, steep)
            n += 1
    cut.time[n] = time[-1]


@jit_borrowing
def _middle(k: int, count: int, steady: bool) -> float:
    """How much of piece k of a single stance is of its middle third; the briefest of a steady curve have none."""
    if count < SINGLE and not steady:
        return 1 / SINGLE
    return 1.0 if count <= SINGLE * k < 2 * count else 0.0


@jit_borrowing
def _share(beside: float, rocky: bool, middle: float, steep: float) -> float:
    """Share of comfort that counts in a piece: `beside` as much of a flight, on rocks, in the middle of a stance, so steep."""
    share = 1.0
    if beside < 1:
        share = ROCKY if rocky else 1.0 + middle * (MIDDLE - 1.0)
    share += steep * (min(share, GIVES) - share)
    if beside > 0:
        share = SPRINGY + (share - SPRINGY) * (1 - beside) if beside < 1 else SPRINGY
    return share
