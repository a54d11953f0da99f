"""Geometry of the world: terrain, rocks, trees, water and footprints as triangles (position, normal, colour)."""

import numpy as np

from worlds.queries import terrain_height, tree_clearance, water_clearance
from worlds.world import World

GRASS, MOSS, SAND = np.array([0.47, 0.53, 0.29]), np.array([0.36, 0.44, 0.25]), np.array([0.74, 0.68, 0.48])
BARK, STONE = np.array([0.40, 0.29, 0.20]), np.array([0.56, 0.55, 0.53])
LEAVES = np.array([[0.30, 0.47, 0.20], [0.37, 0.53, 0.22], [0.24, 0.41, 0.22], [0.45, 0.54, 0.22]])
WATER_BELOW = 0.06
"""The water's surface lies this far below the banks [m]."""
SKIRT = 25.0
"""The ground goes on this far beyond the border [m]."""


def capsule(rings: int = 5, sides: int = 10) -> np.ndarray:
    """Triangles (K, 4) of a capsule: unit direction about the axis z, and the share of the way (0 or 1)."""
    latitudes = np.concatenate([np.linspace(-np.pi / 2, 0, rings), np.linspace(0, np.pi / 2, rings)])
    ends = np.concatenate([np.zeros(rings), np.ones(rings)])
    around = np.linspace(0, 2 * np.pi, sides + 1)
    grid = np.array([
        [(np.cos(a) * np.cos(s), np.sin(a) * np.cos(s), np.sin(s), e) for a in around]
        for s, e in zip(latitudes, ends, strict=True)
    ])  # fmt: skip
    return _quads(grid).reshape(-1, 4).astype("f4")


def _quads(grid: np.ndarray) -> np.ndarray:
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    return np.stack([a, b, c, a, c, d], axis=2)


def _triangles(points: np.ndarray, colour: np.ndarray) -> np.ndarray:
    """(K, 9) flat-shaded triangles from (K, 3) points and a colour (3,) or (K, 3)."""
    corners = points.reshape(-1, 3, 3)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True) + 1e-12
    colours = np.broadcast_to(colour, points.shape)
    return np.hstack([points, np.repeat(normals, 3, axis=0), colours])


def ground(world: World, cells: int = 150) -> np.ndarray:
    """The terrain, wide beyond the border, coloured by moss, and by sand along the water; hollowed under it."""
    w = world.arrays
    xs = np.linspace(-SKIRT, world.size[0] + SKIRT, cells)
    ys = np.linspace(-SKIRT, world.size[1] + SKIRT, cells)
    if world.rivers:  # finer, for the banks
        xs, ys = (np.linspace(-SKIRT, size + SKIRT, 2 * cells) for size in world.size)
    xy = np.stack(np.meshgrid(xs, ys), axis=-1)
    height = np.array([terrain_height(w, x, y) for x, y in xy.reshape(-1, 2)]).reshape(xy.shape[:2])
    wet = np.array([water_clearance(w, x, y) for x, y in xy.reshape(-1, 2)]).reshape(xy.shape[:2])
    shade = np.array([tree_clearance(w, x, y) for x, y in xy.reshape(-1, 2)]).reshape(xy.shape[:2])
    height = height - 0.35 * np.clip(-wet / 0.6, 0, 1) * (wet < 0)
    patch = 0.5 + 0.25 * (np.sin(0.9 * xy[..., 0] + 0.5 * xy[..., 1]) + np.sin(1.7 * xy[..., 1] - 0.6 * xy[..., 0]))
    patch = np.clip(patch + 0.5 * np.clip(1 - shade / 1.2, 0, 1), 0, 1)[..., None]
    sandy = np.clip(1 - wet / 0.8, 0, 1)[..., None]
    colours = (GRASS + patch * (MOSS - GRASS)) * (1 - sandy) + sandy * SAND
    points = np.concatenate([xy, height[..., None]], axis=2)
    dy, dx = np.gradient(height, ys, xs)
    normals = np.stack([-dx, -dy, np.ones_like(dx)], axis=2)
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    return _quads(np.concatenate([points, normals, colours], axis=2)).reshape(-1, 9).astype("f4")


def stairs(world: World) -> np.ndarray | None:
    """Sharp treads and risers of a straight flight; other terrains need none."""
    if world.terrain != "stairs":
        return None
    x0, rise, run, count = world.terrain_parameters[:4]
    profile = [(-SKIRT, 0.0), (x0, 0.0)]
    for k in range(int(count)):
        profile += [(x0 + k * run, (k + 1) * rise), (x0 + (k + 1) * run, (k + 1) * rise)]
    profile.append((world.size[0] + SKIRT, profile[-1][1]))
    line = np.array(profile)
    sides = np.array([-SKIRT, world.size[1] + SKIRT])
    grid = np.array([[(x, y, z) for x, z in line] for y in sides])
    return _triangles(_quads(grid).reshape(-1, 3), STONE * 1.15).astype("f4")


def rocks(world: World) -> np.ndarray:
    """Each rock a bevelled drum with a flat top, its outline irregular outside the radius that carries."""
    parts = []
    for x, y, radius, top in world.arrays.rocks:
        rng = np.random.default_rng(int(1000 * x) * 7919 + int(1000 * y) & 0x7FFFFFFF)
        around = np.linspace(0, 2 * np.pi, 14)
        bulge = 1 + 0.10 * rng.random(13)
        bulge = np.append(bulge, bulge[0])
        base = top - 0.75
        rings = [(0.0, top), (1.0, top), (1.07, top - 0.035), (1.2, base)]
        grid = np.array([
            [(x + radius * s * k * np.cos(a), y + radius * s * k * np.sin(a), z) for a, k in zip(around, bulge, strict=True)]
            for s, z in rings
        ])  # fmt: skip
        parts.append(_triangles(_quads(grid[::-1]).reshape(-1, 3), STONE * rng.uniform(0.85, 1.1)))
    return np.vstack(parts).astype("f4") if parts else np.zeros((0, 9), "f4")


def trees(world: World) -> np.ndarray:
    """Each tree a tapered trunk and two or three low crowns, turned and sized by chance."""
    parts = []
    for i, (x, y, radius) in enumerate(world.trees):
        rng = np.random.default_rng(i)
        z = terrain_height(world.arrays, x, y)
        tall = (2.6 + 5.5 * radius) * rng.uniform(0.85, 1.2)
        around = np.linspace(0, 2 * np.pi, 8)
        rings = [(1.25, -0.2), (1.0, 0.25), (0.75, 0.55 * tall), (0.3, 0.9 * tall)]
        grid = np.array([[(x + radius * s * np.cos(a), y + radius * s * np.sin(a), z + h) for a in around] for s, h in rings])
        parts.append(_triangles(_quads(grid).reshape(-1, 3), BARK * rng.uniform(0.85, 1.15)))
        leaf = LEAVES[i % len(LEAVES)] * rng.uniform(0.9, 1.1)
        for share, size in ((0.62, 1.0), (0.85, 0.78), (1.06, 0.5)):
            spread = size * (0.75 + 1.6 * radius) * rng.uniform(0.9, 1.15)
            centre = (x + rng.normal(0, 0.12), y + rng.normal(0, 0.12), z + share * tall)
            parts.append(_triangles(_blob(centre, spread, rng), leaf * (0.85 + 0.25 * share)))
    return np.vstack(parts).astype("f4") if parts else np.zeros((0, 9), "f4")


def _blob(centre, size: float, rng) -> np.ndarray:
    latitudes, around = np.linspace(-np.pi / 2, np.pi / 2, 5), np.linspace(0, 2 * np.pi, 8) + rng.uniform(0, 1)
    radius = size * (1 + 0.14 * rng.normal(size=(5, 7)))
    radius[0], radius[-1] = radius[0, 0], radius[-1, 0]
    radius = np.hstack([radius, radius[:, :1]])
    s, a = np.meshgrid(latitudes, around, indexing="ij")
    grid = np.stack([np.cos(s) * np.cos(a), np.cos(s) * np.sin(a), 0.72 * np.sin(s)], axis=2) * radius[..., None]
    return _quads(grid + np.array(centre)).reshape(-1, 3)


def water(world: World) -> np.ndarray:
    """River ribbons; the normal's x, y hold the direction of the stream."""
    parts = []
    for river in world.rivers:
        points = np.asarray(river.points)
        for a, b in zip(points, points[1:], strict=False):
            along = (b - a) / np.linalg.norm(b - a)
            across = np.array([-along[1], along[0]]) * river.width / 2
            a, b = a - along * 0.25 * river.width, b + along * 0.25 * river.width
            count = max(int(np.linalg.norm(b - a) / 2), 1)
            middle = a + np.linspace(0, 1, count + 1)[:, None] * (b - a)
            level = min(terrain_height(world.arrays, *p) for p in middle) - WATER_BELOW
            grid = np.array([[(*(p - across), level) for p in middle], [(*(p + across), level) for p in middle]])
            flat = _triangles(_quads(grid[::-1]).reshape(-1, 3), np.zeros(3))
            flat[:, 3:5] = along
            parts.append(flat)
    return np.vstack(parts).astype("f4") if parts else np.zeros((0, 9), "f4")


def prints(position: np.ndarray, heading: np.ndarray, normal: np.ndarray, outline: np.ndarray, colour) -> np.ndarray:
    """Footprints on the ground: outline (Q, 3, 2) triangles of one foot [m], for each of N footprints."""
    c, s = np.cos(heading), np.sin(heading)
    forward = np.stack([c, s, -(normal[:, 0] * c + normal[:, 1] * s) / normal[:, 2]], axis=1)
    forward /= np.linalg.norm(forward, axis=1, keepdims=True)
    left = np.cross(normal, forward)
    flat = outline.reshape(-1, 2)
    points = position[:, None] + flat[None, :, :1] * forward[:, None] + flat[None, :, 1:] * left[:, None]
    points = points + 0.006 * normal[:, None]
    out = np.empty((len(position), len(flat), 9))
    out[..., :3], out[..., 3:6], out[..., 6:] = points, normal[:, None], colour
    return out.reshape(-1, 9).astype("f4")
