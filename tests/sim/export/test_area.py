"""Where one can walk: the world less its walls, beside points by chance and beside somebody else's polygons."""

import numpy as np
import pytest

from sim.export.clip.asked import Asked
from sim.export.tables.area import area_of, areas
from sim.export.tables.trajectories import export_sqlite
from tests.sim.export.readers import clip, recording
from worlds.contents.polygons import inside
from worlds.level import load_level
from worlds.world import Wall, World

SIZE = 10.0


def by_chance(seed):
    """Walls that cross, touch, close and go beyond the border."""
    rng, walls = np.random.default_rng(seed), []
    for _ in range(rng.integers(1, 8)):
        count = rng.integers(2, 6)
        points = rng.integers(0, 11, (count, 2)) * 1.0 if rng.random() < 0.5 else rng.uniform(0, SIZE, (count, 2))
        points = points[np.append(True, np.any(np.diff(points, axis=0), axis=1))]
        if len(points) > 1:
            walls.append(Wall(points, float(rng.choice([0.1, 0.2, 0.5]))))
    return World("walls", (SIZE, SIZE), walls=tuple(walls))


def within_walls(world, points):
    """Whether each point lies in a box around a piece of a wall."""
    found = np.zeros(len(points), bool)
    for x0, y0, x1, y1, half in world.arrays.walls:
        a, along = np.array([x0, y0]), np.array([x1 - x0, y1 - y0])
        length = np.hypot(*along)
        far = (points - a) @ along / length
        aside = (points - a) @ np.array([-along[1], along[0]]) / length
        found |= (far > -half) & (far < length + half) & (np.abs(aside) < half)
    return found


def walkable(found, points):
    """Whether each point lies in an area, in none of its holes."""
    within = np.zeros(len(points), int)
    for area in found:
        within += inside(np.array(area.rim), points) & ~sum(
            (inside(np.array(hole), points) for hole in area.holes), np.zeros(len(points), bool)
        )
    assert within.max() <= 1
    return within == 1


@pytest.mark.parametrize("seed", range(30))
def test_points_by_chance(seed):
    world = by_chance(seed)
    points = np.random.default_rng(1).uniform(0, SIZE, (4000, 2))
    assert np.mean(walkable(areas(world), points) != ~within_walls(world, points)) < 1e-3


def test_without_walls_it_is_the_world():
    (area,) = areas(World("bare", (4.0, 3.0)))
    assert area.wkt == "POLYGON ((0 0, 4 0, 4 3, 0 3, 0 0))" or sorted(area.rim) == [(0, 0), (0, 3), (4, 0), (4, 3)]


def test_of_two_rooms_the_one_where_people_were():
    square = np.array([(2.0, 2.0), (6.0, 2.0), (6.0, 6.0), (2.0, 6.0), (2.0, 2.0)])
    world = World("closed", (SIZE, SIZE), walls=(Wall(square, 0.2),))
    outer, inner = areas(world)
    assert len(outer.holes) == 1 and len(outer.holes[0]) == 4 and not inner.holes
    assert np.ptp(np.array(inner.rim), axis=0) == pytest.approx(3.8)
    assert area_of(world, np.array([(4.0, 4.0), (5.0, 4.0), (9.0, 9.0)])) == inner
    assert area_of(world, np.array([(1.0, 1.0)])) == outer


def test_pedpy_reads_it(tmp_path):
    pedpy = pytest.importorskip("pedpy", reason="needs PedPy")
    run, path = clip(recording("human", 2, 1.0, level="rooms")), tmp_path / "run.sqlite"
    export_sqlite(run, str(path), Asked())
    found = pedpy.load_walkable_area_from_jupedsim_sqlite(trajectory_file=path).polygon
    assert found.is_valid and len(found.interiors) >= 1
    world = load_level("rooms")
    points = np.random.default_rng(2).uniform((0, 0), world.size, (20_000, 2))
    assert found.area == pytest.approx(np.prod(world.size) * np.mean(~within_walls(world, points)), rel=0.01)
    seen = pedpy.load_trajectory_from_jupedsim_sqlite(trajectory_file=path)
    assert pedpy.is_trajectory_valid(traj_data=seen, walkable_area=pedpy.WalkableArea(found))
