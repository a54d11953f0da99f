"""The whole loop: wandering and crossing for every character, measured as a user would."""

import hashlib

import numba
import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.wander import Wander
from planner.stepping.timing import step_timing
from sim.files.recording import Recorder, load_recording
from sim.reports.measure import measure
from sim.stage.commands import PlantTree, SetGoal, apply
from sim.stage.making import make_simulation
from sim.stage.simulation import Simulation
from worlds.level import load_level

CHARACTERS = ("bird", "dinosaur", "human")


def recorded(sim, seconds):
    recorder = Recorder(sim)
    for _ in range(int(seconds * sim.tick_rate)):
        sim.tick()
        recorder.capture()
        if sim.world.goal and sim.reached_goal.all():
            break
    return recorder


def report_of(recorder):
    return measure(recorder.recording())["worst"]


@pytest.mark.parametrize("character", CHARACTERS)
@pytest.mark.parametrize("level", ["forest", "dense_forest", "hills", "forest_river", "concourse", "rock_field"])
def test_wanderers_walk_well(level, character):
    sim = make_simulation(level, character, 1, 5, False)
    worst = report_of(recorded(sim, 60))
    b = load_character(character).biped
    walking = b.gait.preferred_step / step_timing(b, b.gait.preferred_step, 0.0, 0.0, False)[0]
    assert worst["speed"] >= 0.5 * walking
    assert worst["stance_slide"] <= 1e-3 and worst["penetration"] <= 3e-3
    assert min(worst[f"{what}_distance"] for what in ("tree", "water", "border")) > 0.5 * b.foot.length
    assert worst["mean_physics_cost"] <= 0.3 and worst["flight_residual"] <= 0.2
    assert worst["physics_cost_error"] <= 1e-6
    assert worst["force"] <= 4 and worst["friction"] <= 0.7
    assert worst["shank_gap"] >= -7e-3, "legs keep out of each other"


@pytest.mark.parametrize("character", CHARACTERS)
@pytest.mark.parametrize("level", ["river_easy", "river_long_steps", "river_leaps", "river_delta"])
def test_rivers_are_crossed(level, character):
    sim = make_simulation(level, character, 1, 0, True)
    worst = report_of(recorded(sim, 90))
    assert sim.reached_goal.all()
    assert worst["stance_slide"] <= 1e-3 and worst["penetration"] <= 3e-3
    assert worst["flight_residual"] <= 0.4 and worst["mean_physics_cost"] <= 0.45
    assert worst["overreach"] <= 1.5e-3, "less than half of what a foot tilts for"
    assert worst["force"] <= 4 and worst["friction"] <= 0.7, "no more than legs and soles give, leaps from a slow step too"
    assert worst["shank_gap"] >= -7e-3


def crowd_digest(threads):
    before = numba.get_num_threads()
    numba.set_num_threads(threads)
    try:
        sim = Simulation(load_level("forest"), [load_character("bird"), load_character("human")] * 8, Wander(), 9)
        recorder = recorded(sim, 6)
        digest = hashlib.sha256()
        for name, array in sorted(recorder.arrays().items()):
            digest.update(name.encode() + np.ascontiguousarray(array).tobytes())
        return digest.hexdigest()
    finally:
        numba.set_num_threads(before)


def test_threads_change_nothing():
    assert crowd_digest(1) == crowd_digest(min(2, numba.config.NUMBA_NUM_THREADS))


def test_asking_for_poses_changes_nothing():
    quiet, watched = (make_simulation("forest", "human", 1, 3, False) for _ in range(2))
    for k in range(300):
        quiet.tick()
        watched.tick()
        watched.snapshot(watched.time - 0.3 / (1 + k % 7) / 60)
    for a, b in zip(quiet.snapshot(), watched.snapshot(), strict=True):
        np.testing.assert_array_equal(a, b)


def test_recordings_round_trip(tmp_path):
    sim = make_simulation("hills", "dinosaur", 2, 1, False)
    recorder = recorded(sim, 2)
    recorder.save(tmp_path / "a.npz")
    loaded = load_recording(tmp_path / "a.npz")
    for name, array in recorder.arrays().items():
        np.testing.assert_array_equal(loaded.arrays[name], array)
    np.testing.assert_array_equal(loaded.world.arrays.trees, sim.world.arrays.trees)
    assert loaded.arrays["hip"].shape == (120, 2, 2, 3)


def test_a_tree_planted_ahead_is_walked_round():
    sim = make_simulation("forest", "human", 1, 0, False)
    for _ in range(200):
        sim.tick()
    pose = sim.snapshot()
    ahead = pose.com[0, :2] + 3.0 * pose.com_velocity[0, :2] / np.linalg.norm(pose.com_velocity[0, :2])
    apply(sim, PlantTree(*ahead.tolist(), 0.4))
    recorder = recorded(sim, 20)
    assert report_of(recorder)["tree_distance"] > 0.13


def test_a_new_goal_is_walked_to():
    sim = make_simulation("river_easy", "human", 1, 0, True)
    for _ in range(300):
        sim.tick()
    apply(sim, SetGoal(23.0, 11.0))
    for _ in range(60 * 60):
        sim.tick()
        if sim.reached_goal[0]:
            break
    assert sim.reached_goal[0]
    assert np.hypot(*(sim.feet().position[0, 1, :2] - (23.0, 11.0))) < 1.5


def test_live_window_is_near_the_global_optimum():
    from sim.bench import live

    sim, curve, _ = live.wander_windows(seed=2)
    assert 1.0 <= live.over_global(sim, curve) <= 1.06


def test_late_frames_are_the_same_to_the_bit():
    """A window that falls behind captures several ticks at once, after later footprints were placed."""
    prompt, late = (make_simulation("forest", "bird", 1, 3, False) for _ in range(2))
    early, after = Recorder(prompt), Recorder(late)
    for k in range(1, 601):
        prompt.tick()
        early.capture()
        late.tick()
        if k % 6 == 0:
            for tick in range(k - 5, k + 1):
                after.capture(tick / 60)
    for name, array in early.arrays().items():
        assert array.tobytes() == after.arrays()[name].tobytes(), name
