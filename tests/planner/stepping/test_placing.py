"""The lift of a swing against a slow twin that looks at many more moments of it."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.pose import swing
from planner.stepping import placing
from tests.walks import straight_walk
from worlds import queries
from worlds.world import World

STEP = 0.5
"""The walks' steps [m], in the middle of a world where rocks can be put."""
FLAT = World("flat", (30.0, 10.0))


def rocky(at: float) -> World:
    return World("rocky", (30.0, 10.0), rocks=np.array([[at, 5.0, 0.1, 0.05]]))


def walk(character: str, rng):
    """Footprints with chance places and headings, right after left."""
    b = load_character(character).biped
    footprints = straight_walk(b, 6)
    shift = np.array([10.0, 5.0, 0.0])
    position = footprints.position + shift + np.column_stack([rng.normal(0, 0.08, (6, 2)), np.zeros(6)])
    return b, footprints._replace(position=position, heading=footprints.heading + rng.normal(0, 0.2, 6))


def needed_lift(b, world, footprints, n, m, moments=800):
    """Lift with which heel, ball and toe keep the gait's clearance times the bump above the ground at every moment."""
    footprints.lift[m], lift = 0.0, b.gait.clearance
    back, ahead = -0.5 * b.foot.length - b.foot.ball_forward, 0.5 * b.foot.length - b.foot.ball_forward
    for k in range(1, moments):
        sole = swing.sole_at(b, footprints, n, m, k / moments)
        rise = 16 * (k / moments) ** 2 * (1 - k / moments) ** 2
        for forward, bend in ((back, sole.pitch), (0.0, 0.0), (ahead, sole.pitch - sole.flex)):
            x, y, z = swing.point_of_foot(sole, forward, 0.0, bend)
            lack = queries.ground_height(world, x, y) + b.gait.clearance * rise - z
            lift = max(lift, min(lack / rise, placing.MOST_RISES * b.reach.max_rise))
    return lift


@pytest.mark.parametrize("character", ["bird", "human", "dinosaur"])
def test_lift_on_level_ground_is_the_twin_s(character):
    rng = np.random.default_rng(1)
    for _ in range(20):
        b, footprints = walk(character, rng)
        for m in range(2, 6):
            assert placing.is_level(b, FLAT.arrays, footprints, m - 2, m)
            placing.lay_swing(b, FLAT.arrays, footprints, m)
            assert footprints.lift[m] == pytest.approx(needed_lift(b, FLAT.arrays, footprints, m - 2, m), abs=1e-3)


def test_ground_with_a_rock_in_the_way_is_not_level():
    """Wherever the walk begins in the cells of the grid, and wherever on the way the rock lies."""
    rng = np.random.default_rng(2)
    for _ in range(200):
        b, footprints = walk("human", rng)
        footprints.position[:, 0] += rng.uniform(-4, 4)
        start, goal = footprints.position[2], footprints.position[4]
        assert placing.is_level(b, rocky(29.5).arrays, footprints, 2, 4)
        at = start[0] + rng.uniform() * (goal[0] - start[0])
        assert not placing.is_level(b, rocky(at).arrays, footprints, 2, 4)


@pytest.mark.parametrize("character", ["bird", "human", "dinosaur"])
def test_a_sole_that_stands_in_a_crest_is_not_lifted_for_it(character):
    """What reaches 5 mm into a standing sole is there at either end of the swing, where no lift helps."""
    b, footprints = walk(character, np.random.default_rng(3))
    bumps = World("bumps", (30.0, 10.0), "heightmap", (0.5,), np.zeros((21, 61))).arrays
    placing.lay_swing(b, bumps, footprints, 4)
    level = footprints.lift[4]
    footprints.position[:, 2] -= 0.005
    placing.lay_swing(b, bumps, footprints, 4)
    assert level - 1e-9 <= footprints.lift[4] < level + 0.02


def test_a_foot_goes_straight_by_the_other_where_a_rock_leaves_no_room_to_bow():
    b = load_character("bird").biped
    footprints = straight_walk(b, 6)
    footprints.position[:] += [10.0, 5.0, 0.0]
    footprints.position[:, 1] = 5.0 + np.where(footprints.side == 0, 0.02, -0.02)  # so near that it has to bow
    before, n = 2, 4
    start, goal = footprints.position[before], footprints.position[n]
    bow = swing.outward(b, footprints, before, n, tuple(start), tuple(goal))
    side, middle = np.sign(bow[1]), 0.5 * (start + goal)
    room = 0.5 * b.foot.width + 0.02
    rocks = np.array([[middle[0], middle[1] + side * (room + 0.2), 0.2, 3 * b.reach.max_rise]])
    world = World("beside", (30.0, 10.0), rocks=rocks).arrays
    assert abs(bow[1]) > 0.05
    placing.lay_swing(b, world, footprints, n)
    assert footprints.bow[n] == 0.0 and footprints.lift[n] < 2 * b.gait.clearance
    placing.lay_swing(b, FLAT.arrays, footprints, n)
    assert footprints.bow[n] == 1.0
