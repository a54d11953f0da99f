"""Trials: a short one of each character, and that what they look for is found where it is."""

import json

import numpy as np
import pytest

from motion.characters.character import character_names, load_character
from planner.modes.steer import Steered
from sim.cli import entry, parser
from sim.reports.trials.answers import answer, twin
from sim.reports.trials.trial import as_dict, in_words, misplaced, seed_of, trial
from sim.reports.trials.watching import Watch, Worst
from sim.stage.commands import PlantTree, apply, steer, steer_by_chance
from sim.stage.making import make_steered
from sim.stage.simulation import Simulation
from worlds.world import World

YARD = World("yard", (40.0, 30.0), start=(10.0, 15.0))


def walking(name="human", ticks=240):
    sim = Simulation(YARD, [load_character(name)], Steered(), 0)
    sim.keep_footprints()
    for _ in range(60):
        sim.tick()
    steer(sim, 0.0, "walk")
    for _ in range(ticks):
        sim.tick()
    return sim


@pytest.mark.parametrize("name", character_names())
@pytest.mark.parametrize("level", ["river_delta", "hills"])
def test_keys_by_chance_do_no_harm(level, name):
    found = trial(level, name, 25.0, 3)
    assert found.soles == {} and found.body > 0 and found.skate < 1e-4
    assert found.jump.value < 0.05 and found.turn.value < 0.25 and found.kick.value < 2.5
    assert found.ended <= 1 and found.at_once >= 0.7 * found.keys == 14.0
    assert json.loads(json.dumps(as_dict(found)))["jump"]["joint"] and "soles all well" in in_words(found)


@pytest.mark.parametrize(
    ("level", "name", "seconds", "seed"),
    [("dense_forest", "human", 17.0, 1), ("dense_forest", "human", 16.0, 7), ("rooms", "dinosaur", 22.0, 7)],
)
def test_what_stood_beyond_its_reach_leaves_without_a_jerk(level, name, seconds, seed):
    sim = make_steered(level, name, 1, seed_of(level, name, seed))
    watch = Watch(sim)
    for _ in range(round(seconds * sim.tick_rate)):
        sim.tick()
        steer_by_chance(sim)
        watch.look()
    assert watch.jump.value < 0.02 and watch.turn.value < 0.1


def test_a_key_is_answered_by_the_footprint_that_is_planned_next():
    sim = walking()
    before = sim.crowd.number.copy(), sim.snapshot().knee.copy()
    found = answer(sim, (1.0, "walk", 0.0, False))
    assert found.later == 0 and found.contacts <= 1 and 0.3 < found.seconds < 2.0
    assert answer(sim, (0.0, "walk", 0.0, False)) is None
    np.testing.assert_array_equal(sim.crowd.number, before[0])
    np.testing.assert_array_equal(sim.snapshot().knee, before[1])


def test_a_twin_goes_on_as_the_run_itself_would():
    sim = walking()
    other = twin(sim)
    for _ in range(150):
        sim.tick(), other.tick()
    np.testing.assert_array_equal(sim.snapshot().toe, other.snapshot().toe)
    assert sim.time == other.time


def test_soles_in_a_tree_are_found():
    sim = walking()
    assert not misplaced(sim)
    x, y = sim.walked().footprints.position[-1, :2].tolist()
    apply(sim, PlantTree(x + 4.0, y, 0.3))
    sim.world = sim.world.with_tree(x, y, 0.3)  # which no command would do
    assert set(misplaced(sim)) == {"is in a tree"}


class Bent:
    """A cast whose every joint starts to move at once when a foot lands."""

    def __init__(self, sim, speed):
        self.sim, self.speed, self.at = sim, speed, float(sim.track(0).contact_time[-2])

    def __getattr__(self, name):
        return getattr(self.sim, name)

    def snapshot(self, time, rows):
        pose = self.sim.snapshot(time, rows)
        pose.head[:, 0] += self.speed * max(time - self.at, 0.0)
        return pose


def test_a_joint_that_starts_at_once_is_found():
    sim = walking()
    watch = Watch(Bent(sim, 0.7))
    for _ in range(120):
        sim.tick()
        watch.look()
    assert watch.jump == Worst(pytest.approx(0.7, abs=1e-3), "head", watch.sim.at)
    assert watch.kick.value < 3.0


def test_the_command_tells_each(capsys):
    assert entry.run(parser.parsed(["trials", "forest", "--character", "bird", "--seconds", "3", "--json"])) == 0
    (one,) = json.loads(capsys.readouterr().out)
    assert one["level"] == "forest" and one["character"] == "bird" and one["seconds"] == 3.0
    assert entry.run(parser.parsed(["trials", "forrest"])) == 2
    assert "forest" in capsys.readouterr().err
