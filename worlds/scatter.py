"""Seeded trees and rocks: chance places that keep off each other, the water, the start and the goal."""

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from worlds.queries import water_clearance
from worlds.world import World

TRIES = 30
"""Places tried for each thing before it is left out."""
Size = Annotated[float, Field(gt=0, le=1000, allow_inf_nan=False)]
Room = Annotated[float, Field(ge=0, le=1000, allow_inf_nan=False)]
Count = Annotated[int, Field(ge=0, le=100_000)]


class Scatter(BaseModel):
    """The [scatter] table of a level file; lengths in metres."""

    model_config = ConfigDict(extra="forbid")
    seed: Annotated[int, Field(ge=0)] = 0
    trees: Count = 0
    tree_radius: tuple[Size, Size] = (0.2, 0.45)
    tree_spacing: Room = 2.2  # between trunks
    rocks: Count = 0
    rock_radius: tuple[Size, Size] = (0.4, 0.8)
    rock_height: tuple[Room, Room] = (0.1, 0.3)
    rock_spacing: Room = 0.3
    clear: Room = 3.0  # around start and goal


def scattered(world: World, scatter: Scatter) -> World:
    """The world with the scattered things added; counter-based, so the same on every machine."""
    rng = np.random.Generator(np.random.Philox(key=scatter.seed))
    trees = _Discs(scatter.trees, scatter.tree_radius, scatter.tree_spacing, scatter.clear).places(world, rng, world.trees)
    rocks = _Discs(scatter.rocks, scatter.rock_radius, scatter.rock_spacing, scatter.clear).places(world, rng, world.rocks)
    heights = rng.uniform(*scatter.rock_height, len(rocks))
    return replace(
        world,
        trees=np.vstack([world.trees, trees]),
        rocks=np.vstack([world.rocks, np.column_stack([rocks, heights]).reshape(-1, 4)]),
    )


@dataclass(frozen=True)
class _Discs:
    """What is scattered; metres."""

    count: int
    radius: tuple[float, float]  # least and largest
    spacing: float  # between any two
    clear: float  # around start and goal

    def places(self, world: World, rng: np.random.Generator, present: np.ndarray) -> np.ndarray:
        """(K, 3) x, y, radius, K <= count, each `spacing` from the others and those present, dry, and off start and goal."""
        discs = [tuple(row[:3]) for row in present]
        found = len(discs)
        keep_off = [(*place, 0.0) for place in (world.start, world.goal) if place]
        for _ in range(self.count):
            for _ in range(TRIES):
                x, y = rng.uniform((0, 0), world.size)
                r = rng.uniform(*self.radius)
                if _fits(discs, x, y, r + self.spacing) and _fits(keep_off, x, y, r + self.clear):
                    if water_clearance(world.arrays, x, y) > r + 0.5:
                        discs.append((x, y, r))
                        break
        return np.array(discs[found:], np.float64).reshape(-1, 3)


def _fits(discs: list, x: float, y: float, room: float) -> bool:
    if not discs:
        return True
    d = np.array(discs)
    return bool((np.hypot(d[:, 0] - x, d[:, 1] - y) >= d[:, 2] + room).all())
