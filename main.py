"""Footfall: footprints in, living motion out. This file only sets up what the program needs, and calls it."""

import importlib.util
import os
import platform
import shutil
import subprocess
import sys
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
VENV = HERE / ".venv"
LOCKS = {
    "requirements": ("numpy", "pygame", "moderngl", "numba", "imgui_bundle", "OpenGL", "pydantic", "PIL", "tomlkit"),
    "requirements-video": ("imageio_ffmpeg",),
    "requirements-plots": ("matplotlib",),
    "requirements-test": ("pytest", "hypothesis", "scipy", "mypy", "importlinter", "ruff", "gymnasium", "pettingzoo"),
}
"""What is pinned where, and what of it is imported: the first is needed always, the others by some commands."""
STARTED, COMPLETE = "footfall", "complete"
"""Marks in a .venv that we have made: that it is ours, and that everything is in it."""
PYTHONS = ((3, 11), (3, 14))
MACHINES = {("Linux", "x86_64"), ("Linux", "aarch64"), ("Windows", "AMD64"), ("Darwin", "arm64")}
DONE, BAD_INPUT = 0, 2


def main(arguments: list[str] | None = None) -> int:
    """Runs one command; returns its exit status: 0 done, 2 bad usage or input, 3 the task itself cannot be done."""
    arguments = sys.argv[1:] if arguments is None else arguments
    if sys.version_info < (3, 11):
        return _refused(f"Footfall needs Python 3.11 or newer; this is {sys.version.split()[0]}")
    from sim.cli import parser
    from sim.cli.status import refuse_words

    try:
        options = parser.parsed(arguments)
    except OSError as error:
        return refuse_words(error)
    locks = _locks(options)
    missing = _missing(locks)
    if missing and not _is_ours():
        if options.command == "test" or _missing(locks[:1]):
            return _run_in_own_environment(locks, arguments)
    elif missing and _install(Path(sys.executable), locks) != DONE:
        return BAD_INPUT
    if options.command == "test":
        return _hand_over([sys.executable, "-m", "pytest", *options.arguments], HERE)
    from sim.cli import entry

    return entry.run(options)


def _locks(options: object) -> list[str]:
    """The locks that a command needs."""
    base, video, plots, test = LOCKS
    command = getattr(options, "command", None)
    if command == "test":
        return [base, video, plots, test]
    figures = "pictures" if command == "verify" else "plot"
    return [base] + [lock for lock, asks in ((video, "video"), (plots, figures)) if getattr(options, asks, None)]


def _missing(locks: list[str]) -> list[str]:
    return [name for lock in locks for name in LOCKS[lock] if importlib.util.find_spec(name) is None]


def _is_ours() -> bool:
    """Whether this runs in the .venv that we have made."""
    return Path(sys.prefix).resolve() == VENV.resolve() and (VENV / COMPLETE).exists()


def _run_in_own_environment(locks: list[str], arguments: list[str]) -> int:
    """Makes .venv where it is missing, installs what is pinned, and runs the same command in it."""
    python = VENV / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if not (VENV / COMPLETE).exists() or not python.exists():
        fault = _fault_of_machine() or _fault_of_folder(python)
        if fault:
            return _refused(fault)
        if _make(python, locks) != DONE:
            return BAD_INPUT
    return _hand_over([str(python), str(HERE / "main.py"), *arguments], None)


def _fault_of_machine() -> str | None:
    """Why the pinned libraries cannot be installed here, or None."""
    version, machine = sys.version_info[:2], (platform.system(), platform.machine())
    if PYTHONS[0] <= version <= PYTHONS[1] and sys.implementation.name == "cpython" and machine in MACHINES:
        return None
    return (
        "Footfall's libraries are pinned for CPython 3.11 to 3.14 on Linux (x86-64, arm64), Windows (x86-64) and Macs with "
        f"Apple silicon; this is {platform.python_implementation()} {platform.python_version()} on {' '.join(machine)}. "
        "Call main.py with such a Python, or install what you have: pip install ."
    )


def _fault_of_folder(python: Path) -> str | None:
    """Why .venv must not be made anew, or None: it is somebody else's."""
    if not VENV.exists() or (VENV / STARTED).exists() or (VENV / COMPLETE).exists() or not any(VENV.iterdir()):
        return None
    return (
        f"{VENV} is there, but Footfall has not made it, so it is left alone. To use it: {python} -m pip install -r "
        f"{HERE / 'requirements.lock'}, then {python} main.py. To have one made: move it away"
    )


def _make(python: Path, locks: list[str]) -> int:
    """Makes .venv, anew where somebody has stopped us half-way, and installs the locks."""
    if VENV.exists():
        _say(f"Setting up: {VENV} is incomplete; making it anew.")
    _say(f"Setting up: making {VENV} (once, a minute or two) ...")
    try:
        shutil.rmtree(VENV, ignore_errors=True)
        VENV.mkdir(exist_ok=True)
        (VENV / STARTED).touch()
        venv.create(VENV, with_pip=True)
    except (OSError, subprocess.CalledProcessError) as error:
        return _refused(f"Setting up failed: {VENV} could not be made: {error} (Debian, Ubuntu: apt-get install python3-venv)")
    if _install(python, locks) != DONE:
        return BAD_INPUT
    (VENV / COMPLETE).touch()
    _say("Setting up: done.")
    return DONE


def _install(python: Path, locks: list[str]) -> int:
    _say(f"Setting up: installing what {', '.join(f'{lock}.lock' for lock in locks)} pins ...")
    files = [word for lock in locks for word in ("-r", str(HERE / f"{lock}.lock"))]
    install = [str(python), "-m", "pip", "install", "--require-hashes", "--disable-pip-version-check", "--progress-bar", "off"]
    if subprocess.call([*install, *files], stdout=2) != DONE:  # its words are no result: not to stdout
        return _refused("Setting up failed: the pinned libraries could not be installed (see above)")
    importlib.invalidate_caches()
    return DONE


def _hand_over(command: list[str], folder: Path | None) -> int:
    """Goes on as another program, which signals then reach; where that cannot be, as Windows has it, waits for it."""
    if folder is not None:
        os.chdir(folder)
    sys.stderr.flush()
    if os.name == "posix":
        os.execv(command[0], command)
    return subprocess.call(command)


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def _refused(text: str) -> int:
    _say(text)
    return BAD_INPUT


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
