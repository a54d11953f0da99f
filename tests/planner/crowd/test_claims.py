"""Who has the right of way: how long one has been about where it is, and which place it claims."""

from math import cos

import numpy as np
import pytest

from motion.arithmetic.gravity import pendulum_time
from motion.track.footprints import Feet, Foot
from planner.crowd.choosing import CLAIMS, _claim
from planner.crowd.walker import LONGER, STAYS, longer, look_where
from planner.round.round import Me
from tests.planner.crowd.test_avoiding import TABLE, around, facing, nothing_held
from tests.planner.crowd.test_terms import other, waiting
from worlds.world import World

B = TABLE[0]
SWING, STRIDE = pendulum_time(B.timing.hip_height), B.gait.preferred_step


def at(x, time):
    """One whose feet stand beside each other at x, 5 since then."""
    return Me(0, 3, True, 0, Feet(Foot(0, x, 5.07, 0.0, time - 0.5, 0.5), Foot(1, x, 4.93, 0.0, time, 0.5)))


def alone():
    return around(nothing_held(1), World("plain", (12.0, 12.0)))


def test_who_shuffles_stays_where_it_is():
    """Back and forth by less than STAYS of a step, in sum further."""
    round, step = alone(), 0.9 * STAYS * STRIDE
    since = []
    for k, x in enumerate((5.0, 5 + step, 5 - step, 5.0, 5 + 1.2 * step, 5.0)):
        look_where(round, at(x, 1.0 + k), True)
        since.append(round.intents.since[0])
    np.testing.assert_array_equal(since, [1, 1, 1, 1, 5, 6])


def test_who_stands_as_it_wishes_has_not_been_kept_there():
    round = alone()
    for time in (1.0, 9.0):
        look_where(round, at(5.0, time), False)
    assert round.intents.since[0] == 9
    assert longer(round, 0) == pytest.approx(9 - LONGER * SWING)


def test_who_has_long_been_where_it_is_claims_a_step_along_its_course():
    round, none = alone(), other(3.0, 3.0)
    ahead = []
    for since in (-0.9 * LONGER * SWING, -1.1 * LONGER * SWING):
        round.intents.since[0] = since
        _claim(round, waiting()._replace(time=0.0), none, 5.0, 5.0)
        ahead.append(round.intents.claim[0, 0] - 5)
    assert ahead[0] == 0
    assert ahead[1] == pytest.approx(0.5 * CLAIMS * STRIDE * cos(waiting().course), abs=0.5 * CLAIMS * STRIDE)
    assert ahead[1] > 0.2 * CLAIMS * STRIDE


def test_who_has_long_been_where_it_is_has_the_right_of_way_over_those_who_go_its_way():
    """People merge like the teeth of a zipper. All here have been where they are since 0 s."""
    claims = [facing(5.6, 5.0, (5.3, 5.0), 6.0, 9, (1.0, 0.0), before)[1]["claim_x"] for before in (-1.0, 1.0)]
    np.testing.assert_allclose(claims, [np.inf, 0.3], atol=1e-12)
    assert np.isinf(facing(5.6, 5.0, (5.3, 5.0), 0.0, 9, (1.0, 0.0), 1.0)[1]["claim_x"]), (
        "who stands as it wishes claims nothing"
    )
