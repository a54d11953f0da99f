"""Crowds in each other's way: nobody treads on another, nobody walks through another, nobody is stuck."""

import hashlib

import numba
import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.wander import Wander
from sim.stage.making import make_visited
from sim.stage.simulation import Simulation
from tests.crowds import Watch, forest, ring, streams
from worlds.errors import InputError
from worlds.level import load_level
from worlds.world import World


def assert_well(watch, still):
    figures = watch.figures()
    assert figures["feet overlaps"] == 0 and figures["body overlap % of depth"] <= 5, figures
    assert figures["least clearance m"] > 0 and figures["longest standstill s"] <= still, figures
    assert figures["not arrived"] == 0, figures


def test_a_ring_swaps_sides():
    assert_well(Watch(ring(12, 3.0)).run(60), 10)


@pytest.mark.parametrize("character", ["bird", "human"])
def test_streams_pass_a_gap(character):
    assert_well(Watch(streams(8, character)).run(90), 10)


@pytest.mark.parametrize("seed", [2, 9])
def test_people_who_wait_at_the_wall_beside_a_gap_are_let_in(seed):
    assert_well(Watch(streams(20, "human", seed=seed)).run(90), 10)


def test_wanderers_share_a_crowded_forest():
    assert_well(Watch(forest(60, 14.0)).run(20), 10)


def digest(threads):
    before = numba.get_num_threads()
    numba.set_num_threads(threads)
    try:
        sim = ring(24, 3.0)
        for _ in range(600):
            sim.tick()
        return hashlib.sha256(sim.crowd.footprints.position.tobytes() + sim.crowd.committed.control.tobytes()).hexdigest()
    finally:
        numba.set_num_threads(before)


def test_threads_change_nothing_in_a_throng():
    assert digest(1) == digest(min(2, numba.config.NUMBA_NUM_THREADS))


def test_a_full_world_says_so():
    with pytest.raises(InputError, match="no room for bird number"):
        Simulation(World("closet", (3.0, 3.0), start=(1.5, 1.5)), [load_character("bird")] * 50, Wander())


def test_everyone_starts_apart():
    places = Wander().starts(World("yard", (20.0, 20.0), start=(10, 10)), [load_character("bird")] * 200, 3)[:, :2]
    apart = np.linalg.norm(places[:, None] - places[None], axis=2) + np.where(np.eye(200), np.inf, 0)
    assert apart.min() >= 1.4 * 0.4


def test_windows_of_people_who_walk_among_others_are_solved():
    """One in a hundred was left at forty times its least cost, and bodies were thrown about by 9 m/s^2 in single steps."""
    sim, costs = make_visited("concourse", 200, 0), []
    while sim.time < 20.0:
        before = sim.crowd.number.copy()
        sim.tick()
        window, last = sim.crowd.window.time, sim.crowd.points - 1
        for c in np.flatnonzero(sim.crowd.number != before):
            costs.append(sim.crowd.window_cost[c, 0] / (window[c, last[c]] - window[c, 0]))
    assert len(costs) > 500 and np.mean(np.array(costs) > 1) < 0.003 and max(costs) < 3


def test_who_is_posed_beside_others_is_posed_as_alone_to_the_bit():
    kinds = [load_character(name) for name in ("bird", "human", "ostrich")]
    sim = Simulation(load_level("forest"), [kinds[k % 3] for k in range(11)], Wander(), 5)
    for _ in range(150):
        sim.tick()
    rows = np.array([4, 0, 10, 7, 1, 2, 9, 3, 8, 5])
    together = sim.snapshot(sim.time - 0.01, rows)
    for k, c in enumerate(rows):
        for found, alone in zip(together, sim.snapshot(sim.time - 0.01, np.array([c])), strict=True):
            np.testing.assert_array_equal(found[k], alone[0])
