"""Into the terms of other programs: from our axes (x forward, y left, z up) to theirs (z forward, x left, y up).

Both are right-handed, so the change is a turn: (x, y, z) becomes (y, z, x), of points as of a quaternion's vector.
"""

import numpy as np

ORDER = (1, 2, 0)


def y_up(points: np.ndarray) -> np.ndarray:
    """Points or directions (..., 3) in the other axes."""
    return points[..., ORDER]


def y_up_xyzw(rotation_wxyz: np.ndarray) -> np.ndarray:
    """Rotations (..., 4) in the other axes, w last; neighbours along the first axis on the same side."""
    w, x, y, z = np.moveaxis(rotation_wxyz, -1, 0)
    return np.stack([y, z, x, w], axis=-1)


def steady(rotations: np.ndarray) -> np.ndarray:
    """(F, ..., 4) quaternions whose signs are such that each is the nearer one to its predecessor: q and -q are one turn."""
    dots = np.einsum("...i,...i->...", rotations[1:], rotations[:-1])
    signs = np.cumprod(np.concatenate([np.ones_like(dots[:1]), np.where(dots < 0, -1.0, 1.0)]), axis=0)
    return rotations * signs[..., None]


def light_of(colour: np.ndarray) -> np.ndarray:
    """Red, green, blue of a screen (..., 3), 0..1, as light (IEC 61966-2-1)."""
    return np.where(colour <= 0.04045, colour / 12.92, ((colour + 0.055) / 1.055) ** 2.4)
