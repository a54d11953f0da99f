"""Steps around others: nothing changes for one alone, and what is placed is free of what others hold."""

import numpy as np
import pytest

from motion.biped import load_biped
from planner.walking import WalkTo
from planner.way_around import wrong_side
from sim.simulation import Simulation
from worlds.world import World

BIRD = load_biped("bird")


def test_a_walker_goes_to_its_stops_and_stays():
    planner = WalkTo([(2, 5, 0.0)], [[(8, 5), (8, 9), (3, 9)]])
    sim, nearest = Simulation(World("plain", (12.0, 12.0)), [BIRD], planner), np.full(3, np.inf)
    for _ in range(60 * 40):
        sim.tick()
        nearest = np.minimum(nearest, np.linalg.norm(planner.stops[0] - sim.snapshot().com[0, :2], axis=1))
    assert nearest.max() < 0.6 and sim.crowd.reached[0] == 2 and sim.crowd.standing[0]
    assert np.linalg.norm(sim.snapshot().com[0, :2] - (3, 9)) < 0.5


def test_a_walker_may_begin_again():
    sim = Simulation(World("plain", (12.0, 12.0)), [BIRD], WalkTo([(3, 5, 0.0)], [[(7, 5), (3, 5)]], again=True))
    for _ in range(60 * 60):
        sim.tick()
    assert sim.crowd.reached[0] >= 8


def test_stops_of_another_shape_are_refused():
    with pytest.raises(ValueError, match="starts"):
        WalkTo([(2, 5, 0.0)], [(8, 5)])


def test_who_meet_head_on_pass_each_other():
    planner = WalkTo([(2, 5, 0.0), (10, 5, np.pi)], [[(10, 5)], [(2, 5)]])
    sim, nearest = Simulation(World("plain", (12.0, 10.0)), [BIRD, BIRD], planner), np.inf
    for _ in range(60 * 25):
        sim.tick()
        nearest = min(nearest, float(np.hypot(*np.diff(sim.snapshot().com[:, :2], axis=0)[0])))
    assert nearest > 0.39
    assert np.linalg.norm(sim.snapshot().com[:, :2] - planner.stops[:, 0], axis=1).max() < 0.6


def oncoming(x, y):
    """One at x, y who walks toward -x, as planner.avoiding.foresee tells: room to keep 0.5 m."""
    return np.array([[x, y, -0.5, 0.0, 0.5, -1.0, 0.0]])


def test_who_comes_against_one_belongs_on_the_left():
    ahead, to_the_left, to_the_right = (wrong_side(oncoming(2.0, y), 0.0, 0.0, 4.0) for y in (0.0, 1.0, -1.0))
    assert to_the_left == 0 and ahead > 0 and to_the_right > 0
    assert wrong_side(oncoming(2.0, 0.0), 0.0, -np.pi / 6, 4.0) < ahead < wrong_side(oncoming(1.0, 0.0), 0.0, 0.0, 4.0)
    assert wrong_side(oncoming(-1.0, 0.0), 0.0, 0.0, 4.0) == 0 and wrong_side(oncoming(5.0, 0.0), 0.0, 0.0, 4.0) == 0


def test_who_goes_the_same_way_may_be_on_either_side():
    same = oncoming(2.0, -0.2)
    same[0, 5] = 1.0
    assert wrong_side(same, 0.0, 0.0, 4.0) == 0
