"""What one walker sees of another: where it is and goes, and what it wants."""

import numpy as np

NEIGHBOUR = np.dtype(
    [
        ("x", np.float64),  # place, relative to where my body rests [m]
        ("y", np.float64),
        ("vx", np.float64),  # velocity [m/s]; inf: it lets me go first
        ("vy", np.float64),
        ("room", np.float64),  # distance to keep from it [m]
        ("aim_x", np.float64),  # unit vector of the course that it wishes; 0, 0 where it stays
        ("aim_y", np.float64),
        ("rank", np.float64),  # of its claim; -inf: no more than one's own
        ("speed", np.float64),  # that it claims [m/s]; 0: it claims nothing
    ]
)


class Neighbour:
    """A record of NEIGHBOUR, for the type checker; never made."""

    x: float
    y: float
    vx: float
    vy: float
    room: float
    aim_x: float
    aim_y: float
    rank: float
    speed: float
