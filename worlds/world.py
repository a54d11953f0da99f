"""One world type: terrain with trees, rivers and rocks on it, a start and a goal."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from worlds import arrays as grid
from worlds import limits
from worlds.errors import InputError
from worlds.queries import survey

NO_TREES, NO_ROCKS = np.zeros((0, 3)), np.zeros((0, 3 + 1))
TERRAINS = {"flat": grid.FLAT, "hills": grid.HILLS, "stairs": grid.STAIRS, "spiral_stairs": grid.SPIRAL_STAIRS}
TERRAINS |= {"heightmap": grid.HEIGHTMAP}


@dataclass(frozen=True)
class River:
    """Water within width / 2 of a polyline. points (P, 2) [m]."""

    points: np.ndarray
    width: float


@dataclass(frozen=True)
class Wall:
    """A wall along a polyline, as high as a room; a closed one is a building, a door a gap between two. points (P, 2) [m]."""

    points: np.ndarray
    thickness: float


@dataclass(frozen=True)
class World:
    """The ground 0..size[0] by 0..size[1] [m]. Never changes: an edit gives a new world. rocks: (R, 4) x, y, radius, height
    of the flat top above the terrain; trees: (T, 3) x, y, radius; headings in radians.

    Raises InputError for what no world can be (worlds.limits).
    """

    name: str
    size: tuple[float, float]
    terrain: str = "flat"
    terrain_parameters: tuple[float, ...] = ()
    heights: np.ndarray = field(default_factory=lambda: np.zeros((1, 1)))
    trees: np.ndarray = field(default_factory=lambda: NO_TREES)
    rivers: tuple[River, ...] = ()
    walls: tuple[Wall, ...] = ()
    rocks: np.ndarray = field(default_factory=lambda: NO_ROCKS)
    start: tuple[float, float] = (0.0, 0.0)
    start_heading: float = 0.0
    goal: tuple[float, float] | None = None
    goal_radius: float = 1.0

    def __post_init__(self) -> None:
        """Everything checked, and as arrays of the right kind."""
        if not isinstance(self.name, str):
            raise InputError(f"name = {self.name!r}: text is needed")
        checked = {
            "size": limits.sized(self.size),
            "terrain_parameters": limits.parameters(self.terrain, self.terrain_parameters),
            "heights": limits.heights(self.heights),
            "trees": limits.discs(self.trees, "trees", 3),
            "rivers": tuple(_river(river, f"rivers.{k}") for k, river in enumerate(self.rivers)),
            "walls": tuple(_wall(wall, f"walls.{k}") for k, wall in enumerate(self.walls)),
            "rocks": limits.discs(self.rocks, "rocks", 4),
            "start": limits.place(self.start, "start"),
            "start_heading": limits.number(self.start_heading, "start_heading", -1e6, 1e6),
            "goal": None if self.goal is None else limits.place(self.goal, "goal"),
            "goal_radius": limits.number(self.goal_radius, "goal_radius", 1e-6, limits.LONGEST),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)
        limits.counted(len(self._banks()), "rivers")
        limits.counted(len(self._wall_pieces()), "walls")
        for what, boxes in self._boxes().items():
            limits.listed(int(grid.cells_of(boxes, grid.grid_shape(self.size)).sum()), len(boxes), what)

    def _boxes(self) -> dict[str, np.ndarray]:
        """What the grid lists, by its boxes."""
        return {
            "trees": grid.boxes_of_discs(self.trees, grid.REACH),
            "rivers": grid.boxes_of_pieces(self._banks(), grid.REACH),
            "walls": grid.boxes_of_pieces(self._wall_pieces(), grid.REACH),
            "rocks": grid.boxes_of_discs(self.rocks, 0.0),
        }

    @cached_property
    def arrays(self) -> grid.WorldArrays:
        """The world for kernels."""
        shape = grid.grid_shape(self.size)
        parameters = np.zeros(8)
        parameters[: len(self.terrain_parameters)] = self.terrain_parameters
        lists = {what: grid.bucket(boxes, shape) for what, boxes in self._boxes().items()}
        bare = grid.WorldArrays(
            np.array([0.0, 0.0, *self.size]),
            TERRAINS[self.terrain],
            parameters,
            self.heights,
            self.trees,
            self._banks(),
            np.zeros((0, 4)),
            shape[1],
            *lists["trees"],
            *lists["rivers"],
            *grid.bucket(np.zeros((0, 4)), shape),
            self._wall_pieces(),
            *lists["walls"],
        )
        rocks, found = self.rocks.copy(), np.zeros((len(self.rocks), 4))
        if self.terrain != "flat":
            survey(bare, np.ascontiguousarray(rocks[:, :2]), found)
        rocks[:, 3] += found[:, 0]
        start, index = lists["rocks"]
        return bare._replace(rocks=rocks, rock_start=start, rock_index=index)

    def _banks(self) -> np.ndarray:
        return _pieces([(river.points, river.width) for river in self.rivers])

    def _wall_pieces(self) -> np.ndarray:
        return _pieces([(wall.points, wall.thickness) for wall in self.walls])

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

    def to_dict(self, heights: bool = True) -> dict:
        """Everything as plain JSON values; floats round-trip exactly. Without `heights`, a file keeps those as an array."""
        plain = {name: getattr(self, name) for name in self.__dataclass_fields__}
        plain["rivers"] = [{"points": r.points.tolist(), "width": r.width} for r in self.rivers]
        plain["walls"] = [{"points": w.points.tolist(), "thickness": w.thickness} for w in self.walls]
        if not heights:
            plain["heights"] = None
        return {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in plain.items()}

    @classmethod
    def from_dict(cls, plain: dict, heights: np.ndarray | None = None) -> "World":
        """The world that `to_dict` described; heights: those that it left out. Raises InputError naming what is wrong."""
        if not isinstance(plain, dict):
            raise InputError(f"world = {plain!r}: a table is needed")
        known = set(cls.__dataclass_fields__)
        if set(plain) != known:
            raise InputError(f"world: lacks {sorted(known - set(plain))}, does not know {sorted(set(plain) - known)}")
        values = dict(plain)
        for name in ("trees", "rocks", "rivers", "walls", "terrain_parameters"):
            if not isinstance(values[name], list | tuple):
                raise InputError(f"world: {name} = {values[name]!r}: a list is needed")
        if values["heights"] is None:
            values["heights"] = np.zeros((1, 1)) if heights is None else heights
        values["rivers"] = tuple(River(*_plain(r, "width", f"world: rivers.{k}")) for k, r in enumerate(values["rivers"]))
        values["walls"] = tuple(Wall(*_plain(w, "thickness", f"world: walls.{k}")) for k, w in enumerate(values["walls"]))
        return cls(**values)


def _pieces(lines: list[tuple[np.ndarray, float]]) -> np.ndarray:
    """(S, 5) x0, y0, x1, y1, half width [m] of all pieces of polylines (P, 2) with their widths."""
    pieces = [(*a, *b, width / 2) for points, width in lines for a, b in zip(points, points[1:], strict=False)]
    return np.array(pieces, np.float64).reshape(-1, 5)


def _plain(plain: object, width: str, what: str) -> tuple[Any, Any]:
    """The points and the width of a river or a wall, by its key, of plain values. Raises InputError."""
    if not isinstance(plain, dict) or set(plain) != {"points", width}:
        raise InputError(f"{what} = {plain!r}: points and {width} are needed")
    return plain["points"], plain[width]


def _river(river: object, what: str) -> River:
    """A river, checked. Raises InputError."""
    if not isinstance(river, River):
        raise InputError(f"{what} = {river!r}: a worlds.world.River is needed")
    return River(_line(river.points, what), limits.number(river.width, f"{what}.width", 1e-6, limits.LONGEST))


def _wall(wall: object, what: str) -> Wall:
    """A wall, checked. Raises InputError."""
    if not isinstance(wall, Wall):
        raise InputError(f"{what} = {wall!r}: a worlds.world.Wall is needed")
    return Wall(_line(wall.points, what), limits.number(wall.thickness, f"{what}.thickness", 1e-3, limits.LONGEST))


def _line(points: Any, what: str) -> np.ndarray:
    """A polyline (P, 2) [m]. Raises InputError."""
    line = limits.numbers(points, f"{what}.points", 2)
    if len(line) < 2 or np.abs(line).max() > limits.FAR:
        raise InputError(f"{what}.points: two or more are needed, within {limits.FAR:g} m")
    return line
