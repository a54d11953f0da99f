"""Blender, where it is there as a Python module: it imports what is exported, and every joint is where ours is."""

import numpy as np
import pytest

from sim.export.clip.asked import Asked
from sim.export.skeletons.bvh import SCALE, export_bvh
from sim.export.skeletons.glb import export_glb
from tests.sim.export.readers import clip, moments, recording

bpy = pytest.importorskip("bpy", reason="needs Blender as a Python module: pip install bpy")
CLOSE = 1e-3


def from_above(places):
    """Our places in Blender's axes after its import of files that have y up: x right, y away, z up."""
    return np.stack([places[..., 1], -places[..., 0], places[..., 2]], axis=-1)


def check(run, first):
    """Heads of Blender's bones beside ours, at 20 moments; first: its number of the first frame."""
    actor, scene = run.actors[0], bpy.context.scene
    armature = next(one for one in bpy.data.objects if one.type == "ARMATURE")
    bones = [armature.pose.bones.get(name) for name in actor.skeleton.names]
    assert sum(bone is not None for bone in bones) >= len(bones) - 1  # the root may be called by its character
    worst = 0.0
    for frame in moments(run):
        at = run.elapsed[frame] * scene.render.fps / scene.render.fps_base + first
        scene.frame_set(int(at), subframe=at - int(at))
        for b, bone in enumerate(bones):
            if bone is not None:
                place = np.array(armature.matrix_world @ bone.head)
                worst = max(worst, float(np.linalg.norm(place - from_above(actor.placed.head[frame, b]))))
    assert worst < CLOSE


def test_a_glb(tmp_path):
    run = clip(recording("dinosaur"))
    export_glb(run, str(tmp_path / "run.glb"), Asked())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(tmp_path / "run.glb"))
    assert len(bpy.data.actions) == 1 and any(one.type == "MESH" for one in bpy.data.objects)
    check(run, 0)


def test_a_bvh(tmp_path):
    run = clip(recording("human"))
    export_bvh(run, str(tmp_path / "run.bvh"), Asked())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_anim.bvh(filepath=str(tmp_path / "run.bvh"), global_scale=1 / SCALE, update_scene_fps=True)
    check(run, 1)
