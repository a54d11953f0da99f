"""What a step among others costs, term by term, and when bodies touch."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion.characters.character import load_character
from planner.crowd import terms
from planner.crowd.bodies import extent, gap_between, way_to_touch
from planner.crowd.candidates import DIRECTIONS, bearing_of, candidate, candidate_to, crosses, longest
from planner.crowd.neighbour import NEIGHBOUR
from planner.crowd.sides import on_the_right, wrong_side
from planner.crowd.walker import Walker

B = load_character("human").biped
ROUND, LONG = (0.2, 0.2), (0.15, 0.25)


def test_an_ellipse_extends_and_touches_as_far_as_its_axes_tell():
    assert extent(LONG, (1.0, 0.0), 1.0, 0.0) == pytest.approx(0.15) and extent(LONG, (0.0, 1.0), 1.0, 0.0) == pytest.approx(
        0.25
    )
    assert gap_between(LONG, (1.0, 0.0), LONG, (1.0, 0.0), 1.0, 0.0) == pytest.approx(0.7)
    assert gap_between(LONG, (0.0, 1.0), LONG, (1.0, 0.0), 1.0, 0.0) == pytest.approx(0.6)
    assert gap_between(ROUND, (1.0, 0.0), ROUND, (0.6, 0.8), 0.0, 0.3) == pytest.approx(-0.1)


@given(st.floats(-3, 3), st.floats(-3.1, 3.1), st.floats(0.05, 0.4), st.floats(0.05, 0.4))
def test_an_ellipse_extends_as_its_outline(turn, toward, deep, wide):
    angle = np.linspace(0, 2 * np.pi, 2001)
    c, s = np.cos(turn), np.sin(turn)
    x, y = deep * np.cos(angle), wide * np.sin(angle)
    outline = (c * x - s * y) * np.cos(toward) + (s * x + c * y) * np.sin(toward)
    assert extent((deep, wide), (c, s), np.cos(toward), np.sin(toward)) == pytest.approx(outline.max(), abs=1e-5)


@given(st.floats(-2, 2), st.floats(-2, 2), st.floats(-3, 3), st.floats(0.05, 0.4), st.floats(0.05, 0.4))
def test_two_who_face_alike_touch_where_their_ellipses_do(px, py, course, deep, wide):
    """Along and across the course their sum is an ellipse again: its outline is where one touches."""
    face, (dx, dy) = (np.cos(course), np.sin(course)), (np.cos(course), np.sin(course))
    way = way_to_touch(px, py, dx, dy, 2 * deep, 2 * wide)
    if np.isfinite(way):
        assert gap_between((deep, wide), face, (deep, wide), face, px - way * dx, py - way * dy) == pytest.approx(0, abs=1e-6)
    else:
        aside = abs(px * dy - py * dx)
        assert px * dx + py * dy <= 0 or aside >= 2 * wide


def waiting(hindered=0, side=0, course=0.0):
    """A human who stands at 5, 5 with its feet beside each other, and wishes to go on a course."""
    foot_y = 4.93 if side == 0 else 5.07
    return Walker(
        0,
        side,
        5.0,
        foot_y,
        5.0,
        5.0,
        0.0,
        5.0,
        5.0,
        0.0,
        0.0,
        0.0,
        0.25,
        1.3,
        False,
        0.0,
        0.0,
        hindered,
        course,
        1.0,
        0.0,
        0.15,
        0.25,
        0.0,
        0.0,
        9.0,
        False,
    )


def other(x, y, vx=0.0, vy=0.0, along=1.0, claim=(np.inf, np.inf), rank=0.0):
    """Another one, at x, y from there."""
    return np.array([(x, y, vx, vy, x, y, 0.15, 0.25, 1.0, 0.0, along, *claim, rank)], NEIGHBOUR)


def test_progress_is_lost_by_what_lacks_of_the_full_speed_on_the_course():
    assert terms.progress_lost(waiting(), 1.3, 0.0) == pytest.approx(0) and terms.progress_lost(waiting(), 0.0, 1.3) == 1
    assert terms.progress_lost(waiting(), -1.3, 0.0) == pytest.approx(2)
    assert terms.progress_lost(waiting(), 2.0, 0.0) == 0, "nothing is won by haste"
    calm = waiting()._replace(calm=True, wish_x=0.2)
    assert terms.progress_lost(calm, 0.2, 0.0) == 0 < terms.progress_lost(calm, 0.0, 0.0) < terms.progress_lost(calm, 1.3, 0.0)


def test_the_time_gap_is_kept_to_who_is_before_one_at_its_own_pace():
    me = waiting()
    speeds = [terms.speed_behind(me, other(1.2, 0.0, v)[0], 1.0, 0.0, 0.5, 0.6) for v in (-1.0, 0.0, 0.3, 1.0)]
    assert speeds[0] == speeds[1] < speeds[2] < speeds[3], "the faster it goes, the closer one may follow"
    for v, speed in zip((0.0, 0.3, 1.0), speeds[1:], strict=True):
        assert 1.2 + 0.5 * (v - speed) - 0.3 == pytest.approx(0.6 * speed), "what is left when the step has landed is the gap"
    assert terms.speed_behind(me, other(1.5, 0.6)[0], 1.0, 0.0, 0.5, 0.6) == np.inf, "one passes by"
    assert terms.speed_behind(me, other(0.25, 0.0)[0], 1.0, 0.0, 0.5, 0.6) == 0, "they touch"


def test_danger_grows_as_a_touch_comes_nearer_and_with_the_speed_of_it():
    me = waiting()
    near, far = (terms.danger(me, other(x, 0.0)[0], 1.0, 0.0, 6.0, 0.3) for x in (0.8, 1.6))
    slow = terms.danger(me, other(0.8, 0.0)[0], 0.3, 0.0, 6.0, 0.3)
    assert near > far > 0 and slow < near and terms.danger(me, other(0.8, 0.0, 1.0)[0], 1.0, 0.0, 6.0, 0.3) == 0
    assert terms.danger(me, other(9.0, 0.0)[0], 1.0, 0.0, 6.0, 0.3) == 0, "beyond the horizon"


def test_having_others_near_fades():
    me = waiting()
    costs = [terms.nearness(me, other(x, 0.0)[0], 0.0, 0.0, 0.5, 0.15) for x in (0.3, 0.45, 0.6, 3.0)]
    np.testing.assert_allclose(costs, [1, np.exp(-1), np.exp(-2), 0], atol=1e-12)


def test_who_has_the_right_of_way_is_let_through():
    me = waiting()
    claims = other(0.6, 0.0, claim=(0.1, 0.0), rank=5.0)[0]
    assert terms.in_the_way(me, claims, 0.0, 0.0) == 1 and terms.in_the_way(me, claims, -0.3, 0.0) == 0
    assert 0 < terms.in_the_way(me, claims, -0.15, 0.0) < 1
    assert terms.in_the_way(me, other(0.6, 0.0)[0], 0.0, 0.0) == 0, "who has none"


def test_who_comes_against_one_belongs_on_the_left():
    me = waiting()
    east = (1.0, 0.0)
    ahead, left, right = (on_the_right(me, other(2.0, y, -1.0, along=-1.0), east, 4.0) for y in (0.0, 1.0, -0.4))
    assert left == 0 and right == pytest.approx(ahead) == pytest.approx(0.5)
    assert on_the_right(me, other(2.0, -0.4), east, 4.0) == 0, "who goes the same way may be on either side"
    behind, far = (on_the_right(me, other(x, 0.0, along=-1.0), east, 4.0) for x in (-1.0, 5.0))
    assert behind == 0 == far
    around = (0.6, -0.8)  # behind a wall on the right, around whose end my way leads
    assert on_the_right(me, other(2.0, -0.4, -1.0, along=-1.0), around, 4.0) == 0, "whom my way leaves on the left"
    assert wrong_side(me, 0.8, 0.0, -0.5) < 0 == wrong_side(me, 0.8, 1.0, 0.0), "a step to the right mends it"
    assert wrong_side(me, 2.0, -0.5, 0.0) < 0 < wrong_side(me, 2.0, 0.5, 0.0), "in their lane one goes back"


def test_candidates_reach_as_far_as_a_leg_steps():
    me = waiting()
    assert longest(B, 0.0) == pytest.approx(0.7) and longest(B, np.pi / 2) == pytest.approx(0.35) == pytest.approx(
        longest(B, np.pi)
    )
    assert bearing_of(B, me, 0.0).longest == pytest.approx(0.7)
    for k in range(len(DIRECTIONS)):
        to = bearing_of(B, me, DIRECTIONS[k])
        step = candidate(B, me, to, to.longest)
        assert np.hypot(step.x - 5, step.y - 5) <= 0.7 + 1e-9 and abs(step.heading) <= B.reach.max_turn + 1e-9
        assert np.arctan2(step.y - 5, step.x - 5) == pytest.approx(DIRECTIONS[k])


def stepping_aside(me, k):
    """A step of 0.2 m in direction k."""
    return candidate(B, me, bearing_of(B, me, DIRECTIONS[k]), 0.2)


def test_who_faces_away_from_its_course_turns_to_it_as_it_steps():
    most = B.reach.max_turn
    assert stepping_aside(waiting(course=1.8), 0).heading == pytest.approx(most), "rather than to step aside for ever"
    assert stepping_aside(waiting(), 9).heading == 0, "who faces its course steps aside"


def test_no_foot_comes_down_across_the_other():
    left, right = (waiting(side=side) for side in (0, 1))
    aside = [candidate_to(B, me, (5.0, 5.0 + dy), 0.0) for me in (left, right) for dy in (0.2, -0.2)]
    assert [crosses(B, me, step) for me, step in zip((left, left, right, right), aside, strict=True)] == [
        False,
        True,
        True,
        False,
    ]
    assert not crosses(B, left, candidate_to(B, left, (5.6, 4.9), 0.0)), "a step ahead may"


def spread(density, far=2.1, wide=0.2378, deep=0.185):
    """People on a lattice, so many per square metre, all around."""
    apart = density**-0.5
    k = np.arange(-int(far / apart) - 1, int(far / apart) + 2)
    x, y = (one.ravel() * apart for one in np.meshgrid(k + 0.5, k + 0.5))
    others = np.zeros(len(x), NEIGHBOUR).view(np.recarray)
    others.x, others.y, others.deep, others.wide = x, y, deep, wide
    return others


@pytest.mark.parametrize("density", [1.5, 2.0, 3.0])
def test_people_walk_as_slowly_as_their_density_ahead_tells(density):
    """Weidmann's curve for people, a little steeper; nobody behind counts, and where bodies touch all shuffle on."""
    everyone = spread(density)
    ahead = sum(terms.covered(other, 2.1) for other in everyone[everyone.x > 0])
    assert ahead == pytest.approx(density * 4 * 0.2378 * 0.185, rel=0.12)
    assert terms.pace_at(ahead) == pytest.approx(1 - np.exp(-2.2 * (1 / density - 1 / 5.4)), abs=0.08)
    assert terms.pace_at(0.0) == 1 and terms.pace_at(0.95) == terms.SLOWEST
    assert sum(terms.covered(other, 0.0) for other in everyone) == 0, "who does not look ahead"
