"""Bones against the pose that they come from: the places that follow are the joints, to a tenth of a millimetre."""

import numpy as np
import pytest

from motion.characters.character import character_names, load_character
from motion.motion import placed, solve
from motion.pose.bones import BONES, parent_of
from motion.pose.skeleton import skeleton_of
from planner.script.footprint import Footprint
from planner.script.laying import laid
from planner.script.scene import load_scene, scene_names
from sim.stage.making import make_simulation
from sim.stage.scripted.performance import Performance
from tests.walks import straight_walk

CLOSE = 1e-4
"""What is drawn, and what bones say, differ by less than this [m]."""
HEADS = {"thigh": "hip", "shank": "knee", "foot": "ankle", "toes": "ball"}
ARMS = {"upper_arm": "shoulder", "forearm": "elbow", "hand": "hand"}
TIPS = {"foot": "heel", "toes": "toe"}


def apart(motion, t):
    """Largest distance [m] of a bone's place from the joint of the pose that it stands for."""
    pose, skeleton, bones = motion.pose(t), motion.skeleton, motion.bones(t)
    at, index = placed(bones, skeleton), {name: k for k, name in enumerate(skeleton.names)}
    pairs = [(at.head[0, index[name]], getattr(pose, name)[0]) for name in ("neck", "head")]
    pairs.append((at.head[0, 0], pose.com[0]))
    legs = HEADS | ({"metatarsus": "hock"} if "metatarsus_left" in index else {})
    for side, word in enumerate(("left", "right")):
        for bone, joint in (legs | (ARMS if "hand_left" in index else {})).items():
            pairs.append((at.head[0, index[f"{bone}_{word}"]], getattr(pose, joint)[0, side]))
        for bone, joint in TIPS.items():
            pairs.append((at.tip[0, index[f"{bone}_{word}"]], getattr(pose, joint)[0, side]))
    if "tail_1" in index:
        pairs += [(at.head[0, index[f"tail_{k + 1}"]], pose.tail[0, k]) for k in range(len(pose.tail[0]) - 1)]
    return max(float(np.linalg.norm(a - b)) for a, b in pairs)


@pytest.mark.parametrize("name", character_names())
def test_bones_lie_where_the_joints_are(name):
    character = load_character(name)
    footprints = straight_walk(character.biped, turn=0.15)
    footprints.stance_time[-2:] += 1.0
    motion = solve(footprints, character)
    for t in np.linspace(motion.begin, motion.end, 60):
        assert apart(motion, t) < CLOSE
        bones = motion.bones(t)
        np.testing.assert_allclose(np.linalg.norm(bones.rotation_wxyz[0], axis=1), 1.0, atol=1e-9)
        legs = [k for k, bone in enumerate(motion.skeleton.names) if bone.startswith(("thigh", "shank", "metatarsus"))]
        assert bones.stretch[0, legs].max() < 1.03
        np.testing.assert_allclose(np.delete(bones.stretch[0], legs), 1.0, atol=1e-6)


def test_bones_of_a_crowd_are_those_of_each_ones_skeleton():
    sim = make_simulation("forest", "dinosaur", 2, 1, False)
    for _ in range(90):
        sim.tick()
    skeleton, bones = sim.skeleton(1), sim.bones(1, 1.2)
    assert bones.rotation_wxyz.shape == (1, len(skeleton.names), 4) and bones.stretch.shape == (1, len(skeleton.names))
    at, pose = placed(bones, skeleton), sim.snapshot(1.2)
    toe = at.tip[0, skeleton.names.index("toes_right")]
    np.testing.assert_allclose(toe, pose.toe[1, 1], atol=CLOSE)


@pytest.mark.parametrize("name", scene_names())
def test_bones_of_every_scene_lie_where_the_joints_are(name):
    motion = Performance(load_scene(name)).motion
    assert max(apart(motion, t) for t in np.linspace(motion.begin, motion.end, 25)) < CLOSE


def test_lengths_between_bones_are_the_skeletons_times_their_stretch():
    motion = Performance(load_scene("sprint")).motion
    skeleton = motion.skeleton
    for t in np.linspace(motion.begin, motion.end, 40):
        bones = motion.bones(t)
        at = placed(bones, skeleton)
        for b, above in enumerate(skeleton.parent):
            if above >= 0:
                length = np.linalg.norm(at.head[0, b] - at.head[0, above])
                rest = np.linalg.norm(skeleton.offset[b]) * bones.stretch[0, above]
                assert length == pytest.approx(rest, abs=1e-9)


def test_a_foot_out_of_reach_is_a_named_stretch():
    human = load_character("human")
    far = [Footprint(side=s, position=(x, y)) for s, x, y in (("left", 0.0, 0.1), ("right", 0.0, -0.1), ("left", 2.6, 0.1))]
    motion = solve(laid(far, human), human)
    stretch = np.array([motion.bones(t).stretch[0] for t in np.linspace(motion.begin, motion.end, 80)])
    worst = motion.skeleton.names[int(stretch.max(axis=0).argmax())]
    assert stretch.max() > 1.05 and worst.startswith(("thigh", "shank"))


@pytest.mark.parametrize("name", character_names())
def test_a_skeleton_is_whole(name):
    skeleton = skeleton_of(load_character(name))
    assert skeleton.parent[0] == -1 and (skeleton.parent[1:] < np.arange(1, len(skeleton.parent))).all()
    assert len(set(skeleton.names)) == len(skeleton.names) and set(skeleton.names) <= set(BONES)
    left = [k for k, bone in enumerate(skeleton.names) if bone.endswith("_left")]
    right = [skeleton.names.index(skeleton.names[k].replace("_left", "_right")) for k in left]
    np.testing.assert_allclose(skeleton.offset[left], skeleton.offset[right] * [1, -1, 1])
    assert parent_of("toes_left") == "foot_left" and parent_of("root") == ""


def test_wings_open_in_a_hop_and_are_folded_walking():
    turned = {}
    for level, hops in (("forest", False), ("river_long_steps", True)):
        sim = make_simulation(level, "bird", 1, 2, hops)
        wings = [sim.skeleton(0).names.index(f"wing_{side}") for side in ("left", "right")]
        seen = []
        for _ in range(12 * 60):
            sim.tick()
            seen.append(np.abs(sim.bones(0, sim.time).rotation_wxyz[0, wings, 0]))
        turned[level] = 2 * np.arccos(np.clip(seen, 0, 1))
    assert turned["forest"].max() < np.radians(3)
    assert turned["river_long_steps"].max() > np.radians(30)
    np.testing.assert_allclose(turned["river_long_steps"][:, 0], turned["river_long_steps"][:, 1], atol=1e-6)
    assert np.abs(np.diff(turned["river_long_steps"], axis=0)).max() < np.radians(15)  # within a frame
