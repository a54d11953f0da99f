"""Bodies that would touch press each other apart, as they are posed; plans stay what they are."""

from math import cos, sin

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.track.footprints import step_onto
from planner.modes.custom import Custom
from planner.round.round import Wish, biped_of
from planner.stepping.beside import beside, middle_beside
from sim.reports import flows
from sim.reports.throngs import figures
from sim.stage.simulation import Simulation
from worlds.world import World

HUMAN = load_character("human")
STRIDE = 0.5
FIRST = (3.0, 3.0, 0.0)


@pytest.mark.parametrize(
    ("width", "seed", "until", "was"),
    [(1.2, 5, 30.0, 0.209), (2.0, 7, 30.2, 0.131), (3.0, 6, 8.5, 0.091), (0.9, 12, 59.5, 0.061)],
)
def test_bodies_hardly_overlap_in_a_throng(width, seed, until, was):
    """Where they did, the com strayed further from its plan than the room that bodies keep."""
    flow = flows.watched(flows.bottleneck(width, seed=seed), until, bodies=True)
    assert figures.deepest_overlap(flow) < 0.03 < was


def _straight_on(round, me):
    """Straight on, whoever is in the way."""
    biped, foot, side = biped_of(round, me), me.feet.newer, 1 - me.feet.newer.side
    x, y = middle_beside(biped, foot)
    place = beside(biped, side, (x + STRIDE * cos(foot.heading), y + STRIDE * sin(foot.heading)), foot.heading)
    return Wish(step_onto(side, *place, foot.heading), foot.heading)


def _walked(*starts):
    """(F, C, 3) where those are who go straight on from x, y [m], heading [rad]; and what the dearest window costs."""
    sim, com, cost = Simulation(World("yard", (12.0, 8.0)), [HUMAN] * len(starts), Custom(_straight_on, starts)), [], 0.0
    while sim.time < 5.0:
        sim.tick()
        com.append(sim.com().copy())
        cost = max(cost, float(sim.crowd.window_cost[:, 0].max()))
    return np.array(com), cost


def _past(aside):
    """Two who go against each other, so far aside [m]: where they are, how far that is from where the first would be alone, and
    what the dearest window costs."""
    (both, cost), (alone, _) = _walked(FIRST, (9.0, 3.0 + aside, np.pi)), _walked(FIRST)
    return both, both[:, 0] - alone[:, 0], cost


def test_shoulders_that_would_graze_are_leant_out_of_each_other():
    found = []
    for aside in (0.33, 0.35, 0.37):
        both, moved, cost = _past(aside)
        beside = np.abs(both[:, 0, 0] - both[:, 1, 0]) < 0.05
        found.append((both[beside, 1, 1] - both[beside, 0, 1]).min())
        assert np.abs(moved).max() < 0.05 and cost < 1
    assert min(found) > 0.41, "0.37 m without"


def test_who_passes_with_room_moves_as_alone_to_the_bit():
    assert not _past(0.6)[1].any()


@pytest.mark.parametrize("aside", [0.0, 0.2])
def test_who_goes_through_another_is_not_thrown_about(aside):
    _, moved, cost = _past(aside)
    assert np.abs(moved).max() < 0.07 and cost < 2


@pytest.mark.parametrize(
    ("name", "other", "aside"), [("dinosaur", "dinosaur", 0.5), ("ostrich", "ostrich", 0.3), ("human", "dinosaur", 0.3)]
)
def test_large_ones_who_go_through_each_other_are_not_thrown_about(name, other, aside):
    """They were, by up to 65 m/s^2: what a spring could not do in time it asked for again and again."""
    starts = np.array([(6.0, 10.0, 0.0), (14.0, 10.0 - aside, np.pi)])
    sim, fastest = (
        Simulation(World("yard", (20.0, 20.0)), [load_character(one) for one in (name, other)], Custom(_straight_on, starts)),
        0.0,
    )
    while sim.time < 7.0:
        sim.tick()
        fastest = max(fastest, float(np.linalg.norm(sim.snapshot().com_acceleration[:, :2], axis=1).max()))
    assert fastest < 5 and sim.crowd.window_cost[:, 0].max() < 2
