"""The head (paper, section 2.5): where it looks, and where a bird's stays while the body walks on; functions of time.

It looks where the feet will go: aside before the body turns, down at footprints that need care (rocks, treads), over the
shoulder walking backward. A bird's head keeps its place in the world while one foot carries the body and darts ahead while both
stand (Dagg 1977): between the holds of two steps

    place(t) = mix(com(middle of the last hold), com(middle of this one), smoothstep(x)),   x: share of the double stance
"""

from typing import NamedTuple

from motion.arithmetic.functions import exponential, levelled, logarithm
from motion.arithmetic.smooth import mix, smoothstep
from motion.arithmetic.triples import Triple, between, minus, norm, times
from motion.characters.dimensions import Dimensions
from motion.track import foot, heading
from motion.track.curve import Track, place_at
from motion.track.footprints import Footprints, out_of_plane
from worlds.compiled.across import any_of
from worlds.compiled.jit import jit_borrowing
from worlds.compiled.lanes import Some, choose, larger, smaller
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

    heading: Some  # [rad]
    down: Some  # [rad]


@jit_borrowing
def on_rocks(footprints: Footprints, t: Some) -> Some:
    """How much the feet are on rocks at time t: 0 on land, 1 on rocks, smooth between contacts."""
    i, x = _step_at(footprints, t)
    following = smaller(i + 1, len(footprints.side) - 1)
    now, then = choose(footprints.rock[i] >= 0, 1.0, 0.0), choose(footprints.rock[following] >= 0, 1.0, 0.0)
    return mix(now, then, smoothstep(x))


@jit_borrowing
def looks(biped: Dimensions, footprints: Footprints, yaw: Some, pace: Some, t: Some) -> Looks:
    """Where the head of a walker is turned whose body has heading yaw [rad] and that pace (motion.pose.trunk)."""
    ahead = heading.mean_heading(footprints, t, 0.4 * heading.window_length(biped))
    backward = OVER_SHOULDER * smoothstep(-pace / BACKWARD)
    i, x = _step_at(footprints, t)
    care = mix(_care(biped, footprints, i + 1), _care(biped, footprints, i + 2), smoothstep(x))
    return Looks(yaw + LOOKS_ASIDE * levelled((ahead - yaw) / LOOKS_ASIDE) + backward, LOOKS_DOWN * care)


@jit_borrowing
def _care(biped: Dimensions, footprints: Footprints, n: Some) -> Some:
    """How much footprint n, or the last one, is looked at: rocks wholly, treads by their height."""
    n = smaller(n, len(footprints.side) - 1)
    step = choose(n > 0, abs(out_of_plane(footprints, larger(n, 1))) / biped.timing.hip_height, 0.0)
    return choose(footprints.rock[n] >= 0, 1.0, smoothstep((step - CARE[0]) / (CARE[1] - CARE[0])))


@jit_borrowing
def _step_at(footprints: Footprints, t: Some) -> tuple[Some, Some]:
    """(footprint that landed last, share of the time to the next contact that has passed since)."""
    i = larger(newest(footprints.contact_time, t), 0)
    return i, smaller(larger((t - footprints.contact_time[i]) / larger(footprints.step_time[i], 1e-3), 0.0), 1.0)


@jit_borrowing
def _dart_time(footprints: Footprints, i: Some) -> Some:
    """How long the head darts after contact i [s]: while both feet stand."""
    last, step = larger(i - 1, 0), larger(footprints.step_time[i], 1e-3)
    both = footprints.contact_time[last] + footprints.stance_time[last] - footprints.contact_time[i]
    return smaller(larger(choose(i > 0, both, 0.0), DART[0] * step), DART[1] * step)


@jit_borrowing
def _hold(track: Track, i: Some) -> Triple:
    """Where the com is in the middle of the hold after contact i."""
    footprints, curve = track
    contact = footprints.contact_time[i]
    middle = contact + 0.5 * (_dart_time(footprints, i) + footprints.step_time[i])
    return place_at(curve, smaller(larger(middle, curve.time[0]), curve.time[len(curve.time) - 1]))


@jit_borrowing
def thrust(biped: Dimensions, track: Track, com: Triple, t: Some) -> Triple:
    """How far a bobbing head is from its middle place [m], world; com now. Who runs does not bob."""
    bob, footprints = biped.body.head_bob, track.footprints
    if not any_of(bob > 0.0):
        return 0.0 * bob, 0.0 * bob, 0.0 * bob
    i, _ = _step_at(footprints, t)
    before = larger(i - 1, 0)
    x = smoothstep((t - footprints.contact_time[i]) / _dart_time(footprints, i))
    walks = 1 - mix(foot.runs(footprints, before), foot.runs(footprints, i), x)
    away = minus(between(_hold(track, before), _hold(track, i), x), com)
    far = norm(away) / (THRUST * biped.timing.hip_height)
    cube = far * far * far
    return times(bob * walks * exponential(logarithm(1 + cube * cube) / -6), away)  # at most THRUST, and hardly less before
