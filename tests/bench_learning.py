"""Footsteps a second of the environments: `python -m tests.bench_learning [rows]`.

By the wall clock, and by the processor time of all threads, which does not count what other programs take.
"""

import sys
import time

import numpy as np

from sim.stage.learning.stepping import SteppingStones
from tests.sim.stage.learning.test_stepping import onto

STEPS = 20


def main(rows: int, level: float) -> None:
    """Everybody steps onto the next stone, again and again; who falls begins anew."""
    stones = SteppingStones(rows, level=level)
    seen = stones.reset(np.arange(rows))
    stones.step(onto(seen))
    seen, fell = stones.reset(np.arange(rows)), 0
    wall, processor = time.perf_counter(), time.process_time()
    for _ in range(STEPS):
        stepped = stones.step(onto(seen))
        seen = stones.begin(np.flatnonzero(stepped.fell)) if stepped.fell.any() else stepped.seen
        fell += int(stepped.fell.sum())
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    done = rows * STEPS
    print(
        f"{rows} rows, level {level:g}: {done / wall:,.0f} footsteps/s, {done / processor:,.0f} per processor second; "
        f"{fell / done:.1%} fell"
    )


if __name__ == "__main__":
    for share in (0.0, 0.5, 1.0):
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 2000, share)
