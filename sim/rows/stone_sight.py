"""What is seen of stepping stones: an observation for every row (sim.stage.learning)."""

from math import cos, sin

import numpy as np

from motion.track.footprints import LEFT
from sim.rows.rounds import open_work
from sim.rows.stones import IN_VIEW, NEXT, open_ground
from worlds.compiled.jit import jit, jit_borrowing
from worlds.compiled.tables import row

SEEN = 8 + 4 + 3 * IN_VIEW
"""Numbers of an observation."""


@jit
def observe_rows(work_at: int, ground_at: int, seen: np.ndarray) -> None:
    """Fills seen (N, SEEN): what lies around each newer foot, along its heading, mirrored where the right foot is next.

    com and its velocity, step and stance time, the older foot with its heading, the next stones; metres, seconds, radians.
    """
    crowd, ground = open_work(work_at).crowd, open_ground(ground_at)
    for c in range(len(crowd.kind)):
        n, segment = crowd.real[c] - 1, crowd.segments[c]
        f, place, com = row(crowd.footprints, c), ground.stones.place[c], crowd.committed.control[c, segment]
        p, q, mirror = f.position[n], f.position[n - 1], -1.0 if f.side[n] == LEFT else 1.0
        co, si = cos(f.heading[n]), sin(f.heading[n])
        _put(seen[c], 0, com[0] - p[0], com[1] - p[1], com[2] - p[2], co, si, mirror)
        _put(seen[c], 3, com[3], com[4], com[5], co, si, mirror)
        seen[c, 6], seen[c, 7] = f.step_time[n - 1], f.stance_time[n - 1]
        _put(seen[c], 8, q[0] - p[0], q[1] - p[1], q[2] - p[2], co, si, mirror)
        seen[c, 11] = mirror * (f.heading[n - 1] - f.heading[n])
        for k in range(IN_VIEW):
            stone = place[NEXT + k]
            _put(seen[c], 12 + 3 * k, stone[0] - p[0], stone[1] - p[1], stone[3] - p[2], co, si, mirror)


@jit_borrowing
def _put(seen: np.ndarray, at: int, x: float, y: float, z: float, co: float, si: float, mirror: float) -> None:
    seen[at], seen[at + 1], seen[at + 2] = x * co + y * si, mirror * (y * co - x * si), z
