"""A* on rocks against Dijkstra over the same states, and what a route promises."""

from heapq import heappop, heappush

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.track.footprints import Footprints
from planner.planner import NoWay, Situation
from planner.river import grid, moves, search
from planner.river import route as routes
from planner.river.crossing import Country
from planner.river.rock_hop import RockHop
from worlds import queries
from worlds.compiled.tables import empty
from worlds.level import load_level
from worlds.world import River, World

HUMAN = load_character("human").biped


def walks_of(b, spots, land):
    """(K + 1, K + 1) seconds over land between banks; the last row is the start, the last column the goal."""
    k = len(spots.rock)
    walks, from_cell = np.full((k + 1, k + 1), np.inf), [tuple(cell) for cell in spots.cell.tolist()]
    banks = [i for i in range(k) if spots.rock[i] < 0]
    for i in (*banks, k):
        if from_cell[i][0] >= 0:
            lengths = grid.dijkstra(land, *from_cell[i])[0] * grid.SPACING * moves.slowest_pace(b)
            for j in (*banks, k + 1):
                walks[i, min(j, k)] = lengths[from_cell[j]] if from_cell[j][0] >= 0 else np.inf
    return walks


def dijkstra(b, spots, walks, start, foot):
    """Cost of the cheapest way, by plain Dijkstra without a heuristic, over all ways between banks."""
    place, rock, _ = spots
    k = len(rock)
    heap, done = [(0.0, (start, -1, foot, 1))], set()
    while heap:
        cost, state = heappop(heap)
        if state in done:
            continue
        done.add(state)
        spot, before, foot, arrived = state
        if spot == k + 1:
            return cost
        if arrived and (spot == k or rock[spot] < 0):
            for j in range(k + 1):
                for last in (0, 1):
                    if np.isfinite(walks[spot, j]):
                        heappush(heap, (cost + walks[spot, j], (k + 1 if j == k else j, -1, last, 0)))
        elif spot < k:
            for j in range(k):
                if j != spot and moves.can_step(b, spots, spot, j):
                    for hop in (False, True):
                        step = moves.directed_cost(b, place, before, spot, j, foot, hop)
                        if np.isfinite(step):
                            heappush(heap, (cost + step, (j, spot, foot if hop else 1 - foot, 1)))
    return np.inf


def land_beside_water(rng):
    """A grid of 8 x 3.2 m with holes by chance, and a river across it from x = 2 to 4 m."""
    free = rng.uniform(size=(8, 20)) < 0.8
    free[:, 5:10] = False
    land = grid.Grid(free, np.full(free.shape, 511, np.int16))
    return land, np.argwhere(free[:, :5]), np.argwhere(free[:, 10:]) + (0, 10)


@pytest.mark.parametrize("seed", range(8))
def test_a_star_costs_what_dijkstra_costs(seed):
    rng, k = np.random.default_rng(seed), 20
    land, here, there = land_beside_water(rng)
    cell = np.full((k + 2, 2), -1)
    cell[[0, 1, 2, k]], cell[[3, 4, 5, k + 1]] = rng.choice(here, 4, False), rng.choice(there, 4, False)
    place = np.column_stack([rng.uniform(1.8, 4.2, k + 2), rng.uniform(0, 3.2, k + 2), rng.uniform(0, 0.2, k + 2)])
    on_land = cell[:, 0] >= 0
    place[on_land] = np.column_stack([(cell[on_land, ::-1] + 0.5) * grid.SPACING, 0 * cell[on_land, 0]])
    spots = moves.Spots(place, np.where(on_land[:k], -1, np.arange(k)), cell)
    walks = walks_of(HUMAN, spots, land)
    states, reached = search.find(HUMAN, spots, land, k, 0)
    expected = dijkstra(HUMAN, spots, walks, k, 0)
    assert reached[k] and reached[k + 1] == bool(len(states))
    if not len(states):
        assert expected == np.inf
        return
    cost = 0.0
    for (a, before, foot, _), (z, _, then, arrived) in zip(states, states[1:], strict=False):
        walked = walks[a, min(z, k)] if not arrived else None
        came = before if before < k else -1
        cost += moves.directed_cost(HUMAN, place, came, a, z, foot, foot == then) if walked is None else walked
    assert cost == pytest.approx(expected)


def route(world, character, feet):
    return routes.route(Country(world, character), feet, world.goal)


def standing(world):
    x, y = world.start
    return empty(Footprints, 2)._replace(side=np.array([1, 0]), position=np.array([[x, y - 0.06, 0.0], [x, y + 0.06, 0.0]]))


@pytest.mark.parametrize("name", ["river_easy", "river_long_steps", "river_leaps", "river_delta", "rock_field"])
def test_routes_stand_wholly_on_rocks_or_land(name):
    world = load_level(name)
    sole = 0.5 * HUMAN.foot.length
    steps = route(world, load_character("human"), standing(world))
    side, place = np.array([step.side for step in steps]), np.array([(step.x, step.y) for step in steps])
    assert np.hypot(*(place[-1] - world.goal)) < world.goal_radius
    for x, y in place:
        assert queries.rock_under(world.arrays, x, y, sole) >= 0 or queries.water_clearance(world.arrays, x, y) >= sole
    lengths = np.hypot(*np.diff(place, axis=0).T)
    assert lengths[np.diff(side) == 0].max(initial=0) <= HUMAN.reach.max_step and lengths.max() <= HUMAN.reach.max_leap + 0.2
    assert np.abs(np.diff([step.heading for step in steps])).max() < 2.0


def test_hops_where_a_foot_would_have_to_cross():
    """Three stones that turn right by 60 degrees twice: one of the turns would cross the legs, so a foot hops."""
    ways = np.radians([0, -60, -120])
    corners = 0.9 * np.cumsum(np.column_stack([np.cos(ways), np.sin(ways)]), axis=0)
    height = [0.35, 0.5, 0.1, -0.3]  # too high for short cuts
    place = np.vstack([np.column_stack([[(0, 0), *corners], height]), [(-1, 0, 0), (0, -2, 0)]])
    land = grid.Grid(np.ones((1, 8), bool), np.zeros((1, 8), np.int16))
    cell = np.array([(0, 0), (-1, -1), (-1, -1), (0, 7), (0, 0), (0, 7)])
    states, _ = search.find(HUMAN, moves.Spots(place, np.array([-1, 0, 1, -1]), cell), land, 4, 0)
    spots, feet = states[:, 0], states[:, 2]
    assert list(spots) == [4, 0, 1, 2, 3, 5]
    assert sum(feet[k] == feet[k + 1] for k in (1, 2, 3)) == 1


def test_no_way_names_the_gap():
    world = load_level("river_impossible")
    with pytest.raises(NoWay) as told:
        route(world, load_character("bird"), standing(world))
    assert told.value.gap["distance"] > told.value.gap["reach"]
    bridged = world.with_rock(12.6, 8.0, 0.5, 0.2).with_rock(13.3, 8.0, 0.5, 0.2).with_rock(14.1, 8.0, 0.5, 0.2)
    feet = Footprints(*(column[None] for column in standing(world)))
    situation = Situation(bridged, [load_character("bird")], feet, np.array([3]), 0)
    assert RockHop().prepare(situation).length[0] > 10


@pytest.mark.parametrize("size", [200.0, 1000.0])
def test_long_rivers_are_leapt_across_in_large_worlds(size):
    """Two thousand places on banks, a quarter of a million cells of land; and more than a search takes places."""
    river = River(np.array([[100.0, -5.0], [100.0, size + 5]]), 1.0)
    world = World("plains", (size, size), rivers=(river,), start=(80.0, 100.0), goal=(120.0, 100.0))
    steps = route(world, load_character("human"), standing(world))
    place = np.array([(step.x, step.y) for step in steps])
    assert np.hypot(*(place[-1] - world.goal)) < 1.0 and np.hypot(*np.diff(place, axis=0).T).sum() < 42.0


def test_a_river_too_wide_names_the_gap():
    river = River(np.array([[15.0, -5.0], [15.0, 25.0]]), 8.0)
    world = World("wide", (30.0, 20.0), rivers=(river,), start=(3.0, 10.0), goal=(27.0, 10.0))
    with pytest.raises(NoWay, match="is narrowest") as told:
        route(world, load_character("human"), standing(world))
    assert 8.0 < told.value.gap["distance"] < 9.0 and told.value.gap["reach"] == 2.0


def test_a_rock_written_twice_carries_a_foot():
    rocks = np.array([(9.0 + 0.6 * k, 10.0, 0.3, 0.1) for k in range(5) for _ in (0, 1)])
    world = World("twice", (20.0, 20.0), rivers=(River(np.array([[10.2, -5.0], [10.2, 25.0]]), 3.2),), rocks=rocks,
                  start=(3.0, 10.0), goal=(17.0, 10.0))  # fmt: skip
    steps = route(world, load_character("human"), standing(world))
    assert any(queries.rock_under(world.arrays, step.x, step.y, 0.0) >= 0 for step in steps)
    assert not any(queries.in_water(world.arrays, step.x, step.y) for step in steps)


def test_no_foot_is_set_onto_a_rock_under_a_tree():
    rocks = np.array([(x, 5.0, 0.4, 0.1) for x in (8.9, 10.0, 11.1)])
    world = World("tree", (20.0, 10.0), trees=np.array([[10.0, 5.0, 0.3]]), rocks=rocks, start=(5.0, 5.0), goal=(17.0, 5.0),
                  rivers=(River(np.array([[10.0, -5.0], [10.0, 15.0]]), 4.0),))  # fmt: skip
    for step in route(world, load_character("human"), standing(world)):
        assert queries.tree_clearance(world.arrays, step.x, step.y) > 0.1
