"""Bodies and their motion as USD (.usda, .usdc): UsdSkel, by the library usd-core. Our own axes, z up, metres.

Each character is a SkelRoot with skeleton, animation and mesh; samples are at time codes of the clip's own rate. As in a .glb
the root joint alone travels, and joints at the end of a bone that stretches move along it.
"""

import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from sim.export.clip.asked import Asked
from sim.export.clip.clip import Actor, Clip
from sim.export.skeletons.axes import light_of, steady
from sim.export.skeletons.scenery import Shape, scenery_of
from sim.export.skeletons.skin import Skin, colours_of_skin, heads_at_rest, kind_of, skin_of
from sim.files import outputs


def export_usd(clip: Clip, path: str, asked: Asked) -> None:
    """Writes all characters of a clip, and the world around them where that is asked for. Raises InputError."""
    stage = stage_of(clip)
    if asked.scenery:
        middle = np.mean([actor.pose.com[:, :2].mean(axis=0) for actor in clip.actors], axis=0)
        for name, shape in scenery_of(clip.world, middle).items():
            _define_mesh(stage, f"/{name}", shape)
    with outputs.whole(path) as temporary, tempfile.TemporaryDirectory() as folder:
        made = Path(folder) / f"made{Path(path).suffix.lower()}"  # the library tells formats by their endings
        stage.GetRootLayer().Export(str(made))
        temporary.write_bytes(made.read_bytes())


def stage_of(clip: Clip) -> Any:
    """The stage, a pxr.Usd.Stage, with its characters."""
    from pxr import Usd, UsdGeom

    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    stage.SetTimeCodesPerSecond(clip.rate)
    stage.SetFramesPerSecond(clip.rate)
    stage.SetStartTimeCode(0)
    stage.SetEndTimeCode(len(clip.time) - 1)
    skins: dict[bytes, Skin] = {}
    for actor in clip.actors:
        kind = kind_of(actor.character)
        skin = skins[kind] = skins.get(kind) or skin_of(actor.character)
        _add_actor(stage, actor, skin)
    stage.SetDefaultPrim(stage.GetPrimAtPath(f"/{_word(clip.actors[0].name)}"))
    return stage


def _word(name: str) -> str:
    """A name as USD allows them."""
    from pxr import Tf

    return Tf.MakeValidIdentifier(name)


def _add_actor(stage: Any, actor: Actor, skin: Skin) -> None:
    from pxr import UsdGeom, UsdSkel

    path = f"/{_word(actor.name)}"
    root = UsdSkel.Root.Define(stage, path)
    if not actor.there.all():
        seen, tokens = UsdGeom.Imageable(root).CreateVisibilityAttr(), UsdGeom.Tokens
        for k in np.flatnonzero(np.diff(actor.there, prepend=~actor.there[0])).tolist():
            seen.Set(tokens.inherited if actor.there[k] else tokens.invisible, k)
    skeleton = _add_skeleton(stage, f"{path}/skeleton", actor)
    animation = _add_animation(stage, f"{path}/animation", actor)
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets([animation.GetPath()])
    colour = colours_of_skin(actor.character, skin, actor.colours)
    mesh = _define_mesh(stage, f"{path}/body", Shape(skin.position, skin.normal, colour, skin.triangles))
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets([skeleton.GetPath()])
    binding.CreateJointIndicesPrimvar(False, 2).Set(_array("IntArray", skin.bones.astype(np.int32).ravel()))
    binding.CreateJointWeightsPrimvar(False, 2).Set(_array("FloatArray", skin.weight.astype(np.float32).ravel()))
    UsdGeom.Imageable(skeleton).CreatePurposeAttr(UsdGeom.Tokens.guide)


def _array(kind: str, values: np.ndarray) -> Any:
    from pxr import Vt

    return getattr(Vt, kind).FromNumpy(np.ascontiguousarray(values))


def _joints(actor: Actor) -> list[str]:
    """Each bone by the path of those that it hangs on."""
    paths: list[str] = []
    for name, above in zip(actor.skeleton.names, actor.skeleton.parent, strict=True):
        paths.append(name if above < 0 else f"{paths[above]}/{name}")
    return paths


def _add_skeleton(stage: Any, path: str, actor: Actor) -> Any:
    """The bones at rest: against the world, and against their parents."""
    from pxr import Gf, UsdSkel

    skeleton = UsdSkel.Skeleton.Define(stage, path)
    skeleton.CreateJointsAttr(_joints(actor))

    def moved(places: np.ndarray) -> list:
        return [Gf.Matrix4d().SetTranslate(Gf.Vec3d(*place.tolist())) for place in places]

    skeleton.CreateBindTransformsAttr(moved(heads_at_rest(actor.skeleton)))
    skeleton.CreateRestTransformsAttr(moved(actor.skeleton.offset))
    return skeleton


def _add_animation(stage: Any, path: str, actor: Actor) -> Any:
    from pxr import UsdSkel, Vt

    bones, skeleton = actor.bones, actor.skeleton
    animation = UsdSkel.Animation.Define(stage, path)
    animation.CreateJointsAttr(_joints(actor))
    places = skeleton.offset * bones.stretch[:, skeleton.parent, None]
    places[:, 0] = bones.root
    turns = np.roll(steady(bones.rotation_wxyz), -1, axis=2).astype(np.float32)  # x, y, z, w
    translations, rotations = animation.CreateTranslationsAttr(), animation.CreateRotationsAttr()
    for frame in range(len(places)):
        translations.Set(_array("Vec3fArray", places[frame].astype(np.float32)), frame)
        rotations.Set(_array("QuatfArray", turns[frame]), frame)
    animation.CreateScalesAttr(Vt.Vec3hArray(len(skeleton.names), (1, 1, 1)))
    return animation


def _define_mesh(stage: Any, path: str, shape: Shape) -> Any:
    """A mesh of triangles with normals and colours, each at its vertices."""
    from pxr import UsdGeom

    mesh = UsdGeom.Mesh.Define(stage, path)
    mesh.CreatePointsAttr(_array("Vec3fArray", shape.position.astype(np.float32)))
    mesh.CreateFaceVertexCountsAttr(_array("IntArray", np.full(len(shape.triangles), 3, np.int32)))
    mesh.CreateFaceVertexIndicesAttr(_array("IntArray", shape.triangles.astype(np.int32).ravel()))
    mesh.CreateNormalsAttr(_array("Vec3fArray", np.asarray(shape.normal, np.float32)))
    mesh.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    mesh.CreateExtentAttr(UsdGeom.PointBased.ComputeExtent(mesh.GetPointsAttr().Get()))
    colour = mesh.CreateDisplayColorPrimvar(UsdGeom.Tokens.vertex)
    colour.Set(_array("Vec3fArray", light_of(shape.colour).astype(np.float32)))
    return mesh
