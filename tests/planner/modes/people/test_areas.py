"""Areas: inside, nearest places, places by chance, and ways that weigh crowding."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.people.areas import cells_inside, places_in
from planner.modes.people.crowding import density, grid_of, share_of_speed, weigh
from planner.stepping.field import ways_from
from worlds.contents.polygons import inside, nearest
from worlds.contents.traffic import corners
from worlds.world import Wall, World

HUMAN = load_character("human").biped
TRIANGLE = np.array([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)])


def test_inside_a_polygon_is_where_a_ray_crosses_it_once():
    points = np.array([(1.0, 1.0), (2.5, 2.5), (-0.1, 1.0), (3.5, 0.2)])
    assert inside(TRIANGLE, points).tolist() == [True, False, False, True]
    hollow = np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (2.0, 3.0), (2.0, 1.0), (1.0, 1.0), (1.0, 3.0), (0.0, 3.0)])
    assert inside(hollow, np.array([(1.5, 2.0), (0.5, 2.0), (1.5, 0.5)])).tolist() == [False, True, True]


def test_the_nearest_place_lies_on_the_border():
    found = nearest(TRIANGLE, np.array([(1.0, -2.0), (3.0, 3.0), (-1.0, -1.0)]))
    np.testing.assert_allclose(found, [(1.0, 0.0), (2.0, 2.0), (0.0, 0.0)], atol=1e-12)


def test_places_by_chance_lie_inside_and_off_the_border():
    places = np.concatenate([places_in(TRIANGLE, 5, (0, k), 900, 0.3) for k in range(20)])
    assert len(places) > 150 and inside(TRIANGLE, places).all() and places.min() >= 0.3
    assert cells_inside(np.array([(1.01, 1.01), (1.02, 1.01), (1.02, 1.02)]), (20, 20), 0.2).sum() == 1


BOTH = np.array([[0], [1]])


def two_doors():
    """A room with a near door and a far one, each with an area behind it."""
    walls = (Wall(np.array([(0.0, 6.0), (2.0, 6.0)]), 0.2), Wall(np.array([(3.2, 6.0), (8.8, 6.0)]), 0.2))
    walls += (Wall(np.array([(10.0, 6.0), (12.0, 6.0)]), 0.2),)
    areas = [corners([(x, 7.0), (x + 1.2, 7.6)]) for x in (2.0, 8.8)]
    return grid_of(World("doors", (12.0, 9.0), walls=walls), HUMAN, areas)


def test_ways_are_as_long_as_they_are_when_nobody_is_there():
    grid = two_doors()
    fields = np.empty((2, *grid.slowness.shape), np.float32)
    weigh(grid, np.zeros((0, 2)), fields)
    ways = ways_from(fields, grid.cell, BOTH, np.array([(2.6, 3.0), (9.4, 3.0)]))
    assert ways[0, 0] == pytest.approx(4.0, abs=0.6) and ways[1, 1] == pytest.approx(4.0, abs=0.6)
    assert ways[1, 0] > 7.0 and ways[0, 1] > 7.0


def test_a_jam_before_a_door_makes_the_other_one_nearer():
    grid = two_doors()
    fields = np.empty((2, *grid.slowness.shape), np.float32)
    here, sides = np.array([(5.0, 3.0)]), (np.linspace(1.8, 3.4, 6), np.linspace(4.2, 5.6, 6))
    jam = np.stack(np.meshgrid(*sides), axis=2).reshape(-1, 2)
    weigh(grid, np.zeros((0, 2)), fields)
    empty = ways_from(fields, grid.cell, BOTH, here)[:, 0]
    weigh(grid, jam, fields)
    full = ways_from(fields, grid.cell, BOTH, here)[:, 0]
    assert empty[0] < empty[1] and full[0] > full[1] and full[0] > 1.5 * empty[0]


def test_density_counts_everyone_once_and_speeds_fall_with_it():
    grid = two_doors()
    people = np.array([(3.0, 3.0), (6.0, 3.0), (6.2, 3.1)])
    assert density(grid, people).sum() * grid.cell**2 == pytest.approx(3.0, rel=0.01)
    share = share_of_speed(np.array([0.0, 1.0, 2.0, 4.0, 6.0]))
    assert (np.diff(share) <= 0).all() and share[0] > 0.99 and share[1] == pytest.approx(1.06 / 1.34, abs=0.02)
