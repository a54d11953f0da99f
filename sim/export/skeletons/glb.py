"""Bodies and their motion as glTF (.glb): a skeleton of nodes, a skin, an animation per character. Metres, y up, z forward.

The root node alone travels, with the centre of mass and the heading of the feet; all other bones only turn, but for those at
the end of one that stretches. Without it nodes lie as the skeleton does at rest, the root where the clip begins. Characters of
a kind share their mesh's numbers, and differ by colours.
"""

import numpy as np

from sim import VERSION
from sim.export.clip.asked import Asked
from sim.export.clip.clip import Actor, Clip
from sim.export.skeletons.axes import light_of, steady, y_up, y_up_xyzw
from sim.export.skeletons.gltf import INDICES, VERTICES, Gltf
from sim.export.skeletons.scenery import Shape, scenery_of
from sim.export.skeletons.skin import Skin, colours_of_skin, heads_at_rest, kind_of, skin_of
from sim.files import outputs

LITTLE = 1e-5
"""A bone that never turns or moves by more than this, of its quaternion or in metres, is not animated."""


def export_glb(clip: Clip, path: str, asked: Asked) -> None:
    """Writes all characters of a clip, and the world around them where that is asked for. Raises InputError."""
    gltf = gltf_of(clip)
    if asked.scenery:
        add_scenery(gltf, clip)
    with outputs.whole(path) as temporary:
        gltf.write(temporary)


def gltf_of(clip: Clip) -> Gltf:
    """The file with its characters."""
    gltf = Gltf(f"Footfall {VERSION}")
    look = gltf.add("materials", name="body", pbrMetallicRoughness={"metallicFactor": 0.0, "roughnessFactor": 0.8})
    skins: dict[bytes, Skin] = {}
    for actor in clip.actors:
        kind = kind_of(actor.character)
        skin = skins[kind] = skins.get(kind) or skin_of(actor.character)
        joints = _add_skeleton(gltf, actor)
        _add_body(gltf, actor, skin, joints, look)
        _add_animation(gltf, actor, joints, clip.elapsed)
    return gltf


def _add_skeleton(gltf: Gltf, actor: Actor) -> list[int]:
    """A node for each bone; returns their numbers."""
    skeleton, first = actor.skeleton, len(gltf.tables.get("nodes", []))
    for b, name in enumerate(skeleton.names):
        children = [first + int(k) for k in np.flatnonzero(skeleton.parent == b)] or None
        if b:
            gltf.add("nodes", name=name, translation=_numbers(y_up(skeleton.offset[b])), children=children)
            continue
        place, turn = y_up(actor.bones.root[0]), y_up_xyzw(actor.bones.rotation_wxyz[0, 0])
        gltf.add("nodes", name=actor.name, translation=_numbers(place), rotation=_numbers(turn), children=children)
    return [first + b for b in range(len(skeleton.names))]


def _numbers(values: np.ndarray) -> list[float]:
    return [round(float(value), 9) for value in values]


def _add_body(gltf: Gltf, actor: Actor, skin: Skin, joints: list[int], look: int) -> None:
    """The mesh in its colours, and what carries it."""
    heads = heads_at_rest(actor.skeleton)
    inverse = np.tile(np.eye(4), (len(heads), 1, 1))
    inverse[:, 3, :3] = -y_up(heads)  # columns first, as OpenGL has them
    colour = colours_of_skin(actor.character, skin, actor.colours)
    share = np.round(255 * skin.weight[:, :1])
    carriers, shares = np.zeros((len(share), 4)), np.zeros((len(share), 4))
    shares[:, :1], shares[:, 1:2] = share, 255 - share
    carriers[:, :2] = np.where(shares[:, :2] > 0, skin.bones, 0)
    attributes = {
        "POSITION": gltf.array(y_up(skin.position), "f4", VERTICES),
        "NORMAL": gltf.array(y_up(skin.normal), "f4", VERTICES),
        "COLOR_0": gltf.array(_linear(colour), "u2", VERTICES, normalized=True),
        "JOINTS_0": gltf.array(carriers, "u1", VERTICES),
        "WEIGHTS_0": gltf.array(shares, "u1", VERTICES, normalized=True),
    }  # fmt: skip
    indices = gltf.array(skin.triangles.ravel(), "u2" if len(skin.position) < 65535 else "u4", INDICES)
    mesh = gltf.add("meshes", name=actor.name, primitives=[{"attributes": attributes, "indices": indices, "material": look}])
    carried = gltf.add(
        "skins", name=actor.name, joints=joints, skeleton=joints[0], inverseBindMatrices=gltf.array(inverse, "f4")
    )  # fmt: skip
    gltf.add("nodes", name=f"{actor.name}_body", mesh=mesh, skin=carried)


def _linear(colour: np.ndarray) -> np.ndarray:
    """(V, 4) colours of a screen (V, 3), 0..1, as light and no transparency; 0..65535."""
    return np.round(65535 * np.column_stack([light_of(colour), np.ones(len(colour))]))


def _add_animation(gltf: Gltf, actor: Actor, joints: list[int], elapsed: np.ndarray) -> None:
    """What moves: the root's place, each bone's turn, and the heads of bones at the end of one that stretches.

    Who is not there has no size.
    """
    bones, skeleton = actor.bones, actor.skeleton
    time, samplers, channels = gltf.array(elapsed, "f4"), list[dict](), list[dict]()

    def move(b: int, path: str, values: np.ndarray) -> None:
        samplers.append({"input": time, "output": gltf.array(values, "f4"), "interpolation": "LINEAR"})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": joints[b], "path": path}})

    move(0, "translation", y_up(bones.root))
    for b in range(len(joints)):
        turn = steady(y_up_xyzw(bones.rotation_wxyz[:, b]))
        if b == 0 or np.abs(np.abs(turn) - (0, 0, 0, 1)).max() > LITTLE:
            move(b, "rotation", turn)
        above = skeleton.parent[b]
        more = (bones.stretch[:, above, None] - 1) * skeleton.offset[b] if b else np.zeros(1)
        if np.abs(more).max() > LITTLE:
            move(b, "translation", y_up(skeleton.offset[b] + more))
    if not actor.there.all():
        change = np.flatnonzero(np.diff(actor.there, prepend=~actor.there[0]))  # the moments at which it comes or goes
        size = np.repeat(actor.there[change, None].astype(float), 3, axis=1)
        output, times = gltf.array(size, "f4"), gltf.array(elapsed[change], "f4")
        samplers.append({"input": times, "output": output, "interpolation": "STEP"})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": joints[0], "path": "scale"}})
    gltf.add("animations", name=actor.name, samplers=samplers, channels=channels)


def add_scenery(gltf: Gltf, clip: Clip, cells: int = 150, trees: int = 2000) -> None:
    """The world around, a node for each kind of thing."""
    middle = np.mean([actor.pose.com[:, :2].mean(axis=0) for actor in clip.actors], axis=0)
    look = gltf.add("materials", name="world", pbrMetallicRoughness={"metallicFactor": 0.0, "roughnessFactor": 1.0})
    for name, shape in scenery_of(clip.world, middle, cells, trees).items():
        gltf.add("nodes", name=name, mesh=_mesh(gltf, name, shape, look))


def _mesh(gltf: Gltf, name: str, shape: Shape, look: int) -> int:
    attributes = {
        "POSITION": gltf.array(y_up(shape.position), "f4", VERTICES),
        "NORMAL": gltf.array(y_up(shape.normal), "f4", VERTICES),
        "COLOR_0": gltf.array(_linear(shape.colour), "u2", VERTICES, normalized=True),
    }  # fmt: skip
    indices = gltf.array(shape.triangles.ravel(), "u2" if len(shape.position) < 65535 else "u4", INDICES)
    return gltf.add("meshes", name=name, primitives=[{"attributes": attributes, "indices": indices, "material": look}])
