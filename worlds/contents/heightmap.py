"""Heightmaps: 16-bit greyscale PNG images, the top row at the far border (largest y)."""

import struct
from pathlib import Path

import numpy as np
from PIL import Image, UnidentifiedImageError

LARGEST = 4096
"""Pixels along an edge."""
LARGEST_FILE = 200_000_000
"""Bytes."""


def read_heightmap(path: Path) -> tuple[np.ndarray, str | None]:
    """Heights in 0..1, row 0 at y = 0, and what is wrong with the file, or None."""
    nothing = np.zeros((1, 1))
    try:
        size = path.stat().st_size if path.is_file() else -1
    except (OSError, ValueError):  # a name that no file can have
        size = -1
    if not 0 <= size <= LARGEST_FILE:
        return nothing, f"{path}: {'no such file' if size < 0 else f'{size} bytes; at most {LARGEST_FILE}'}"
    try:
        width, height = _declared(path)
        if max(width, height) > LARGEST:
            return nothing, f"{path}: is {width} x {height} pixels; 2 to {LARGEST} along an edge"
        with Image.open(path) as image:
            if image.format != "PNG" or image.mode not in ("I;16", "I;16B", "I"):
                return nothing, f"{path}: is {image.format} of mode {image.mode}; a 16-bit greyscale PNG is needed"
            if max(image.size) > LARGEST or min(image.size) < 2:
                return nothing, f"{path}: is {image.size[0]} x {image.size[1]} pixels; 2 to {LARGEST} along an edge"
            pixels = np.asarray(image, dtype=np.float64)
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        return nothing, f"{path}: is not a readable image ({error})"
    return np.ascontiguousarray(pixels[::-1]) / 65535.0, None


def write_heightmap(path: Path, heights: np.ndarray) -> None:
    """Writes heights in 0..1, row 0 at y = 0, of which one in 65535 is the least difference. Raises OSError."""
    pixels = np.round(np.clip(heights, 0.0, 1.0) * 65535.0).astype(np.uint16)
    Image.fromarray(np.ascontiguousarray(pixels[::-1])).save(path, format="PNG")


def _declared(path: Path) -> tuple[int, int]:
    """Width and height that a PNG's header tells, before anything of it is unpacked; 0, 0 for what is none."""
    with open(path, "rb") as file:
        head = file.read(24)
    return struct.unpack(">II", head[16:24]) if head.startswith(b"\x89PNG") and len(head) == 24 else (0, 0)
