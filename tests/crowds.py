"""Crowds in places where they get into each other's way, and what must never happen there. For the tests and the bench."""

import numpy as np
from scipy.spatial import cKDTree

from motion.characters.character import load_character
from planner.modes.walk_to import WalkTo
from planner.modes.wander import Wander
from sim.stage.simulation import Simulation
from worlds import queries
from worlds.contents.scatter import Scatter, scattered
from worlds.world import World

EVERY = 2
"""Ticks between two looks: 30 a second."""


def forest(count: int, side: float, character: str = "bird", seed: int = 1) -> Simulation:
    """Wanderers in a forest of a tree per 15 m^2."""
    bare = World("crowded forest", (side, side), start=(side / 2, side / 2))
    world = scattered(bare, Scatter(seed=seed, trees=int(side * side / 15), tree_spacing=1.4, clear=1.0))
    return Simulation(world, [load_character(character)] * count, Wander(), seed)


def streams(count: int, character: str = "bird", gap: float = 3.0, seed: int = 1) -> Simulation:
    """Two streams of `count` characters each, head-on through a gap between two walls of trees."""
    biped = load_character(character).biped
    pitch, rows = 2 * float(biped.body.radius) + 0.5, 4
    columns = -(-count // rows)
    size = (2 * (2 * pitch * columns + 5.0), max(14.0, 2 * pitch * rows + 6))
    middle = size[1] / 2
    trunks = [(size[0] / 2, y, 0.3) for y in np.arange(0.3, middle - gap / 2 - 0.29, 0.4)] + [
        (size[0] / 2, middle - gap / 2 - 0.3, 0.3)
    ]
    trunks += [(x, size[1] - y, r) for x, y, r in trunks]
    column, row = np.divmod(np.arange(count), rows)
    from_gap, aside = 4 + pitch * (columns - 1 - column), pitch * (row - (rows - 1) / 2)
    beyond, apart = 4 + 2 * pitch * column, 2 * aside  # the front goes farthest; there is room between those who have arrived
    begin = np.concatenate([np.stack([-from_gap, aside, 0 * aside], 1), np.stack([from_gap, aside, 0 * aside + np.pi], 1)])
    end = np.concatenate([np.stack([beyond, apart], 1), np.stack([-beyond, apart], 1)])
    begin[:, :2] += size[0] / 2, middle
    lane = np.clip(aside, 2 * biped.body.radius - gap / 2, gap / 2 - 2 * biped.body.radius)
    past = 0.3 * gap + 0.5  # a stop just behind the gap: whoever is shoved aside, or back, would walk at the wall
    gate = np.concatenate([np.stack([0 * lane + past, lane], 1), np.stack([0 * lane - past, lane], 1)])
    stops = np.stack([gate, end], axis=1) + (size[0] / 2, middle)
    world = World("gap", size, trees=np.array(trunks))
    return Simulation(world, [load_character(character)] * (2 * count), WalkTo(begin, stops, near=0.3 * gap), seed)


def ring(count: int, radius: float, character: str = "bird", seed: int = 1) -> Simulation:
    """Everyone on a circle walks to the opposite side."""
    angle = 2 * np.pi * np.arange(count) / count
    side = 2 * radius + 6
    out = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    starts = np.column_stack([side / 2 + out, angle + np.pi])
    world = World("ring", (side, side))
    return Simulation(world, [load_character(character)] * count, WalkTo(starts, (side / 2 - out)[:, None]), seed)


def radius_of(half: np.ndarray, angle: np.ndarray) -> np.ndarray:
    """(K,) radius of ellipses of half axes (K, 2) at an angle off the first axis [m]."""
    return half[:, 0] * half[:, 1] / np.hypot(half[:, 1] * np.cos(angle), half[:, 0] * np.sin(angle))


def lines_apart(p: np.ndarray, u: np.ndarray, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    """(K,) distance of the lines p - u to p + u from q - v to q + v, all (K, 2) [m], by dense samples of one of them."""
    s = np.linspace(-1, 1, 41)[:, None, None]
    points, length2 = p + s * u, np.maximum((v * v).sum(axis=1), 1e-12)
    t = np.clip(((points - q) * v).sum(axis=2) / length2, -1, 1)
    return np.linalg.norm(points - q - t[..., None] * v, axis=2).min(axis=0)


class Watch:
    """Ticks a simulation and keeps the worst that happened."""

    def __init__(self, sim: Simulation) -> None:
        self.sim = sim
        sim.keep_footprints()
        kind = sim.kind
        body, foot = sim.bipeds["body"], sim.bipeds["foot"]
        self.radius = body["radius"][kind]
        whole = [np.where(body[name] > 0, body[name], 2 * body["radius"]) for name in ("depth", "width")]
        self.half = 0.5 * np.stack(whole, axis=1)[kind]
        self.sole = 0.5 * np.stack([foot["length"], foot["width"]], axis=1)[kind]
        self.anchor, self.since = sim.snapshot().com[:, :2], np.zeros(len(kind))
        self.body_overlap, self.standstill, self.stillest = -np.inf, 0.0, -1
        self.arrived = np.full(len(kind), np.nan)

    def run(self, seconds: float) -> "Watch":
        """For so long, or until all have arrived."""
        for _ in range(int(seconds * self.sim.tick_rate)):
            self.sim.tick()
            if self.sim.ticks % EVERY == 0:
                self._look()
            if not np.isnan(self.arrived).any():
                break
        return self

    def _look(self) -> None:
        sim, pose = self.sim, self.sim.snapshot()
        com = pose.com[:, :2]
        pairs = cKDTree(com).query_pairs(2 * self.half.max(), output_type="ndarray")
        if len(pairs):
            i, j = pairs.T
            w, x, y, z = pose.body_rotation_wxyz.T
            yaw = np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
            d = com[j] - com[i]
            radii = sum(radius_of(self.half[k], np.arctan2(d[:, 1], d[:, 0]) - yaw[k]) for k in (i, j))
            share = (radii - np.hypot(*d.T)) / (2 * np.minimum(self.half[i], self.half[j]).min(axis=1))
            self.body_overlap = max(self.body_overlap, float(share.max()))
        if isinstance(sim.planner, WalkTo) and not sim.planner.again:
            there = sim.crowd.standing & (
                np.linalg.norm(com - sim.plans.stops[:, -1], axis=1) < 4 * sim.bipeds["gait"]["preferred_step"][0]
            )
            self.arrived[there & np.isnan(self.arrived)] = sim.time
        moved = np.linalg.norm(com - self.anchor, axis=1) > 0.5 * self.radius
        moved |= ~np.isnan(self.arrived)
        self.anchor[moved], self.since[moved] = com[moved], sim.time
        still = sim.time - self.since
        if still.max() > self.standstill:
            self.standstill, self.stillest = float(still.max()), int(still.argmax())

    def feet_overlaps(self, window: float = 1.0) -> tuple[int, float]:
        """(pairs, worst depth [m]) of soles of two characters that overlap at the same time: capsules."""
        log = self.sim.footprints.arrays(self.sim.crowd)
        who, place = log["footprint_character"], log["footprint_position"][:, :2]
        ahead = np.column_stack([np.cos(log["footprint_heading"]), np.sin(log["footprint_heading"])])
        radius = self.sole.min(axis=1)
        line = (self.sole[:, 0] - radius)[who, None] * ahead
        begin, end = log["footprint_contact_time"], log["footprint_contact_time"] + log["footprint_stance_time"]
        found, worst = set(), 0.0
        for t in np.arange(0.0, self.sim.time, window):
            now = np.flatnonzero((begin < t + window) & (end > t))
            pairs = cKDTree(place[now]).query_pairs(2 * self.sole.max(), output_type="ndarray")
            i, j = now[pairs[:, 0]], now[pairs[:, 1]]
            depth = radius[who[i]] + radius[who[j]] - lines_apart(place[i], line[i], place[j], line[j])
            bad = (who[i] != who[j]) & (np.minimum(end[i], end[j]) > np.maximum(begin[i], begin[j]) + 1e-9) & (depth > 1e-9)
            found |= set(zip(i[bad].tolist(), j[bad].tolist(), strict=True))
            worst = max(worst, float(depth[bad].max(initial=0.0)))
        return len(found), worst

    def tree_clearance(self) -> float:
        """Between a tree and the worst sole, a capsule [m]; below 0 it is in the tree."""
        log, w = self.sim.footprints.arrays(self.sim.crowd), self.sim.world.arrays
        who, radius = log["footprint_character"], self.sole.min(axis=1)
        ahead = np.column_stack([np.cos(log["footprint_heading"]), np.sin(log["footprint_heading"])])
        line = (self.sole[:, 0] - radius)[who, None] * ahead
        along = log["footprint_position"][:, :2] + np.linspace(-1, 1, 9)[:, None, None] * line
        near = np.array([[queries.clearance(w, x, y) for x, y in each] for each in along])
        return float((near - radius[who]).min())

    def figures(self) -> dict[str, float]:
        """All that was measured."""
        pairs, depth = self.feet_overlaps()
        return {
            "seconds": self.sim.time,
            "feet overlaps": pairs,
            "by mm": 1e3 * depth,
            "body overlap % of depth": 100 * self.body_overlap,
            "least clearance m": self.tree_clearance(),
            "longest standstill s": self.standstill,
            "not arrived": int(np.isnan(self.arrived).sum()) if isinstance(self.sim.planner, WalkTo) else 0,
        }
