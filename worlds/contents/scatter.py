"""Seeded trees and rocks: chance places that keep off each other, the water, the start and the goal."""

from collections.abc import Generator, Iterator
from dataclasses import dataclass, replace
from itertools import product
from math import floor, hypot
from typing import Annotated

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from worlds.queries import REACH, survey
from worlds.world import World

TRIES = 30
"""Places tried for each thing before it is left out."""
Size = Annotated[float, Field(gt=0, le=1000, allow_inf_nan=False, strict=True)]
Room = Annotated[float, Field(ge=0, le=1000, allow_inf_nan=False, strict=True)]
Count = Annotated[int, Field(ge=0, le=100_000, strict=True)]


class Scatter(BaseModel):
    """The [scatter] table of a level file; lengths in metres."""

    model_config = ConfigDict(extra="forbid")
    seed: Annotated[int, Field(ge=0, le=2**63 - 1, strict=True)] = 0
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
    chance = _Chance(scatter.seed)
    trees = _Discs(scatter.trees, scatter.tree_radius, scatter.tree_spacing, scatter.clear).places(world, chance, world.trees)
    rocks = _Discs(scatter.rocks, scatter.rock_radius, scatter.rock_spacing, scatter.clear).places(world, chance, world.rocks)
    low, high = scatter.rock_height
    heights = low + (high - low) * chance.look(len(rocks))
    return replace(
        world,
        trees=np.vstack([world.trees, trees]),
        rocks=np.vstack([world.rocks, np.column_stack([rocks, heights]).reshape(-1, 4)]),
    )


class _Chance:
    """A stream of numbers in [0, 1), looked at in blocks, of which no more is gone than was used."""

    def __init__(self, seed: int) -> None:
        self._rng = np.random.Generator(np.random.Philox(key=seed))
        self._ahead = np.zeros(0)

    def look(self, count: int) -> np.ndarray:
        """The next so many, which are not gone yet."""
        if len(self._ahead) < count:
            self._ahead = np.concatenate([self._ahead, self._rng.random(count - len(self._ahead))])
        return self._ahead[:count]

    def use(self, count: int) -> None:
        """So many of them are gone."""
        self._ahead = self._ahead[count:]


@dataclass(frozen=True)
class _Discs:
    """What is scattered; metres."""

    count: int
    radius: tuple[float, float]  # least and largest
    spacing: float  # between any two
    clear: float  # around start and goal

    def places(self, world: World, chance: _Chance, present: np.ndarray) -> np.ndarray:
        """(K, 3) x, y, radius, K <= count, each `spacing` from the others and those present, dry, and off start and goal."""
        cell = max(2 * min(self.radius) + self.spacing, 0.5 * (world.size[0] * world.size[1] / max(self.count, 1)) ** 0.5)
        taken, found = _Taken(cell, self.spacing), []
        for x, y, r in present[:, :3].tolist():
            taken.add(x, y, r)
        keep_off = [place for place in (world.start, world.goal) if place]
        tries = self._tries(world, chance)
        for _ in range(self.count):
            for _ in range(TRIES):
                x, y, r, water = next(tries)
                far = all(hypot(x - u, y - v) >= r + self.clear for u, v in keep_off)
                if far and water > r + 0.5 and taken.leaves(x, y, r):
                    taken.add(x, y, r)
                    found.append((x, y, r))
                    break
        tries.close()
        return np.array(found, np.float64).reshape(-1, 3)

    def _tries(self, world: World, chance: _Chance) -> Generator[tuple[float, float, float, float]]:
        """Chance's places and radii, each with its distance to water and walls, without end."""
        low, high = self.radius
        block, used = 3 * min(max(2 * self.count, 16), 4096), 0
        try:
            while True:
                u = chance.look(block).reshape(-1, 3)
                xy = np.ascontiguousarray(u[:, :2] * world.size)
                found = np.full((len(xy), 4), REACH)
                if len(world.arrays.banks) or len(world.arrays.walls):
                    survey(world.arrays, xy, found)
                columns = (*xy.T, low + (high - low) * u[:, 2], found[:, [1, 3]].min(axis=1))
                rows = zip(*(column.tolist() for column in columns), strict=True)
                for used, row in enumerate(rows, 1):  # noqa: B007
                    yield row
                chance.use(block)
                used = 0
        finally:
            chance.use(3 * used)


class _Taken:
    """Discs by the cells of a grid that they reach with their spacing."""

    def __init__(self, cell: float, spacing: float) -> None:
        self.cell, self.spacing = cell, spacing
        self.discs: dict[tuple[int, int], list[tuple[float, float, float]]] = {}

    def _cells(self, x: float, y: float, reach: float) -> Iterator[tuple[int, int]]:
        columns = range(floor((x - reach) / self.cell), floor((x + reach) / self.cell) + 1)
        rows = range(floor((y - reach) / self.cell), floor((y + reach) / self.cell) + 1)
        return product(columns, rows)

    def add(self, x: float, y: float, r: float) -> None:
        """One more."""
        for cell in self._cells(x, y, r + self.spacing):
            self.discs.setdefault(cell, []).append((x, y, r))

    def leaves(self, x: float, y: float, r: float) -> bool:
        """Whether there is room for another one, spacing and all."""
        room = r + self.spacing
        near = (disc for cell in self._cells(x, y, r) for disc in self.discs.get(cell, ()))
        return all(hypot(x - u, y - v) >= s + room for u, v, s in near)
