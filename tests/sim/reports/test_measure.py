"""`measure`, its figures, the timing table and the human beside people, as a user would call them."""

import builtins
import json
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

import main
from motion.characters.character import load_character
from planner.script.scene import load_scene
from sim.files.recording import Recorder, Recording
from sim.reports import literature, timings
from sim.reports.measure import measure
from sim.reports.measured import in_words
from sim.stage.run import run
from sim.stage.scripted.performance import Performance
from worlds import queries
from worlds.errors import InputError


@pytest.fixture(scope="module")
def recorder():
    show = Performance(load_scene("sprint"))
    recorder = Recorder(show)
    recorder.capture()
    run(show, show.end, recorder.capture, quiet=True)
    return recorder


@pytest.fixture(scope="module")
def recording(recorder):
    return recorder.recording()


@pytest.fixture(scope="module")
def file(recorder, tmp_path_factory):
    path = tmp_path_factory.mktemp("measure") / "run.npz"
    recorder.save(path)
    return str(path)


def changed(recording, **arrays):
    return Recording(recording.arrays | arrays, recording.meta)


def test_a_scene_stands_on_its_footprints(recording):
    one = measure(recording)["characters"][0]
    assert one["skate"] <= 1e-3 and one["footprint_error"] <= 1e-3 and one["contact_error"] == 0
    assert one["skate_horizontal"] <= one["skate"] and one["clearance_share"] >= 0.012
    assert one["gait"]["name"] == "run" and one["gait"]["shares"]["stand"] > 0
    assert set(one["joints"]) == {"hip", "knee", "ankle"}


def test_faults_put_into_a_recording_are_found(recording):
    good = measure(recording)["worst"]
    toe, side = recording.arrays["toe"].copy(), np.zeros(3)
    flat = (toe[:, 0, 1, 2] < 1e-6) & (recording.arrays["heel"][:, 0, 1, 2] < 1e-6)
    frames = np.flatnonzero(recording.arrays["contact"][:, 0, 1] & flat)
    toe[frames[len(frames) // 2], 0, 1] += [0.0, 0.003, 0.0]
    assert measure(changed(recording, toe=toe))["worst"]["skate"] == pytest.approx(0.003, rel=0.02)
    knee, middle = recording.arrays["knee"].copy(), len(recording.arrays["time"]) // 2
    knee[middle, 0, 0] += [0.2, 0.0, 0.0]
    assert measure(changed(recording, knee=knee))["worst"]["knee_acceleration_ratio"] > 3 > good["knee_acceleration_ratio"]
    joints = {name: recording.arrays[name].copy() for name in ("knee", "hock", "ankle")}
    for joint in joints.values():
        joint[middle, 0, 0] = joint[middle, 0, 1] + side
    radius = recording.meta["characters"][0]["shank_radius"]
    assert measure(changed(recording, **joints))["worst"]["shank_gap"] == pytest.approx(-2 * radius)


def test_the_report_is_plain_numbers_and_words(recording):
    report = measure(recording)
    assert json.loads(json.dumps(report, allow_nan=False)) == report
    assert report["rate"] == pytest.approx(60)
    assert "times the 99th percentile" in in_words(report) and "gait run" in in_words(report)


def test_a_moment_can_be_measured(recording):
    """One frame has no rates, no strides and no swings, but is no error."""
    frame = {name: value[:1] for name, value in recording.arrays.items() if value.shape[:1] == recording.arrays["time"].shape}
    report = measure(changed(recording, **frame))
    assert report["worst"]["swing_clearance"] is None and report["characters"][0]["gait"]["bob"] is None
    assert "none" in in_words(report)


def test_recordings_that_cannot_be_measured(recording):
    with pytest.raises(InputError, match="even spacing"):
        time = recording.arrays["time"].copy()
        time[50:] += 0.01
        measure(changed(recording, time=time))
    with pytest.raises(InputError, match="lacks ball"):
        measure(Recording({k: v for k, v in recording.arrays.items() if k != "ball"}, recording.meta))


def test_ground_heights_are_those_of_single_points(recording):
    world = replace(load_scene("fig18_run_over_hills").world, rocks=np.array([[3.0, 2.0, 0.5, 0.3]])).arrays
    points = np.random.default_rng(2).uniform([0, 0, 0], [10, 4, 1], (300, 3))
    slow = [queries.ground_height(world, x, y) for x, y, _ in points]
    np.testing.assert_array_equal(queries.ground_heights(world, points), slow)
    assert max(slow) - min(slow) > 0.1


@pytest.mark.parametrize("name", ["run.png", "run.svg"])
def test_the_figure_of_a_run(file, tmp_path, capsys, name):
    path = tmp_path / name
    assert main.main(["measure", file, "--plot", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["characters"]
    assert [p.name for p in tmp_path.iterdir()] == [name]  # no .part left
    if name.endswith("png"):
        pixels = np.array(Image.open(path).convert("RGB")).reshape(-1, 3) / 255
        for colour in ((0.92, 0.18, 0.85), (0.90, 0.12, 0.12), (0.10, 0.14, 0.55), (0.55, 0.80, 0.98)):
            assert (np.abs(pixels - colour).max(axis=1) < 0.02).sum() > 500


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--plot", "{}/a.gif"], "must end in"),
        (["--plot", "{}/no/a.png"], "does not exist"),
        (["--plot", "{}/a.png", "--character-index", "1"], "0 to 0"),
        (["--plot", "{}/a.png", "--between", "900", "901"], "holds 0 frames"),
    ],
)
def test_figures_that_cannot_be_drawn(file, tmp_path, capsys, more, said):
    assert main.main(["measure", file, *(word.format(tmp_path) for word in more)]) == 2
    assert said in capsys.readouterr().err and not list(tmp_path.iterdir())


def test_without_matplotlib_a_message_tells(file, tmp_path, capsys, monkeypatch):
    real = builtins.__import__

    def without(name, *rest):
        if name.startswith("matplotlib") or (name == "sim.reports" and rest[2] and "plots" in rest[2]):
            raise ImportError("No module named 'matplotlib'")
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    assert main.main(["measure", file, "--plot", str(tmp_path / "a.png")]) == 2
    assert "pip install matplotlib" in capsys.readouterr().err


def test_the_timing_table_is_the_law():
    table = timings.timing_table(load_character("human"))
    length, step, stance = (np.array(table[name]) for name in ("step_length", "step_time", "stance_time"))
    np.testing.assert_allclose(np.array(table["swing_time"]) + stance, 2 * step)
    np.testing.assert_allclose(table["speed"], length / step)
    np.testing.assert_allclose(np.array(table["flight_time"]) - table["double_support_time"], step - stance, atol=1e-12)
    assert list(dict.fromkeys(table["gait"])) == ["walk", "run", "leap"]
    assert 0.4 <= table["run_from"]["froude"] <= 0.6


def test_timing_command(tmp_path, capsys):
    assert main.main(["timing", "--json"]) == 0
    assert {"bird", "dinosaur", "human"} <= set(json.loads(capsys.readouterr().out))
    assert main.main(["timing", "--character", "bird", "--plot", str(tmp_path / "t.png")]) == 0
    assert Image.open(tmp_path / "t.png").width > 300
    assert main.main(["timing"]) == 0 and "runs from" in capsys.readouterr().out
    assert main.main(["timing", "--character", "unicorn"]) == 2


def test_the_human_goes_as_people_do():
    rows = {row.what.split(",")[0].split(" (")[0]: row for row in literature.compare()}
    for what in ("walk: bob", "walk: height at mid-stance", "run: flight", "run: height at mid-stance"):
        assert rows[what].fits, rows[what]
    assert literature.steady(literature.WALK)["gait"]["step_length"] == pytest.approx(0.7, abs=1e-9)
    assert "does NOT fit" in literature.in_words([literature.Row("x", "cm", 7.0, 1.0, 2.0)])
