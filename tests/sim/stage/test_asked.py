"""What a program asks of a cast is checked where it comes in; two simulations run in two Python threads."""

from threading import Thread

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.pose.pose import empty_pose
from planner.modes.walk_to import WalkTo
from planner.modes.wander import Wander
from sim.stage.making import make_simulation
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.world import World

BIRD, YARD, NAN = load_character("bird"), World("yard", (20.0, 20.0), start=(10.0, 10.0)), float("nan")
CASTS = {
    "0 characters": (YARD, [], 0, 60),
    "characters.1": (YARD, [BIRD, "bird"], 0, 60),
    "seed = -1": (YARD, [BIRD], -1, 60),
    "seed = 1.5": (YARD, [BIRD], 1.5, 60),
    "seed = True": (YARD, [BIRD], True, 60),
    "tick_rate = 0": (YARD, [BIRD], 0, 0),
    "tick_rate = 0.1": (YARD, [BIRD], 0, 0.1),
    "world": ("yard", [BIRD], 0, 60),
}
ASKED = {
    "there are 2 characters": lambda sim: sim.snapshot(rows=np.array([2])),
    "rows: -1": lambda sim: sim.snapshot(rows=np.array([-1])),
    "rows of type float64": lambda sim: sim.snapshot(rows=np.array([0.0])),
    "rows of type bool": lambda sim: sim.snapshot(rows=np.array([True, False])),
    "shape": lambda sim: sim.snapshot(rows=np.zeros((1, 1), int)),
    "time = nan": lambda sim: sim.snapshot(NAN),
    "time = '1'": lambda sim: sim.com("1"),
    "a pose of 1 rows": lambda sim: sim.pose_into(empty_pose(1), 0.0, np.arange(2)),
    "character = 9": lambda sim: sim.bones(9),
    "places": lambda sim: sim.stand(0, 0, np.full((2, 3), NAN)),
}


@pytest.mark.parametrize("said", CASTS)
def test_what_no_cast_can_be_made_of_is_refused(said):
    world, characters, seed, rate = CASTS[said]
    with pytest.raises(InputError, match=said):
        Simulation(world, characters, Wander(), seed, rate)


@pytest.mark.parametrize("said", ASKED)
def test_what_cannot_be_shown_is_refused(said):
    sim = make_simulation("forest", "bird", 2, 1, False)
    with pytest.raises(InputError, match=said):
        ASKED[said](sim)


def test_rows_of_any_kind_of_whole_numbers_are_shown():
    sim = make_simulation("forest", "bird", 3, 1, False)
    for rows in ([2, 0], np.array([2, 0], np.int32), np.array([9, 2, 0, 1])[1:3]):
        np.testing.assert_array_equal(sim.snapshot(rows=rows).com, sim.com()[[2, 0]])
    assert len(sim.snapshot(rows=[]).com) == 0


@pytest.mark.parametrize(
    "more", [{"near": NAN}, {"near": "1"}, {"again": 1}, {"stops": [[(NAN, 1.0)]]}, {"stops": [[("1", 2)]]}]
)
def test_walks_are_of_numbers(more):
    with pytest.raises(InputError):
        WalkTo(**({"starts": [(5.0, 5.0, 0.0)], "stops": [[(6.0, 6.0)]]} | more))


def test_two_simulations_run_in_two_threads_as_they_run_alone():
    def run(found, seed):
        sim = make_simulation("forest", "bird", 12, seed, False)
        for _ in range(90):
            sim.tick()
            found[seed] = sim.snapshot().com

    alone, together = {}, {}
    for seed in (1, 2):
        run(alone, seed)
    threads = [Thread(target=run, args=(together, seed)) for seed in (1, 2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for seed in (1, 2):
        np.testing.assert_array_equal(alone[seed], together[seed])
