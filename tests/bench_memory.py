"""Memory of a crowd over a simulated hour: python tests/bench_memory.py [CHARACTERS] [MINUTES]

Prints the memory of the process [MB] every ten simulated minutes. Uses the interpreter that has the dependencies.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))
from motion.characters.character import load_character  # noqa: E402
from planner.modes.wander import Wander  # noqa: E402
from sim.bench.crowds import open_forest  # noqa: E402
from sim.stage.simulation import Simulation  # noqa: E402


def resident_mb() -> float:
    """Of this process now (Linux)."""
    fields = dict(line.split(":") for line in Path("/proc/self/status").read_text().splitlines() if ":" in line)
    return int(fields["VmRSS"].split()[0]) / 1024


def main() -> None:
    count, minutes = (int(sys.argv[k]) if len(sys.argv) > k else usual for k, usual in ((1, 300), (2, 60)))
    sim = Simulation(open_forest(count), [load_character("bird")] * count, Wander(), 1)
    for minute in range(minutes + 1):
        if minute % 10 == 0:
            print(f"{minute} min: {resident_mb():.1f} MB, {sim.footprints.steps} steps", flush=True)
        for _ in range(60 * sim.tick_rate):
            sim.tick()


if __name__ == "__main__":
    main()
