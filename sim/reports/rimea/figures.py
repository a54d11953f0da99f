"""Figures of the RiMEA tests from where people went, a Flow: NaN where somebody is not there."""

import numpy as np

from planner.modes.people.mix import AGES, Mix
from sim.reports.flows import PER_SECOND, Flow
from worlds.contents.traffic import Traffic

MOVED = 0.3
"""Who is so far from where it was [m] has set out."""
STILL = 0.2
"""Who is slower than this [m/s] stands."""


def all_out(flow: Flow) -> float:
    """When the last is gone [s]; inf: somebody is there at the end."""
    there = ~np.isnan(flow.place[..., 0])
    return float(flow.time[-1]) if not there[-1].any() else float("inf")


def speed_between(flow: Flow, begin: float, end: float) -> float:
    """Speed of the first one over the ground between x = begin and x = end [m/s], whichever way; 0 where it came not so far."""
    x = flow.place[:, 0, 0]
    inside = np.flatnonzero((x > min(begin, end)) & (x < max(begin, end)))
    if len(inside) < 2 or (np.diff(inside) > 1).any():
        return 0.0
    return float(abs(x[inside[-1]] - x[inside[0]]) / (flow.time[inside[-1]] - flow.time[inside[0]]))


def latest_start(flow: Flow, traffic: Traffic, seed: int) -> float:
    """How much later than its reaction anyone sets out, at most [s]; inf where somebody does before it, or never."""
    mix, worst = Mix(traffic.population), 0.0
    for c in range(flow.place.shape[1]):
        away = np.hypot(*(flow.place[:, c] - flow.place[0, c]).T) > MOVED
        if not away.any():
            return float("inf")
        late = float(flow.time[away.argmax()]) - mix.person(seed, (0, c), 0).reaction
        worst = max(worst, late if late > 0 else np.inf)
    return worst


def within_their_ages(flow: Flow, traffic: Traffic, seed: int) -> float:
    """Share of those whose speed between x = 6 and 22 m lies within that of their age, 5 % either way."""
    mix, fits = Mix(traffic.population), []
    for c in range(flow.place.shape[1]):
        age = mix.person(seed, (c, 0), 0).age
        _, women, men = next(row for row in AGES if age <= row[0])
        speed = speed_between(flow._replace(place=flow.place[:, c : c + 1]), 6.0, 22.0)
        fits.append(0.95 * women[0] <= speed <= 1.05 * men[1])
    return float(np.mean(fits))


def last_places(flow: Flow) -> np.ndarray:
    """(C, 2) where each was when it was last there [m]."""
    there = ~np.isnan(flow.place[..., 0])
    last = len(there) - 1 - there[::-1].argmax(axis=0)
    return flow.place[last, np.arange(there.shape[1])]


def share_beyond(flow: Flow, x: float) -> float:
    """Share of people who go out beyond x [m]."""
    return float((last_places(flow)[:, 0] > x).mean())


def wrong_exits(flow: Flow, doors: np.ndarray) -> float:
    """How many go out nearer to another of the doors' x (D,) than to the one that was given to them: (C,) by their start."""
    begin, end = flow.place[0, :, 0], last_places(flow)[:, 0]
    given = np.where(begin < 14.0, 0, 1)
    return float((np.abs(end[:, None] - doors).argmin(axis=1) != given).sum())


def standing_within(flow: Flow, begin: float, end: float) -> float:
    """How many stand at once, at most, between x = begin and x = end [m]: the ninety-fifth in a hundred moments."""
    speed = np.hypot(*np.diff(flow.place, axis=0).transpose(2, 0, 1)) * PER_SECOND
    x = flow.place[1:, :, 0]
    with np.errstate(invalid="ignore"):
        count = ((speed < STILL) & (x > begin) & (x < end)).sum(axis=1)
    return float(np.percentile(count, 95)) if len(count) else 0.0
