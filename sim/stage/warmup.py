"""The first start: kernels are compiled one after the other, by plain names, and half of them in a second process.

Compiled kernels are kept (worlds.compiled.cache), so this happens once for these sources, this numba and this processor. They
are compiled for the types of their arguments, which a small cast provides; nothing is run. Half of them are compiled by a
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

from motion import motion
from motion.characters.character import load_character
from motion.com import newton, window
from motion.pose.pose import empty_pose
from motion.pose.posing import pose_one
from motion.track.footprints import STEP, Footprints
from planner.modes.wander import Wander
from planner.river import search
from planner.river.rock_hop import RockHop
from planner.script import laying
from sim.rows import crowd as crowds
from sim.rows import posing, rounds
from sim.stage.simulation import Simulation
from worlds import queries
from worlds.compiled.tables import empty
from worlds.world import World

ROOT = Path(__file__).resolve().parents[2]
LIVE, SHOWN = ("window solve", "tick of the crowd"), ("poses", "standing", "ground")
NEEDED = {
    "wander": (LIVE, ("placing footprints", "wandering", *SHOWN)),
    "river": ((*LIVE, "route search"), ("placing footprints", "crossing", *SHOWN)),
    "play": (("whole curves",), ("laying footprints", *SHOWN)),
}
"""What a command needs: (compiled here, by the second process)."""


def warm_up(command: str, tell: Callable[[str], None]) -> None:
    """Compiles what the command needs, where it has not been yet; tell is called with a line for each kernel."""
    ours, theirs = NEEDED[command]
    stamp = _stamp(command)
    if stamp.exists():
        return
    names = (*ours, *theirs)
    helper = subprocess.Popen([sys.executable, "-m", "sim.stage.warmup", ",".join(names), ",".join(theirs)], cwd=ROOT)
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


class _Still(Simulation):
    """A simulation that provides types, and runs nothing."""

    def _begin(self) -> None:
        self._use(None)

    def _publish_anew(self) -> None:
        pass

    def _plan(self) -> None:
        pass


def steps() -> dict[str, list[tuple[Any, tuple]]]:
    """Kernels by plain names, with arguments of the types that they are called with."""
    world = World("warm-up", (10.0, 10.0), start=(5.0, 5.0))
    sim = _Still(world, [load_character("bird")], Wander())
    crowd, bipeds, w, biped = sim.crowd, sim.bipeds, world.arrays, sim.bipeds[0]
    one, matrix, place = np.zeros(2, np.int64), np.zeros((2, 3)), (w, 0.0, 0.0)
    spots = search.Spots(matrix, one, matrix)
    return {
        "window solve": [(rounds.optimise_step, ())],
        "placing footprints": [(rounds.plan_step, ())],
        "wandering": [(Wander.planning.part, ())],
        "crossing": [(RockHop.planning.part, ())],
        "tick of the crowd": [(rounds.advance_all, (rounds.Parts(0, 0), 0, 0.0, one))],
        "poses": [
            (pose_one, ()),
            (posing.pose_rows, (0, 0, 0.0, one, empty_pose(1))),
            (posing.com_all, (0, 0.0, matrix)),
        ],
        "standing": [
            (crowds.stand, (crowd, bipeds, w, 0, 0, matrix, 0.0)),
            (rounds.publish_all, (0, one)),
        ],
        "ground": [
            (queries.rock_under, (*place, 0.0)),
            (queries.survey, (w, np.zeros((2, 2)), matrix)),
            *((kernel, place) for kernel in (queries.clearance, queries.terrain_height, queries.in_water)),
        ],
        "route search": [(search.find, (biped, spots, 0, 0))],
        "laying footprints": [(laying.lay_steps, (biped, w, empty(Footprints, 1), 0, matrix, np.zeros(1, STEP), 0.0, 0.0))],
        "whole curves": [(motion.solve_track, (biped, empty(Footprints, 1), 0.0, window.SCENE, newton.SCENE))],
    }


if __name__ == "__main__":
    every, some = (tuple(names.split(",")) for names in sys.argv[1:])
    _compile(every, some, lambda line: print(line, file=sys.stderr, flush=True))
