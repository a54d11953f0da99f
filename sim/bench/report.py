"""The report of `bench`."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

from motion.characters.character import load_character
from planner.modes.wander import Wander
from sim.bench import crowds, driven, jams, learning, live, solver
from sim.stage.simulation import Simulation
from worlds.level import load_level

ROOT = Path(__file__).resolve().parents[2]
SIZE = (960, 540)
CROWDS = ((1, 5.0), (100, 5.0), (1000, 5.0), (10_000, 2.0), (100_000, 0.5))
QUICK_CROWDS = ((1, 2.0), (100, 2.0))
"""Characters, and the simulated seconds for which they are timed."""
FRAMES = (1, 100, 1000)
"""Characters in view, of which frames per second are told."""


Jam = Callable[[float], Simulation]
"""Makes people on a ring, so many per square metre."""


def run(quick: bool, jam: Jam, only: str | None = None) -> dict:
    """All figures (README, Benchmarks), or one part of them. quick: fewer repetitions, no crowd above 100."""
    report: dict = {}
    for part in PARTS if only is None else (only,):
        report |= PARTS[part](quick, jam)
    return report


def _crowds(quick: bool, _: Jam) -> dict:
    by_count = {str(n): crowds.measure(n, seconds) for n, seconds in (QUICK_CROWDS if quick else CROWDS)}
    return {"crowd": by_count, "crowd_growth_exponent": crowds.growth(by_count)}


def _frames(quick: bool, _: Jam) -> dict:
    by_characters = {str(n): frames(n, 20 if quick else 60) for n in FRAMES}
    return {"frames_per_second": by_characters["1"], "frames_per_second_by_characters": by_characters}


def startup(runs: int) -> float:
    """Seconds of a whole headless process that simulates a tenth of a second, from a warm cache."""
    command = [sys.executable, "-m", "sim", "wander", "--headless", "--seconds", "0.1", "--json"]
    seconds = []
    for _ in range(runs + 1):
        begin = perf_counter()
        subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
        seconds.append(perf_counter() - begin)
    return median(seconds[1:])


def frames(n: int, count: int) -> float | None:
    """Frames per second at 960x540 in memory, at the quality a window starts with in software, its ticks included.

    One character: the default demo. More: n wanderers in the same forest, all of them in view.
    """
    from sim.view.graphics.gl import NoGL
    from sim.view.graphics.quality import LEVELS, SOFTWARE_LEVEL
    from sim.view.pictures.offscreen import Picture
    from sim.view.window.app import tick_for

    try:
        picture = Picture(SIZE, LEVELS[SOFTWARE_LEVEL])
    except NoGL:
        return None
    sim = Simulation(load_level("forest"), [load_character("bird")] * n, Wander(), 0)
    com = sim.com()
    middle = 0.5 * (com.min(axis=0) + com.max(axis=0))
    picture.camera.frame(middle, float(np.linalg.norm(com - middle, axis=1).max()), SIZE[0] / 100)
    seconds = [1 / 60]
    for _ in range(count):
        begin = perf_counter()
        tick_for(sim, max(round(seconds[-1] * sim.tick_rate), 1))
        picture.frame(sim) if n == 1 else picture.shoot(sim, 0, sim.time)
        seconds.append(perf_counter() - begin)
    return 1 / median(seconds[5:])


PARTS: dict[str, Callable[[bool, Jam], dict]] = {
    "solver": lambda quick, _: {"solver": solver.compare(5 if quick else 21)},
    "window": lambda quick, _: {"window": live.report()},
    "crowd": _crowds,
    "jam": lambda quick, jam: {"jam": jams.report(jam, *((2.0, 300) if quick else (10.0, jams.MANY)))},
    "learning": lambda quick, _: {"learning": learning.report(500 if quick else 3000)},
    "startup": lambda quick, _: {"startup_s": startup(1 if quick else 3)},
    "frames": _frames,
    "driven": lambda quick, _: {"driven": driven.report(quick, SIZE)},
}
"""What is measured, by names."""


def in_words(report: dict) -> str:
    """The report, or a part of it, for people."""
    lines = _solvers_in_words(report["solver"]) if "solver" in report else []
    if "window" in report:
        lines.append(
            f"live window: {report['window']['us_per_step']:.0f} us per step, "
            f"E {report['window']['cost_over_tight']:.3f} of that with windows solved tightly, "
            f"{report['window']['cost_over_global']:.3f} of the global optimum ({live.STEPS}-step wander)"
        )
    lines += crowds.in_words(report.get("crowd", {}))
    if report.get("crowd_growth_exponent"):
        lines.append(f"cost grows as characters^{report['crowd_growth_exponent']:.2f} from 1000 on")
    lines += jams.in_words(report["jam"]) if "jam" in report else []
    lines += learning.in_words(report.get("learning", {}))
    if "startup_s" in report:
        lines.append(f"start-up {report['startup_s']:.2f} s")
    if "frames_per_second" in report:
        rates = report["frames_per_second_by_characters"]
        told = ", ".join(f"{rate:.0f} with {n}" for n, rate in rates.items() if rate)
        lines.append(f"frames/s: {told} in view" if told else "frames/s: no OpenGL here")
    lines += driven.in_words(report.get("driven", {}))
    return "\n".join(lines)


def _solvers_in_words(by_track: dict[str, dict]) -> list[str]:
    lines = ["12-step tracks, a segment per step or per phase, 10 samples   ms (E, E / best)"]
    for track, row in by_track.items():
        cells = [
            f"{name} {row[f'{name}_ms']:.2f} ({row[f'{name}_cost']:.3f}, {row[f'{name}_cost'] / row['best_cost']:.3f})"
            for name in ("newton", "newton_loose", "greedy", "lbfgs", "ipopt")
            if f"{name}_ms" in row
        ]
        lines.append(f"  {track}: " + ", ".join(cells))
    return lines
