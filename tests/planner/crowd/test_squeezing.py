"""What keeps a throng going: whom one does not slow down for, how long a step may be, and who presses on."""

import numpy as np
import pytest

from motion.track.footprints import Feet, Foot
from planner.crowd import terms
from planner.crowd.bodies import gap_between, press_between
from planner.crowd.candidates import bearing_of, candidate
from planner.crowd.terms import room_in
from planner.crowd.walker import PRESSED, SQUEEZE, squeeze, walker_of
from planner.round.reservations import strays
from planner.round.round import Me
from sim.reports.throngs import figures
from tests.planner.crowd.test_avoiding import TABLE, around, nothing_held
from tests.planner.crowd.test_terms import LONG, B, other, waiting
from worlds.world import World


def speed(me, one):
    """That one may go straight on at behind another."""
    return terms.speed_behind(me, one[0], 1.0, 0.0, 0.5, 0.6)


def test_a_pace_across_the_way_does_not_count():
    assert speed(waiting(), other(1.2, 0.0, 0.0, -1.0)) == speed(waiting(), other(1.2, 0.0))


def test_the_edge_of_a_shoulder_is_passed_by():
    assert speed(waiting(), other(1.0, 0.46)) == np.inf > speed(waiting(), other(1.0, 0.4))


def test_a_step_is_as_long_as_the_body_comes_to_rest_where_it_touches_who_stops():
    me = waiting()._replace(foot_x=5.0, foot_y=4.93, side=0)
    long = room_in(me, other(0.7, 0.0), bearing_of(B, me, 0.0), 0.7)
    step = candidate(B, me, bearing_of(B, me, 0.0), long)
    x, y = 0.5 * (me.foot_x + step.foot_x) - me.rest_x, 0.5 * (me.foot_y + step.foot_y) - me.rest_y
    assert long > 0.3 and gap_between(LONG, (1.0, 0.0), LONG, (1.0, 0.0), 0.7 - x, -y) == pytest.approx(0, abs=2e-3)
    assert room_in(me, other(-0.7, 0.0), bearing_of(B, me, 0.0), 0.7) == np.inf, "who is behind is in nobody's way"


def test_who_has_long_stood_presses_into_the_room_that_bodies_keep():
    feet = Feet(Foot(0, 5.0, 5.07, 0.0, 0.0, 0.5), Foot(1, 5.0, 4.93, 0.0, 0.5, 0.5))
    held = nothing_held(1)
    round = around(held, World("plain", (12.0, 12.0)))
    pressed, keeps = [], strays(TABLE[0])
    for stood in (0, PRESSED // 2, PRESSED, 3 * PRESSED):
        round.intents.stood[0] = stood
        me = walker_of(round, Me(0, 3, True, 0, feet), 0.0)
        pressed.append((squeeze(me, 1.0, 0.0), squeeze(me, 0.0, 1.0)))
    np.testing.assert_allclose(pressed, SQUEEZE * np.outer([0, 0.5, 1, 1], keeps), err_msg="never into bodies")
    touching = other(0.25, 0.0)
    assert speed(waiting(), touching) == 0 < speed(waiting()._replace(press_deep=0.08, press_wide=0.04), touching)


def test_two_that_just_touch_press_by_how_far_one_must_move_and_that_way():
    random, half, told, twin, left = np.random.default_rng(3), (0.135, 0.21), [], [], []
    for _ in range(300):
        (first, second, angle), far = random.uniform(-np.pi, np.pi, 3), random.uniform(0.24, 0.4)
        p, faces = far * np.array([np.cos(angle), np.sin(angle)]), [(np.cos(a), np.sin(a)) for a in (first, second)]
        one = press_between(half, faces[0], half, faces[1], *p)
        ways = np.array([p, p + one.deep * np.array([one.x, one.y])])
        deep, after = -figures.gaps(np.array([half] * 2), np.full(2, first), np.array([half] * 2), np.full(2, second), ways)
        if abs(deep) < 0.05:
            told, twin, left = [*told, one.deep], [*twin, deep], [*left, after]
    assert len(told) > 50
    np.testing.assert_allclose(told, twin, atol=5e-4)
    np.testing.assert_allclose(left, 0, atol=5e-4, err_msg="so far moved, they only touch")
