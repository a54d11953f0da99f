"""Many cross one river: apart from the start to the end, one behind the other where it is narrow; and nobody leaps backward."""

import itertools

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.crowd.bodies import gap_between
from planner.planner import NoWay
from planner.river.rock_hop import RockHop
from planner.round.reservations import body_sizes
from sim.stage.commands import SetGoal, apply
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.level import load_level
from worlds.world import World


def cast(names, count):
    return [load_character(names[k % len(names)]) for k in range(count)]


def least_gap(sim):
    """Least room between two bodies [m]."""
    place, radius = sim.com()[:, :2], np.array([float(one.biped.body.radius) for one in sim.characters])
    gaps = np.hypot(*(place[:, None] - place[None]).T) - radius[:, None] - radius[None]
    return gaps[~np.eye(len(place), dtype=bool)].min()


def least_gap_of_ellipses(sim):
    """The same of bodies as they pass each other, less deep than wide [m]."""
    place, face, kinds = sim.com()[:, :2], sim.reservations.face, [one.biped for one in sim.characters]
    half = [tuple(0.5 * body_sizes(one)) for one in kinds]
    pairs = itertools.combinations(range(len(kinds)), 2)
    return min(gap_between(half[a], tuple(face[a]), half[b], tuple(face[b]), *(place[a] - place[b])) for a, b in pairs)


@pytest.mark.parametrize(
    ("level", "names"), [("river_easy", ["bird"]), ("river_leaps", ["human"]), ("river_delta", ["human", "bird"])]
)
def test_many_cross_and_keep_apart(level, names):
    sim, least = Simulation(load_level(level), cast(names, 8), RockHop(), 0), np.inf
    assert least_gap(sim) > 0
    for k in range(60 * 150):
        sim.tick()
        if k % 6 == 0:
            least = min(least, least_gap(sim))
        if sim.reached_goal.all():
            break
    assert sim.reached_goal.all() and least > 0


@pytest.mark.parametrize(("level", "name", "count", "seed"), [
    ("river_leaps", "human", 4, 0), ("river_leaps", "human", 8, 2), ("river_easy", "bird", 8, 2),
])  # fmt: skip
def test_all_arrive_where_the_goal_goes_back_and_forth_among_them(level, name, count, seed):
    """They are at odds then, and would wait for each other: some make room, and nobody is at its goal who does."""
    world, rng, parked = load_level(level), np.random.default_rng(seed), 0
    sim = Simulation(world, cast([name], count), RockHop(), seed)
    for k, time in enumerate(sorted(rng.uniform(6, 60, 4))):
        while sim.time < time:
            sim.tick()
        apply(sim, SetGoal(*(world.start, world.goal)[k % 2]))
    least = np.inf
    while not sim.reached_goal.all() and sim.time < 240:
        sim.tick()
        if sim.ticks % 30 == 0:
            least, parked = min(least, least_gap_of_ellipses(sim)), max(parked, int(sim.plans.parked.sum()))
            assert not (sim.planner.arrived(sim.plans) & sim.plans.parked).any()
    assert sim.reached_goal.all() and parked > 0
    assert least > 0


def test_the_first_begins_at_the_start_and_the_others_behind_it():
    world = load_level("river_easy")
    starts = RockHop().starts(world, cast(["bird"], 12), 0)
    assert (starts[0, :2] == world.start).all()
    assert np.hypot(*(starts[1:, :2] - world.start).T).min() > 0.5


def test_too_many_are_refused_with_how_many_there_is_room_for():
    world, bird = load_level("river_easy"), load_character("bird")
    with pytest.raises(InputError, match="501 characters: at most 500"):
        RockHop().starts(world, [bird] * 501, 0)
    with pytest.raises(InputError, match=r"500 characters: only \d+ can stand apart"):
        RockHop().starts(world, [bird] * 500, 0)


def test_a_goal_where_no_body_fits_is_refused():
    world = World("tree", (20.0, 10.0), trees=np.array([[15.0, 5.4, 0.3]]), start=(5.0, 5.0), goal=(15.0, 5.0))
    with pytest.raises(InputError, match=r"goal at \(15, 5\): no room for the body of the human"):
        Simulation(world, cast(["human"], 1), RockHop(), 0)


def leads(steps, stride):
    """Of the long steps of a route: cosine between heading and way; and the turns of all steps [rad]."""
    way = np.diff(np.column_stack([steps["x"], steps["y"]]), axis=0)
    length, heading = np.hypot(*way.T), steps["heading"][1:]
    ahead = np.cos(heading) * way[:, 0] + np.sin(heading) * way[:, 1]
    far = length > 0.6 * stride
    return ahead[far] / length[far], np.abs(np.diff(steps["heading"]))


@pytest.mark.parametrize("name", ["human", "bird", "dinosaur", "ostrich"])
@pytest.mark.parametrize("level", ["river_easy", "river_long_steps", "river_leaps", "river_delta"])
def test_nobody_leaps_backward_even_where_the_goal_is_moved_behind_it(level, name):
    who, world = load_character(name), load_level(level)
    try:
        sim = Simulation(world, [who], RockHop(), 0)
    except NoWay:
        pytest.skip(f"no way for the {name}")
    on_rocks, reach, stride = 0, who.biped.reach, who.biped.gait.preferred_step
    for turned in (False, True):
        ahead, turns = leads(sim.plans.steps[0, : sim.plans.length[0]], stride)
        assert ahead.min() > 0.3 and turns.max() < 1.35 * reach.max_turn, turned
        while on_rocks < 3 and not turned:
            number = sim.crowd.number[0]
            sim.tick()
            on_rocks += int(sim.crowd.number[0] != number and sim.feet().rock[0, 1] >= 0)
        if not turned:
            apply(sim, SetGoal(*world.start))
