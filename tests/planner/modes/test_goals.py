"""A goal that is set while they wander: around what lies between, and refused where no way leads there."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.wander import Wander
from planner.planner import NoWay
from sim.stage.commands import SetGoal, apply
from sim.stage.simulation import Simulation
from worlds.world import River, Wall, World

BIRD = load_character("bird")


@pytest.mark.parametrize("between", ["wall", "river"])
def test_a_wanderer_finds_the_way_to_a_goal_behind_something(between):
    """Straight on there is none: it leads around the far end, as the crow does not fly."""
    line = np.array([[10.0, -2.0], [10.0, 8.0]])
    things = {"walls": (Wall(line, 0.2),)} if between == "wall" else {"rivers": (River(line, 1.5),)}
    world = World("behind", (20.0, 13.0), start=(5.0, 3.0), **things)
    sim = Simulation(world, [BIRD], Wander(), 2)
    apply(sim, SetGoal(15.0, 3.0))
    far, past = np.inf, 0.0
    for _ in range(60 * 60):
        sim.tick()
        x, y, _ = sim.com()[0]
        past = max(past, y) if x < 12 else past
        far = min(far, float(np.hypot(x - 15, y - 3)))
    assert far < 1.0 and past > 8.0


def test_a_goal_to_which_no_way_leads_is_refused_and_nothing_changes():
    """Those to whom one leads go there; the others wander on."""
    river = (River(np.array([[10.0, -2.0], [10.0, 15.0]]), 1.5),)
    alone = Simulation(World("banks", (20.0, 13.0), start=(5.0, 3.0), rivers=river), [BIRD], Wander(), 2)
    with pytest.raises(NoWay, match=r"banks: no way for the bird leads to a goal at \(15\.00, 3\.00\): water"):
        apply(alone, SetGoal(15.0, 3.0))
    for _ in range(600):
        alone.tick()
    many = Simulation(World("banks", (20.0, 13.0), start=(5.0, 3.0), rivers=river), [BIRD] * 12, Wander(), 2)
    beyond = many.com()[:, 0] > 10
    assert 0 < beyond.sum() < 12
    apply(many, SetGoal(15.0, 3.0))
    assert (many.plans.steps > 0).tolist() == beyond.tolist()
