"""Well-known text (OGC 06-103r4, 7): LINESTRING, POLYGON, their MULTI forms and GEOMETRYCOLLECTION, with z and m left out.

A polygon is where people may walk, as in JuPedSim and Vadere: its border and those of its holes are walls. Lines are walls.
"""

import re

import numpy as np

from sim.files.imports.plans.lines import Plan, checked
from sim.files.imports.texts import FARTHEST, text_of
from worlds.errors import InputError
from worlds.reading import nearest

KINDS = ("POINT", "LINESTRING", "POLYGON", "MULTIPOINT", "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION")
LARGEST = 20_000_000
"""Bytes."""
DEEPEST = 20
"""Collections in collections."""
_WORD = re.compile(r"\s*([A-Za-z]+|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|[(),;])")


def read_wkt(path: str) -> Plan:
    """The plan of a text file that holds one geometry or several. Raises InputError."""
    return plan_of(text_of(path, "a plan in WKT", LARGEST), path)


def plan_of(text: str, said: str) -> Plan:
    """The plan that a text tells; said: where it is from. Raises InputError."""
    reader = _Reader(text, said)
    while not reader.done:
        reader.geometry(0)
    return checked(said, Plan(tuple(reader.lines), tuple(reader.walkable)))


class _Reader:
    """Reads from left to right, word by word."""

    def __init__(self, text: str, said: str) -> None:
        text = re.sub(r"SRID\s*=\s*\d+\s*;", " ", text, flags=re.IGNORECASE)
        self.text, self.said, self.at = text, said, 0
        self.lines: list[np.ndarray] = []
        self.walkable: list[int] = []

    @property
    def done(self) -> bool:
        return not self.text[self.at :].strip(" \t\r\n;")

    def _fault(self, needed: str) -> InputError:
        line = self.text.count("\n", 0, self.at) + 1
        there = self.text[self.at :].strip()[:30] or "the end"
        return InputError(f"{self.said}: line {line}, at {there!r}: {needed} is needed")

    def _next(self) -> str:
        found = _WORD.match(self.text, self.at)
        return found[1] if found else ""

    def _take(self) -> str:
        found = _WORD.match(self.text, self.at)
        if not found:
            raise self._fault("a word, a number or a bracket")
        self.at = found.end()
        return found[1]

    def _expect(self, word: str) -> None:
        if self._next() != word:
            raise self._fault(repr(word))
        self._take()

    def geometry(self, depth: int) -> None:
        """One of KINDS."""
        while self._next() == ";":
            self._take()
        kind = self._next().upper()
        if kind not in KINDS or depth > DEEPEST:
            raise self._fault(f"one of {', '.join(KINDS)}{nearest(kind, KINDS)}")
        self._take()
        if self._next().upper() in ("Z", "M", "ZM"):
            self._take()
        if self._next().upper() == "EMPTY":
            self._take()
        elif kind == "GEOMETRYCOLLECTION":
            self._several(lambda: self.geometry(depth + 1))
        elif kind == "POLYGON":
            self._polygon()
        elif kind == "MULTIPOLYGON":
            self._several(self._polygon)
        elif kind == "LINESTRING":
            self.lines.append(self._points(2))
        elif kind == "MULTILINESTRING":
            self._several(lambda: self.lines.append(self._points(2)))
        else:  # points are no walls
            self._points(1, nested=True)

    def _several(self, one: object) -> None:
        self._expect("(")
        one()  # type: ignore[operator]
        while self._next() == ",":
            self._take()
            one()  # type: ignore[operator]
        self._expect(")")

    def _polygon(self) -> None:
        self.walkable.append(len(self.lines))
        self._several(self._ring)

    def _ring(self) -> None:
        ring = self._points(4)
        if not np.allclose(ring[0], ring[-1]):
            raise self._fault(f"a ring that ends where it begins, ({ring[0, 0]:g} {ring[0, 1]:g}),")
        self.lines.append(ring)

    def _points(self, least: int, nested: bool = False) -> np.ndarray:
        points: list[tuple[float, float]] = []

        def point() -> None:
            if nested and self._next() == "(":
                self._several(point)
                return
            numbers = []
            while re.fullmatch(r"[-+.\d].*", self._next()):
                numbers.append(float(self._take()))
            if not 2 <= len(numbers) <= 4 or not max(map(abs, numbers)) <= FARTHEST:
                raise self._fault(f"a point of 2 to 4 numbers up to {FARTHEST:g}")
            points.append((numbers[0], numbers[1]))

        self._several(point)
        if len(points) < least:
            raise self._fault(f"{least} points or more")
        return np.array(points)
