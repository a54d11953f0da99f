"""Prints as somebody has digitised them: a landmark file (.tps, F. J. Rohlf's), or a table (.csv: trackway,x,y).

A print that is missing has a line of its own with NA for both numbers, so that sides go on in turn.
"""

import csv
import io
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from sim.files.imports import texts
from worlds.errors import InputError

WHAT = "a file of trackways (.tps, .csv)"
FEWEST, MOST = 4, 20_000
"""Prints of a trackway."""
MOST_TRACKWAYS = 1_000
COLUMNS = ("trackway", "x", "y")


@dataclass(frozen=True)
class Prints:
    """The prints of a trackway in their order."""

    name: str
    points: np.ndarray  # (n, 2) in the units of the file, y upward; NaN where one is missing
    scale: float | None = None  # metres in a unit, where the file says it


def read_prints(path: str | Path) -> list[Prints]:
    """The trackways of a file. Raises InputError naming every fault with its line."""
    kind = Path(path).suffix.lower()
    if kind not in (".tps", ".csv"):
        raise InputError(f"{path}: {kind or 'no ending'}: .tps and .csv are read")
    text, faults = texts.text_of(path, WHAT, 20_000_000), list[str]()
    found = _of_tps(text, faults) if kind == ".tps" else _of_csv(text, faults)
    if not found and not faults:
        faults.append("no trackway in it: a .tps file has LM=n and n lines `x y`, a .csv file a header trackway,x,y")
    for k, prints in enumerate(found, 1):
        faults += _faults(prints, k)
    texts.refuse(path, faults)
    return found


def _faults(prints: Prints, k: int) -> Iterator[str]:
    """What keeps prints from being a trackway."""
    known, count = np.isfinite(prints.points[:, 0]), len(prints.points)
    if count < FEWEST:
        yield f"trackway {k}: {count} prints; {FEWEST} at least are needed, for a stride of either foot"
    same = np.flatnonzero(known[1:] & known[:-1] & (np.abs(np.diff(prints.points, axis=0)).max(axis=1) == 0))
    for i in same.tolist():
        yield f"trackway {k}: prints {i + 1} and {i + 2} are in one place; two prints of a course are apart"
    ends = [0, 1, count - 2, count - 1] if count >= FEWEST else []
    for i in (one for one in ends if not known[one]):
        yield f"trackway {k}: print {i + 1} is missing: the first two and the last two must be there; leave it out"


def _point(words: list[str]) -> tuple[float, float] | None:
    """The numbers of a line, NaN for a missing print, None where they are none."""
    if len(words) != 2:
        return None
    if all(texts.is_missing(word) for word in words):
        return (np.nan, np.nan)
    values = [texts.number(word) for word in words]
    return None if None in values else (values[0], values[1])  # type: ignore[return-value]


def _of_tps(text: str, faults: list[str]) -> list[Prints]:
    """LM=n, then n lines `x y`, then IMAGE=, ID=, SCALE= as there may be."""
    lines, found, i = text.splitlines(), list[Prints](), 0
    while i < len(lines) and len(faults) <= texts.SAID:
        key, _, value = (word.strip() for word in lines[i].partition("="))
        i += 1
        if key.upper() == "LM":
            count = int(value) if value.isdigit() and len(value) < 8 else -1
            if not 0 <= count <= MOST or len(found) == MOST_TRACKWAYS:
                faults.append(f"line {i}: LM={value[:40]}: a number of prints, at most {MOST}, is needed")
                return found
            points = [_point(line.split()) for line in lines[i : i + count]]
            faults += [f"line {i + k + 1}: {lines[i + k][:40]!r}: x y, or NA NA" for k, p in enumerate(points) if p is None]
            if len(points) < count:
                faults.append(f"line {len(lines)}: the file ends after {len(points)} of LM={count} prints")
            found.append(Prints(f"trackway {len(found) + 1}", np.array([p or (np.nan, np.nan) for p in points]).reshape(-1, 2)))
            i += count
        elif key.upper() in ("IMAGE", "ID", "SCALE") and found:
            found[-1] = _with(found[-1], key.upper(), value, i, faults)
        elif key and not key.upper().startswith(("COMMENT", "VARIABLES", "LM3", "CURVES", "POINTS")):
            faults.append(f"line {i}: {lines[i - 1][:40]!r}: LM=, IMAGE=, ID= or SCALE= is expected here")
    return found


def _with(prints: Prints, key: str, value: str, line: int, faults: list[str]) -> Prints:
    """The prints with what a line behind them says."""
    if key == "IMAGE":
        return Prints(Path(value[:200]).stem or prints.name, prints.points, prints.scale)
    if key == "SCALE":
        scale = texts.number(value)
        if scale is None or scale <= 0:
            faults.append(f"line {line}: SCALE={value[:40]}: a number above 0 is needed")
        return Prints(prints.name, prints.points, scale)
    return prints


def _of_csv(text: str, faults: list[str]) -> list[Prints]:
    """Columns trackway, x, y in any order, by their header."""
    rows = csv.reader(io.StringIO(text))
    tracks: dict[str, list[tuple[float, float]]] = {}
    try:
        header = [name.strip().lower() for name in next(rows, [])]
        if missing := [name for name in COLUMNS if name not in header]:
            faults.append(f"line 1: columns {', '.join(header)[:80]}: {', '.join(missing)} missing; trackway,x,y are needed")
            return []
        at = [header.index(name) for name in COLUMNS]
        for row in rows:
            if not row:
                continue
            point = _point([row[k] for k in at[1:]]) if len(row) > max(at) else None
            if point is None:
                faults.append(f"line {rows.line_num}: {','.join(row)[:40]!r}: trackway,x,y, or NA for both, are needed")
            else:
                tracks.setdefault(row[at[0]].strip(), []).append(point)
            if len(faults) > texts.SAID or len(tracks) > MOST_TRACKWAYS or max(map(len, tracks.values()), default=0) > MOST:
                faults.append(
                    f"line {rows.line_num}: more than {MOST_TRACKWAYS} trackways, {MOST} prints or {texts.SAID} faults"
                )
                return []
    except csv.Error as error:
        faults.append(f"line {rows.line_num}: {error}")
    return [Prints(name or f"trackway {k}", np.array(points)) for k, (name, points) in enumerate(tracks.items(), 1)]
