"""Where one can walk, as polygons: the world within its border, less its walls, for tools of pedestrian dynamics.

Walls are boxes, as they are drawn, and the border is a frame of four more. Of all edges those parts are kept beyond which lies
no box; with the boxes on their left they close to loops. Loops that turn left go around walls; those that turn right are the
rims of places, the largest of which is the world.
"""

from collections import Counter, defaultdict
from typing import NamedTuple

import numpy as np

from worlds.contents.polygons import inside
from worlds.world import World

FRAME = 1.0
"""Width of the frame around the world [m]."""
BESIDE = 1e-5
"""So far beside an edge one looks whether it lies in a box [m]."""
DIGITS, SAME = 6, 1e-5
"""Places of coordinates, and how near two corners are that are one [m]."""

WIDER = (0.0, 1e-4, 3e-4, 1e-3, 2e-3)
"""Where walls touch each other within a hair's breadth they are so much wider [m], until the edges close to loops."""

Loop = list[tuple[float, float]]


class Area(NamedTuple):
    """A place to walk in."""

    rim: Loop  # counter-clockwise
    holes: list[Loop]  # clockwise

    def holds(self, places: np.ndarray) -> int:
        """How many of the places (N, 2) lie in it."""
        rim, *holes = (int(inside(np.array(loop), places).sum()) for loop in (self.rim, *self.holes))
        return rim - sum(holes)

    @property
    def wkt(self) -> str:
        """As well-known text."""
        rings = [", ".join(f"{x:.6g} {y:.6g}" for x, y in [*ring, ring[0]]) for ring in (self.rim, *self.holes)]
        return f"POLYGON ({', '.join(f'({ring})' for ring in rings)})"


def areas(world: World) -> list[Area]:
    """The places of a world that walls part from each other, the largest first."""
    low_x, low_y, high_x, high_y = world.arrays.bounds.tolist()
    frame = [(low_x, low_y, high_x, low_y), (high_x, low_y, high_x, high_y), (high_x, high_y, low_x, high_y)]
    frame.append((low_x, high_y, low_x, low_y))
    beside = [_box(*sides, 0.0, FRAME) for sides in frame]
    pieces: list[list[float]] = world.arrays.walls.tolist()
    for more in WIDER:
        walls = [_box(w[0], w[1], w[2], w[3], w[4] + more, w[4] + more) for w in pieces]
        edges = _edges(np.array(beside + walls).round(DIGITS))
        if Counter(begin for begin, _ in edges) == Counter(end for _, end in edges):
            break
    loops = _loops(edges)
    rims = sorted((loop[::-1] for loop in loops if _size(loop) < 0), key=_size, reverse=True)
    around = [loop for loop in loops if _size(loop) > 0]
    found = [Area(rim, []) for rim in rims]
    for loop in around:
        middle = 0.5 * (np.array(loop[0]) + loop[1])
        within = [area for area in found if inside(np.array(area.rim), middle[None])[0]]
        if within:  # not the frame's own outline
            within[-1].holes.append(loop[::-1])
    return found


def area_of(world: World, places: np.ndarray) -> Area:
    """The one in which most of the places (N, 2) lie."""
    return max(areas(world), key=lambda area: area.holds(places))


def _box(x0: float, y0: float, x1: float, y1: float, left: float, right: float) -> np.ndarray:
    """(4, 2) corners, counter-clockwise, of a piece of a wall that goes on as far beyond its ends as it is wide."""
    a, b = np.array([x0, y0]), np.array([x1, y1])
    along = (b - a) / max(float(np.linalg.norm(b - a)), 1e-9)
    across, on = np.array([-along[1], along[0]]), max(left, right) * along
    return np.array([a - on - right * across, b + on - right * across, b + on + left * across, a - on + left * across])


def _edges(boxes: np.ndarray) -> set[tuple[tuple[float, float], tuple[float, float]]]:
    """What is seen of the edges of boxes (B, 4, 2): begin and end of each part."""
    begin, end = boxes.reshape(-1, 2), np.roll(boxes, -1, axis=1).reshape(-1, 2)
    kept, corner = set(), _Corners()
    for a, b in zip(begin, end, strict=True):
        length = float(np.linalg.norm(b - a))
        if length < 1e-9:
            continue
        cuts = np.unique(np.concatenate([[0.0, 1.0], _crossings(a, b, begin, end)]).round(12))
        places = a + cuts[:, None] * (b - a)
        outward = BESIDE * np.array([b[1] - a[1], a[0] - b[0]]) / length
        hidden = _covered(0.5 * (places[1:] + places[:-1]) + outward, boxes)
        corners = [corner(x, y) for x, y in places.tolist()]
        kept |= {(p, q) for p, q, gone in zip(corners, corners[1:], hidden, strict=False) if not gone and p != q}
    return kept


class _Corners:
    """Corners that are one, whichever edge they were found on."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, int], tuple[float, float]] = {}

    def __call__(self, x: float, y: float) -> tuple[float, float]:
        """The corner within SAME [m] of a place; the place itself, rounded, where there is none."""
        i, j = round(x / SAME), round(y / SAME)
        for key in ((i + a, j + b) for a in (0, -1, 1) for b in (0, -1, 1)):
            if key in self._known:
                return self._known[key]
        self._known[i, j] = round(x, DIGITS), round(y, DIGITS)
        return self._known[i, j]


def _crossings(a: np.ndarray, b: np.ndarray, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Shares of the way from a to b at which edges cross it, or begin or end on it."""
    way, to, edge = b - a, begin - a, end - begin
    length = float(way @ way)
    across = way[0] * edge[:, 1] - way[1] * edge[:, 0]
    beside = to[:, 0] * way[1] - to[:, 1] * way[0]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = (to[:, 0] * edge[:, 1] - to[:, 1] * edge[:, 0]) / across
        of_edge = beside / across
    meets = (np.abs(across) > 1e-12) & (of_edge > -1e-9) & (of_edge < 1 + 1e-9)
    ends = np.concatenate([begin, end]) - a
    on = np.abs(ends[:, 0] * way[1] - ends[:, 1] * way[0]) < 1e-7 * length**0.5
    found = np.concatenate([share[meets], (ends[on] @ way) / length])
    return found[(found > 0) & (found < 1)]


def _covered(points: np.ndarray, boxes: np.ndarray) -> np.ndarray:
    """(N,) bool: which points (N, 2) lie in a box."""
    edge = np.roll(boxes, -1, axis=1) - boxes
    to = points[:, None, None] - boxes
    left = edge[..., 0] * to[..., 1] - edge[..., 1] * to[..., 0] >= 0
    return left.all(axis=2).any(axis=1)


def _loops(edges: set) -> list[Loop]:
    """Edges joined to loops, each without the corners at which it goes straight on; where several part, the leftmost."""
    following = defaultdict(list)
    for p, q in sorted(edges):
        following[p].append(q)
    loops = []
    while following:
        loop = [min(following)]
        while True:
            here = loop[-1]
            choices = following[here]
            goal = max(choices, key=lambda q: _turn(loop[-2], here, q)) if len(loop) > 1 else choices[0]
            choices.remove(goal)
            if not choices:
                del following[here]
            if goal == loop[0] or goal not in following:
                break
            loop.append(goal)
        loops.append(_bent(loop))
    return [loop for loop in loops if len(loop) > 2]


def _turn(a: tuple, b: tuple, c: tuple) -> float:
    """By which angle the way from a by b to c turns left [rad]."""
    before, behind = np.subtract(b, a), np.subtract(c, b)
    return float(np.arctan2(before[0] * behind[1] - before[1] * behind[0], before @ behind))


def _bent(loop: Loop) -> Loop:
    return [b for a, b, c in zip([loop[-1], *loop], loop, [*loop[1:], loop[0]], strict=False) if abs(_turn(a, b, c)) > 1e-6]


def _size(loop: Loop) -> float:
    """Area, positive for those that turn left."""
    x, y = np.array(loop).T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))
