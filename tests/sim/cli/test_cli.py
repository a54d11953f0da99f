"""The command line: statuses and messages for what people hand in."""

import json

import numpy as np
import pytest
from PIL import Image

import main

GOOD = 'format = 1\nname = "t"\n[world]\nsize = [20.0, 20.0]\n[start]\nposition = [5.0, 5.0]\n'
BAD = {
    "unknown key": (GOOD + "[wrold]\nx = 1\n", "wrold"),
    "wrong type": (GOOD.replace("[20.0, 20.0]", '"big"'), "world.size"),
    "negative radius": (GOOD + "[[rock]]\nposition = [8.0, 8.0]\nradius = -1.0\n", "rock.0.radius"),
    "start in tree": (GOOD + "[[tree]]\nposition = [5.0, 5.0]\nradius = 0.5\n", "inside a tree"),
    "start in water": (GOOD + "[[river]]\npoints = [[5.0, 0.0], [5.0, 20.0]]\nwidth = 3.0\n", "in water"),
    "goal outside": (GOOD + "[goal]\nposition = [25.0, 5.0]\n", "outside the world"),
    "not toml": ("format = = 1", "TOML"),
    "empty": ("", "is empty"),
    "infinite": (GOOD.replace("5.0, 5.0", "nan, 5.0"), "start.position"),
    "no heightmap": (GOOD.replace("[start]", 'terrain = "heightmap"\n[world.heightmap]\nfile = "no.png"\n[start]'), "no.png"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_level_is_refused_with_its_fault(case, tmp_path, capsys):
    text, said = BAD[case]
    path = tmp_path / "level.toml"
    path.write_text(text)
    assert main.main(["wander", str(path), "--headless", "--seconds", "0.1"]) == 2
    message = capsys.readouterr().err
    assert said in message and str(path) in message and "Traceback" not in message


def test_every_fault_is_told_at_once(tmp_path, capsys):
    path = tmp_path / "level.toml"
    path.write_text(GOOD + "bogus = 1\n[[tree]]\nposition = [1.0, 1.0]\nradius = -2.0\n[goal]\nposition = [1.0]\n")
    assert main.main(["check", str(path)]) == 2
    message = capsys.readouterr().err
    assert all(part in message for part in ("start.bogus", "tree.0.radius", "goal.position"))


def test_starts_and_goals_are_judged_with_the_body(tmp_path, capsys):
    path = tmp_path / "level.toml"
    path.write_text(GOOD + "[goal]\nposition = [15.0, 5.0]\n[[tree]]\nposition = [15.0, 5.35]\nradius = 0.3\n")
    assert main.main(["check", str(path)]) == 2
    assert "goal.position: no character that ships can stand there" in capsys.readouterr().err
    path.write_text(GOOD + "[goal]\nposition = [15.0, 5.0]\n[[tree]]\nposition = [15.0, 5.6]\nradius = 0.3\n")
    assert main.main(["check", str(path)]) == 0
    told = capsys.readouterr()
    assert "warning: goal.position: no room for the body of the dinosaur" in told.err and "2 warning(s)" in told.out
    assert main.main(["river", str(path), "--headless", "--character", "dinosaur"]) == 2
    assert "goal at (15, 5): no room for the body of the dinosaur" in capsys.readouterr().err


def test_binary_large_and_missing_files(tmp_path):
    binary, large = tmp_path / "b.toml", tmp_path / "l.toml"
    binary.write_bytes(bytes(range(256)) * 10)
    large.write_text("# " + "x" * 10_000_000)
    for path in (binary, large, tmp_path / "none.toml", tmp_path):
        assert main.main(["river", str(path), "--headless"]) == 2


def test_heightmap_of_the_wrong_kind(tmp_path, capsys):
    Image.new("RGB", (8, 8)).save(tmp_path / "h.png")
    path = tmp_path / "level.toml"
    path.write_text(GOOD.replace("[start]", 'terrain = "heightmap"\n[world.heightmap]\nfile = "h.png"\n[start]'))
    assert main.main(["check", str(path)]) == 2
    assert "16-bit" in capsys.readouterr().err
    Image.fromarray(np.full((50, 50), 30000, np.uint16)).save(tmp_path / "h.png")
    assert main.main(["check", str(path)]) == 0


def test_impossible_river_names_the_gap(capsys):
    assert main.main(["river", "river_impossible", "--headless"]) == 3
    message = capsys.readouterr().err
    assert "rock 2" in message and "rock 3" in message and "leaps" in message


def test_run_records_and_measures(tmp_path, capsys):
    path = tmp_path / "run.npz"
    assert main.main(["--headless", "--seconds", "3", "--record", str(path), "--json"]) == 0
    summary = json.loads(capsys.readouterr().out)
    assert {"seconds", "steps", "distance", "reached_goal", "seconds_to_goal"} <= set(summary)
    assert main.main(["measure", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["worst"]["physics_cost_error"] < 1e-6
    path.write_bytes(path.read_bytes()[:500])
    assert main.main(["measure", str(path)]) == 2


def test_places_that_cannot_be_written(tmp_path, capsys):
    assert main.main(["--headless", "--seconds", "1", "--record", str(tmp_path / "no" / "run.npz")]) == 2
    assert "does not exist" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", (["fly"], ["--seed", "-1"], ["--size", "9"], ["--characters", "0"], ["--seconds", "-3"]))
def test_bad_usage_is_status_2(arguments):
    with pytest.raises(SystemExit) as stop:
        main.main(arguments)
    assert stop.value.code == 2


def test_what_will_be_ugly_is_not_fine(tmp_path, capsys):
    """A turn of 60 degrees in a step can be walked, but is no good."""
    feet = [("left", 2.0, 5.08, 0), ("right", 2.0, 4.92, 0), ("left", 2.6, 5.08, 60)]
    prints = "".join(f'[[footprint]]\nside = "{side}"\nposition = [{x}, {y}]\nheading_deg = {h}\n' for side, x, y, h in feet)
    path = tmp_path / "scene.toml"
    path.write_text(f'format = 1\nname = "turn"\nabout = "turns"\ncharacter = "human"\n[world]\nsize = [9.0, 9.0]\n{prints}')
    assert main.main(["check", str(path)]) == 0
    assert "1 warning" in capsys.readouterr().out
