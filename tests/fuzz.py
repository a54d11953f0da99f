"""Files changed by chance: each is done or refused, whatever it holds. A large run: python -m tests.fuzz N [FIRST]

Levels, scenes, characters, saved states and recordings (with right digests) are changed and used as a command uses them. A
second process does it, so that a crash or a hang is found and told; case k is the same on every machine.
"""

import json
import queue
import random
import re
import subprocess
import sys
import tempfile
import threading
import traceback
from collections.abc import Callable, Iterable
from functools import cache
from pathlib import Path

import numpy as np

from motion.characters.character import CHARACTERS
from planner.planner import NoWay
from planner.script.scene import SCENES, load_scene
from sim.files import saving
from sim.files.recording import Recorder, load_recording
from sim.reports.measure import measure
from sim.stage.making import make_simulation
from sim.stage.scripted.performance import Performance
from worlds.errors import InputError
from worlds.level import LEVELS

HANGS, BEGINS = 30.0, 300.0
"""A case that takes longer [s] hangs; the first one may compile kernels."""
NASTY = ("nan",
          "inf", "-inf", "0", "-1", "1", "1e308", "-1e308", "1e-300", "1e9", "0.1", "3", "100", "true", '"x"', "[]", "[1, 2]",
         "[[1, 2]]", "{}", "9" * 40, "1e155", '"' + "y" * 300 + '"')  # fmt: skip
NUMBERS = (np.nan, np.inf, -np.inf, 0.0, -1.0, 1e308, 1e-300, 1e155, 1e9, 7.0, 0.5)
PLAIN = (None, True, -1, 0, 1, 2**70, 1.5, float("nan"), float("inf"), 1e308, "x", [], [1], {}, {"a": 1}, [[]])
Chance = random.Random


def changed_text(text: str, chance: Chance) -> str:
    """A TOML text with one to three things changed."""
    for _ in range(chance.randint(1, 3)):
        kind, lines = chance.random(), text.splitlines()
        if kind < 0.7:
            found = list(re.finditer(r"-?\d+\.?\d*", text))
            at = chance.choice(found)
            new = chance.choice(NASTY) if chance.random() < 0.6 else f"{float(at[0]) * chance.choice((0.1, 0.5, 2, 10, -1)):g}"
            text = text[: at.start()] + new + text[at.end() :]
        elif kind < 0.8:
            lines.pop(chance.randrange(len(lines)))
            text = "\n".join(lines)
        elif kind < 0.9:
            lines.insert(chance.randrange(len(lines)), chance.choice(lines))
            text = "\n".join(lines)
        else:
            at = chance.randrange(len(text))
            text = text[:at] + chr(chance.randrange(1, 300)) + text[at + 1 :]
    return text


def changed_arrays(arrays: dict, chance: Chance) -> dict:
    """Arrays with one of them changed: a value, a shape, a type, or gone."""
    name = chance.choice(sorted(arrays))
    array, kind = arrays[name].copy(), chance.random()
    if kind < 0.7 and array.size and array.dtype.kind in "ifb":
        value = chance.choice(NUMBERS) if array.dtype.kind == "f" else chance.choice((-1, 0, 1, 2, 9, 10**6, -(2**62)))
        array.flat[chance.randrange(array.size)] = value
    elif kind < 0.8:
        array = array[..., :1] if array.ndim else np.zeros(3)
    elif kind < 0.9:
        array = array.astype(np.float32 if array.dtype.kind in "fi" else np.int64) if array.dtype.kind in "fib" else array[:0]
    else:
        return {key: value for key, value in arrays.items() if key != name}
    return arrays | {name: array}


def changed_plain(plain: object, chance: Chance) -> object:
    """JSON values with one of them changed, somewhere."""
    if isinstance(plain, dict) and plain and chance.random() < 0.9:
        key = chance.choice(sorted(plain))
        return plain | {key: changed_plain(plain[key], chance)}
    if isinstance(plain, list) and plain and chance.random() < 0.8:
        at = chance.randrange(len(plain))
        return [*plain[:at], changed_plain(plain[at], chance), *plain[at + 1 :]]
    return chance.choice(PLAIN)


def _text_of(folder: Path, place: Path, chance: Chance) -> Path:
    """A file of a folder that ships, changed."""
    source = chance.choice(sorted(folder.glob("*.toml")))
    (place / "file.toml").write_text(changed_text(source.read_text("utf-8"), chance), "utf-8")
    return place / "file.toml"


def _ticked(sim: object, ticks: int) -> None:
    for _ in range(ticks):
        sim.tick()  # type: ignore[attr-defined]
    assert np.isfinite(sim.snapshot().com).all(), "a body is nowhere"  # type: ignore[attr-defined]


def level(place: Path, chance: Chance) -> None:
    """A changed level, wandered or crossed."""
    path, who = _text_of(LEVELS, place, chance), chance.choice(("bird", "human", "dinosaur"))
    _ticked(make_simulation(path, who, chance.choice((1, 1, 7)), chance.randrange(99), chance.random() < 0.4), 200)


def scene(place: Path, chance: Chance) -> None:
    """A changed scene, played."""
    show = Performance(load_scene(_text_of(SCENES, place, chance)))
    for share in np.linspace(0, 1, 5):
        assert np.isfinite(show.snapshot(show.end * share).com).all(), "a body is nowhere"


def character(place: Path, chance: Chance) -> None:
    """A changed character, wandering."""
    _ticked(make_simulation("forest", _text_of(CHARACTERS, place, chance), 1, 1, False), 300)


@cache
def _kept(kind: str) -> tuple[dict, dict]:
    """(arrays, meta) of a saved state or a recording."""
    with tempfile.TemporaryDirectory() as folder:
        sim = make_simulation("forest", "bird", 3, 1, False) if kind != "river" else make_simulation(
            "river_easy", "human", 1, 0, True)  # fmt: skip
        recorder = Recorder(sim)
        for _ in range(120):
            sim.tick()
            recorder.capture()
        path = Path(folder) / "file.npz"
        recorder.save(path) if kind == "run" else saving.save(sim, path)
        with np.load(path) as file:
            arrays = {name: file[name] for name in file.files}
    return arrays, json.loads(str(arrays.pop("meta")))


def _changed_archive(kind: str, place: Path, chance: Chance) -> Path:
    arrays, meta = _kept(kind)
    if chance.random() < 0.6:
        arrays = changed_arrays(arrays, chance)
    else:
        key = chance.choice([key for key in sorted(meta) if key not in ("format", "version")])
        meta = meta | {key: changed_plain(meta[key], chance)}
    if "digest" in meta:
        meta = meta | {"digest": saving._digest(arrays, {k: v for k, v in meta.items() if k != "digest"})}
    path = place / "file.npz"
    np.savez(path, allow_pickle=False, **arrays, meta=np.array(json.dumps(meta)))
    if chance.random() < 0.1:
        raw = bytearray(path.read_bytes())
        raw[chance.randrange(len(raw))] ^= 1 << chance.randrange(8)
        path.write_bytes(raw)
    return path


def state(place: Path, chance: Chance) -> None:
    """A changed state, gone on from."""
    _ticked(saving.restore(_changed_archive(chance.choice(("state", "river")), place, chance)), 120)


def run(place: Path, chance: Chance) -> None:
    """A changed recording, measured."""
    json.dumps(measure(load_recording(_changed_archive("run", place, chance))))


KINDS: tuple[Callable[[Path, Chance], None], ...] = (level, scene, character, state, run)


def case(k: int, place: Path) -> str:
    """What became of case k: done, refused, or a traceback."""
    kind = KINDS[k % len(KINDS)]
    try:
        kind(place, Chance(k))
    except (InputError, NoWay):
        return "refused"
    except Exception:
        return traceback.format_exc()
    return "done"


def _work(first: int, last: int) -> None:
    """Does cases in this process, telling each as a line of JSON."""
    with tempfile.TemporaryDirectory() as folder:
        for k in range(first, last):
            print(json.dumps([k, case(k, Path(folder))]), flush=True)


def _hand_on(lines: Iterable[bytes], told: queue.Queue) -> None:
    for line in lines:
        told.put(line)
    told.put(b"")


def _watched(first: int, last: int) -> dict[int, str]:
    """The cases that failed, done in other processes, each of which goes on behind the one that it died of."""
    failed: dict[int, str] = {}
    while first < last:
        worker = subprocess.Popen([sys.executable, "-m", "tests.fuzz", "--work", str(first), str(last)], stdout=subprocess.PIPE)
        told: queue.Queue = queue.Queue()
        threading.Thread(target=_hand_on, args=(worker.stdout, told), daemon=True).start()
        patience = BEGINS
        while first < last:
            try:
                line = told.get(timeout=patience)
            except queue.Empty:
                line = None
            if not line:
                worker.kill()
                failed[first] = "hangs" if line is None else f"killed: status {worker.wait()}"
                first += 1
                break
            k, said = json.loads(line)
            if said not in ("done", "refused"):
                failed[k] = said
            first, patience = k + 1, HANGS
    return failed


def main(arguments: list[str]) -> int:
    """N cases from FIRST on; tells those that fail."""
    if arguments[0] == "--work":
        _work(int(arguments[1]), int(arguments[2]))
        return 0
    first = int(arguments[1]) if len(arguments) > 1 else 0
    failed = _watched(first, first + int(arguments[0]))
    for k, said in failed.items():
        print(f"case {k} ({KINDS[k % len(KINDS)].__name__}): {said}")
    print(f"{len(failed)} of {arguments[0]} cases failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
