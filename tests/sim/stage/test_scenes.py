"""Every scene that ships, measured as its user would: exact at its footprints, physical, and without a pop."""

from functools import cache

import numpy as np
import pytest

from planner.script.scene import load_scene, scene_names
from sim.files.recording import Recorder
from sim.reports.measure import measure
from sim.stage.scripted.performance import Performance
from worlds.errors import InputError

FAST = {"sprint", "ditch_jump", "one_leg_hops", "stop_from_a_run", "fig18_run_over_hills", "ostrich_run"}
FAST |= {"fig01_steps_and_a_hop", "fig17_large_leap", "fig17_small_leap", "fig19_automatic_timing"}
ONE_LANDING = {"fig01_steps_and_a_hop"}
"""A slow scene whose only landing from a hop stands out of all else."""
GRAVITY = 9.81


def recorded(scene):
    recorder = Recorder(scene)
    while not scene.over:
        recorder.capture()
        scene.tick()
    return recorder.recording()


@cache
def report(name):
    return measure(recorded(Performance(load_scene(name))))["characters"][0]


@pytest.mark.parametrize("name", scene_names())
def test_feet_are_exact(name):
    r = report(name)
    assert r["footprint_error"] <= 1e-3 and r["contact_error"] < 1
    assert r["skate"] <= 1e-3 and r["penetration"] <= 3e-3
    assert r["clearance_share"] >= 0.012
    assert r["shank_gap"] >= 0


@pytest.mark.parametrize("name", scene_names())
def test_legs_do_not_pop_and_reach(name):
    r = report(name)
    for joint in ("knee", "ankle"):
        assert r["joints"][joint]["acceleration_ratio"] <= (9 if name in ONE_LANDING else 3.2)
    assert r["overreach"] <= 1e-3


JOINTS = ("com", "hip", "knee", "hock", "ankle", "heel", "ball", "toe", "shoulder", "elbow", "hand", "head", "tail")


@pytest.mark.parametrize("name", scene_names())
def test_no_joint_changes_its_velocity_at_once(name):
    motion, h = Performance(load_scene(name)).motion, 5e-6
    f, knots = motion.footprints, motion.curve.time
    for t in np.concatenate([f.contact_time, f.contact_time + f.stance_time]):
        if not knots[0] + 0.1 < t < knots[-1] - 0.1:
            continue
        poses = [motion.pose(t + k * h) for k in (-5, -3, -1, 1, 3, 5)]
        for joint in JOINTS:
            a, b, c, d, e, g = (getattr(pose, joint)[0].reshape(-1, 3) for pose in poses)
            before, after = (3 * c - 4 * b + a) / (4 * h), (4 * e - 3 * d - g) / (4 * h)
            assert np.linalg.norm(after - before, axis=1).max() <= 0.03, (joint, t)
            assert np.linalg.norm(d - c - h * (before + after), axis=1).max() <= 1e-6, (joint, t)


@pytest.mark.parametrize("name", scene_names())
def test_physics_is_kept(name):
    r = report(name)
    assert r["flight_residual"] <= 0.04 * GRAVITY
    assert r["physics_cost"]["all"]["mean"] <= (0.045 if name in FAST else 0.02) * GRAVITY


def test_a_scripted_facing_turns_the_hips_and_is_optimised():
    ahead, aside = (Performance(s.changed(path=(s.track.path[0].model_copy(update={"facing_deg": d}),))) for s, d in
                    ((load_scene("looking_aside"), d) for d in (0.0, 60.0)))  # fmt: skip
    t = 0.5 * ahead.end
    yaw = [np.degrees(2 * np.arctan2(p.pelvis_rotation_wxyz[0, 3], p.pelvis_rotation_wxyz[0, 0])) for p in
           (ahead.snapshot(t), aside.snapshot(t))]  # fmt: skip
    assert yaw[1] - yaw[0] == pytest.approx(60, abs=8)
    assert np.abs(ahead.snapshot(t).com - aside.snapshot(t).com).max() > 1e-3


@pytest.mark.parametrize("support, share", [("middle", 0.5), ("toe", 1.0)])
def test_the_papers_points_of_support(support, share):
    show = Performance(load_scene("fig17_walking_turn").changed(support=support))
    pose = show.snapshot(0.3 * show.end)
    foot = int(np.flatnonzero(pose.contact[0])[0])
    walked, t = show.track(0), 0.3 * show.end
    n = int(np.flatnonzero((walked.side == foot) & (walked.contact_time <= t))[-1])
    along = np.array([np.cos(walked.heading[n]), np.sin(walked.heading[n])])
    offset = (pose.point_of_support[0, foot, :2] - walked.position[n, :2]) @ along
    assert offset == pytest.approx((share - 0.5) * float(show.bipeds[0].foot.length), abs=1e-9)


def test_the_papers_layout_has_fewer_segments():
    scene = load_scene("fig17_walking_turn")
    by_phase, by_step = Performance(scene), Performance(scene.changed(segments="step"))
    assert len(by_step.curve(0).time) < len(by_phase.curve(0).time)
    assert by_step.snapshot(3.0).physics_cost[0] < 2


def test_a_foot_must_leave_before_it_lands():
    scene = load_scene("fig19_automatic_timing")
    footprints = [one.model_copy(update={"stance_time": 3.0, "step_time": 0.5}) for one in scene.track.footprint]
    with pytest.raises(InputError, match="lands on"):
        Performance(scene.changed(footprint=tuple(footprints)))
