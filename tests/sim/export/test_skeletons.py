"""Skeletons in other programs: validated, played by three.js, read by an independent reader; joints where ours are."""

import numpy as np
import pytest

from motion.characters.character import character_names
from planner.script.scene import load_scene, scene_names
from planner.script.shaping import Key
from sim.export.clip.asked import Asked
from sim.export.skeletons.axes import y_up
from sim.export.skeletons.bvh import SCALE, bvh_of, euler_zyx, export_bvh
from sim.export.skeletons.glb import export_glb
from sim.files.recording import Recorder, load_recording
from sim.stage.scripted.performance import Performance
from tests.sim.export.readers import clip, moments, node, recording

CLOSE = 1e-3
"""Joints agree within this [m]."""


def apart(found, expected):
    return float(np.linalg.norm(np.asarray(found) - expected, axis=-1).max())


@pytest.mark.parametrize("name", character_names())
def test_three_js_plays_a_glb_as_we_do(name, tmp_path):
    run = clip(recording(name, 2), begin=0.5)
    export_glb(run, str(tmp_path / "run.glb"), Asked())
    frames = moments(run)
    found = node("joints.mjs", str(tmp_path / "run.glb"), str(run.elapsed[frames].tolist()))
    places, at = np.array(found["places"]), 0
    for actor in run.actors:
        count = len(actor.skeleton.names)
        assert apart(places[:, at : at + count], y_up(actor.placed.head[frames])) < CLOSE
        at += count + 1  # and the node of its body
    assert at == len(found["names"])


@pytest.mark.parametrize("name", ["human", "dinosaur"])
def test_three_js_plays_a_bvh_as_we_do(name, tmp_path):
    run = clip(recording(name, 2), character=1)
    export_bvh(run, str(tmp_path / "run.bvh"), Asked())
    frames = moments(run)
    found = node("joints.mjs", str(tmp_path / "run.bvh"), str(run.elapsed[frames].tolist()))
    actor = run.actors[0]
    index = [found["names"].index(bone) for bone in actor.skeleton.names]
    assert apart(np.array(found["places"])[:, index] / SCALE, y_up(actor.placed.head[frames])) < CLOSE


def test_an_independent_reader_finds_the_joints_of_a_bvh():
    """Its numbers, put together by the rule of the format."""
    bvh = pytest.importorskip("bvh", reason="needs the package bvh")
    actor = (run := clip(recording("bird"))).actors[0]
    read = bvh.Bvh(bvh_of(actor, run.rate))
    assert read.nframes == len(run.time) and read.frame_time == pytest.approx(1 / run.rate)
    worst = 0.0
    for frame in moments(run):
        at = {}
        for name in read.get_joints_names():
            channels = read.joint_channels(name)
            numbers = dict(zip(channels, read.frame_joint_channels(frame, name, channels), strict=True))
            move = [numbers.get(f"{axis}position", 0.0) for axis in "XYZ"]
            above = read.joint_parent(name)
            place, turn = at[above.name] if above else (np.zeros(3), np.eye(3))
            turned = turn
            for axis in "ZYX":
                turned = turned @ about("XYZ".index(axis), numbers.get(f"{axis}rotation", 0.0))
            at[name] = place + turn @ (np.array(read.joint_offset(name)) + move), turned
        found = np.array([at[name][0] for name in actor.skeleton.names]) / SCALE
        worst = max(worst, apart(found, y_up(actor.placed.head[frame])))
    assert worst < CLOSE


def about(axis, degrees):
    """The matrix of a turn about an axis."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn = np.eye(3)
    turn[i, i], turn[i, j], turn[j, i], turn[j, j] = c, -s, s, c
    return turn


def test_euler_angles_are_the_turn():
    chance = np.random.default_rng(0).normal(size=(50, 4))
    turns = chance / np.linalg.norm(chance, axis=1, keepdims=True)
    for (x, y, z, w), (a, b, c) in zip(turns, euler_zyx(turns), strict=True):
        matrix = about(2, a) @ about(1, b) @ about(0, c)
        expected = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]
        np.testing.assert_allclose(matrix[:, 0], expected, atol=1e-9)
        np.testing.assert_allclose(matrix[1, 2], 2 * (y * z - w * x), atol=1e-9)


def test_every_scene_is_a_valid_glb(tmp_path):
    paths = []
    for name in scene_names():
        run = clip(Performance(load_scene(name)), rate=10.0)
        paths.append(str(tmp_path / f"{name}.glb"))
        export_glb(run, paths[-1], Asked(scenery=True))
    assert node("validate.mjs", *paths) == [[0, 0, []]] * len(paths)


def test_a_river_run_and_a_hundred_wanderers_are_valid_glb(tmp_path):
    river, crowd = recording("dinosaur", 1, 3.0, "river_leaps", True), recording("human", 100, 1.0, "forest")
    export_glb(clip(river), str(tmp_path / "river.glb"), Asked(scenery=True))
    export_glb(clip(crowd, rate=30.0), str(tmp_path / "crowd.glb"), Asked())
    assert node("validate.mjs", str(tmp_path / "river.glb"), str(tmp_path / "crowd.glb")) == [[0, 0, []]] * 2


def test_a_scene_at_its_own_times_is_the_recording_of_it():
    """Bones of a recording are those of the run: they follow from the poses that it holds."""
    show = Performance(load_scene("sprint"))
    run = clip(Performance(load_scene("sprint")), rate=24.0)
    for frame in moments(run, 6):
        bones = show.bones(0, float(run.time[frame]))
        np.testing.assert_allclose(run.actors[0].bones.rotation_wxyz[frame], bones.rotation_wxyz[0], atol=1e-12)
        np.testing.assert_allclose(run.actors[0].bones.root[frame], bones.root[0], atol=1e-12)


def test_hand_keys_go_out_with_a_recording(tmp_path):
    scene = load_scene("fig17_small_leap")
    show = Performance(scene.changed(key=[Key(bone="head", footprint=4, rotation_deg=(0.0, 0.0, 40.0))]))
    recorder = Recorder(show)
    while not show.over:
        show.tick()
        recorder.capture()
    recorder.save(tmp_path / "run.npz")
    actor = (run := clip(load_recording(tmp_path / "run.npz"))).actors[0]
    assert len(actor.hand_keys) == 1
    for frame in moments(run):
        expected = show.bones(0, float(run.time[frame])).rotation_wxyz[0]
        np.testing.assert_allclose(actor.bones.rotation_wxyz[frame], expected, atol=1e-9)
