"""Figures of throngs: known ones of people who stand, who walk in lanes, and whose bodies overlap."""

import numpy as np
import pytest

import main
from planner.crowd.bodies import gap_between
from planner.round.weights import PEOPLE
from sim.reports.flows import PER_SECOND, Flow
from sim.reports.throngs import cases, figures, places
from worlds.world import World

WORLD = World("w", (40.0, 7.0))


def walking(speeds, y, seconds=20):
    """People who walk along x from its middle, or against it, in lines at y."""
    time = np.arange(0, seconds, 1 / PER_SECOND)
    x = 20.0 + time[:, None] * np.array(speeds)
    return Flow(time, np.stack([x, np.broadcast_to(np.array(y, float), x.shape)], axis=2), WORLD)


def test_the_longest_standstill_is_known():
    flow = walking([1.0, 1.0], [3.0, 4.0])
    flow.place[50:81, 1, 0] = flow.place[50, 1, 0]
    flow.place[120:140, 0, 0] = flow.place[120, 0, 0]
    assert figures.still_longest(flow) == pytest.approx(3.0)
    flow.place[..., 0] -= 5.0  # the first is beyond 26 m before it stands, the second is not
    assert figures.still_longest(flow, 26.0) == pytest.approx(3.0)
    assert figures.still_longest(flow, 18.0) == pytest.approx(0.0)


def test_who_has_come_to_its_place_on_a_circle_may_stand_there():
    """Two change places, 20 m apart; one waits for 3 s on its way, both stand where they arrive."""
    time = np.arange(0, 30, 1 / PER_SECOND)
    way = np.minimum(np.stack([time, np.where(time < 5, time, np.maximum(time - 3, 5))], axis=1), 20.0)
    x = 20.0 + np.array([-1, 1]) * (10.0 - way)
    flow = Flow(time, np.stack([x, np.full_like(x, 20.0)], axis=2), World("w", (40.0, 40.0)))
    assert cases.still_before(flow) == pytest.approx(3.0) and cases.last_across(flow) == pytest.approx(21.6, abs=0.11)
    short = flow._replace(time=time[:200], place=flow.place[:200])
    assert cases.still_before(short) == np.inf == cases.last_across(short)


@pytest.mark.parametrize(
    ("y", "order"), [([2.0, 2.0, 4.0, 4.0], 1.0), ([3.0, 3.0, 3.0, 3.0], 1 / 9), ([2.0, 4.0, 2.0, 4.0], 1.0)]
)
def test_lanes_have_the_order_that_they_have(y, order):
    """Two go each way: each way in a lane of its own, all in one, or each beside one who goes against it alone."""
    flow = walking([0.01, 0.01, -0.01, -0.01], y)
    everyone = np.ones(flow.place.shape[:2], bool)
    assert figures.lanes(flow, everyone) == pytest.approx(order)
    assert figures.speed(flow, everyone) == pytest.approx(0.01)


def test_bodies_that_face_alike_overlap_by_what_they_are_too_near():
    flow = walking([0.0, 0.0], [3.0, 3.0], 4)
    flow.place[:, 1, 0] += np.where(np.arange(40) < 25, 0.24, 0.5)
    flow = flow._replace(heading=np.zeros((40, 2)), half=np.tile([0.15, 0.25], (2, 1)))
    np.testing.assert_allclose(figures.overlaps(flow)[[0, 39]], [[0.2, 0.2], [0, 0]], atol=1e-12)
    assert figures.longest_overlap(flow) == pytest.approx(2.5) and figures.deepest_overlap(flow) == pytest.approx(0.2)


def _apart(half, heading, half2, heading2, p):
    """Whether no point of the border of the second ellipse, p from the first, lies in the first, nor the first in it."""
    t = np.linspace(0, 2 * np.pi, 1200)
    x, y = half2[0] * np.cos(t), half2[1] * np.sin(t)
    c, s = np.cos(heading2), np.sin(heading2)
    x, y = p[0] + c * x - s * y, p[1] + s * x + c * y
    c, s = np.cos(heading), np.sin(heading)
    return bool((np.hypot((c * x + s * y) / half[0], (c * y - s * x) / half[1]) > 1).all())


def _depth(half, heading, half2, heading2, p):
    """How far the second must move at least, whichever way, to leave the first: found by moving it."""
    found = 1.5
    for angle in np.linspace(0, 2 * np.pi, 180, endpoint=False):
        way, inside, outside = np.array([np.cos(angle), np.sin(angle)]), 0.0, found
        while outside - inside > 1e-5 and _apart(half, heading, half2, heading2, p + found * way):
            middle = 0.5 * (inside + outside)
            free = _apart(half, heading, half2, heading2, p + middle * way)
            inside, outside = (inside, middle) if free else (middle, outside)
        found = outside
    return found


def test_how_deep_bodies_lie_in_each_other_is_how_far_one_must_move():
    random, half = np.random.default_rng(1), np.array([[0.135, 0.21]] * 8)
    headings, angle = random.uniform(-np.pi, np.pi, (2, 8)), random.uniform(-np.pi, np.pi, 8)
    apart = random.uniform(0.12, 0.28, (8, 1)) * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    told = figures.gaps(half, headings[0], half, headings[1], apart)
    twin = [_depth(half[k], headings[0, k], half[k], headings[1, k], apart[k]) for k in range(8) if told[k] < 0]
    assert len(twin) > 4
    np.testing.assert_allclose(-told[told < 0], twin, atol=3e-4)


def test_bodies_that_face_differently_overlap_before_their_radii_do():
    half, heading, p = (0.135, 0.21), 0.9, np.array([0.0, 0.33])
    straight = gap_between(half, (np.cos(heading), np.sin(heading)), half, (np.cos(heading), -np.sin(heading)), *p)
    told = figures.gaps(*(np.array([v]) for v in (half, heading, half, -heading, p)))
    assert told[0] < straight - 0.005


def test_streams_meet_where_both_are():
    time = np.arange(0, 30, 1 / PER_SECOND)
    x = 20.0 + np.array([-15.0, 15.0]) + time[:, None] * np.array([1.0, -1.0])
    flow = Flow(time, np.stack([x, np.full_like(x, 3.0)], axis=2), WORLD)
    met = places.met(flow)
    assert met[:, 0].sum() == met[:, 1].sum() > 0 and not met[:50].any() and met[150].all()


@pytest.mark.parametrize("density", cases.TWO_WAYS)
def test_two_streams_pass_each_other_in_lanes_at_a_metre_per_second(density):
    flow = places.two_ways(density, PEOPLE)
    met = places.met(flow)
    assert met.any() and figures.lanes(flow, met) > 0.8 and 0.95 < figures.speed(flow, met) < 1.1


def test_a_table_of_ablation_is_asked_for_by_an_option(monkeypatch, capsys):
    from sim.reports.throngs import ablation

    monkeypatch.setattr(ablation, "_row", lambda name, weights: f"{name} {sum(value == 0 for value in weights)}")
    assert main.main(["verify", "--ablation"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[2] == "nothing 0" and lines[3] == "progress 1" and not any("horizon" in line for line in lines)
