"""What runs do after a command: those who are paused stand, recast ones walk on, and measurements stay true."""

import numpy as np

from motion.characters.character import load_character
from planner.modes.wander import Wander
from sim.files.recording import Recorder
from sim.reports.measure import measure
from sim.stage.commands import Pause, PlantTree, PutRock, Recast, apply
from sim.stage.making import make_simulation
from sim.stage.simulation import Simulation
from tests.sim.stage.test_commands import ticked, wandering
from worlds.level import load_level


def test_one_that_is_paused_stands_while_the_others_go_on():
    sim = ticked(wandering(), 200)
    apply(sim, Pause(1))
    ticked(sim, 120)
    still = sim.snapshot().toe[1].copy()
    moved = sim.com()[0].copy()
    ticked(sim, 240)
    np.testing.assert_array_equal(sim.snapshot().toe[1], still)
    assert np.linalg.norm(sim.com()[0] - moved) > 0.5
    apply(sim, Pause(1, False))
    ticked(sim, 300)
    assert np.abs(sim.snapshot().toe[1] - still).max() > 0.3


def test_one_that_is_recast_walks_on_where_it_stood():
    sim = ticked(wandering(), 300)
    feet = sim.feet().position[1, :, :2].mean(axis=0)
    apply(sim, Recast.to(1, load_character("human")))
    assert np.linalg.norm(sim.com()[1, :2] - feet) < 0.2 and sim.leg(1) > 1.7 * sim.leg(0)
    ticked(sim, 600)
    assert np.linalg.norm(sim.com()[1, :2] - feet) > 1.0


def test_edits_do_not_falsify_a_measurement():
    """A tree planted where footprints lie by then was not there when they were made; nor does one of a human measure a bird."""
    sim = make_simulation("forest", "bird", 1, 4, False)
    recorder = Recorder(sim)
    for k in range(1200):
        sim.tick()
        recorder.capture()
        if k == 600:
            behind = sim.walked().footprints.position[2, :2].tolist()
            apply(sim, PlantTree(*behind, 0.4))
        if k == 800:
            apply(sim, Recast.to(0, load_character("human")))
    report = measure(recorder.recording())
    assert report["worst"]["tree_distance"] > 0.1
    assert [one["name"] for one in report["characters"]] == ["bird", "human"]
    assert report["worst"]["skate"] < 1e-3 and report["worst"]["overreach"] < 1e-3


def test_wanderers_of_a_level_change_worlds_without_losing_their_way():
    sim = ticked(Simulation(load_level("forest_river"), [load_character("human")], Wander(), 3), 100)
    apply(sim, PutRock(5.0, 5.0))
    assert ticked(sim, 300).steps_planned[0] > 5
