"""Trajectories as text: of JuPedSim and PedPy, Vadere, ETH and UCY, and plain tables (`formats`)."""

import re
from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from sim.files.imports import texts
from sim.files.imports.trajectories import formats
from sim.files.imports.trajectories.annotated import looks_like_frames
from sim.files.imports.trajectories.ways import MOST_ROWS, Way, ways_of
from worlds.errors import InputError


class Lines(NamedTuple):
    """A text as comments and rows of words, each row with its line's number."""

    comments: list[str]
    rows: list[list[str]]
    number: list[int]


def split(text: str) -> Lines:
    """Comments behind `#`, and words parted by commas, semicolons, tabs or spaces. Raises InputError."""
    comments, rows, number = [], [], []
    for k, line in enumerate(text.splitlines(), 1):
        line = line.strip()
        if line.startswith("#"):
            comments.append(line)
        elif line:
            parts = re.split(r"\s*[,;]\s*", line) if "," in line or ";" in line else line.split()
            rows.append(parts)
            number.append(k)
        if len(rows) > MOST_ROWS:
            raise InputError(f"more than {MOST_ROWS:,} rows; take fewer people, or fewer frames a second")
    return Lines(comments, rows, number)


def format_of(name: str, lines: Lines) -> str:
    """Which format a text is of, by its name and by how it begins."""
    first = lines.rows[0] if lines.rows else []
    if any(word.startswith(formats.FOOTSTEP[0]) for word in first):
        return formats.VADERE
    if any(formats.RATE in comment.lower() or "x/" in comment.lower() for comment in lines.comments):
        return formats.TEXT
    numbers = all(texts.number(word) is not None for word in first)
    if "obsmat" in name.lower() or (numbers and len(first) == 8):
        return formats.OBSMAT
    return formats.FRAMES if looks_like_frames(lines.rows) else formats.PLAIN


def read_table(kind: str, lines: Lines, fps: float | None) -> list[Way]:
    """The ways of a text of a format. Raises InputError naming every fault by its line."""
    if not lines.rows:
        raise InputError("has no rows")
    readers = {formats.TEXT: _text, formats.VADERE: _vadere, formats.PLAIN: _plain}
    readers |= {formats.OBSMAT: partial(_annotated, formats.OBSERVED), formats.FRAMES: partial(_annotated, formats.FRAMED)}
    return readers[kind](lines, fps)


def _numbers(lines: Lines, columns: Sequence[int], named: bool = True) -> tuple[list[str], np.ndarray]:
    """The first of the columns as names, the others as numbers (n, k - 1). Raises InputError."""
    faults, names, found, most = list[str](), list[str](), [], max(columns)
    for row, number in zip(lines.rows, lines.number, strict=True):
        values = [texts.number(row[k]) for k in columns[1:]] if len(row) > most else [None]
        if None in values or not (row[columns[0]] if named else True):
            faults.append(f"line {number}: {' '.join(row)[:60]!r}: {most + 1} columns of numbers are needed")
            if len(faults) > texts.SAID:
                break
            continue
        names.append(_name(row[columns[0]]))
        found.append(values)
    if faults:
        more = ["and perhaps more"] if len(faults) > texts.SAID else []
        raise InputError("\n".join([*faults[: texts.SAID], *more]))
    return names, np.array(found, np.float64).reshape(len(names), len(columns) - 1)


def _name(word: str) -> str:
    """An identity; 3.0000000e+00 is 3."""
    value = texts.number(word)
    return str(int(value)) if value is not None and value == int(value) else word[:100]


def _frames(lines: Lines, columns: Sequence[int], fps: float, unit: float = 1.0) -> list[Way]:
    names, found = _numbers(lines, columns)
    return ways_of(names, found[:, 0] / fps, found[:, 1:3] * unit)


def _text(lines: Lines, fps: float | None) -> list[Way]:
    rate = next((m for one in lines.comments if (m := re.search(rf"{formats.RATE}\D*([0-9.]+)", one, re.IGNORECASE))), None)
    found = fps or (texts.number(rate[1].rstrip(".")) if rate else None)
    if not found or not 0 < found <= 10_000:
        raise InputError(f"says no `# {formats.RATE}: FPS` between 0 and 10000; give --fps")
    said = " ".join(lines.comments).lower()
    return _frames(lines, (0, 1, 2, 3), found, 0.01 if any(unit in said for unit in formats.CENTIMETRES) else 1.0)


def _annotated(columns: Sequence[int], lines: Lines, fps: float | None) -> list[Way]:
    names, found = _numbers(lines, columns)
    if fps is None:  # frames are counted as the film's; those that were annotated come ANNOTATED times a second
        steps = np.diff(np.unique(found[:, 0]))
        fps = formats.ANNOTATED * float(np.median(steps)) if len(steps) else formats.ANNOTATED
    return ways_of(names, found[:, 0] / fps, found[:, 1:3])


def _plain(lines: Lines, fps: float | None) -> list[Way]:
    header = [word.strip('"').lower() for word in lines.rows[0]]
    if all(texts.number(word) is not None for word in header[1:4]) and len(header) >= 4:
        columns: Sequence[int] = (0, 1, 2, 3)
    else:
        at = {name: header.index(name) for name in formats.COLUMNS if name in header}
        if time := next((name for name in formats.TIMES if name in header), None):
            at["t"] = header.index(time)
        if missing := [name for name in formats.COLUMNS if name not in at]:
            raise InputError(f"line {lines.number[0]}: columns {', '.join(header)[:80]}: {', '.join(missing)} missing")
        columns = [at[name] for name in formats.COLUMNS]
        lines = Lines(lines.comments, lines.rows[1:], lines.number[1:])
    names, found = _numbers(lines, columns)
    return ways_of(names, found[:, 0] / (fps or 1.0), found[:, 1:3])


def _vadere(lines: Lines, fps: float | None) -> list[Way]:
    """Footsteps; where a file has but starts, places."""
    header, rest = lines.rows[0], Lines(lines.comments, lines.rows[1:], lines.number[1:])
    at = {name: [k for k, word in enumerate(header) if word.split("-")[0] == name] for name in formats.FOOTSTEP}
    lacking = [name for name in formats.PLACE_OF_FOOTSTEP if len(at[name]) != 1]
    if lacking:
        raise InputError(f"line {lines.number[0]}: one column each of {', '.join(lacking)} is needed")
    if not all(at[name] for name in formats.FOOTSTEP):
        names, found = _numbers(rest, [at[name][0] for name in formats.PLACE_OF_FOOTSTEP])
        return ways_of(names, found[:, 0], found[:, 1:3])
    names, found = _numbers(rest, [at[name][0] for name in formats.FOOTSTEP])
    if (wrong := np.flatnonzero(found[:, 1] < found[:, 0])).size:
        raise InputError(f"line {rest.number[wrong[0]]}: a footstep that ends before it begins")
    return _footsteps(names, found)


def _footsteps(names: list[str], found: np.ndarray) -> list[Way]:
    """Ways of rows (n, 6): simTime, endTime, start, end. Who waits before a step is where the step begins until then."""
    begins, ends = found[:, [0, 2, 3]], found[:, [1, 4, 5]]
    moves = np.hypot(*(ends - begins)[:, 1:].T) > 1e-6
    rows: dict[tuple[str, float], tuple[float, float, bool]] = {}
    for name, begin, end, step in zip(names, begins.tolist(), ends.tolist(), moves.tolist(), strict=True):
        rows.setdefault((name, begin[0]), (begin[1], begin[2], False))
        known = rows.get((name, end[0]))
        rows[name, end[0]] = (end[1], end[2], step or bool(known and known[2]))
    values = np.array(list(rows.values()))
    time = np.array([at for _, at in rows])
    return ways_of([name for name, _ in rows], time, values[:, :2], values[:, 2] > 0)
