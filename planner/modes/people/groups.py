"""Groups: people who came together walk together, abreast where there is room.

Each is drawn to its place in a line across the way of the group, about its middle, and slows down where it is ahead of the
others (Moussaid, Perozo, Garnier, Helbing & Theraulaz 2010: two and three walk abreast, about 0.75 m from each other).
"""

import numpy as np

from planner.modes.visiting import Visits
from planner.planner import Moment

ABREAST = 0.75
"""Metres between two who walk side by side."""
PULL, MOST = 0.5, 0.6
"""Share of the way to its place that one is drawn by, per metre, and at most: in the unit of its course."""
AHEAD, CALM, SLOWER, SLOWEST = 0.1, 0.75, 1.0, 0.35
"""Who is further ahead of the middle than AHEAD [m] takes steps of CALM of its own, SLOWER less for each metre, at least
SLOWEST: a wish that is hardly shorter than one's own step is none among others (planner.crowd.avoiding)."""
LOST = 12.0
"""Who is further from its group than this [m] goes on alone."""


def keep_together(plans: Visits, moment: Moment) -> None:
    """Sets pace and draw of those who came in groups and are on their way."""
    stops = plans.stops
    walk = plans.there & (plans.rest == 0)
    stops.pace[:], stops.draw[:] = 1.0, 0.0
    rows = np.flatnonzero(walk & (plans.group >= 0))
    key = plans.source[rows] * 2**40 + plans.group[rows]
    for one in np.unique(key):
        members = rows[key == one]
        if len(members) > 1:
            _together(plans, moment, members)


def _together(plans: Visits, moment: Moment, members: np.ndarray) -> None:
    place, stops = moment.place[members], plans.stops
    middle = place.mean(axis=0)
    near = np.hypot(*(place - middle).T) < LOST
    members, place = members[near], place[near]
    if len(members) < 2:
        return
    way = (stops.stops[members, 0] - place).mean(axis=0)
    gone = (moment.rest[members] - place).mean(axis=0)
    ahead = gone if np.hypot(*gone) > 0.05 else way
    ahead = ahead / max(np.hypot(*ahead), 1e-9)
    left = np.array([-ahead[1], ahead[0]])
    off = place - middle
    order = np.argsort(np.argsort(off @ left, kind="stable"), kind="stable")
    seat = ABREAST * (order - 0.5 * (len(members) - 1))
    aside = seat - off @ left
    stops.draw[members] = np.clip(PULL * aside, -MOST, MOST)[:, None] * left
    further = off @ ahead - AHEAD
    stops.pace[members] = np.where(further > 0, np.maximum(CALM - SLOWER * further, SLOWEST), 1.0)
