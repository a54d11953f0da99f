"""Scene files: what ships loads, and every fault of a bad one is told with its key."""

import pytest

import main
from planner.script.scene import load_scene, scene_names
from worlds.errors import InputError

HEAD = 'format = 1\nname = "t"\n[world]\nsize = [9.0, 4.0]\n'
PATH = "[path]\npoints = [[1.0, 2.0], [6.0, 2.0]]\nstep_length = 0.5\n"
PRINTS = "".join(f'[[footprint]]\nside = "{s}"\nposition = [{x}, 2.0]\n' for s, x in (("left", 1), ("right", 1), ("left", 1.5)))
BAD = {
    "neither": (HEAD, "either"),
    "same side": (HEAD + PRINTS.replace("right", "left"), "footprint.1.side"),
    "two only": (HEAD + PRINTS.rsplit("[[footprint]]", 1)[0], "at least three"),
    "one point": (HEAD + PATH.replace(", [6.0, 2.0]", ""), "path.points"),
    "no length": (HEAD + PATH.replace("0.5", "0.0"), "path.step_length"),
    "support": (HEAD.replace("[world]", 'support = "heel"\n[world]') + PATH, "support"),
    "segments": (HEAD.replace("[world]", 'segments = "foot"\n[world]') + PATH, "segments"),
    "unknown": (HEAD + PATH + "speed = 3.0\n", "path.speed"),
}


def test_scenes_of_every_figure_ship():
    figures = {load_scene(name).figure for name in scene_names()}
    assert {"1", "15", "16", "17", "18", "19", "20"} <= figures


@pytest.mark.parametrize("case", BAD)
def test_bad_scene_is_refused_with_its_fault(case, tmp_path, capsys):
    text, said = BAD[case]
    path = tmp_path / "scene.toml"
    path.write_text(text)
    assert main.main(["play", str(path), "--headless"]) == 2
    message = capsys.readouterr().err
    assert said in message and str(path) in message and "Traceback" not in message


def test_good_scene_loads(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(HEAD + PATH)
    scene = load_scene(path)
    track = scene.track
    assert (track.support, track.segments, track.character) == ("roll", "smooth", "human")
    with pytest.raises(InputError, match="no such scene"):
        load_scene(tmp_path / "none.toml")
