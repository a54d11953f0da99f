"""Crowds in each other's way, worst values: python tests/bench_crowds.py [SECONDS] [CHARACTER ...]

Uses the interpreter that has the dependencies (the project's .venv). 600 s (the forest's; the others end on arrival) take some
ten minutes a character.
"""

import sys
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1]))
from tests.crowds import Watch, forest, ring, streams  # noqa: E402

SIDE = {"bird": 40.0, "human": 60.0, "dinosaur": 110.0}
"""Of the forest [m] for 500."""


def main() -> None:
    """Prints a line per crowd and character."""
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 600.0
    for character in sys.argv[2:] or ["bird"]:
        size = SIDE[character] / SIDE["bird"]
        crowds = {
            "ring": lambda c=character, s=size: (ring(24, 5.0 * s, c), 120.0),
            "streams": lambda c=character, s=size: (streams(20, c, 3.0 * max(s / 1.5, 1)), 180.0),
            "forest": lambda c=character: (forest(500, SIDE[c], c), seconds),
        }
        for name, make in crowds.items():
            begin = perf_counter()
            sim, longest = make()
            watch = Watch(sim).run(longest)
            figures = watch.figures()
            print(
                f"{name:9}{character:9}",
                *(f"{k} {v:.3g}," for k, v in figures.items()),
                f"wall {perf_counter() - begin:.0f} s",
                flush=True,
            )


if __name__ == "__main__":
    main()
