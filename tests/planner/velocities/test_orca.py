"""The second model: half-planes as they are told, and that it lets people walk, as safely as the first."""

import numpy as np
import pytest

from planner.round.weights import PEOPLE
from planner.velocities.orca import evasion
from sim.reports import flows
from sim.reports.throngs import figures, places

ORCA = PEOPLE._replace(model="orca")
RADIUS, HORIZON = 0.4, 2.0


def nearest_approach(p, w, until):
    """How near one who goes at w comes to another at p that stands, until then."""
    t = np.linspace(0, until, 4001)
    return np.hypot(p[0] - t * w[0], p[1] - t * w[1]).min()


def test_after_an_evasion_two_just_do_not_touch():
    r = np.random.Generator(np.random.Philox(key=3))
    for _ in range(200):
        p, w = r.uniform(-2, 2, 2), r.uniform(-1.5, 1.5, 2)
        if np.hypot(*p) > 1.05 * RADIUS:
            ux, uy, dx, dy = evasion(tuple(p), tuple(w), RADIUS, HORIZON, 0.4)
            assert nearest_approach(p, w + (ux, uy), HORIZON) == pytest.approx(RADIUS, abs=2e-3)
            assert abs(ux * dx + uy * dy) < 1e-9 and np.hypot(dx, dy) == pytest.approx(1)
            collides = nearest_approach(p, w, HORIZON) < RADIUS
            assert (ux * -dy + uy * dx > 0) == collides, "it leads out of what is forbidden, or says how much is left"


def test_who_overlap_part_soon():
    ux, uy, *_ = evasion((0.3, 0.0), (0.0, 0.0), RADIUS, HORIZON, 0.5)
    assert (ux, uy) == pytest.approx((-0.2, 0.0))


def test_people_walk_by_it_and_keep_apart():
    flow = flows.watched(flows.ring(1.0, ORCA), 8.0, bodies=True)
    assert flows.ring_speed(flow) > 0.9 and figures.longest_overlap(flow) <= 0.3
    flow = flows.watched(places.circle(8, 2.5, ORCA), 40.0, bodies=True)
    gone = np.hypot(*(flow.place[-1] - flow.place[0]).T)
    assert gone.min() > 4.0 and figures.longest_overlap(flow) <= 0.3, "all come to the other side"


def test_it_is_another_model():
    first, second = (flows.watched(flows.counterflow(3, weights=table), 6.0).place for table in (PEOPLE, ORCA))
    assert np.abs(first - second[: len(first)]).max() > 0.01
