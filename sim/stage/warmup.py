"""The first start: kernels are compiled one after the other, by plain names, and half of them in a second process.

Compiled kernels are kept (worlds.compiled.cache), so this happens once for these sources, this numba and this processor. They
are compiled for the types of their arguments, which a small cast provides; nothing is run. Half of them are compiled by a
second process meanwhile. The solver takes as long as all the others together; one who walks alone needs no way around others.
"""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import llvmlite.binding
import numba

from worlds.compiled import leaving
from worlds.compiled.jit import start_threads
from worlds.compiled.telling import be_quiet, compiling, tell

ROOT = Path(__file__).resolve().parents[2]
SOLVE, OTHERS = "window solve", "going around others"
WALK, SHOWN = ("placing footprints", "tick of the crowd"), ("poses", "bones", "standing", "ground")
NEEDED = {
    "wander": ((SOLVE,), (*WALK, "wandering", *SHOWN)),
    "wander of many": ((SOLVE,), (*WALK, "wandering", *SHOWN, OTHERS)),
    "steer": ((SOLVE,), (*WALK, "steering", *SHOWN)),
    "steer of many": ((SOLVE,), (*WALK, "steering", *SHOWN, OTHERS)),
    "river": ((SOLVE, "route search"), (*WALK, "crossing", *SHOWN)),
    "river of many": ((SOLVE, "route search"), (*WALK, "crossing", *SHOWN, OTHERS)),
    "crowd": ((SOLVE,), (*WALK, "visiting", "ways", "speeds of people", *SHOWN, OTHERS)),
    "import-trajectories": (("whole curves", "stride law"), ("laying footprints", *SHOWN)),
    "play": (("whole curves",), ("laying footprints", *SHOWN)),
    "edit": (("whole curves", "edited curves"), ("laying footprints", *SHOWN)),
}
"""What a command needs: (compiled here, by the second process)."""


def warm_up(command: str, tell: Callable[[str], None], characters: int = 1) -> None:
    """Compiles what the command needs, where it has not been yet; tell is called with a line for each kernel."""
    if characters > 1 and f"{command} of many" in NEEDED:
        command = f"{command} of many"
    ours, theirs = NEEDED[command]
    stamp = _stamp(command)
    if stamp is None or stamp.exists():
        return
    start_threads()  # before there are two who would complain
    names = (*ours, *theirs)
    helper = subprocess.Popen(
        [sys.executable, "-m", "sim.stage.warmup", ",".join(names), ",".join(theirs)],
        cwd=ROOT,
        start_new_session=os.name == "posix",  # Ctrl-C is ours: we end it
    )
    leaving.remember(helper, helper.terminate)
    try:
        with compiling():
            _compile(names, ours, tell)
            helper.wait()
    finally:
        if helper.poll() is None:
            helper.terminate()
        leaving.forget(helper)
    if stamp.parent.is_dir():
        stamp.touch()


def _stamp(command: str) -> Path | None:
    """A file that is there once the command's kernels lie in the cache; None where nothing is kept."""
    if "NUMBA_CACHE_DIR" not in os.environ:
        return None
    made_for = f"{numba.__version__}-{llvmlite.binding.get_host_cpu_name()}-{sys.version_info.major}{sys.version_info.minor}"
    return Path(os.environ["NUMBA_CACHE_DIR"]) / f"warm-{command.replace(' ', '-')}-{made_for}"


def _compile(names: tuple[str, ...], mine: tuple[str, ...], tell: Callable[[str], None]) -> None:
    from sim.stage.kernels import steps

    kernels = steps()
    for name in mine:
        tell(f"compiling {names.index(name) + 1} of {len(names)}: {name} ...")
        for kernel, arguments in kernels[name]:
            kernel.compile(tuple(numba.typeof(one) for one in arguments))


if __name__ == "__main__":
    be_quiet()
    every, some = (tuple(names.split(",")) for names in sys.argv[1:])
    _compile(every, some, tell)
