"""Footfall: footprints in, living motion out. This file only sets up what the program needs, and calls it."""

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
DONE, BAD_INPUT = 0, 2


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; returns its exit status: 0 done, 2 bad usage or input, 3 the task itself cannot be done."""
    arguments = sys.argv[1:] if arguments is None else arguments
    if sys.version_info < (3, 11):
        print("Footfall needs Python 3.11 or newer; this is", sys.version.split()[0], file=sys.stderr)
        return BAD_INPUT
    from sim.cli import parser

    options = parser.parsed(arguments)
    missing = _missing(options.command)
    if missing:
        return _run_in_own_environment(missing, arguments)
    if options.command == "test":
        return subprocess.call([sys.executable, "-m", "pytest", *options.arguments], cwd=HERE)
    from sim.cli import entry

    return entry.run(options)


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
