"""USD, read back by usd-core."""

import numpy as np
import pytest

from sim.export.clip.asked import Asked
from tests.sim.export.readers import clip, moments, recording

Usd = pytest.importorskip("pxr.Usd", reason="needs usd-core")
from pxr import UsdGeom, UsdSkel  # noqa: E402

from sim.export.skeletons.usd import export_usd  # noqa: E402

CLOSE = 1e-3


@pytest.mark.parametrize("ending", [".usda", ".usdc"])
def test_joints_are_where_ours_are(ending, tmp_path):
    run = clip(recording("bird", 2))
    path = str(tmp_path / f"run{ending}")
    export_usd(run, path, Asked(scenery=True))
    stage = Usd.Stage.Open(path)
    assert UsdGeom.GetStageUpAxis(stage) == "Z" and UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert stage.GetTimeCodesPerSecond() == run.rate and stage.GetEndTimeCode() == len(run.time) - 1
    for actor in run.actors:
        root = UsdSkel.Root(stage.GetPrimAtPath(f"/{actor.name}"))
        cache = UsdSkel.Cache()
        cache.Populate(root, Usd.PrimDefaultPredicate)
        skeleton = UsdSkel.Skeleton(stage.GetPrimAtPath(f"/{actor.name}/skeleton"))
        query = cache.GetSkelQuery(skeleton)
        assert query.HasBindPose() and query.HasRestPose()
        for frame in moments(run):
            found = np.array([one.ExtractTranslation() for one in query.ComputeJointSkelTransforms(float(frame))])
            assert np.linalg.norm(found - actor.placed.head[frame], axis=1).max() < CLOSE
        skinning = cache.GetSkinningQuery(stage.GetPrimAtPath(f"/{actor.name}/body"))
        assert skinning and skinning.GetNumInfluencesPerComponent() == 2
    ground = UsdGeom.Mesh(stage.GetPrimAtPath("/ground"))
    assert len(ground.GetPointsAttr().Get()) > 1000


def test_the_body_is_carried_to_where_it_is(tmp_path):
    """Skinned by usd-core: soles stand on the ground, the head is above."""
    run = clip(recording("human"))
    export_usd(run, str(tmp_path / "run.usdc"), Asked())
    stage = Usd.Stage.Open(str(tmp_path / "run.usdc"))
    cache = UsdSkel.Cache()
    cache.Populate(UsdSkel.Root(stage.GetPrimAtPath("/human_0")), Usd.PrimDefaultPredicate)
    query = cache.GetSkelQuery(UsdSkel.Skeleton(stage.GetPrimAtPath("/human_0/skeleton")))
    skinning = cache.GetSkinningQuery(stage.GetPrimAtPath("/human_0/body"))
    frame = 120
    points = UsdGeom.Mesh(stage.GetPrimAtPath("/human_0/body")).GetPointsAttr().Get()
    assert skinning.ComputeSkinnedPoints(query.ComputeSkinningTransforms(float(frame)), points, float(frame))
    points = np.array(points)
    actor = run.actors[0]
    lowest = actor.pose.heel[frame, :, 2].min()
    assert abs(points[:, 2].min() - lowest) < 0.06
    assert np.linalg.norm(points[:, :2].mean(axis=0) - actor.pose.com[frame, :2]) < 0.2
