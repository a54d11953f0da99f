"""The golden runs, made and kept anew: python -m tests.golden.runs [NAME ...]

Of each run the footprints and the centres of mass are hashed, every tick of them; a few of their values are kept beside the
hash, for machines whose libraries round otherwise. Making them anew is a decision: say in the commit why they changed.
"""

import hashlib
import json
import platform
import sys
from collections.abc import Callable, Iterator
from functools import partial
from importlib.metadata import version
from pathlib import Path

import numpy as np

from planner.script.scene import load_scene, scene_names
from sim.stage.cast import Cast
from sim.stage.making import make_simulation
from sim.stage.scripted.performance import Performance
from tests.crowds import streams

HERE = Path(__file__).parent
HASHES, VALUES = HERE / "hashes.json", HERE / "values.npz"
EVERY = 60
"""Ticks between two kept centres of mass: what lies between follows from the same footprints."""
FOOTPRINT = ("character", "side", "position", "heading", "normal", "rock", "contact_time", "stance_time", "step_time")
"""What is hashed of a footprint, as a recording names it."""
Arrays = dict[str, np.ndarray]


RUNS: dict[str, Callable[[], Iterator[Cast]]] = {
    **{f"wander {c}": partial(lambda c: _ticks(make_simulation("forest", c, 1, 1, False), 40.0), c)
       for c in ("bird", "dinosaur", "human", "ostrich")},
    **{f"wander hills {c}": partial(lambda c: _ticks(make_simulation("hills", c, 1, 1, False), 20.0), c)
       for c in ("dinosaur", "human")},
    "wander in a crowd": lambda: _ticks(make_simulation("dense_forest", "human", 30, 3, False), 15.0),
    **{f"{level} {c}": partial(lambda level, c: _ticks(make_simulation(level, c, 1, 0, True), 45.0), level, c)
       for level, c in (("river_easy", "bird"), ("river_long_steps", "human"), ("river_leaps", "dinosaur"),
                        ("river_delta", "ostrich"))},
    **{f"streams {c}": partial(lambda c: _ticks(streams(20, c, seed=1), 30.0), c) for c in ("bird", "human")},
    **{f"scene {name}": partial(lambda name: _ticks(Performance(load_scene(name)), 120.0), name) for name in scene_names()},
}  # fmt: skip


def _ticks(sim: Cast, seconds: float) -> Iterator[Cast]:
    """The run before its first tick and after each one, until it is over."""
    sim.keep_footprints()
    yield sim
    while sim.time < seconds and not sim.over:
        sim.tick()
        yield sim


def made(name: str) -> Arrays:
    """Footprints, and the centres of mass (F, C, 3) at every tick, of a run."""
    com = []
    for sim in RUNS[name]():
        com.append(sim.snapshot().com)
    log = sim.footprints.arrays(sim.crowd)
    return {"com": np.array(com), **{key: log[f"footprint_{key}"] for key in FOOTPRINT}}


def digest(run: Arrays) -> str:
    """Of all bits of a run."""
    whole = hashlib.sha256()
    for key in sorted(run):
        whole.update(f"{key} {run[key].shape}".encode() + np.ascontiguousarray(run[key]).tobytes())
    return whole.hexdigest()


def thinned(run: Arrays) -> Arrays:
    """What is kept of a run beside its hash."""
    return {"com": run["com"][::EVERY], "position": run["position"], "contact_time": run["contact_time"]}


def libraries() -> dict[str, str]:
    """What may round otherwise: the pinned libraries and the C library that brings sine and cosine."""
    return {**{name: version(name) for name in ("numpy", "numba", "llvmlite")}, "c": " ".join(platform.libc_ver())}


def kept() -> tuple[dict[str, str], dict[str, str]]:
    """(hash of each run, libraries that they were made with)."""
    held = json.loads(HASHES.read_text(encoding="utf-8"))
    return held["runs"], held["libraries"]


def kept_values(name: str) -> Arrays:
    """What `thinned` has kept of a run."""
    with np.load(VALUES) as held:
        return {key.removeprefix(f"{name}/"): held[key] for key in held.files if key.startswith(f"{name}/")}


def main(names: list[str]) -> None:
    """Makes these runs anew, or all."""
    hashes = kept()[0] if names else {}
    values = {name: kept_values(name) for name in hashes}
    for name in names or RUNS:
        run = made(name)
        hashes[name], values[name] = digest(run), thinned(run)
        print(name, hashes[name][:16], flush=True)
    np.savez_compressed(VALUES, **{f"{name}/{key}": array for name, run in values.items() for key, array in run.items()})
    HASHES.write_text(json.dumps({"libraries": libraries(), "runs": hashes}, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
