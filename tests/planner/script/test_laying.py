"""From scenes to footprints: the Hermite path, step lengths along it, and standing in between."""

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

from motion.characters.character import load_character
from motion.motion import solve
from planner.script.footprint import Footprint
from planner.script.laying import laid
from planner.script.path import Path, footprints_along, hermite_path
from worlds.errors import InputError

HUMAN = load_character("human")


def along(**keys):
    return footprints_along(Path(**keys), HUMAN)


def test_hermite_path_is_the_cubic_through_its_points():
    points = np.array([[0.0, 0.0], [2.0, 1.0], [4.0, -1.0], [7.0, 0.5]])
    ours = hermite_path(points)
    theirs = CubicHermiteSpline(np.arange(4), points, np.gradient(points, axis=0))(np.linspace(0, 3, len(ours)))
    np.testing.assert_allclose(ours, theirs, atol=1e-12)


def test_steps_are_as_long_and_wide_as_asked():
    feet = along(points=[(1, 2), (6, 2)], step_length=0.5, step_width=0.2)
    x = [p.position[0] for p in feet]
    np.testing.assert_allclose(np.diff(x)[1:-1], 0.5, atol=1e-9)
    assert {round(p.position[1], 9) for p in feet} == {1.9, 2.1}
    assert all(a.side != b.side for a, b in zip(feet, feet[1:], strict=False))


def test_step_lengths_change_along_the_way():
    lengths = np.diff([p.position[0] for p in along(points=[(1, 2), (11, 2)], step_length=[0.4, 1.0])])[1:-1]
    assert (np.diff(lengths) > 0).all() and lengths[0] < 0.5 < 0.9 < lengths[-1]


def test_feet_point_where_asked_and_bodies_face_where_asked():
    feet = along(points=[(1, 2), (6, 2)], step_length=0.4, feet_deg=180.0, facing_deg=30.0)
    assert all(p.heading_deg == pytest.approx(180.0) and p.facing_deg == 30.0 for p in feet)
    assert feet[2].position[0] > feet[0].position[0]


def test_standing_needs_both_feet_down():
    hop = [Footprint(side=s, position=(x, 2.0), stand=w) for s, x, w in (("left", 1, 0), ("right", 1, 0), ("right", 1.5, 1))]
    with pytest.raises(InputError, match=r"footprint.2.stand"):
        laid(hop, HUMAN)


def test_a_hop_may_be_the_last_step():
    """One then stands on that foot alone, above it; it was refused, as if the foot had still to stand where it left."""
    feet = [("left", 0.0, 0.06), ("right", 0.0, -0.06), ("left", 0.45, 0.06), ("left", 0.9, 0.03)]
    motion = solve(laid([Footprint(side=side, position=(x, y)) for side, x, y in feet], HUMAN), HUMAN)
    end = motion.pose(motion.end)
    assert end.contact[0].tolist() == [True, False] and np.hypot(*(end.com[0, :2] - (0.9, 0.03))) < 0.02
