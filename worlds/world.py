"""One world type: terrain with trees, rivers and rocks on it, a start and a goal."""

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from worlds import arrays as grid
from worlds.queries import terrain_height

NO_TREES, NO_ROCKS = np.zeros((0, 3)), np.zeros((0, 3 + 1))
TERRAINS = {"flat": grid.FLAT, "hills": grid.HILLS, "stairs": grid.STAIRS, "spiral_stairs": grid.SPIRAL_STAIRS}
TERRAINS |= {"heightmap": grid.HEIGHTMAP}


@dataclass(frozen=True)
class River:
    """Water within width / 2 of a polyline. points (P, 2) [m]."""

    points: np.ndarray
    width: float


@dataclass(frozen=True)
class World:
    """The ground 0..size[0] by 0..size[1] [m]. Never changes: an edit gives a new world. rocks: (R, 4) x, y, radius, height
    of the flat top above the terrain; trees: (T, 3) x, y, radius; headings in radians."""

    name: str
    size: tuple[float, float]
    terrain: str = "flat"
    terrain_parameters: tuple[float, ...] = ()
    heights: np.ndarray = field(default_factory=lambda: np.zeros((1, 1)))
    trees: np.ndarray = field(default_factory=lambda: NO_TREES)
    rivers: tuple[River, ...] = ()
    rocks: np.ndarray = field(default_factory=lambda: NO_ROCKS)
    start: tuple[float, float] = (0.0, 0.0)
    start_heading: float = 0.0
    goal: tuple[float, float] | None = None
    goal_radius: float = 1.0

    @cached_property
    def arrays(self) -> grid.WorldArrays:
        """The world for kernels."""
        shape = grid.grid_shape(self.size)
        banks = self._banks()
        trees = np.ascontiguousarray(self.trees, np.float64).reshape(-1, 3)
        parameters = np.zeros(8)
        parameters[: len(self.terrain_parameters)] = self.terrain_parameters
        tree_lists = grid.bucket(grid.boxes_of_discs(trees, grid.REACH), shape)
        bank_lists = grid.bucket(grid.boxes_of_banks(banks, grid.REACH), shape)
        bare = grid.WorldArrays(
            np.array([0.0, 0.0, *self.size]),
            TERRAINS[self.terrain],
            parameters,
            np.ascontiguousarray(self.heights, np.float64),
            trees,
            banks,
            np.zeros((0, 4)),
            shape[1],
            *tree_lists,
            *bank_lists,
            *grid.bucket(np.zeros((0, 4)), shape),
        )
        rocks = np.array(self.rocks, np.float64).reshape(-1, 4)
        rocks[:, 3] += [terrain_height(bare, x, y) for x, y in rocks[:, :2]]
        start, index = grid.bucket(grid.boxes_of_discs(rocks, 0.0), shape)
        return bare._replace(rocks=rocks, rock_start=start, rock_index=index)

    def _banks(self) -> np.ndarray:
        pieces = [
            (*a, *b, river.width / 2) for river in self.rivers for a, b in zip(river.points, river.points[1:], strict=False)
        ]
        return np.array(pieces, np.float64).reshape(-1, 5)

    def with_tree(self, x: float, y: float, radius: float) -> "World":
        """This world with one more tree."""
        return replace(self, trees=np.vstack([self.trees, [x, y, radius]]))

    def without_tree(self, index: int) -> "World":
        """This world without tree `index`."""
        return replace(self, trees=np.delete(self.trees, index, axis=0))

    def with_rock(self, x: float, y: float, radius: float, height: float) -> "World":
        """This world with one more rock."""
        return replace(self, rocks=np.vstack([self.rocks, [x, y, radius, height]]))

    def without_rock(self, index: int) -> "World":
        """This world without rock `index`."""
        return replace(self, rocks=np.delete(self.rocks, index, axis=0))

    def with_goal(self, x: float, y: float) -> "World":
        """This world with the goal elsewhere."""
        return replace(self, goal=(x, y))

    def to_dict(self) -> dict:
        """Everything as plain JSON values; floats round-trip exactly."""
        plain = {name: getattr(self, name) for name in self.__dataclass_fields__}
        plain["rivers"] = [{"points": np.asarray(r.points).tolist(), "width": r.width} for r in self.rivers]
        return {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in plain.items()}

    @classmethod
    def from_dict(cls, plain: dict) -> "World":
        """The world that `to_dict` described."""
        values = dict(plain)
        for name, columns in (("trees", 3), ("rocks", 4)):
            values[name] = np.array(values[name], np.float64).reshape(-1, columns)
        values["heights"] = np.array(values["heights"], np.float64)
        values["rivers"] = tuple(River(np.array(r["points"]), r["width"]) for r in values["rivers"])
        for name in ("size", "start", "goal", "terrain_parameters"):
            values[name] = tuple(values[name]) if values[name] is not None else None
        return cls(**values)
