"""The head (paper, section 2.5): where it looks, and where a bird's stays while the body walks on; functions of time.

It looks where the feet will go: aside before the body turns, down at footprints that need care (rocks, treads), over the
shoulder walking backward. A bird's head keeps its place in the world while one foot carries the body and darts ahead while both
stand (Dagg 1977): between the holds of two steps

    place(t) = mix(com(middle of the last hold), com(middle of this one), smoothstep(x)),   x: share of the double stance
"""

from math import sqrt, tanh
from typing import NamedTuple

import numpy as np

from motion.arithmetic.smooth import mix, smoothstep
from motion.arithmetic.triples import Triple
from motion.characters.dimensions import Dimensions
from motion.track import foot, heading
from motion.track.curve import Curve, Track, position_at
from motion.track.footprints import Footprints, out_of_plane
from worlds.compiled.jit import jit_borrowing, stack_array
from worlds.compiled.tables import newest

LOOKS_ASIDE = 1.0
"""Largest turn of the head against the body [rad]."""
LOOKS_DOWN = 0.38
"""How far the head bends to look at a footprint that needs care [rad]; the eyes do the rest."""
OVER_SHOULDER, BACKWARD = 0.85, 0.12
"""Turn of the head [rad] walking backward, and from which pace on wholly."""
CARE = (0.06, 0.16)
"""Steps up or down, in hip heights, from which on one looks where one treads, and from which on wholly."""
DART = (0.2, 0.45)
"""Shortest and longest time, in steps, in which a bobbing head comes to its next place."""
THRUST = 0.6
"""Farthest that a bobbing head is from its middle place, in hip heights."""


class Looks(NamedTuple):
    """Where the head is turned."""

    heading: float  # [rad]
    down: float  # [rad]


@jit_borrowing
def on_rocks(footprints: Footprints, t: float) -> float:
    """How much the feet are on rocks at time t: 0 on land, 1 on rocks, smooth between contacts."""
    i, x = _step_at(footprints, t)
    following = min(i + 1, len(footprints.side) - 1)
    return mix(1.0 * (footprints.rock[i] >= 0), 1.0 * (footprints.rock[following] >= 0), smoothstep(x))


@jit_borrowing
def looks(biped: Dimensions, footprints: Footprints, yaw: float, pace: float, t: float) -> Looks:
    """Where the head of a walker is turned whose body has heading yaw [rad] and that pace (motion.pose.trunk)."""
    ahead = heading.mean_heading(footprints, t, 0.4 * heading.window_length(biped))
    backward = OVER_SHOULDER * smoothstep(-pace / BACKWARD)
    i, x = _step_at(footprints, t)
    care = mix(_care(biped, footprints, i + 1), _care(biped, footprints, i + 2), smoothstep(x))
    return Looks(yaw + LOOKS_ASIDE * tanh((ahead - yaw) / LOOKS_ASIDE) + backward, LOOKS_DOWN * care)


@jit_borrowing
def _care(biped: Dimensions, footprints: Footprints, n: int) -> float:
    """How much footprint n, or the last one, is looked at: rocks wholly, treads by their height."""
    n = min(n, len(footprints.side) - 1)
    if footprints.rock[n] >= 0:
        return 1.0
    step = abs(out_of_plane(footprints, n)) / biped.timing.hip_height if n > 0 else 0.0
    return smoothstep((step - CARE[0]) / (CARE[1] - CARE[0]))


@jit_borrowing
def _step_at(footprints: Footprints, t: float) -> tuple[int, float]:
    """(footprint that landed last, share of the time to the next contact that has passed since)."""
    i = max(newest(footprints.contact_time, t), 0)
    return i, min(max((t - footprints.contact_time[i]) / max(footprints.step_time[i], 1e-3), 0.0), 1.0)


@jit_borrowing
def _dart_time(footprints: Footprints, i: int) -> float:
    """How long the head darts after contact i [s]: while both feet stand."""
    both = footprints.contact_time[i - 1] + footprints.stance_time[i - 1] - footprints.contact_time[i] if i > 0 else 0.0
    step = max(footprints.step_time[i], 1e-3)
    return min(max(both, DART[0] * step), DART[1] * step)


_empty_place = stack_array(2, 3)


@jit_borrowing
def _hold(footprints: Footprints, curve: Curve, i: int, place: np.ndarray) -> None:
    """Where the com is in the middle of the hold after contact i, into place (3,)."""
    begin, end = footprints.contact_time[i] + _dart_time(footprints, i), footprints.contact_time[i] + footprints.step_time[i]
    position_at(curve, min(max(0.5 * (begin + end), curve.time[0]), curve.time[-1]), place)


@jit_borrowing
def thrust(biped: Dimensions, track: Track, com: np.ndarray, t: float) -> Triple:
    """How far a bobbing head is from its middle place [m], world; com (3,) now. Who runs does not bob."""
    if biped.body.head_bob == 0:
        return 0.0, 0.0, 0.0
    footprints, curve = track
    i, _ = _step_at(footprints, t)
    before, place = max(i - 1, 0), _empty_place()
    _hold(footprints, curve, before, place[0])
    _hold(footprints, curve, i, place[1])
    x = smoothstep((t - footprints.contact_time[i]) / _dart_time(footprints, i))
    walks = 1 - mix(foot.runs(footprints, before), foot.runs(footprints, i), x)
    dx, dy = mix(place[0, 0], place[1, 0], x) - com[0], mix(place[0, 1], place[1, 1], x) - com[1]
    dz, most = mix(place[0, 2], place[1, 2], x) - com[2], THRUST * biped.timing.hip_height
    far = sqrt(dx * dx + dy * dy + dz * dz) / most
    share = biped.body.head_bob * walks * (1 + far**6) ** (-1 / 6)  # at most `most`, and hardly less before
    return share * dx, share * dy, share * dz
