"""The measures of quality on made-up signals whose answer is known."""

import numpy as np
import pytest

from motion.measures import quality
from motion.track.footprints import Footprints
from tests import reference
from worlds.compiled.tables import empty

RATE = 60
FOOT, BALL = 0.26, 0.05


def three_footprints():
    """Three footprints, left, right, left, each for 0.6 s and 0.4 s later than the last, on a slope of 20 degrees."""
    normal = np.tile([-np.sin(0.35), 0.0, np.cos(0.35)], (3, 1))
    position = np.array([[0.0, 0.1, 0.0], [0.6, -0.1, 0.6 * np.tan(0.35)], [1.2, 0.1, 1.2 * np.tan(0.35)]])
    return empty(Footprints, 3)._replace(
        side=np.array([0, 1, 0]), position=position, heading=np.array([0.0, 0.2, -0.1]), normal=normal,
        contact_time=np.array([0.0, 0.405, 0.805]), stance_time=np.full(3, 0.6),
    )  # fmt: skip


def standing(footprints, shift=(0.0, 0.0, 0.0)):
    """Frames of feet exactly on their footprints; between them the sole hangs a metre above. `shift` moves later frames."""
    time = np.arange(0, 1.4, 1 / RATE)
    places = quality.marks(footprints, FOOT, BALL)
    sole = np.zeros((len(time), 2, 3, 3)) + [0, 0, 1.0]
    contact = np.zeros((len(time), 2), bool)
    for k, side in enumerate(footprints.side):
        on = (time >= footprints.contact_time[k]) & (time < footprints.contact_time[k] + footprints.stance_time[k])
        drift = (time[on] - time[on][0])[:, None, None] * np.array(shift)
        sole[on, side] = places[k] + drift
        contact[on, side] = True
    return time, sole, contact


def judged(footprints, time, sole, contact):
    stands = quality.footing(time, contact, footprints)
    down = quality.on_ground(sole, stands, footprints, np.zeros(3, bool))
    error = quality.footprint_error(sole, down, stands, quality.marks(footprints, FOOT, BALL))
    return *quality.skate(sole, down, stands), error


def test_feet_on_their_footprints_neither_skate_nor_err():
    footprints = three_footprints()
    time, sole, contact = standing(footprints)
    assert judged(footprints, time, sole, contact) == pytest.approx((0, 0, 0), abs=1e-12)
    assert quality.contact_error(time, contact, footprints) == 0


def test_skate_adds_up_over_the_stance():
    footprints = three_footprints()
    time, sole, contact = standing(footprints, shift=(0.03, 0.0, 0.04))
    lasts = 0.6 - 1 / RATE  # from the first frame of a stance to its last
    horizontal, total, error = judged(footprints, time, sole, contact)
    assert horizontal == pytest.approx(0.03 * lasts, rel=0.02) and total == pytest.approx(0.05 * lasts, rel=0.02)
    assert error == pytest.approx(total)
    stands = quality.footing(time, contact, footprints)
    down = quality.on_ground(sole, stands, footprints, np.zeros(3, bool))
    assert quality.stance_slide(sole, down) == pytest.approx(0.05 / RATE)


def test_a_floating_foot_skates_too():
    footprints = three_footprints()
    time, sole, contact = standing(footprints, shift=(0.03, 0.0, 0.0))
    sole[contact] += 0.02 * footprints.normal[0]
    assert judged(footprints, time, sole, contact)[0] == pytest.approx(0.0175, abs=6e-4)


def test_a_rolling_foot_does_not_skate():
    """Heel first, then flat, then over the ball: each point only counts while it is down."""
    footprints = three_footprints()
    time, sole, contact = standing(footprints)
    normal, level = footprints.normal[0], np.array([0.0, 1.0, 0.0])
    frames = np.flatnonzero(contact[:, 1])
    sole[frames[:5], 1, 1:] += 0.03 * normal + 0.01 * level
    sole[frames[-8:], 1, 0] += np.linspace(0.01, 0.08, 8)[:, None] * normal + 0.05 * level
    assert judged(footprints, time, sole, contact) == pytest.approx((0, 0, 0), abs=1e-12)
    sole[frames[-1], 1, 2] += [0.0, 0.004, 0.0]
    assert judged(footprints, time, sole, contact) == pytest.approx((0.004, 0.004, 0.004))


def test_a_foot_beside_its_footprint_is_found():
    footprints = three_footprints()
    time, sole, contact = standing(footprints)
    sole[contact[:, 0], 0] += [0.0, 0.006, 0.0]
    assert judged(footprints, time, sole, contact) == pytest.approx((0, 0, 0.006), abs=1e-12)


def test_late_contacts_count_in_ticks():
    footprints = three_footprints()
    time, _, contact = standing(footprints)
    first = np.flatnonzero(contact[:, 1])[0]
    contact[first : first + 2, 1] = False
    assert quality.contact_error(time, contact, footprints) == 2
    contact[first - 3 : first + 2, 1] = True
    assert quality.contact_error(time, contact, footprints) == 3


def test_clearance_is_taken_in_the_middle_of_swings():
    _, _, contact = standing(three_footprints())
    height = np.full(contact.shape, 9.0)
    swing = np.flatnonzero(~contact[:, 0])
    swing = swing[swing < 48]
    height[swing, 0] = 0.04 + np.abs(swing - swing.mean())
    assert quality.swing_clearance(height, contact) == pytest.approx(0.04, abs=0.51)
    height[:, 0] -= height[int(swing.mean()) + 1, 0] - 0.03
    assert quality.swing_clearance(height, contact) == pytest.approx(0.03, abs=0.51)
    assert quality.swing_clearance(height, np.ones_like(contact)) is None


def test_physics_costs_are_the_slow_ones():
    rng = np.random.default_rng(4)
    com, a = rng.normal([0, 0, 1], 0.1, (40, 3)), rng.normal(0, 3, (40, 3))
    contact = rng.random((40, 2)) < 0.6
    support = np.where(contact[..., None], rng.normal(0, 0.3, (40, 2, 3)) * [1, 1, 0], np.nan)
    slow = [reference.physics_cost(com[f], a[f], list(support[f][contact[f]])) for f in range(40)]
    np.testing.assert_allclose(quality.physics_cost(com, a, support, contact), slow, atol=1e-9)
