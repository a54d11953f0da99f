"""Geometry of the world: terrain, rocks and water as triangles (position, normal, colour); what bodies are drawn with."""

import numpy as np

from worlds.queries import survey, terrain_height
from worlds.world import World

GRASS, MOSS, SAND = np.array([0.47, 0.53, 0.29]), np.array([0.36, 0.44, 0.25]), np.array([0.74, 0.68, 0.48])
STONE = np.array([0.56, 0.55, 0.53])
PLASTER = np.array([0.80, 0.76, 0.68])
WALL_CUT = 1.0
"""Walls are drawn up to this height [m]."""
WATER_BELOW = 0.06
"""The water's surface lies this far below the banks [m]."""
APART = 0.004
"""Pieces of a river that meet lie at heights that differ so much [m]: where both are, one of them is seen."""
SKIRT = 25.0
"""The ground goes on this far beyond the border [m]."""


def capsule(rings: int = 5, sides: int = 10) -> tuple[np.ndarray, np.ndarray]:
    """A capsule: vertices (K, 4), unit direction about the axis z and the share of the way (0 or 1); triangles (T, 3)."""
    latitudes = np.concatenate([np.linspace(-np.pi / 2, 0, rings), np.linspace(0, np.pi / 2, rings)])
    ends = np.concatenate([np.zeros(rings), np.ones(rings)])
    around = np.linspace(0, 2 * np.pi, sides + 1)[:-1]
    vertices = [
        (np.cos(a) * np.cos(s), np.sin(a) * np.cos(s), np.sin(s), e)
        for s, e in zip(latitudes[1:-1], ends[1:-1], strict=True)
        for a in around
    ]
    bottom, top = len(vertices), len(vertices) + 1
    index = np.arange(bottom).reshape(2 * rings - 2, sides)
    grid = quads(np.hstack([index, index[:, :1]])).reshape(-1, 3)
    following = np.roll(index, -1, axis=1)
    caps = [np.column_stack([np.full(sides, bottom), following[0], index[0]])]
    caps.append(np.column_stack([np.full(sides, top), index[-1], following[-1]]))
    return np.array([*vertices, (0, 0, -1, 0), (0, 0, 1, 1)], "f4"), np.vstack([grid, *caps])


def lozenge() -> tuple[np.ndarray, np.ndarray]:
    """A flat capsule that is turned to the eye, which looks along y: six corners, whose normals make it look round."""
    lean = -0.7
    corners = [(-1, lean, 0, 0), (1, lean, 0, 0), (1, lean, 0, 1), (-1, lean, 0, 1), (0, lean, -1, 0), (0, lean, 1, 1)]
    return np.array(corners, "f4"), np.array([(0, 1, 2), (0, 2, 3), (4, 1, 0), (3, 2, 5)])


def quads(grid: np.ndarray) -> np.ndarray:
    """Two triangles per cell of a grid (A, B, ...), as (A - 1, B - 1, 6, ...)."""
    a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
    return np.stack([a, b, c, a, c, d], axis=2)


def flat_normals(points: np.ndarray) -> np.ndarray:
    """(K, 3) the normal of its triangle at each of (K, 3) corners."""
    corners = points.reshape(-1, 3, 3)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return np.repeat(normals / (np.linalg.norm(normals, axis=1, keepdims=True) + 1e-12), 3, axis=0)


def _triangles(points: np.ndarray, colour: np.ndarray) -> np.ndarray:
    """(K, 9) flat-shaded triangles from (K, 3) points and a colour (3,) or (K, 3)."""
    return np.hstack([points, flat_normals(points), np.broadcast_to(colour, points.shape)])


def ground(world: World, cells: int = 150) -> tuple[np.ndarray, np.ndarray]:
    """The terrain as vertices (K, 9) and triangles (T, 3)."""
    grid = ground_grid(world, cells)
    index = np.arange(grid.shape[0] * grid.shape[1]).reshape(grid.shape[:2])
    return grid.reshape(-1, 9), quads(index).reshape(-1, 3)


def ground_grid(world: World, cells: int = 150) -> np.ndarray:
    """The terrain, wide beyond the border, coloured by moss, and by sand along the water; hollowed under it.

    Vertices (R, C, 9), rows along y and columns along x.
    """
    xs = np.linspace(-SKIRT, world.size[0] + SKIRT, cells)
    ys = np.linspace(-SKIRT, world.size[1] + SKIRT, cells)
    if world.rivers:  # finer, for the banks
        xs, ys = (np.linspace(-SKIRT, size + SKIRT, 2 * cells) for size in world.size)
    xy = np.stack(np.meshgrid(xs, ys), axis=-1)
    found = np.empty((xy.shape[0] * xy.shape[1], 4))
    survey(world.arrays, np.ascontiguousarray(xy.reshape(-1, 2)), found)
    height, wet, trees, walls = np.moveaxis(found.reshape(*xy.shape[:2], 4), 2, 0)
    shade = np.minimum(trees, walls)
    height = height - 0.35 * np.clip(-wet / 0.6, 0, 1) * (wet < 0)
    x, y = xy[..., 0], xy[..., 1]
    bent = x + 2.3 * np.sin(0.31 * y + 1.1 * np.sin(0.07 * x)), y + 2.7 * np.sin(0.23 * x + 0.9)  # so that no grid shows
    patch = 0.5 + 0.2 * (np.sin(0.9 * bent[0] + 0.5 * bent[1]) + np.sin(1.7 * bent[1] - 0.6 * bent[0]))
    patch += 0.25 * np.sin(0.17 * bent[0] - 0.11 * bent[1] + 1.3) * np.sin(0.09 * bent[0] + 0.19 * bent[1])
    patch = np.clip(patch + 0.5 * np.clip(1 - shade / 1.2, 0, 1), 0, 1)[..., None]
    sandy = np.clip(1 - wet / 0.8, 0, 1)[..., None]
    colours = (GRASS + patch * (MOSS - GRASS)) * (1 - sandy) + sandy * SAND
    points = np.concatenate([xy, height[..., None]], axis=2)
    dy, dx = np.gradient(height, ys, xs)
    normals = np.stack([-dx, -dy, np.ones_like(dx)], axis=2)
    normals /= np.linalg.norm(normals, axis=2, keepdims=True)
    return np.concatenate([points, normals, colours], axis=2).astype("f4")


def stairs(world: World) -> tuple[np.ndarray, np.ndarray]:
    """Sharp treads and risers of a straight flight: vertices (K, 9) and triangles (T, 3)."""
    x0, rise, run, count = world.terrain_parameters[:4]
    profile = [(-SKIRT, 0.0), (x0, 0.0)]
    for k in range(int(count)):
        profile += [(x0 + k * run, (k + 1) * rise), (x0 + (k + 1) * run, (k + 1) * rise)]
    profile.append((world.size[0] + SKIRT, profile[-1][1]))
    line = np.array(profile)
    sides = np.array([-SKIRT, world.size[1] + SKIRT])
    grid = np.array([[(x, y, z) for x, z in line] for y in sides])
    flat = _triangles(quads(grid).reshape(-1, 3), STONE * 1.15).astype("f4")
    return flat, np.arange(len(flat)).reshape(-1, 3)


def spiral_stairs(world: World) -> tuple[np.ndarray, np.ndarray]:
    """Sharp treads, risers and walls of a spiral staircase on a floor: vertices (K, 9) and triangles (T, 3)."""
    x, y, inner, outer, rise, count = world.terrain_parameters[:6]
    low, high = -SKIRT, max(world.size) + SKIRT
    floor = np.array([[(low, low, 0.0), (high, low, 0.0)], [(low, high, 0.0), (high, high, 0.0)]])
    parts = [_triangles(quads(floor).reshape(-1, 3), STONE)]

    def panel(angles: np.ndarray, low: tuple[float, float], high: tuple[float, float]) -> None:
        """A strip from the line (radius, height) low to high, over the angles; seen from where low is right of high."""
        rows = [[(x + r * np.cos(a), y + r * np.sin(a), z) for a in angles] for r, z in (low, high)]
        parts.append(_triangles(quads(np.array(rows)).reshape(-1, 3), STONE * (1.15 if low[1] == high[1] else 0.95)))

    for k in range(1, int(count)):
        angles, z = 2 * np.pi * np.linspace(k, k + 1, 5) / count, k * rise
        panel(angles, (outer, z), (inner, z))
        panel(angles, (outer, 0.0), (outer, z))
        panel(angles, (inner, z), (inner, 0.0))
        for a, heights in ((angles[0], ((k - 1) * rise, z)), (angles[-1], (z, 0.0 if k == count - 1 else z))):
            side = [[(x + r * np.cos(a), y + r * np.sin(a), h) for r in (inner, outer)] for h in heights]
            parts.append(_triangles(quads(np.array(side)).reshape(-1, 3), STONE * 0.8))
    flat = np.vstack(parts).astype("f4")
    return flat, np.arange(len(flat)).reshape(-1, 3)


GROUNDS = {"stairs": stairs, "spiral_stairs": spiral_stairs}
"""Terrains that are not smooth; the others are a `ground`."""


def walls(world: World) -> np.ndarray:
    """Each piece of a wall a box on the ground, cut off at WALL_CUT as in an architect's model, so that one sees over it."""
    parts = []
    for x0, y0, x1, y1, half in world.arrays.walls:
        a, b = np.array([x0, y0]), np.array([x1, y1])
        along = (b - a) / max(np.linalg.norm(b - a), 1e-9)
        across = half * np.array([-along[1], along[0]])
        a, b = a - half * along, b + half * along
        corners = np.array([a - across, b - across, b + across, a + across, a - across])
        ground = [terrain_height(world.arrays, *corner) for corner in corners]
        low, high = min(ground) - 0.1, max(ground) + WALL_CUT
        sides = np.array([[(*corner, z) for corner in corners] for z in (low, high)])
        top = np.array([[(*corners[0], high), (*corners[1], high)], [(*corners[3], high), (*corners[2], high)]])
        parts += [_triangles(quads(sides).reshape(-1, 3), PLASTER), _triangles(quads(top).reshape(-1, 3), 0.8 * PLASTER)]
    return np.vstack(parts).astype("f4") if parts else np.zeros((0, 9), "f4")


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
        parts.append(_triangles(quads(grid[::-1]).reshape(-1, 3), STONE * rng.uniform(0.85, 1.1)))
    return np.vstack(parts).astype("f4") if parts else np.zeros((0, 9), "f4")


def blob(centre: object, size: float, rng: np.random.Generator, fine: bool = True) -> np.ndarray:
    """(K, 3) triangles of a lump, irregular by chance, flatter than a ball."""
    rings, sides = (5, 7) if fine else (4, 5)
    latitudes, around = np.linspace(-np.pi / 2, np.pi / 2, rings), np.linspace(0, 2 * np.pi, sides + 1) + rng.uniform(0, 1)
    radius = size * (1 + (0.14 if fine else 0.08) * rng.normal(size=(rings, sides)))
    radius[0], radius[-1] = radius[0, 0], radius[-1, 0]
    radius = np.hstack([radius, radius[:, :1]])
    s, a = np.meshgrid(latitudes, around, indexing="ij")
    grid = np.stack([np.cos(s) * np.cos(a), np.cos(s) * np.sin(a), 0.72 * np.sin(s)], axis=2) * radius[..., None]
    corners = quads(grid + np.array(centre)).reshape(-1, 3, 3)
    flat = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) < 1e-9
    return corners[~flat].reshape(-1, 3)


def water(world: World) -> np.ndarray:
    """River ribbons; the normal's x, y hold the direction of the stream."""
    parts = []
    for river in world.rivers:
        points = np.asarray(river.points)
        for k, (a, b) in enumerate(zip(points, points[1:], strict=False)):
            along = (b - a) / np.linalg.norm(b - a)
            across = np.array([-along[1], along[0]]) * river.width / 2
            a, b = a - along * 0.25 * river.width, b + along * 0.25 * river.width
            count = max(int(np.linalg.norm(b - a) / 2), 1)
            middle = a + np.linspace(0, 1, count + 1)[:, None] * (b - a)
            level = min(terrain_height(world.arrays, *p) for p in middle) - WATER_BELOW - APART * (k % 2)
            grid = np.array([[(*(p - across), level) for p in middle], [(*(p + across), level) for p in middle]])
            flat = _triangles(quads(grid[::-1]).reshape(-1, 3), np.zeros(3))
            flat[:, 3:5] = along
            parts.append(flat)
    return np.vstack(parts).astype("f4") if parts else np.zeros((0, 9), "f4")
