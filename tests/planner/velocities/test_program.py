"""Half-planes: the nearest point is that of all corners, and the least breach that of a linear program."""

import numpy as np
from scipy.optimize import linprog

from planner.velocities.program import best

RADIUS = 1.3


def some(seed, count, reach):
    """So many half-planes by chance, whose borders are up to so far from the origin; and a wish."""
    r = np.random.Generator(np.random.Philox(key=seed))
    turn, away = r.uniform(0, 2 * np.pi, count), r.uniform(-reach, 0.6, count)
    d = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    return np.hstack([away[:, None] * np.stack([-d[:, 1], d[:, 0]], axis=1), d]), tuple(r.uniform(-1.5, 1.5, 2).tolist())


def worst(planes, point):
    """How far a point lies outside of the half-plane that it is furthest outside of."""
    return float((planes[:, 2] * (planes[:, 1] - point[1]) - planes[:, 3] * (planes[:, 0] - point[0])).max())


def corners(planes, wish):
    """All points that may be the nearest: the wish, its feet on borders and circle, and where those cross."""
    found = [np.array(wish), RADIUS * np.array(wish) / np.hypot(*wish)]
    for k, (px, py, dx, dy) in enumerate(planes):
        p, d = np.array([px, py]), np.array([dx, dy])
        found.append(p + (np.array(wish) - p) @ d * d)
        square = (p @ d) ** 2 + RADIUS**2 - p @ p
        found += [p + (-p @ d + s * np.sqrt(square)) * d for s in (-1, 1) if square >= 0]
        for q in planes[:k]:
            found.append(p + np.linalg.solve(np.stack([d, -q[2:]], axis=1), q[:2] - p)[0] * d)
    return found


def test_the_nearest_is_that_of_all_corners():
    feasible = 0
    for seed in range(300):
        planes, wish = some(seed, 1 + seed % 7, 1.2)
        x, y = best(planes, RADIUS, wish, np.empty_like(planes))
        allowed = [c for c in corners(planes, wish) if np.hypot(*c) <= RADIUS + 1e-9 and worst(planes, c) <= 1e-9]
        assert (worst(planes, (x, y)) < 1e-7) == bool(allowed)
        if allowed:
            least = min(np.hypot(*(c - wish)) for c in allowed)
            assert abs(np.hypot(x - wish[0], y - wish[1]) - least) < 1e-7 and worst(planes, (x, y)) < 1e-7
            feasible += 1
    assert 50 < feasible < 290


def test_where_none_is_left_the_worst_is_breached_least():
    turn, tried = np.linspace(0, 2 * np.pi, 720, endpoint=False), 0
    circle = np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    for seed in range(200):
        planes, wish = some(seed, 3 + seed % 9, 0.5)
        x, y = best(planes, RADIUS, wish, np.empty_like(planes))
        if worst(planes, (x, y)) < 1e-7:
            continue
        outside = np.column_stack([planes[:, 3], -planes[:, 2], -np.ones(len(planes))])  # of (x, y, breach)
        bounds = planes[:, 3] * planes[:, 0] - planes[:, 2] * planes[:, 1]
        least = linprog([0, 0, 1], np.vstack([outside, circle]), [*bounds, *(RADIUS + 0 * turn)], bounds=[(None, None)] * 3)
        assert np.hypot(x, y) < RADIUS + 1e-9 and worst(planes, (x, y)) <= least.fun + 1e-4
        tried += 1
    assert tried > 50
