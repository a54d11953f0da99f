"""Standing: who steps on the spot stays between its feet."""

import numpy as np

from motion.characters.character import load_character
from motion.com.standing import settling
from motion.track.footprints import step_onto
from planner.modes.custom import Custom
from planner.round.round import Wish, standing
from sim.stage.simulation import Simulation
from tests.walks import straight_walk
from worlds.world import World

HUMAN = load_character("human")


def _settled(last):
    """When the com is to rest, after the last step, whose foot went so much of a usual way [s]."""
    footprints = straight_walk(HUMAN.biped, 8)
    contact = footprints.contact_time
    footprints.stands[6:] = True
    footprints.position[5] = (1 - last) * footprints.position[3] + last * footprints.position[5]
    time = np.linspace(contact[4], contact[5] + 2.0, 3001)
    return settling(HUMAN.biped, footprints, time, 1.0)[0, 0] - contact[5]


def test_a_body_comes_to_rest_the_sooner_the_less_far_its_last_step_went():
    full = _settled(1.0)
    assert full == _settled(0.5)
    np.testing.assert_allclose([_settled(0.0), _settled(0.1)], [0.0, 0.4 * full], atol=2e-3)


def _marks_time(round, me):
    """One step on the spot of four, standing for a moment instead of the others."""
    foot = me.feet.older
    return Wish(step_onto(foot.side, foot.x, foot.y, foot.heading), foot.heading) if me.number % 4 == 0 else standing(me, 0.2)


def test_who_steps_on_the_spot_hardly_sways():
    sim = Simulation(World("yard", (6.0, 6.0)), [HUMAN], Custom(_marks_time, [(3.0, 3.0, 0.0)]))
    sway = []
    while sim.time < 10.0:
        sim.tick()
        sway.append(np.hypot(*(sim.com()[0, :2] - sim.feet().position[0, :, :2].mean(axis=0))))
    assert np.mean(sway[3 * sim.tick_rate :]) < 0.02, "it were 0.023 of one who comes to rest as a walker does"
