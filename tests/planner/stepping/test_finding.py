"""Getting on: nobody treads on the spot for good before rocks, in holes or at banks."""

import numpy as np
import pytest

from motion.characters.character import character_names, load_character
from planner.modes.walk_to import WalkTo
from planner.modes.wander import Wander
from planner.planner import NoWay
from sim.stage.simulation import Simulation
from worlds.world import River, World

SIZE = (16.0, 10.0)


def rocks(*of):
    return np.array(of, float)


def walked(world, name, seconds=25.0):
    """Where a walker to (13, 5) is after so many seconds."""
    sim = Simulation(world, [load_character(name)], WalkTo([(3.0, 5.0, 0.0)], [[(13.0, 5.0)]]), 1)
    while sim.time < seconds:
        sim.tick()
    return sim.snapshot().com[0, :2]


@pytest.mark.parametrize("name", character_names())
@pytest.mark.parametrize("aside", [-0.3, 0.0, 0.2])
def test_a_walker_goes_around_a_rock_that_is_too_high_to_step_on(name, aside):
    height = 1.2 * float(load_character(name).biped.reach.max_rise)
    wide = World("rocks", SIZE, rocks=rocks((7.0, 5.0 + aside, 0.6, height), (9.0, 5.0 - aside, 0.5, height)))
    assert np.hypot(*(walked(wide, name) - (13.0, 5.0))) < 0.6


def test_where_no_way_leads_that_is_told_before_anyone_walks():
    river = World("bank", SIZE, rivers=(River(np.array([[8.0, -5.0], [8.0, 15.0]]), 2.0),))
    with pytest.raises(NoWay, match=r"stops\.0\.0 at \(13, 5\): no way for the human leads there from \(3\.00, 5\.00\): water"):
        walked(river, "human")
    ring = rocks(*((13 + 1.5 * np.cos(a), 5 + 1.5 * np.sin(a), 0.5, 1.0) for a in np.linspace(0, 2 * np.pi, 24)))
    with pytest.raises(NoWay, match="rocks bar it"):
        walked(World("ring", SIZE, rocks=ring), "human")


def test_a_loop_of_stops_leads_back_too():
    trench = World("bank", SIZE, rivers=(River(np.array([[8.0, -5.0], [8.0, 15.0]]), 2.0),))
    stops = [[(4.0, 5.0), (4.0, 8.0)]]
    sim = Simulation(trench, [load_character("human")], WalkTo([(3.0, 5.0, 0.0)], stops, again=True), 1)
    for _ in range(60):
        sim.tick()
    with pytest.raises(NoWay, match=r"stops\.0\.1"):
        Simulation(trench, [load_character("human")], WalkTo([(3.0, 5.0, 0.0)], [[(4.0, 5.0), (12.0, 5.0)]], again=True), 1)


def test_chance_starts_nobody_on_a_rock_from_which_no_step_leads():
    high = rocks(*((x, y, 0.8, 1.4) for x in np.arange(1.5, 16, 2.0) for y in np.arange(1.5, 10, 2.0)))
    world = World("pillars", SIZE, rocks=high, start=(0.5, 5.5))
    sim = Simulation(world, [load_character("human")] * 6, Wander(), 3)
    assert sim.snapshot().ball[..., 2].max() < 0.1
