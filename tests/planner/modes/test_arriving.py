"""Who has arrived comes to rest."""

import numpy as np
import pytest

from motion.characters.character import Character, character_names, load_character
from motion.characters.dimensions import flat_name
from planner.modes.walk_to import WalkTo
from sim.stage.simulation import Simulation
from worlds.world import World

YARD = World("yard", (20.0, 20.0), start=(10.0, 10.0))


@pytest.mark.parametrize("name", character_names())
@pytest.mark.parametrize("stop", [(8.0, 5.0), (5.0, 8.5), (3.0, 2.0)])
def test_who_has_arrived_is_at_rest_a_second_after_its_last_step(name, stop):
    sim = Simulation(YARD, [load_character(name)], WalkTo([(5.0, 5.0, 0.0)], [[stop]]), 1)
    sim.keep_footprints()
    times, speeds = [], []
    while sim.time < 12.0:
        sim.tick()
        times.append(sim.time)
        speeds.append(float(np.linalg.norm(sim.snapshot(sim.time, np.array([0])).com_velocity[0])))
    walked = sim.walked().footprints
    last = walked.contact_time[np.flatnonzero(~walked.stands)[-1]]
    assert max(speed for time, speed in zip(times, speeds, strict=True) if time > last + 1.0) < 0.01


@pytest.mark.parametrize(("name", "wide", "apart"), [("human", 0.1, 0.05), ("bird", 0.08, 0.09)])
def test_who_has_wide_legs_puts_its_feet_together_as_nearly_as_they_let_it(name, wide, apart):
    """It trod on the spot for good: its feet were set down further apart than those that are together."""
    plain = load_character(name).to_dict()
    plain |= {flat_name("leg", "shank_radius"): wide, flat_name("gait", "step_width"): apart}
    sim = Simulation(YARD, [Character.from_dict(plain, {})], WalkTo([(5.0, 5.0, 0.0)], [[(8.0, 5.0)]]), 1)
    while sim.time < 15.0:
        sim.tick()
    steps = int(sim.footprints.steps)
    while sim.time < 20.0:
        sim.tick()
    assert sim.footprints.steps == steps
