"""A motion whose timing is dragged glides: what is shown follows what is solved no further than the hand goes.

The best curve is continuous in its timing, but turns over within milliseconds where a step that is walked becomes one that is
leapt, or where legs come to their end. While a hand drags, the shown curve is the solved one and a lag, which carries on,
contact by contact, from what was shown before:

    shown = solved + lag,    lag = (1 - PACE h / d)+ (what was shown - solved),    d the greatest distance between the two

where h is by how many seconds the hand has moved a contact or a leaving. As time goes by the lag falls off, by exp(-t / LAG).
"""

from dataclasses import replace
from math import exp, inf

import numpy as np

from motion.motion import Motion
from motion.track.curve import Curve, states_at
from motion.track.footprints import Footprints

PACE = 1.6
"""How far the body moves at most for each second that a footprint is dragged [m/s]: 8 mm for 5 ms."""
LAG = 0.08
"""In so many seconds of rest about two thirds of the lag are gone."""
PIECE = 0.06
"""The longest piece [s] of a curve with a lag."""
SPAN = 0.015
"""Half the time [s] over which the velocity of the lag is taken: that of a moment, between brief pieces, says nothing."""
NEAR = 1e-4
"""A lag of less [m] is none."""
TIMED = {"contact_time", "stance_time"}
PLACED = {"position", "gravity", "comfort", "bounce"}
"""What of footprints no timing changes: where that has changed, something else is dragged than a time."""


def glide(shown: Motion, solved: Motion) -> Motion:
    """What is shown of a motion that has been solved anew, after `shown`, as its timing was dragged; else the solved one."""
    seconds = _dragged(shown.footprints, solved.footprints)
    if seconds == inf:
        return solved
    goal = _in_short_pieces(solved.curve)
    place = _behind(shown, solved, goal, goal.time)
    far = _farthest(place)
    share = 1 - PACE * seconds / max(far, NEAR)
    return solved if share * far < NEAR else _lagging(solved, goal, share * _lag(shown, solved, goal, place))


def settle(shown: Motion, solved: Motion, seconds: float) -> Motion:
    """What is shown a while later, of a motion that is no longer dragged."""
    goal = _in_short_pieces(solved.curve)
    lag = exp(-seconds / LAG) * (shown.curve.control - goal.control)
    return solved if _farthest(lag[:, :3]) < NEAR else _lagging(solved, goal, lag)


def _dragged(before: Footprints, after: Footprints) -> float:
    """By how much times were dragged [s]: 0 where nothing has changed, infinite where something else has."""
    if len(before.side) != len(after.side):
        return inf
    changed = {k for k in before._fields if not np.array_equal(getattr(before, k), getattr(after, k))}
    if changed & PLACED or (changed and not changed & TIMED):
        return inf
    contact = np.abs(after.contact_time - before.contact_time)
    left = np.abs(after.contact_time + after.stance_time - before.contact_time - before.stance_time)
    return float(max(contact.max(), left[:-2].max(initial=0.0)))


def _in_short_pieces(curve: Curve) -> Curve:
    """The same curve, none of whose pieces is longer than PIECE: a flight is one, and a lag may bend within it."""
    long = np.diff(curve.time)
    count = np.ceil(long / PIECE).astype(np.int64)
    first = np.repeat(np.cumsum(count) - count, count)
    time = np.repeat(curve.time[:-1], count) + (np.arange(count.sum()) - first) * np.repeat(long / count, count)
    time = np.append(time, curve.time[-1])
    return Curve(time, states_at(curve, time), np.vstack([np.repeat(curve.support[:-1], count, axis=0), curve.support[-1:]]))


def _behind(shown: Motion, solved: Motion, goal: Curve, times: np.ndarray) -> np.ndarray:
    """How far the shown body is from the curve `goal` of the solved one (n, 3) at times of that one, contact by contact."""
    now, then = (np.append(one.footprints.contact_time[1:], one.end) for one in (solved, shown))
    return np.asarray(states_at(shown.curve, np.interp(times, now, then))[:, :3] - states_at(goal, times)[:, :3])


def _lag(shown: Motion, solved: Motion, goal: Curve, place: np.ndarray) -> np.ndarray:
    """That place (m + 1, 3) at the control points of `goal`, with its velocity (m + 1, 6)."""
    if np.array_equal(goal.time, shown.curve.time):
        return shown.curve.control - goal.control
    before, after = np.maximum(goal.time - SPAN, goal.time[0]), np.minimum(goal.time + SPAN, goal.time[-1])
    first, last = (_behind(shown, solved, goal, times) for times in (before, after))
    lag = np.hstack([place, (last - first) / (after - before)[:, None]])
    lag[[0, -1]] = 0.0
    return lag


def _farthest(place: np.ndarray) -> float:
    return float(np.linalg.norm(place, axis=1).max())


def _lagging(solved: Motion, goal: Curve, lag: np.ndarray) -> Motion:
    """The solved motion, of curve `goal`, with a lag (m + 1, 6)."""
    return replace(solved, curve=goal._replace(control=goal.control + lag))
