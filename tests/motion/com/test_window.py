"""The live window: what is laid against the foot's own kernels, the guess of its end, and E against tight solutions."""

import numpy as np
import pytest

from motion.characters.character import load_character
from motion.com import laying, newton, window
from motion.com.problem import Layout, total_cost
from motion.track import curve, foot, heading, phases
from motion.track.curve import Curve
from motion.track.pelvis import pelvis_at
from sim.bench import live
from tests import reference
from tests.walks import straight_walk


@pytest.fixture(scope="module")
def wander():
    return live.wander_windows("bird", seed=3)


@pytest.fixture(scope="module")
def windows(wander):
    return wander[2]


@pytest.mark.parametrize("by_step", [False, True])
def test_laying_asks_the_foot_and_the_heading(windows, by_step):
    for one in windows[::16]:
        b, footprints, end = one.biped, one.footprints, window.window_end(one.footprints)
        problem, _ = laying.build_problem(b, footprints, one.committed.time[-1], end, Layout(5, by_step, False, False, 0.0))
        for i, j in np.ndindex(len(problem.time) - 1, len(problem.standing)):
            t = problem.time[i] + (j + 0.5) / 5 * (problem.time[i + 1] - problem.time[i])
            support = phases.support_at(footprints, 0, t)
            check_legs(b, footprints, support, t, problem.standing[j, :, i], problem.leg_origin[j, :, :, i])
            for leg, n in enumerate(support):
                if n >= 0:
                    point = foot.point_of_support(
                        b, footprints, n, (t - footprints.contact_time[n]) / footprints.stance_time[n]
                    )
                    np.testing.assert_allclose(problem.support_point[j, leg, :, i], point, atol=1e-12)
            if j in (0, 4):
                end = j // 4
                edge = problem.time[i + end]
                check_legs(b, footprints, support, edge, problem.end_standing[end, :, i], problem.end_origin[end, :, :, i])


def check_legs(b, footprints, support, t, standing, origin):
    yaw, (turn, roll) = heading.body_heading(b, footprints, t), pelvis_at(b, footprints, t)
    for leg, n in enumerate(support):
        assert standing[leg] == (n >= 0)
        if n >= 0:
            u = min(max((t - footprints.contact_time[n]) / footprints.stance_time[n], 0.0), 1.0)
            expected = np.array(foot.stance_ankle(b, footprints, n, u)) - foot.hip_offset(b, leg, yaw + turn, roll)
            np.testing.assert_allclose(origin[leg], expected, atol=1e-12)


def test_headings_at_many_times_are_those_at_each(windows):
    one = windows[40]
    times = np.linspace(one.footprints.contact_time[0] - 2.0, one.footprints.contact_time[-1] + 2.0, 400)
    out = np.empty((4, 100))
    heading.body_headings(one.biped, one.footprints, times.reshape(100, 4).T.copy(), out)
    np.testing.assert_allclose(out.T.ravel(), [heading.body_heading(one.biped, one.footprints, t) for t in times], atol=1e-12)


def first_of(old):
    """A committed curve that has only begun."""
    return Curve(old.time[:1], old.control[:1], old.support[:1])


def test_a_regular_walk_is_foreseen_exactly():
    """On a straight walk the state four footprints on is the same one moved along: the guess finds it."""
    b = load_character("human").biped
    footprints = straight_walk(b, 12)
    stride = footprints.position[8] - footprints.position[4]
    later = footprints.contact_time[8] - footprints.contact_time[4]
    old = Curve(
        np.linspace(footprints.contact_time[1], footprints.contact_time[10], 40),
        np.random.default_rng(1).normal(size=(40, 6)),
        np.full((40, 2), -1),
    )
    problem, _ = window.lay_window(b, footprints, footprints.contact_time[6])
    control = np.zeros((len(problem.time), 6))
    window.begin_window(b, footprints, problem, control, first_of(old), old)
    scratch, expected = np.empty(3), np.empty(6)
    curve.evaluate(old, problem.time[-1] - later, expected[:3], expected[3:], scratch)
    np.testing.assert_allclose(control[-1], expected + np.concatenate([stride, np.zeros(3)]), atol=1e-9)
    np.testing.assert_array_equal(problem.anchor, control[-1])
    assert (problem.anchor_stiffness > 0).all()


def test_an_irregular_end_is_left_free():
    b = load_character("human").biped
    footprints = straight_walk(b, 12)
    footprints.side[11] = footprints.side[10]
    old = Curve(footprints.contact_time[1:11].copy(), np.zeros((10, 6)), np.full((10, 2), -1))
    problem, _ = window.lay_window(b, footprints, footprints.contact_time[6])
    control = np.zeros((len(problem.time), 6))
    window.begin_window(b, footprints, problem, control, first_of(old), old)
    assert (problem.anchor_stiffness == 0).all()


def test_cost_of_a_window_is_its_twin(windows):
    """The springs at its end included."""
    one = windows[30]
    problem, _ = window.lay_window(one.biped, one.footprints, one.committed.time[-1])
    control = np.zeros((len(problem.time), 6))
    window.begin_window(one.biped, one.footprints, problem, control, one.committed, one.last)
    control[1:] += np.random.default_rng(2).normal(0, 0.02, control[1:].shape)
    assert (problem.anchor_stiffness > 0).all()
    assert total_cost(problem, control) == pytest.approx(reference.total_cost(problem, control), rel=1e-9)


def test_the_last_two_steps_of_a_window_are_rough(windows):
    """One piece to a single stance, where there are three before."""
    one = windows[30]
    problem, support = window.lay_window(one.biped, one.footprints, one.committed.time[-1])
    begin = one.footprints.contact_time[len(one.footprints.side) - 3]
    phase = np.cumsum(np.r_[True, (np.diff(support, axis=0) != 0).any(axis=1)])
    pieces = {
        (problem.time[i] >= begin - 1e-9, (support[i] < 0).any()): int((phase == phase[i]).sum()) for i in range(len(phase))
    }
    assert pieces[True, True] == 1
    assert pieces[False, True] == 3


def test_a_wander_is_walked_again_to_the_bit(wander):
    sim, curve, windows = wander
    again = live.walked_again(sim, windows, newton.LIVE)
    assert np.array_equal(again.time, curve.time) and np.array_equal(again.control, curve.control)


def test_what_is_walked_is_no_worse_than_of_windows_that_are_solved_tightly(wander):
    """Steps are solved again before they are walked."""
    assert live.over_tight(*wander) <= 1.02
