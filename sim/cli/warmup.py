"""The first start: kernels are compiled one after the other, by plain names, and half of them in a second process.

Compiled kernels are kept (worlds.compiled.jit), so this happens once for these sources, this numba and this processor. They are
compiled for the types of their arguments, which a small cast provides; nothing is run. Those in HELPERS are compiled by a
second process meanwhile: by the time that the tick needs `placing footprints`, it lies in the cache.
"""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import llvmlite.binding
import numba
import numpy as np

from motion.characters.biped import load_biped
from motion.com import newton
from motion.pose.pose import empty_pose
from planner.crowd.reservations import empty_reservations
from planner.river import search
from planner.script.script import Script
from planner.stepping import placing
from planner.wandering import Wander
from sim.rows import crowd as crowds
from sim.rows import rounds
from sim.stage import performance
from sim.stage.cast import Cast
from worlds import queries
from worlds.world import World

ROOT = Path(__file__).resolve().parents[2]
OURS, HELPERS = ("window solve", "tick of the crowd"), ("placing footprints", "poses", "standing", "ground")
SCRIPTED, ROUTES = "whole tracks", "route search"


def warm_up(command: str, tell: Callable[[str], None]) -> None:
    """Compiles what the command needs, where it has not been yet; tell is called with a line for each kernel."""
    ours = {"river": (*OURS, ROUTES), "play": (SCRIPTED,)}.get(command, OURS)
    stamp = _stamp(command)
    if stamp.exists():
        return
    names = (*ours, *HELPERS)
    helper = subprocess.Popen([sys.executable, "-m", "sim.cli.warmup", ",".join(names), ",".join(HELPERS)], cwd=ROOT)
    try:
        _compile(names, ours, tell)
        helper.wait()
    finally:
        if helper.poll() is None:
            helper.terminate()
    if stamp.parent.is_dir():
        stamp.touch()


def _stamp(command: str) -> Path:
    """A file that is there once the command's kernels lie in the cache."""
    made_for = f"{numba.__version__}-{llvmlite.binding.get_host_cpu_name()}-{sys.version_info.major}{sys.version_info.minor}"
    return Path(os.environ["NUMBA_CACHE_DIR"]) / f"warm-{command}-{made_for}"


def _compile(names: tuple[str, ...], mine: tuple[str, ...], tell: Callable[[str], None]) -> None:
    kernels = steps()
    for name in mine:
        tell(f"compiling {names.index(name) + 1} of {len(names)}: {name} ...")
        for kernel, arguments in kernels[name]:
            kernel.compile(tuple(numba.typeof(one) for one in arguments))


def steps() -> dict[str, list[tuple[Any, tuple]]]:
    """Kernels by plain names, with arguments of the types that they are called with."""
    world = World("warm-up", (10.0, 10.0), start=(5.0, 5.0))
    cast = Cast(world, [load_biped("bird")], 0, 60)
    crowd, bipeds, w = cast.crowd, cast.bipeds, world.arrays
    plans = Wander().prepare(world, cast.characters, np.zeros((1, 2, 5)), np.zeros(1, np.int64), 0)
    r = empty_reservations(bipeds, crowd.kind, world.size)
    one, matrix, b = np.zeros(2, np.int64), np.zeros((2, 3)), bipeds[0]
    place, many = (w, 0.0, 0.0), np.zeros(2)
    script = Script(one, np.zeros((2, 2)), many, many, many, many, many, many, 0, 0.0)
    return {
        "window solve": [(rounds.optimise_step, ())],
        "placing footprints": [(rounds.plan_step, ())],
        "tick of the crowd": [(rounds.advance_all, (rounds.Parts(0, 0), crowd, bipeds, w, plans, r, 0, newton.LIVE, 0.0, one))],
        "poses": [(crowds.pose_all, (crowd, bipeds, 0.0, one, empty_pose(1))), (crowds.com_all, (crowd, 0.0, matrix))],
        "standing": [
            (crowds.stand, (crowd, bipeds, 0, 0.0, 0, matrix, np.zeros(2), matrix, one)),
            (rounds.publish_all, (crowd, bipeds, r, one)),
        ],
        "ground": [
            (placing.lay_sole, (b, w, 0.0, 0.0, 0.0, 0)),
            (queries.rock_under, (*place, 0.0)),
            (queries.survey, (w, np.zeros((2, 2)), matrix)),
            *((kernel, place) for kernel in (queries.clearance, queries.terrain_height, queries.in_water)),
        ],
        ROUTES: [(search.find, (b, matrix, one, matrix, 0, 0))],
        SCRIPTED: [(performance.perform, (crowd, bipeds, w, 0, script, 0, False, newton.SCENE))],
    }


if __name__ == "__main__":
    every, some = (tuple(names.split(",")) for names in sys.argv[1:])
    _compile(every, some, lambda line: print(line, file=sys.stderr, flush=True))
