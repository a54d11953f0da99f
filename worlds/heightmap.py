"""Heightmaps: 16-bit greyscale PNG images, the top row at the far border (largest y)."""

from pathlib import Path

import numpy as np
from PIL import Image, UnidentifiedImageError

LARGEST = 4096
"""Pixels along an edge."""


def read_heightmap(path: Path) -> tuple[np.ndarray, str | None]:
    """Heights in 0..1, row 0 at y = 0, and what is wrong with the file, or None."""
    nothing = np.zeros((1, 1))
    if not path.is_file():
        return nothing, f"{path}: no such file"
    try:
        with Image.open(path) as image:
            if image.format != "PNG" or image.mode not in ("I;16", "I;16B", "I"):
                return nothing, f"{path}: is {image.format} of mode {image.mode}; a 16-bit greyscale PNG is needed"
            if max(image.size) > LARGEST or min(image.size) < 2:
                return nothing, f"{path}: is {image.size[0]} x {image.size[1]} pixels; 2 to {LARGEST} along an edge"
            pixels = np.asarray(image, dtype=np.float64)
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError) as error:
        return nothing, f"{path}: is not a readable image ({error})"
    return np.ascontiguousarray(pixels[::-1]) / 65535.0, None
