"""glTF 2.0 in one binary file, .glb: a JSON chunk that says what is there, and one of numbers (Khronos, glTF 2.0, chapter 4).

Only what every format needs: arrays become accessors, equal ones once.
"""

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np

FLOAT, UBYTE, USHORT, UINT = 5126, 5121, 5123, 5125
_COMPONENTS = {"f4": FLOAT, "u1": UBYTE, "u2": USHORT, "u4": UINT}
_SHAPES = {(): "SCALAR", (2,): "VEC2", (3,): "VEC3", (4,): "VEC4", (4, 4): "MAT4"}
VERTICES, INDICES = 34962, 34963
"""What a buffer view is for, where it is for a mesh."""


class Gltf:
    """A file in the making: its tables as JSON has them, and its numbers."""

    def __init__(self, generator: str) -> None:
        self.tables: dict[str, list[dict]] = {}
        self.generator = generator
        self._numbers: list[bytes] = []
        self._size = 0
        self._known: dict[tuple, int] = {}

    def add(self, table: str, **entry: Any) -> int:
        """Adds an entry to a table (nodes, meshes, skins, ...); returns its number."""
        entries = self.tables.setdefault(table, [])
        entries.append({key: value for key, value in entry.items() if value is not None})
        return len(entries) - 1

    def array(self, values: np.ndarray, kind: str, target: int | None = None, **more: Any) -> int:
        """An accessor of an array (N, ...) as `kind` (f4, u1, u2, u4), with the range of f4; returns its number."""
        data = np.ascontiguousarray(values, f"<{kind}")
        key = (data.tobytes(), kind, data.shape, target, tuple(more.items()))
        if key not in self._known:
            view = self.add("bufferViews", buffer=0, byteOffset=self._size, byteLength=data.nbytes, target=target)
            self._put(key[0])
            limits = {"min": _row(data.min(axis=0)), "max": _row(data.max(axis=0))} if kind == "f4" and data.ndim < 3 else {}
            self._known[key] = self.add(
                "accessors", bufferView=view, componentType=_COMPONENTS[kind], count=len(data), type=_SHAPES[data.shape[1:]],
                **limits, **more,
            )  # fmt: skip
        return self._known[key]

    def _put(self, data: bytes) -> None:
        padded = data + bytes(-len(data) % 4)
        self._numbers.append(padded)
        self._size += len(padded)

    def write(self, path: Path) -> None:
        """Writes the file, with one scene of all nodes that hang on none."""
        path.write_bytes(self.as_bytes())

    def as_bytes(self) -> bytes:
        """The file."""
        nodes = self.tables.get("nodes", [])
        below = {child for node in nodes for child in node.get("children", ())}
        scene = {"nodes": [k for k in range(len(nodes)) if k not in below]}
        whole = {
            "asset": {"version": "2.0", "generator": self.generator}, "scene": 0, "scenes": [scene], **self.tables,
            "buffers": [{"byteLength": self._size}],
        }  # fmt: skip
        text = json.dumps(whole, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        head = struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + self._size)
        chunks = (struct.pack("<I4s", len(text), b"JSON"), text, struct.pack("<I4s", self._size, b"BIN\0"), *self._numbers)
        return b"".join((head, *chunks))


def _row(values: np.ndarray) -> list[float]:
    return [float(value) for value in np.atleast_1d(values)]
