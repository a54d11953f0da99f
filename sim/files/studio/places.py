"""Where the studio keeps what is its own: recent files, unsaved work, the ground of runs."""

import hashlib
import os
import sys
from pathlib import Path

import numpy as np

from sim.files import outputs
from worlds.contents.heightmap import write_heightmap
from worlds.errors import InputError


def home() -> Path:
    """The folder of our own for what is remembered between runs, made where it is missing. Raises OSError, RuntimeError."""
    given = os.environ.get("FOOTFALL_STATE")
    if given:
        place = Path(given)
    elif sys.platform == "win32":
        place = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local") / "footfall"
    elif sys.platform == "darwin":
        place = Path.home() / "Library" / "Application Support" / "footfall"
    else:
        place = Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state") / "footfall"
    place.mkdir(parents=True, exist_ok=True)
    return place


def kept_heightmap(heights: np.ndarray) -> Path:
    """The file of our own that has these heights, in 0..1, row 0 at y = 0; made where it is missing. Raises InputError."""
    name = hashlib.sha256(np.ascontiguousarray(heights, np.float64).tobytes() + str(heights.shape).encode()).hexdigest()[:16]
    try:
        folder = home() / "grounds"
        folder.mkdir(exist_ok=True)
    except (OSError, RuntimeError) as error:
        raise InputError(f"the heights of the run's ground cannot be kept: {error}; FOOTFALL_STATE names a folder") from None
    path = folder / f"{name}.png"
    if not path.is_file():
        with outputs.whole(path) as part:
            write_heightmap(part, heights)
    return path
