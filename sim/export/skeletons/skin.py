"""The body as drawn, as one mesh that bones carry: a skin.

The view models a body anew for each pose, of capsules around its bones (sim.view.bodies.plans). What carries a capsule is
found by modelling many poses at once: the end of a capsule hangs on the bone in whose axes it stays where it is; one that lies
between, as those of a bent neck, on the two that together come nearest (linear blend skinning, weights by least squares).
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from motion.arithmetic.rotations import axes_of
from motion.characters.character import Character
from motion.motion import placed
from motion.pose.bones import Bones, Placed
from motion.pose.skeleton import Skeleton, skeleton_of
from sim.view.bodies.clay import COLUMNS, Clay
from sim.view.bodies.dress import COLOURS, Dress
from sim.view.bodies.figure import figure_at
from sim.view.bodies.plans import PLANS
from sim.view.scenery.meshes import capsule

POSES, BENT = 24, 0.35
"""So many poses are tried, every bone turned by chance about each axis by this much [rad]."""
EXACT = 1e-5
"""An end that moves by less than this in a bone's axes, in nominal legs, belongs to it."""
RINGS, SIDES = 4, 10


class Skin(NamedTuple):
    """V vertices of a body at rest (motion.pose.skeleton), world axes and metres, each carried by two bones at most."""

    position: np.ndarray  # (V, 3)
    normal: np.ndarray  # (V, 3)
    bones: np.ndarray  # (V, 2) bones of the skeleton
    weight: np.ndarray  # (V, 2) their shares, together 1
    triangles: np.ndarray  # (T, 3)
    capsule: np.ndarray  # (V,) which capsule a vertex is of


class _Modelled(NamedTuple):
    """N capsules of a body in P poses, the first one at rest."""

    ends: np.ndarray  # (N, P, 2, 3)
    radii: np.ndarray  # (N, 2)
    colour: np.ndarray  # (N, 3)


def skin_of(character: Character) -> Skin:
    """The skin of a character's kind."""
    skeleton, unit = skeleton_of(character), float(character.biped.leg.nominal_length)
    at = _poses(skeleton)
    modelled = _model(character, at, {})
    bones, weight = _carriers(modelled.ends, at, unit)
    position, normal, end = _capsules(modelled.ends[:, 0], modelled.radii)
    shape, triangles = capsule(RINGS, SIDES)
    each, count = np.repeat(np.arange(len(modelled.ends)), len(shape)), len(modelled.ends)
    corners = (triangles + len(shape) * np.arange(count)[:, None, None]).reshape(-1, 3)
    return Skin(position, normal, bones[each, end], weight[each, end], corners, each)


def kind_of(character: Character) -> bytes:
    """Characters of which this is the same have one shape."""
    return character.biped.tobytes() + repr(character.look).encode()  # type: ignore[attr-defined]


def heads_at_rest(skeleton: Skeleton) -> np.ndarray:
    """(B, 3) where the bones begin."""
    heads = skeleton.offset.copy()
    for b in range(1, len(heads)):
        heads[b] += heads[skeleton.parent[b]]
    return heads


def colours_of_skin(character: Character, skin: Skin, colours: dict[str, np.ndarray]) -> np.ndarray:
    """(V, 3) what a character wears, red, green, blue in 0..1: its `colours` as sim.view.bodies.dress has them."""
    at = _poses(skeleton_of(character))
    rest = Placed(*(column[:1] for column in at))
    return np.clip(_model(character, rest, colours).colour[skin.capsule], 0, 1)


@cache
def _turns(count: int) -> np.ndarray:
    """(POSES, count, 4) turns by chance, always the same; none in the first pose."""
    chance = np.random.Generator(np.random.Philox(key=1)).uniform(-BENT, BENT, (POSES, count, 3))
    chance[0] = 0.0
    turns = np.concatenate([np.ones((POSES, count, 1)), 0.5 * chance], axis=2)
    return turns / np.linalg.norm(turns, axis=2, keepdims=True)


def _poses(skeleton: Skeleton) -> Placed:
    """The skeleton at rest, and bent by chance."""
    count = len(skeleton.parent)
    root = np.repeat(skeleton.offset[:1], POSES, axis=0)
    return placed(Bones(root, _turns(count).copy(), np.ones((POSES, count))), skeleton)


def _model(character: Character, at: Placed, colours: dict[str, np.ndarray]) -> _Modelled:
    """What the view models around bones in P poses."""
    clay, unit, count = Clay(), float(character.biped.leg.nominal_length), len(at.head)
    worn = {key: np.repeat(colours.get(key, np.array([getattr(character.look, key)])), count, axis=0) for key in COLOURS}
    PLANS[character.look.plan](clay, Dress(character.look, unit, **worn), figure_at(at, skeleton_of(character), unit))
    rows = clay.rows().reshape(-1, count, COLUMNS).astype(float)
    return _Modelled(np.stack([rows[:, :, 0:3], rows[:, :, 4:7]], axis=2), rows[:, 0, [3, 7]], rows[:, 0, 8:11])


def _carriers(ends: np.ndarray, at: Placed, unit: float) -> tuple[np.ndarray, np.ndarray]:
    """Two bones and their weights for each end of N capsules, (N, 2, 2) each, from their ends (N, P, 2, 3) in P poses."""
    rest = ends[:, 0] - np.zeros((1, 1, 3))
    frames = np.stack(axes_of(at.rotation_wxyz.reshape(-1, 4)), axis=2).reshape(*at.rotation_wxyz.shape[:2], 3, 3)
    local = rest[:, :, None] - at.head[0]  # (N, 2, B, 3): at rest, bones have the world's axes
    carried = np.einsum("pbij,nebj->npebi", frames, local) + at.head[None, :, None]
    apart = np.abs(carried - ends[:, :, :, None]).max(axis=(1, 4)) / unit  # (N, 2, B)
    bones, weight = np.zeros((len(ends), 2, 2), int), np.tile([1.0, 0.0], (len(ends), 2, 1))
    together = apart.max(axis=1)
    for n in range(len(ends)):
        if together[n].min() < EXACT:
            bones[n] = _last(together[n])
            continue
        for e in range(2):
            bones[n, e] = _last(apart[n, e])
            if apart[n, e].min() > EXACT:
                bones[n, e], weight[n, e] = _blend(carried[n, :, e], ends[n, :, e])
    return bones, weight


def _last(apart: np.ndarray) -> int:
    """Of bones (B,) the last that is as near as any: a joint's capsule hangs on the bone that begins there."""
    return int(np.flatnonzero(apart <= max(apart.min(), EXACT))[-1])


def _blend(carried: np.ndarray, point: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The two of B bones, and their weights, that come nearest to a point (P, 3); carried: where each takes it (P, B, 3)."""
    one, other = carried[:, :, None], carried[:, None]
    way = one - other
    share = np.einsum("pabi,pabi->ab", point[:, None, None] - other, way) / np.maximum(
        np.einsum("pabi,pabi->ab", way, way), 1e-12
    )
    share = np.clip(share, 0, 1)
    left = (other + share[..., None] * way - point[:, None, None]) ** 2
    a, b = np.unravel_index(left.sum(axis=(0, 3)).argmin(), share.shape)
    return np.array([a, b]), np.array([share[a, b], 1 - share[a, b]])


def _capsules(ends: np.ndarray, radii: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Places and normals (V, 3) of capsules' vertices, and to which end each belongs (V,), as the view's shader has them."""
    shape, _ = capsule(RINGS, SIDES)
    axis = ends[:, 1] - ends[:, 0]
    length = np.linalg.norm(axis, axis=1, keepdims=True)
    w = np.where(length > 1e-6, axis / np.maximum(length, 1e-12), (0.0, 0.0, 1.0))
    u = np.cross(w, np.where(np.abs(w[:, 2:]) < 0.9, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)))
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    normal = np.einsum("vk,nki->nvi", shape[:, :3].astype(float), np.stack([u, np.cross(w, u), w], axis=1))
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    end = shape[:, 3].astype(int)
    position = ends[:, end] + radii[:, end, None] * normal
    return position.reshape(-1, 3), normal.reshape(-1, 3), np.tile(end, len(ends))
