"""Who has arrived comes to rest."""

import numpy as np
import pytest

from motion.characters.character import character_names, load_character
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
