"""Crowds in each other's way, worst values: python tests/bench_crowds.py [SECONDS] [CHARACTER ...]

Rings and streams with SEEDS, the forest with the first of them.

Uses the interpreter that has the dependencies (the project's .venv). 600 s (the forest's; the others end on arrival) take some
three minutes a character.
"""

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1]))
from sim.stage.simulation import Simulation  # noqa: E402
from tests.crowds import Watch, forest, ring, streams  # noqa: E402

SIDE = {"bird": 40.0, "human": 60.0, "dinosaur": 110.0}
"""Of the forest [m] for 500."""

SEEDS = tuple(range(1, 13))


def crowds_of(character: str, seconds: float) -> list[tuple[str, Callable[[], Simulation], float]]:
    """Names, makers and how long [s] at most."""
    size = SIDE[character] / SIDE["bird"]
    gap = 3.0 * max(size / 1.5, 1)
    rings = [(f"ring {k}", partial(ring, 24, 5.0 * size, character, k), 120.0) for k in SEEDS]
    both = [(f"streams {k}", partial(streams, 20, character, gap, k), 180.0) for k in SEEDS]
    return [*rings, *both, ("forest", partial(forest, 500, SIDE[character], character), seconds)]


def main() -> None:
    """Prints a line per crowd and character."""
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 600.0
    for character in sys.argv[2:] or ["bird"]:
        for name, make, longest in crowds_of(character, seconds):
            begin = perf_counter()
            watch = Watch(make()).run(longest)
            figures = watch.figures()
            print(
                f"{name:10}{character:9}",
                *(f"{k} {v:.3g}," for k, v in figures.items()),
                f"wall {perf_counter() - begin:.0f} s",
                flush=True,
            )


if __name__ == "__main__":
    main()
