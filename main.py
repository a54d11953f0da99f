"""Footfall: footprints in, living motion out. This file is the command line only: set up, parse, call."""

import argparse
import importlib.util
import os
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
VENV = HERE / ".venv"
NEEDED = ("numpy", "pygame", "moderngl", "numba", "imgui_bundle", "OpenGL", "pydantic", "PIL")
NEEDED_BY_TESTS = ("pytest", "hypothesis", "scipy", "mypy", "importlinter", "imageio_ffmpeg", "matplotlib")
DONE, BAD_INPUT, IMPOSSIBLE = 0, 2, 3


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; returns its exit status: 0 done, 2 bad usage or input, 3 the task itself cannot be done."""
    arguments = _with_default(sys.argv[1:] if arguments is None else arguments)
    if arguments[0] == "test":
        options = argparse.Namespace(command="test", arguments=arguments[1:])
    else:
        options = parser().parse_args(arguments)
    if sys.version_info < (3, 11):
        print("Footfall needs Python 3.11 or newer; this is", sys.version.split()[0], file=sys.stderr)
        return BAD_INPUT
    missing = _missing(options.command)
    if missing:
        return _run_in_own_environment(missing, arguments)
    if options.command == "test":
        return subprocess.call([sys.executable, "-m", "pytest", *options.arguments], cwd=HERE)
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    from sim.cli import commands

    return commands.run(options)


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    top = argparse.ArgumentParser(prog="python main.py", description=__doc__.split(" This file")[0])
    commands = top.add_subparsers(dest="command", metavar="COMMAND")
    wander = commands.add_parser("wander", help="wander through a forest (the default)")
    wander.add_argument("level", nargs="?", default="forest", help="a level that ships, or a .toml file")
    river = commands.add_parser("river", help="cross a river on its rocks")
    river.add_argument("level", nargs="?", default="river_easy", help="a level that ships, or a .toml file")
    play = commands.add_parser("play", help="play a scripted scene: footprints from a file")
    play.add_argument(
        "level", nargs="?", default="fig01_steps_and_a_hop", metavar="SCENE", help="a scene that ships, or a .toml file"
    )
    play.add_argument("--list", action="store_true", help="name the scenes that ship")
    for job in (wander, river, play):
        _common(job)
    for job in (wander, river):
        job.add_argument("--save", metavar="STATE.npz", help="the state at the end, to go on from")
        job.add_argument("--restore", metavar="STATE.npz", help="go on from a saved state; --seconds counts from its beginning")
    play.set_defaults(save=None, restore=None)
    play.set_defaults(character=None)
    sheets = commands.add_parser("sheets", help="draw a contact sheet of every scene")
    sheets.add_argument("scenes", nargs="*", metavar="SCENE", help="only these")
    sheets.add_argument("--folder", default="docs/scenes", help="where to write them")
    measure = commands.add_parser("measure", help="measure the quality of a recorded run")
    measure.add_argument("recording", metavar="RUN.npz")
    measure.add_argument("--json", action="store_true")
    measure.add_argument("--plot", metavar="OUT.png", help="draw com, costs, joints, stances over time (.png, .svg, .pdf)")
    measure.add_argument("--character-index", type=int, default=0, metavar="C", help="of the character to draw, from 0")
    measure.add_argument("--between", type=float, nargs=2, metavar=("T0", "T1"), help="draw only these seconds")
    timing = commands.add_parser("timing", help="the automatic timing over the step length")
    timing.add_argument("--character", help="bird, dinosaur, human, or a .toml file; without it every one that ships")
    timing.add_argument("--plot", metavar="OUT.png", help="draw it (.png, .svg, .pdf)")
    timing.add_argument("--json", action="store_true")
    literature = commands.add_parser("literature", help="compare the human, walking and running on the flat, with people")
    literature.add_argument("--json", action="store_true")
    check = commands.add_parser("check", help="check level, scene and character files; names every fault")
    check.add_argument("files", nargs="+", metavar="FILE")
    bench = commands.add_parser("bench", help="measure speed against other solvers")
    bench.add_argument("--json", action="store_true")
    bench.add_argument("--quick", action="store_true", help="fewer repetitions and smaller crowds")
    bench.add_argument("--plot", metavar="OUT.png", help="draw how crowds keep real time, and what a step costs")
    commands.add_parser("test", help="run the tests; further arguments go to pytest")
    return top


def _common(job: argparse.ArgumentParser) -> None:
    job.add_argument("--character", default="bird", help="bird, dinosaur, human, or a .toml file")
    job.add_argument("--characters", type=_positive, default=1, metavar="N", help="how many")
    job.add_argument("--seed", type=_seed, default=0)
    job.add_argument("--headless", action="store_true", help="no window")
    job.add_argument("--seconds", type=_seconds, metavar="T", help="simulated seconds, then end")
    job.add_argument("--record", metavar="RUN.npz")
    job.add_argument("--screenshot", metavar="P.png", help="a picture of the end")
    job.add_argument("--video", metavar="V.mp4", help="a film of the run")
    job.add_argument("--size", type=_size, default=(960, 540), metavar="WxH")
    job.add_argument("--json", action="store_true", help="print the run's summary as JSON")


def _with_default(arguments: list[str]) -> list[str]:
    """A command line that begins with an option is one of `wander`."""
    first = arguments[0] if arguments else ""
    return arguments if first and (first in ("-h", "--help") or not first.startswith("-")) else ["wander", *arguments]


def _positive(text: str) -> int:
    value = int(text)
    if not 1 <= value <= 100_000:
        raise argparse.ArgumentTypeError(f"{text}: 1 to 100000 is allowed")
    return value


def _seed(text: str) -> int:
    value = int(text)
    if not 0 <= value < 2**63:
        raise argparse.ArgumentTypeError(f"{text}: 0 or more, below 2^63, is allowed")
    return value


def _seconds(text: str) -> float:
    value = float(text)
    if not 0 < value <= 1e6:
        raise argparse.ArgumentTypeError(f"{text}: more than 0, at most 1000000 is allowed")
    return value


def _size(text: str) -> tuple[int, int]:
    width, _, height = text.lower().partition("x")
    if not (width.isdigit() and height.isdigit() and 64 <= int(width) <= 8192 and 64 <= int(height) <= 8192):
        raise argparse.ArgumentTypeError(f"{text}: WIDTHxHEIGHT in pixels, 64 to 8192 each, as in 960x540")
    return int(width), int(height)


def _missing(command: str) -> list[str]:
    needed = NEEDED + (NEEDED_BY_TESTS if command == "test" else ())
    return [name for name in needed if importlib.util.find_spec(name) is None]


def _run_in_own_environment(missing: list[str], arguments: list[str]) -> int:
    """Makes .venv where it is missing, installs what is pinned, and runs the same command in it."""
    python = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if Path(sys.prefix).resolve() == VENV.resolve():
        print(f"{VENV} lacks {', '.join(missing)}; remove that folder and run the command again", file=sys.stderr)
        return BAD_INPUT
    if not (VENV / "complete").exists() and _install(python) != DONE:
        return BAD_INPUT
    return subprocess.call([str(python), str(HERE / "main.py"), *arguments])


def _install(python: Path) -> int:
    print(f"Setting up: making {VENV} (once, a minute or two) ...", file=sys.stderr, flush=True)
    venv.create(VENV, with_pip=True, clear=True)
    print("Setting up: installing the pinned libraries ...", file=sys.stderr, flush=True)
    lock = str(HERE / "requirements.lock")
    install = [str(python), "-m", "pip", "install", "--require-hashes", "--disable-pip-version-check", "-q", "-r", lock]
    if subprocess.call(install) != DONE:
        print("Setting up failed: the libraries of requirements.lock could not be installed (see above)", file=sys.stderr)
        return BAD_INPUT
    (VENV / "complete").touch()
    print("Setting up: done.", file=sys.stderr, flush=True)
    return DONE


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
