"""Setting up: what is installed, where, and what is left alone."""

import argparse
import re
import sys

import pytest

import main


@pytest.fixture
def folder(monkeypatch, tmp_path):
    """No library is there; what would be run is noted instead."""
    monkeypatch.setattr(main, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(main, "_missing", lambda locks: ["numpy"])
    made = argparse.Namespace(venv=tmp_path / ".venv", installed=[], ran=[], status=0)

    def create(venv, with_pip):
        (venv / "bin").mkdir()
        (venv / "bin" / "python").touch()

    def call(command, **_):
        made.installed.append([word for word in command if word.endswith(".lock")])
        return made.status

    monkeypatch.setattr(main.venv, "create", create)
    monkeypatch.setattr(main.subprocess, "call", call)
    monkeypatch.setattr(main.os, "name", "posix")
    monkeypatch.setattr(main, "_hand_over", lambda command, folder: made.ran.append(command) or 0)
    monkeypatch.setattr(main, "_fault_of_machine", lambda: None)
    return made


def locks(made):
    return [[path.rsplit("/", 1)[-1] for path in paths] for paths in made.installed]


def test_the_first_call_makes_an_environment_and_goes_on_in_it(folder):
    assert main.main(["--headless"]) == 0
    assert locks(folder) == [["requirements.lock"]] and (folder.venv / main.COMPLETE).exists()
    assert folder.ran == [[str(folder.venv / "bin" / "python"), str(main.HERE / "main.py"), "--headless"]]
    assert main.main(["--headless"]) == 0
    assert len(folder.installed) == 1 and len(folder.ran) == 2


def test_a_half_made_environment_is_made_anew(folder, capsys):
    folder.status = 1
    assert main.main(["--headless"]) == 2 and folder.ran == []
    (folder.venv / "half").touch()
    folder.status = 0
    assert main.main(["--headless"]) == 0
    assert "anew" in capsys.readouterr().err and not (folder.venv / "half").exists()


def test_an_environment_of_somebody_else_is_left_alone(folder, capsys):
    folder.venv.mkdir()
    (folder.venv / "mine").touch()
    assert main.main(["--headless"]) == 2
    said = capsys.readouterr().err
    assert str(folder.venv) in said and "left alone" in said and "pip install" in said
    assert [path.name for path in folder.venv.iterdir()] == ["mine"] and folder.installed == []


@pytest.mark.parametrize(
    "arguments, needs",
    [
        (["river", "--headless"], ["requirements"]),
        (["--video", "a.mp4"], ["requirements", "requirements-video"]),
        (["export", "a.npz", "b.mp4"], ["requirements", "requirements-video"]),
        (["export", "a.npz", "b.glb"], ["requirements"]),
        (["timing", "--plot", "a.png"], ["requirements", "requirements-plots"]),
        (["verify", "--pictures", "folder"], ["requirements", "requirements-plots"]),
        (["test", "-q"], list(main.LOCKS)),
    ],
)
def test_a_command_needs_its_own_locks(arguments, needs):
    from sim.cli import parser

    assert main._locks(parser.parsed(arguments)) == needs


def test_what_an_extra_lacks_is_installed_into_ours_alone(folder, monkeypatch):
    monkeypatch.setattr(main, "_missing", lambda locks: ["matplotlib"] if "requirements-plots" in locks else [])
    monkeypatch.setattr("sim.cli.entry.run", lambda options: 0)
    assert main.main(["timing", "--plot", "a.png"]) == 0 and folder.installed == []
    monkeypatch.setattr(main, "_is_ours", lambda: True)
    assert main.main(["timing", "--plot", "a.png"]) == 0
    assert locks(folder) == [["requirements.lock", "requirements-plots.lock"]]


@pytest.mark.parametrize(
    "version, system, machine, runs",
    [
        ((3, 11), "Linux", "x86_64", True),
        ((3, 14), "Darwin", "arm64", True),
        ((3, 15), "Linux", "x86_64", False),
        ((3, 12), "Darwin", "x86_64", False),
        ((3, 12), "Linux", "riscv64", False),
    ],
)
def test_where_the_pinned_libraries_do_not_run(version, system, machine, runs, monkeypatch):
    monkeypatch.setattr(main.sys, "version_info", (*version, 0))
    monkeypatch.setattr(main.platform, "system", lambda: system)
    monkeypatch.setattr(main.platform, "machine", lambda: machine)
    fault = main._fault_of_machine()
    assert fault is None if runs else "3.11 to 3.14" in fault


def test_everything_is_pinned_once_and_users_need_no_tests():
    pinned = {lock: re.findall(r"^([a-z0-9-]+)==", (main.HERE / f"{lock}.lock").read_text(), re.M) for lock in main.LOCKS}
    every = [name for names in pinned.values() for name in names]
    assert len(every) == len(set(every))
    assert not {"pytest", "matplotlib", "mypy", "scipy", "imageio-ffmpeg"} & set(pinned["requirements"])
    assert main._missing(list(main.LOCKS)) == [] and sys.version_info >= (3, 11)
