"""Supporting forces: what the feet carry is what the motion needs, less what physics lacks."""

import numpy as np
import pytest
from scipy.optimize import nnls

from motion.arithmetic.gravity import GRAVITY
from motion.measures.forces import demands, impulses, needed_force, supporting_forces
from motion.pose.pose import Pose
from planner.script.scene import load_scene, scene_names
from sim.stage.scripted.performance import Performance

FLAT = ("sprint", "standing_start", "stop_from_a_run", "fig15_bird_walk", "ostrich_run", "one_leg_hops", "sneak")


def walked(name, rate=120):
    """Times and poses of a scene."""
    motion = Performance(load_scene(name)).motion
    time = np.arange(motion.begin, motion.end, 1 / rate)
    rows = [motion.pose(t) for t in time]
    return time, Pose(*(np.concatenate(column) for column in zip(*rows, strict=True)))


def forces_of(pose):
    return supporting_forces(pose.com, pose.com_acceleration, pose.point_of_support, pose.contact)


@pytest.mark.parametrize("name", scene_names())
def test_the_sum_of_forces_is_what_is_needed_less_the_residual_of_physics(name):
    _, pose = walked(name, 30)
    lacking = needed_force(pose.com_acceleration) - forces_of(pose).sum(axis=1)
    np.testing.assert_allclose(np.linalg.norm(lacking, axis=1), pose.physics_cost, atol=1e-9)


@pytest.mark.parametrize("name", FLAT)
def test_forces_integrate_to_weight_times_time_on_the_flat(name):
    """From standing to standing, the sum of vertical forces carries the weight for as long: within 1 %."""
    time, pose = walked(name)
    carried = np.trapezoid(forces_of(pose).sum(axis=1)[:, 2], time)
    assert carried == pytest.approx(GRAVITY * (time[-1] - time[0]), rel=0.01)


def test_two_legs_share_as_non_negative_least_squares_does():
    """Against scipy's solver, for legs and forces by chance."""
    chance = np.random.default_rng(2)
    com, support = chance.normal(size=(400, 3)) + [0, 0, 1.5], chance.normal(size=(400, 2, 3)) * [0.5, 0.5, 0.0]
    acceleration = 6 * chance.normal(size=(400, 3))
    force = supporting_forces(com, acceleration, support, np.ones((400, 2), bool))
    for k in range(400):
        legs = com[k] - support[k]
        legs /= np.linalg.norm(legs, axis=1, keepdims=True)
        shares, _ = nnls(legs.T, acceleration[k] + [0, 0, GRAVITY])
        np.testing.assert_allclose(force[k], shares[:, None] * legs, atol=1e-7)


def test_a_foot_in_the_air_carries_nothing_and_impulse_begins_anew():
    time, pose = walked("sprint")
    force = forces_of(pose)
    impulse = impulses(time, force, pose.contact)
    assert not force[~pose.contact].any() and not impulse[~pose.contact].any()
    landed = pose.contact[1:] & ~pose.contact[:-1]
    half = 0.5 * force[1:] * np.diff(time)[:, None, None]  # of the interval in which it landed
    np.testing.assert_allclose(impulse[1:][landed], half[landed])
    begin = np.flatnonzero(landed[:, 0])[1]
    end = begin + 1 + np.flatnonzero(~pose.contact[begin + 1 :, 0])[0]
    np.testing.assert_allclose(impulse[end - 1, 0], np.trapezoid(force[begin:end, 0], time[begin:end], axis=0))
    assert impulse[end - 1, 0, 2] > 1.0


def test_what_a_motion_demands_of_legs_and_ground():
    """At rest its weight; pushed aside by 3 m/s^2 friction for that; where it nearly falls, none."""
    acceleration = np.zeros((5, 3))
    rest = demands(acceleration)
    assert rest["force"] == pytest.approx(1) and rest["force_change"] == 0 and rest["friction"] == 0
    acceleration[2], acceleration[4] = [0.0, 3.0, 0.0], [5.0, 0.0, -0.9 * GRAVITY]
    asked = demands(acceleration)
    assert asked["force"] == pytest.approx(np.hypot(1, 3 / GRAVITY)) and asked["friction"] == pytest.approx(3 / GRAVITY)
    assert asked["force_change"] == pytest.approx(np.hypot(5 / GRAVITY, 0.9)) and demands(acceleration[:1])["force"] == 1
