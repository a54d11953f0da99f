"""Where a sole may stand and how it may come there; that nobody stands elsewhere, on levels that ship and on bad ground."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.track.footprints import LEFT, RIGHT, Foot
from planner.modes.walk_to import WalkTo
from planner.modes.wander import Wander
from planner.planner import NoWay
from planner.river.rock_hop import RockHop
from planner.stepping import footing
from planner.stepping.footing import DEEP, FAR, FINE, HIGH, ROCK, STEEP, TREE, WATER, why_not_stand, why_not_step
from sim.stage.commands import PlantTree, apply
from sim.stage.making import make_simulation
from sim.stage.simulation import Simulation
from worlds import queries
from worlds.errors import InputError
from worlds.level import level_names, load_level
from worlds.world import River, World

HUMAN = load_character("human")
CHARACTERS = ("human", "bird", "dinosaur", "ostrich")
PLACE = World(
    "place", (20.0, 20.0), trees=np.array([[5.0, 5.0, 0.3]]), rivers=(River(np.array([[15.0, 0.0], [15.0, 20.0]]), 2.0),),
    rocks=np.array([[10.0, 10.0, 0.5, 0.3], [15.0, 10.0, 0.5, 0.2]]),
).arrays  # fmt: skip
STANDS = {
    "open ground": (8.0, 3.0, FINE),
    "toe in a tree": (4.6, 5.0, TREE),
    "beside a tree": (4.5, 5.0, FINE),
    "toe in water": (13.9, 3.0, WATER),
    "beside the border": (0.12, 3.0, footing.BORDER),
    "toe in a rock's side": (9.4, 10.0, ROCK),
    "on a rock": (10.0, 10.0, FINE),
    "over a rock's edge": (10.4, 10.0, FINE),
    "on a rock in water": (15.0, 10.0, FINE),
    "on it, toe over the water": (15.4, 10.0, WATER),
}


@pytest.mark.parametrize("case", STANDS)
def test_a_sole_stands_where_all_of_it_may(case):
    x, y, why = STANDS[case]
    assert why_not_stand(HUMAN.biped, PLACE, x, y, 0.0) == why


def test_a_step_is_within_reach():
    stairs = World("s", (20.0, 20.0), "stairs", (10.0, 0.5, 1.0, 5)).arrays
    low, high = Foot(LEFT, 9.5, 5.0, 0.0, 0.0, 0.0), Foot(LEFT, 12.5, 5.0, 0.0, 0.0, 0.0)
    assert why_not_step(HUMAN.biped, stairs, low, 9.7, 4.8, 0.0) == FINE
    assert why_not_step(HUMAN.biped, stairs, low, 10.5, 4.8, 0.0) == HIGH  # 0.5 m; it climbs 0.45
    assert why_not_step(HUMAN.biped, stairs, high, 11.5, 4.8, 0.0) == FINE  # 0.5 m down; it steps 0.6 down
    assert why_not_step(HUMAN.biped, stairs, high, 10.6, 4.8, 0.0) == DEEP
    assert why_not_step(HUMAN.biped, PLACE, Foot(LEFT, 2.0, 2.0, 0.0, 0.0, 0.0), 4.1, 2.0, 0.0) == FAR


@pytest.mark.parametrize(("height", "why"), [(0.4, FINE), (0.5, HIGH)])
def test_a_foot_is_lifted_over_what_is_no_higher_than_the_highest_step(height, why):
    """A human climbs 0.45 m; the rock lies between the right foot and where it shall go, by the left one's side."""
    place = World("between", (20.0, 20.0), rocks=np.array([[10.4, 9.9, 0.1, height]])).arrays
    left = Foot(LEFT, 10.0, 10.06, 0.0, 0.0, 0.0)
    assert why_not_step(HUMAN.biped, place, left, 10.75, 9.9, 0.0) == why


def slope(steepness):
    heights = np.tile(np.arange(41) * 0.5 * steepness, (41, 1))
    return World("slope", (20.0, 20.0), "heightmap", (0.5,), heights, start=(10.0, 10.0))


def test_slopes_are_as_steep_as_the_highest_step_allows():
    steepest = HUMAN.biped.reach.max_rise / HUMAN.biped.gait.preferred_step
    assert why_not_stand(HUMAN.biped, slope(0.95 * steepest).arrays, 10.0, 10.0, 0.3) == FINE
    assert why_not_stand(HUMAN.biped, slope(1.05 * steepest).arrays, 10.0, 10.0, 0.3) == STEEP


def cliff(goal=None):
    heights = np.where(np.arange(41) > 20, 5.0, 0.0) * np.ones((41, 1))
    return World("cliff", (20.0, 20.0), "heightmap", (0.5,), heights, start=(4.0, 10.0), goal=goal)


def stood(sim, ticks):
    """Why each footprint of a run may not be where it is; and their heights."""
    sim.keep_footprints()
    for _ in range(ticks):
        sim.tick()
    walked = sim.walked()
    prints, world, found = walked.footprints, sim.world.arrays, set()
    for k, c in enumerate(walked.character.tolist()):
        x, y = prints.position[k, :2].tolist()
        found.add(int(why_not_stand(sim.characters[c].biped, world, x, y, float(prints.heading[k]))))
    return found, prints


@pytest.mark.parametrize("character", CHARACTERS)
@pytest.mark.parametrize("level", [name for name in level_names() if name != "river_impossible"])
def test_on_every_level_everyone_stands_well(level, character):
    found, _ = stood(make_simulation(level, character, 1, 3, False), 1500)
    assert found == {FINE}
    if load_level(level).goal is not None:
        crossing, _ = stood(make_simulation(level, character, 1, 3, True), 2400)
        assert crossing <= {FINE, WATER}  # corners of a long sole on a small round rock


def test_nobody_climbs_a_cliff():
    found, prints = stood(Simulation(cliff(), [HUMAN], Wander(), 2), 2400)
    assert found == {FINE} and prints.position[:, 2].max() < 0.5


@pytest.mark.parametrize("planner", [RockHop(), WalkTo([(4.0, 10.0, 0.0)], [[(17.0, 10.0)]])])
def test_no_route_leads_up_a_cliff(planner):
    with pytest.raises(NoWay, match="slopes"):
        Simulation(cliff((17.0, 10.0)), [HUMAN], planner, 0)


def test_a_crowd_stands_well_among_rocks():
    found, _ = stood(make_simulation("rock_field", "human", 12, 4, False), 1500)
    assert found == {FINE}


STARTS = {
    "no room for the body": World("corner", (20.0, 20.0), start=(0.1, 0.1)),
    "foot of the human is in water": World(
        "bank", (20.0, 20.0), start=(5.0, 5.0), start_heading=np.pi / 2, rivers=(River(np.array([[6.01, 0], [6.01, 20]]), 2.0),)
    ),
    "too steep": World("hills", (20.0, 20.0), "hills", (100.0, 2.0, 0.3, 1.1, 2.0), start=(5.0, 5.0)),
}  # fmt: skip


@pytest.mark.parametrize("said", STARTS)
def test_a_start_has_room_for_body_and_feet(said):
    with pytest.raises(InputError, match=said):
        Simulation(STARTS[said], [HUMAN], Wander())


STOPS = {"in a tree": (5.0, 5.0), "in water": (15.0, 3.0), "outside": (30.0, 3.0)}


@pytest.mark.parametrize("said", STOPS)
def test_a_stop_where_nobody_can_be_is_told(said):
    world = World("place", (20.0, 20.0), trees=np.array([[5.0, 5.0, 0.3]]),
                  rivers=(River(np.array([[15.0, 0.0], [15.0, 20.0]]), 2.0),))  # fmt: skip
    with pytest.raises(InputError, match=f"stops.0.0 .*{said}"):
        Simulation(world, [HUMAN], WalkTo([(2.0, 2.0, 0.0)], [[STOPS[said]]]))


def test_a_route_keeps_off_trunks():
    """Four trunks stand across the straight way; there is open ground on both sides."""
    trunks = np.array([[12.0, y, 0.3] for y in (8.5, 9.5, 10.5, 11.5)])
    world = World("trunks", (20.0, 20.0), trees=trunks, start=(9.0, 10.0), goal=(17.0, 10.0))
    sim = Simulation(world, [HUMAN], RockHop(), 0)
    found, prints = stood(sim, 1500)
    assert found == {FINE} and sim.reached_goal.all()
    least = min(queries.tree_clearance(world.arrays, x, y) for x, y in prints.position[:, :2])
    assert least > 0.5 * HUMAN.biped.foot.width + 0.03 and RIGHT in prints.side


@pytest.mark.parametrize("character", CHARACTERS)
def test_everyone_stands_well_after_trees_are_planted_before_them(character):
    sim, rng, planted, found = make_simulation("forest", character, 6, 2, False), np.random.default_rng(3), 0, set()
    for tick in range(1800):
        before = sim.steps_planned
        sim.tick()
        newest = sim.feet()
        for c in np.flatnonzero(sim.steps_planned > before):
            (x, y), heading = newest.position[c, 1, :2].tolist(), float(newest.heading[c, 1])
            found.add(int(why_not_stand(sim.characters[c].biped, sim.world.arrays, x, y, heading)))
        if tick % 20 == 0:
            x, y = newest.position[tick // 20 % 6, 1, :2] + rng.uniform(-1.2, 1.2, 2)
            try:
                apply(sim, PlantTree(x, y, rng.uniform(0.2, 1.0)))
                planted += 1
            except InputError:
                pass
    assert found == {FINE} and planted > 15


def test_a_tree_is_not_planted_onto_a_foot_however_large():
    sim = make_simulation("forest", "human", 1, 2, False)
    x, y = sim.feet().position[0, 1, :2]
    with pytest.raises(InputError, match="too near to a foot"):
        apply(sim, PlantTree(x + 1.5, y, 1.45))
