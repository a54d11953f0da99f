"""Long wanders on every kind of land, worst values per level and character: python tests/bench_wander.py [SECONDS] [SEEDS]

Uses the interpreter that has the dependencies (the project's .venv). 600 s and 10 seeds take about ten minutes.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))
from planner.stepping.timing import step_timing  # noqa: E402
from sim.stage.making import make_simulation  # noqa: E402
from worlds import queries  # noqa: E402

LEVELS = ("forest", "dense_forest", "hills", "forest_river")
CHARACTERS = ("bird", "human", "dinosaur", "ostrich")


def wander(level: str, character: str, seed: int, seconds: int) -> dict[str, float]:
    """Clearances of the footprints [m], share of the walking speed, physics cost [m/s^2], penetration and overreach [mm]."""
    sim = make_simulation(level, character, 1, seed, False)
    sim.keep_footprints()
    w, b, last, distance = sim.world.arrays, sim.bipeds[0], None, 0.0
    physics, deep, over = [], 0.0, 0.0
    for k in range(seconds * 60):
        sim.tick()
        if k % 6:
            continue
        p = sim.snapshot()
        distance += 0.0 if last is None else float(np.linalg.norm(p.com[0, :2] - last))
        last = p.com[0, :2].copy()
        physics.append(p.physics_cost[0])
        deep = max(deep, *(queries.ground_height(w, x, y) - z for x, y, z in (*p.heel[0], *p.toe[0])))
        over = max(over, float(np.linalg.norm(p.hip - p.ankle, axis=-1).max() - b.leg.max_length))
    feet = sim.footprints.arrays(sim.crowd)["footprint_position"]
    speed = b.gait.preferred_step / step_timing(b, b.gait.preferred_step, 0.0, 0.0, False)[0]
    return {
        "tree": min(queries.tree_clearance(w, x, y) for x, y, _ in feet),
        "water": min(queries.water_clearance(w, x, y) for x, y, _ in feet),
        "border": min(queries.border_clearance(w, x, y) for x, y, _ in feet),
        "speed": distance / seconds / speed,
        "-physics": -float(np.mean(physics)),  # NaN anywhere shows here
        "-penetration": -1e3 * deep,
        "-overreach": -1e3 * over,
    }


def main() -> None:
    """Prints a line per level and character: the worst over the seeds."""
    seconds, seeds = (int(a) for a in (sys.argv[1:] + ["600", "10"][len(sys.argv) - 1 :]))
    for level in LEVELS:
        for character in CHARACTERS:
            runs = [wander(level, character, seed, seconds) for seed in range(seeds)]
            worst = {key: min(run[key] for run in runs) for key in runs[0]}
            print(f"{level:13}{character:9}", *(f"{k.strip('-')} {abs(v):.3f}" for k, v in worst.items()), flush=True)


if __name__ == "__main__":
    main()
