"""Nothing that is typed is ignored in silence, and what is misspelt is met with the nearest."""

import argparse
import json
import os
import subprocess
import sys
import threading

import pytest

import main
from sim.cli import parser
from worlds import reading
from worlds.errors import InputError


def refused(arguments, capsys):
    """What is said of a command line that is refused before anything is compiled."""
    assert main.main(arguments) == 2
    said = capsys.readouterr().err
    assert "Traceback" not in said
    return said


@pytest.fixture(scope="module")
def state(tmp_path_factory):
    path = str(tmp_path_factory.mktemp("state") / "s.npz")
    assert main.main(["wander", "--headless", "--seconds", "2", "--save", path, "--json"]) == 0
    return path


@pytest.mark.parametrize(
    "typed, said",
    [
        (["dense_forest"], "the level is Dense forest"),
        (["--character", "human"], "--character is human"),
        (["--characters", "3"], "--characters is 3"),
        (["--seed", "7"], "--seed is 7"),
    ],
)
def test_a_restored_state_is_what_is_asked_for(typed, said, state, capsys):
    told = refused(["wander", *typed, "--headless", "--seconds", "3", "--restore", state], capsys)
    assert said in told and state in told


def test_a_state_goes_on_by_its_own_command(state, capsys):
    assert "footfall wander --restore" in refused(["river", "--headless", "--restore", state], capsys)
    same = ["wander", "forest", "--character", "bird", "--characters", "1", "--seed", "0"]
    assert main.main([*same, "--headless", "--seconds", "4", "--restore", state, "--json"]) == 0
    restored = json.loads(capsys.readouterr().out)
    assert main.main([*same, "--headless", "--seconds", "4", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == restored  # steps and distance from the beginning


def test_what_a_scene_does_not_take(capsys):
    assert "one character" in refused(["play", "sprint", "--characters", "2", "--headless"], capsys)
    assert main.main(["play", "fig01_steps_and_a_hop", "--seed", "3", "--headless", "--seconds", "0.1", "--json"]) == 0
    assert "--seed 3" in capsys.readouterr().err


def test_a_film_in_a_window_is_refused(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr("sim.cli.show.has_display", lambda: True)
    assert "--headless" in refused(["wander", "--video", str(tmp_path / "v.mp4")], capsys)


@pytest.mark.parametrize(
    "typed, nearest",
    [
        (["rivr"], "river"),
        (["wander", "--recrod", "a"], "--record"),
        (["mesure", "a.npz"], "measure"),
        (["measure", "a.npz", "--headless"], None),  # others take it
    ],
)
def test_misspelt_commands_and_options(typed, nearest, capsys):
    with pytest.raises(SystemExit) as stop:
        parser.parsed(typed)
    said = capsys.readouterr().err
    assert stop.value.code == 2 and (f"did you mean {nearest}?" in said if nearest else "did you mean" not in said)


@pytest.mark.parametrize(
    "typed, nearest",
    [(["wander", "forrest"], "forest"), (["play", "sprnt"], "sprint"), (["wander", "--character", "burd"], "bird")],
)
def test_misspelt_names_before_anything_is_compiled(typed, nearest, capsys, monkeypatch):
    monkeypatch.setattr("sim.cli.show.warm_up", lambda *_: pytest.fail("compiles before it looks"))
    assert f"did you mean {nearest}?" in refused([*typed, "--headless"], capsys)


def test_a_missing_file_is_called_one(tmp_path, capsys):
    (tmp_path / "level.toml").write_text("")
    said = refused(["wander", str(tmp_path / "levle.toml"), "--headless"], capsys)
    assert "no such level file; did you mean level.toml?" in said


@pytest.mark.skipif(os.name != "posix", reason="pipes of POSIX")
def test_pipes_are_read_and_endless_ones_are_not(tmp_path, capsys, monkeypatch):
    text = 'format = 1\nname = "t"\n[world]\nsize = [20.0, 20.0]\n[start]\nposition = [5.0, 5.0]\n'
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    writer = threading.Thread(target=lambda: pipe.write_text(text))
    writer.start()
    assert main.main(["check", str(pipe)]) == 0
    writer.join()
    assert "bytes" in refused(["check", "/dev/zero"], capsys)
    os.mkfifo(tmp_path / "silent")
    monkeypatch.setattr(reading, "PATIENCE", 0.0)
    with pytest.raises(InputError, match="nothing has come"):
        reading.read_toml(tmp_path / "silent", "level", "")


def test_a_key_is_what_it_types():
    pygame = pytest.importorskip("pygame")
    from sim.view.window.window import typed

    german = argparse.Namespace(key=pygame.K_8, unicode="[")
    assert typed(german, pygame) == "["
    assert typed(argparse.Namespace(key=pygame.K_g, unicode="G"), pygame) == "g"
    assert typed(argparse.Namespace(key=pygame.K_SPACE, unicode=" "), pygame) == "space"
    assert typed(argparse.Namespace(key=pygame.K_LEFT, unicode=""), pygame) == "left"


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="displays of X")
def test_a_display_that_does_not_answer_is_said_and_the_run_headless(tmp_path):
    picture = tmp_path / "end.png"
    env = {name: value for name, value in os.environ.items() if name not in ("SDL_VIDEODRIVER", "WAYLAND_DISPLAY")}
    ran = subprocess.run(
        [sys.executable, str(main.HERE / "main.py"), "--seconds", "0.1", "--screenshot", str(picture), "--json"],
        cwd=tmp_path, capture_output=True, text=True, env=env | {"DISPLAY": ":4711"},
    )  # fmt: skip
    assert ran.returncode == 0 and "DISPLAY=:4711: no display answers there" in ran.stderr
    assert json.loads(ran.stdout)["seconds"] == pytest.approx(0.1) and picture.exists()
