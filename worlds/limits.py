"""What a world may be: types, ranges and budgets, checked once where a World is made, so that kernels see nothing else."""

from collections.abc import Sequence
from numbers import Real
from typing import Any

import numpy as np

from worlds.errors import InputError

LONGEST = 10_000.0
"""An edge of a world, a width or a radius is at most so long [m]."""
FAR = 100_000.0
"""Nothing lies further from the world's corner than this [m]."""
LARGEST_AREA = 4e6
"""A world has at most so many square metres: its grid, and ways over its land, are laid out in memory."""
MOST_THINGS = 200_000
"""Trees; rocks; pieces of rivers: at most so many of each."""
MOST_LISTED = 8_000_000
"""The grid lists each thing in every cell that it reaches: at most so often in all."""
MOST_HEIGHTS = 4096
"""Heights along an edge of a heightmap."""
HIGHEST = 10_000.0
"""Of a heightmap, either way [m]."""
PARAMETERS: dict[str, tuple[tuple[str, float, float], ...]] = {
    "flat": (),
    "hills": (
        ("amplitude", 0.0, 100.0), ("wavelength", 1e-3, LONGEST),
        ("phase", -1e6, 1e6), ("phase", -1e6, 1e6), ("phase", -1e6, 1e6),
    ),
    "stairs": (("position", -FAR, FAR), ("rise", 1e-6, LONGEST), ("run", 1e-3, LONGEST), ("count", 1, 10_000)),
    "spiral_stairs": (
        ("centre x", -FAR, FAR), ("centre y", -FAR, FAR), ("inner radius", 1e-6, LONGEST), ("outer radius", 1e-6, LONGEST),
        ("rise", 1e-6, LONGEST), ("steps per turn", 3, 1000),
    ),
    "heightmap": (("spacing", 1e-3, LONGEST),),
}  # fmt: skip
"""Names and ranges of a terrain's parameters, in their order (worlds.queries.terrain_height)."""


def numbers(values: Any, what: str, columns: int | None = None) -> np.ndarray:
    """Finite numbers as an array, (N, columns) where those are given. Raises InputError: text and truth are no numbers."""
    try:
        array = np.asarray(values)
    except ValueError:
        raise InputError(f"{what}: an array of numbers is needed") from None
    if array.size == 0:
        array = np.zeros(array.shape if columns is None else (0, columns))
    if array.dtype.kind not in "iuf":
        raise InputError(f"{what}: an array of numbers is needed, not of {array.dtype.name}")
    if columns is not None and (array.ndim != 2 or array.shape[1] != columns):
        raise InputError(f"{what} of shape {array.shape}: (N, {columns}) is needed")
    if not np.isfinite(array).all():
        raise InputError(f"{what}: finite numbers are needed")
    return np.ascontiguousarray(array, np.float64)


def number(value: Any, what: str, low: float, high: float) -> float:
    """A number in a range. Raises InputError."""
    real = isinstance(value, Real) and not isinstance(value, bool | np.bool_)
    if not real or not low <= float(value) <= high:
        raise InputError(f"{what} = {value!r}: a number from {low:g} to {high:g} is needed")
    return float(value)


def place(value: Any, what: str) -> tuple[float, float]:
    """Two coordinates. Raises InputError."""
    if not isinstance(value, (Sequence, np.ndarray)) or isinstance(value, str) or len(value) != 2:
        raise InputError(f"{what} = {value!r}: x and y [m] are needed")
    return number(value[0], f"{what}.x", -FAR, FAR), number(value[1], f"{what}.y", -FAR, FAR)


def sized(value: Any) -> tuple[float, float]:
    """The size of a world. Raises InputError."""
    x, y = place(value, "size")
    size = (number(x, "size.x", 1e-3, LONGEST), number(y, "size.y", 1e-3, LONGEST))
    if size[0] * size[1] > LARGEST_AREA:
        raise InputError(f"size = [{x:g}, {y:g}]: is {x * y:.3g} square metres; at most {LARGEST_AREA:.3g} are allowed")
    return size


def parameters(terrain: Any, values: Sequence[float]) -> tuple[float, ...]:
    """Those of a terrain. Raises InputError where it is none, or they are not its."""
    if not isinstance(terrain, str) or terrain not in PARAMETERS:
        raise InputError(f"terrain = {terrain!r}: {', '.join(PARAMETERS)} are allowed")
    needed = PARAMETERS[terrain]
    if len(values) != len(needed):
        names = ", ".join(name for name, _, _ in needed) or "none"
        raise InputError(f"terrain_parameters = {tuple(values)!r}: {terrain} needs {len(needed)} ({names})")
    found = [number(v, f"terrain_parameters: {name}", low, high) for v, (name, low, high) in zip(values, needed, strict=True)]
    if terrain == "spiral_stairs" and found[2] >= found[3]:
        raise InputError(f"terrain_parameters: the inner radius {found[2]:g} m must be less than the outer one, {found[3]:g} m")
    return tuple(found)


def heights(values: Any) -> np.ndarray:
    """Of a heightmap (ny, nx). Raises InputError."""
    array = numbers(values, "heights")
    if array.ndim != 2 or not 1 <= min(array.shape) <= max(array.shape) <= MOST_HEIGHTS:
        raise InputError(f"heights of shape {array.shape}: (ny, nx), 1 to {MOST_HEIGHTS} each, is needed")
    if np.abs(array).max() > HIGHEST:
        raise InputError(f"heights: up to {np.abs(array).max():g} m; at most {HIGHEST:g} are allowed, either way")
    return array


def discs(values: Any, what: str, columns: int) -> np.ndarray:
    """Trees (x, y, radius) or rocks (and height). Raises InputError."""
    found = numbers(values, what, columns)
    counted(len(found), what)
    low, high = (np.array([limit[:columns]] * 1) for limit in ((-FAR, -FAR, 1e-6, 0.0), (FAR, FAR, LONGEST, 100.0)))
    wrong = np.flatnonzero(((found < low) | (found > high)).any(axis=1))
    if len(wrong):
        allowed = f"radius above 0, at most {LONGEST:g}" + (", height 0 to 100" if columns > 3 else "")
        raise InputError(f"{what}.{wrong[0]} = {found[wrong[0]].tolist()}: within {FAR:g} m, {allowed} m is allowed")
    return found


def counted(count: int, what: str) -> None:
    """Raises InputError where there are too many."""
    if count > MOST_THINGS:
        raise InputError(f"{what}: {count}; at most {MOST_THINGS} are allowed")


def listed(count: int, things: int, what: str) -> None:
    """Raises InputError where things are too large for so many: the grid lists them so often."""
    if count > MOST_LISTED:
        raise InputError(f"{what}: {things} so large ones meet {count} cells of the grid; {MOST_LISTED} at most")
