"""The first start: kernels are compiled one after the other, by plain names, by two processes side by side.

Compiled kernels are kept (worlds.compiled.cache), so this happens once for these sources, this numba and this processor. They
are compiled for the types of their arguments, which a small cast provides; nothing is run. Whoever is free takes the next one,
those that take longest first. One who walks alone needs no way around others.
"""

import os
import subprocess
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import llvmlite.binding
import numba

from worlds.compiled import leaving
from worlds.compiled.jit import start_threads
from worlds.compiled.telling import be_quiet, compiling

ROOT = Path(__file__).resolve().parents[2]
OTHERS = "going around others"
WALK, SHOWN = ("window solve", "poses", "placing footprints"), ("tick of the crowd", "bones", "standing", "ground")
NEEDED = {
    "wander": (*WALK, "wandering", *SHOWN),
    "wander of many": (*WALK, OTHERS, "wandering", *SHOWN),
    "steer": (*WALK, "steering", *SHOWN),
    "steer of many": (*WALK, OTHERS, "steering", *SHOWN),
    "river": (*WALK, "crossing", "route search", *SHOWN),
    "river of many": (*WALK, OTHERS, "crossing", "route search", *SHOWN),
    "crowd": (*WALK, OTHERS, "visiting", "ways", *SHOWN, "speeds of people"),
    "import-trajectories": ("whole curves", "poses", "laying footprints", "stride law", *SHOWN[1:]),
    "play": ("whole curves", "poses", "laying footprints", *SHOWN[1:]),
    "edit": ("whole curves", "edited curves", "poses", "laying footprints", *SHOWN[1:]),
}
"""What a command needs, in the order in which it is begun."""


def warm_up(command: str, tell: Callable[[str], None], characters: int = 1) -> None:
    """Compiles what the command needs, where it has not been yet; tell is called with a line for each kernel."""
    if characters > 1 and f"{command} of many" in NEEDED:
        command = f"{command} of many"
    stamp = _stamp(command)
    if stamp is None or stamp.exists():
        return
    start_threads()  # before there are two who would complain
    names = NEEDED[command]
    untaken = iter(names)  # each name goes to one of the two
    helper = subprocess.Popen(
        [sys.executable, "-m", "sim.stage.warmup"],
        cwd=ROOT,
        start_new_session=os.name == "posix",  # Ctrl-C is ours: we end it
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    leaving.remember(helper, helper.terminate)
    giver = threading.Thread(target=_give, args=(helper, untaken), daemon=True)
    try:
        giver.start()
        with compiling():
            _compile(untaken, lambda name: tell(f"compiling {names.index(name) + 1} of {len(names)}: {name} ..."))
            helper.wait()
    finally:
        if helper.poll() is None:
            helper.terminate()
        leaving.forget(helper)
    if stamp.parent.is_dir():
        stamp.touch()


def _give(helper: Any, untaken: Iterator[str]) -> None:
    """Gives the helper a name whenever it asks for one, by a line, until none is left."""
    with suppress(OSError, ValueError), helper.stdin:  # it may have been ended
        for _ in helper.stdout:
            name = next(untaken, None)
            if name is None:
                return
            print(name, file=helper.stdin, flush=True)


def _given() -> Iterator[str]:
    """The names that we are given, each asked for once the one before is done."""
    while True:
        print(flush=True)
        name = sys.stdin.readline().strip()
        if not name:
            return
        yield name


def _stamp(command: str) -> Path | None:
    """A file that is there once the command's kernels lie in the cache; None where nothing is kept."""
    if "NUMBA_CACHE_DIR" not in os.environ:
        return None
    made_for = f"{numba.__version__}-{llvmlite.binding.get_host_cpu_name()}-{sys.version_info.major}{sys.version_info.minor}"
    return Path(os.environ["NUMBA_CACHE_DIR"]) / f"warm-{command.replace(' ', '-')}-{made_for}"


def _compile(names: Iterable[str], tell: Callable[[str], None]) -> None:
    from sim.stage.kernels import steps

    kernels = steps()
    for name in names:
        tell(name)
        for kernel, arguments in kernels[name]:
            kernel.compile(tuple(numba.typeof(one) for one in arguments))


if __name__ == "__main__":
    be_quiet()
    _compile(_given(), lambda name: None)
