"""Trajectories that people have annotated in films, as forecasters of trajectories hand them around.

- Frames: frame, id, x, y, and perhaps velocities, without a header, rows by frames (A. Gupta et al., Social GAN, CVPR 2018, of
  ETH and UCY). Such a table looks as a plain one of id, t, x, y does; who takes the one for the other sees people leap.
- Splines (.vsp, A. Lerner et al., Crowds by Example, 2007, UCY): `N - the number of splines`, and of each `K - Num of control
  points` and K lines x, y, frame, gaze; what begins with ` - ` is a comment. Places are pixels of the film, and a homography
  (3, 3) makes metres of them: [u, v, w] = H [x, y, 1], place (u / w, v / w).
"""

import numpy as np

from sim.files.imports import texts
from sim.files.imports.trajectories import formats
from sim.files.imports.trajectories.ways import MOST_PEOPLE, MOST_ROWS, Way, ways_of
from worlds.errors import InputError

LOOKED_AT = 2000
"""Rows from which one tells what the first two columns are."""


def looks_like_frames(rows: list[list[str]]) -> bool:
    """Whether the first two columns are frame and identity, not identity and time: as the latter people would leap more."""
    if not rows or len(rows[0]) not in (4, 6) or any(len(row) < 4 for row in rows[:LOOKED_AT]):
        return False
    values = [[texts.number(word) for word in row[:4]] for row in rows[:LOOKED_AT]]
    if any(value is None for row in values for value in row):
        return False
    found = np.array(values, np.float64)
    if (found[:, :2] != np.round(found[:, :2])).any():
        return False
    return _leap(found[:, 1], found[:, 0], found[:, 2:]) < _leap(found[:, 0], found[:, 1], found[:, 2:])


def _leap(who: np.ndarray, when: np.ndarray, place: np.ndarray) -> float:
    """The mean way between two moments of one person [m]; infinite where nobody is seen twice, or somebody twice at once."""
    order = np.lexsort((when, who))
    same, later = np.diff(who[order]) == 0, np.diff(when[order]) > 0
    if not same.any() or (same & ~later).any():
        return float("inf")
    return float(np.hypot(*np.diff(place[order], axis=0).T)[same].mean())


def read_splines(text: str, fps: float | None, homography: np.ndarray | None) -> list[Way]:
    """Ways of a .vsp; straight between control points. Raises InputError naming the line of a fault."""
    if homography is None:
        raise InputError(
            "a .vsp holds pixels: give --homography H.txt, nine numbers that make metres of them (s 0 0, 0 s 0, 0 0 1 where a "
            "pixel is s metres)"
        )
    lines = [(k, line.split(" - ")[0].split()) for k, line in enumerate(text.splitlines(), 1)]
    lines = [(k, words) for k, words in lines if words]
    names, found, at = list[str](), list[list[float]](), 1
    for person in range(_count(lines, 0, MOST_PEOPLE, "of splines")):
        points = _count(lines, at, MOST_ROWS - len(found), "of control points")
        for place in range(at + 1, at + 1 + points):
            found.append(_control_point(lines, place))
        names += [str(person + 1)] * points
        at += 1 + points
    if not found:
        raise InputError("nobody is in it")
    values = np.array(found)
    kept = np.ones(len(values), bool)  # a control point set twice at one frame is one
    kept[1:] = (np.diff(values[:, 2]) != 0) | (np.array(names[1:]) != np.array(names[:-1]))
    placed = _in_metres(values[kept, :2], homography)
    return ways_of(
        [name for name, keep in zip(names, kept, strict=True) if keep], values[kept, 2] / (fps or formats.FILM), placed
    )


def _count(lines: list[tuple[int, list[str]]], at: int, most: int, what: str) -> int:
    """A number that stands alone in its line."""
    if at >= len(lines):
        raise InputError(f"ends where a number {what} is needed")
    k, words = lines[at]
    value = texts.number(words[0]) if len(words) == 1 else None
    if value is None or value != int(value) or not 0 <= value <= most:
        raise InputError(f"line {k}: {' '.join(words)[:60]!r}: a number {what}, 0 to {most:,}, is needed")
    return int(value)


def _control_point(lines: list[tuple[int, list[str]]], at: int) -> list[float]:
    """x, y, frame."""
    if at >= len(lines):
        raise InputError("ends amid the control points of a spline")
    k, words = lines[at]
    values = [texts.number(word) for word in words[:3]]
    if len(words) < 3 or None in values:
        raise InputError(f"line {k}: {' '.join(words)[:60]!r}: x, y, frame are needed")
    return [value for value in values if value is not None]


def _in_metres(pixels: np.ndarray, homography: np.ndarray) -> np.ndarray:
    seen = np.column_stack([pixels, np.ones(len(pixels))]) @ homography.T
    if not (np.abs(seen[:, 2]) > 1e-9).all():
        raise InputError("the homography sends a place of the film to infinity: is it one of this film?")
    return seen[:, :2] / seen[:, 2:]


def read_homography(path: str) -> np.ndarray:
    """(3, 3) of a file of nine numbers. Raises InputError."""
    words = texts.text_of(path, "a homography", 10_000).replace(",", " ").split()
    values = [texts.number(word) for word in words]
    if len(values) != 9 or None in values:
        raise InputError(f"{path}: {len(words)} words; a homography is nine numbers, row by row")
    found = np.array(values, np.float64).reshape(3, 3)
    if abs(np.linalg.det(found)) < 1e-12:
        raise InputError(f"{path}: this homography sends everything to one line: its determinant is 0")
    return found
