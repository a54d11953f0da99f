"""kill -9 at moments by chance: old files stay whole, the next start works, nothing is left: python -m tests.kills N [FIRST]

Runs are killed that record, save, film, compile (into a copy of the cache from which something is missing) and set up (all but
the download). Case k is of kind k modulo their number; when exactly it is killed depends on the machine.
"""

import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from sim.files.recording import load_recording
from sim.files.saving import restore
from worlds.compiled import cache

ROOT = Path(__file__).resolve().parents[1]
RUN = (sys.executable, str(ROOT / "main.py"), "wander", "--headless", "--characters", "8", "--seconds", "12")
SETS_UP = """
import sys
from pathlib import Path
import main
main.VENV = Path(sys.argv[1])
main._install = lambda python, locks: 0
sys.exit(main._make(main.VENV / "bin" / "python", []))
"""


class Kind(NamedTuple):
    """A command that is killed."""

    command: tuple[str, ...]
    made: str  # what it leaves
    check: Callable[[Path], object]  # raises where that is not whole
    spoil: Callable[[Path], None] = lambda folder: None  # before each start: what there is to be made


def _plays(path: Path) -> None:
    """Whether a film is whole."""
    import imageio_ffmpeg

    read = [imageio_ffmpeg.get_ffmpeg_exe(), "-v", "error", "-xerror", "-i", str(path), "-f", "null", "-"]
    subprocess.run(read, check=True, capture_output=True)


def _forget_some(folder: Path) -> None:
    """Puts a copy of the compiled kernels into the folder, without some small ones."""
    kept = Path(os.environ.get("NUMBA_CACHE_DIR") or cache.ROOT / ".numba_cache" / cache.source_key())
    shutil.rmtree(folder / "cache", ignore_errors=True)
    shutil.copytree(kept, folder / "cache")
    for path in (*(folder / "cache").rglob("queries.*"), *(folder / "cache").rglob("warm-*")):
        path.unlink()


def _compiled(folder: Path) -> None:
    """Whether every file of a cache is what was put into it."""
    import hashlib

    for path in folder.rglob("*.nb[ci]"):
        data = path.read_bytes()
        assert hashlib.sha256(data[32:]).digest() == data[:32], path


KINDS = {
    "record": Kind((*RUN, "--record", "run.npz"), "run.npz", load_recording),
    "save": Kind((*RUN, "--save", "state.npz"), "state.npz", restore),
    "film": Kind((*RUN[:-1], "2", "--size", "160x90", "--video", "film.mp4"), "film.mp4", _plays),
    "compile": Kind((*RUN[:-1], "1"), "cache", _compiled, _forget_some),
    "set up": Kind((sys.executable, "-c", SETS_UP, ".venv"), ".venv", lambda path: (path / "complete").stat()),
}


def _start(kind: Kind, folder: Path) -> subprocess.Popen:
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    if kind.made == "cache":
        environment["NUMBA_CACHE_DIR"] = str(folder / "cache")
    return subprocess.Popen(
        kind.command, cwd=folder, env=environment, start_new_session=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
    )


def _whole(kind: Kind, folder: Path) -> float:
    """Runs to the end; returns how long that took [s]. Raises where it fails, or leaves something."""
    begin = time.monotonic()
    process = _start(kind, folder)
    _, said = process.communicate(timeout=600)
    assert process.returncode == 0, said.decode()
    kind.check(folder / kind.made)
    left = [path.name for path in folder.iterdir() if path.name.endswith(".part")]
    assert not left, left
    return time.monotonic() - begin


def killed(name: str, folder: Path, times: int, chance: random.Random) -> None:
    """Kills runs of a kind so many times. Raises where something is lost, or does not work afterwards."""
    kind = KINDS[name]
    kind.spoil(folder)
    lasts = _whole(kind, folder)
    for _ in range(times):
        kind.spoil(folder)
        old = (folder / kind.made).read_bytes() if (folder / kind.made).is_file() else None
        process = _start(kind, folder)
        time.sleep(chance.uniform(0.0, 1.1 * lasts))
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        if old is not None and (folder / kind.made).read_bytes() != old:
            kind.check(folder / kind.made)
        _whole(kind, folder)


def main(arguments: list[str]) -> int:
    """N kills, shared among the kinds; tells what fails."""
    count, first, faults = int(arguments[0]), int(arguments[1]) if len(arguments) > 1 else 0, 0
    for k, name in enumerate(KINDS):
        times = len(range(k, count, len(KINDS)))
        with tempfile.TemporaryDirectory(prefix="footfall-kills-") as folder:
            try:
                killed(name, Path(folder), times, random.Random(first + k))
                print(f"{name}: {times} kills, everything whole afterwards", flush=True)
            except Exception as error:
                faults += 1
                print(f"{name}: {type(error).__name__}: {error}", flush=True)
    print(f"{faults} of {len(KINDS)} kinds failed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
