"""What a run leaves: parts of a recording, films whole or not at all."""

import numpy as np
import pytest

from sim.files import frames
from sim.files.recording import Recorder
from sim.stage.making import make_simulation
from sim.view.pictures import film
from sim.view.pictures.results import Results, Wanted
from worlds.errors import InputError


def cast():
    return make_simulation("forest", "bird", 1, 0, False)


def times(path):
    with np.load(path) as run:
        return (60 * run["time"]).round(6).tolist()


def test_starting_over_begins_another_part_of_the_recording(tmp_path, capsys):
    mine = tmp_path / "run.2.npz"
    mine.write_text("mine")
    first, second = cast(), cast()
    results = Results(Wanted(record=str(tmp_path / "run.npz")), first)
    for _ in range(3):
        first.tick()
    results.follow(first)
    results.follow(second)
    second.tick()
    results.follow(second)
    results.end(second)
    assert times(tmp_path / "run.npz") == [0, 1, 2, 3] and times(tmp_path / "run.3.npz") == [0, 1]
    assert mine.read_text() == "mine" and "run.3.npz" in capsys.readouterr().err
    assert results.done == [str(tmp_path / "run.npz"), str(tmp_path / "run.3.npz")] and results.faults == []


def test_a_long_recording_is_the_same_from_disk(monkeypatch):
    sim = cast()
    kept = Recorder(sim)
    monkeypatch.setattr(frames, "BLOCK", 1000)
    spilled = Recorder(sim)
    for _ in range(20):
        kept.capture(), spilled.capture()
        sim.tick()
    assert any(isinstance(array, np.memmap) for array in spilled.arrays().values())
    for name, array in kept.arrays().items():
        np.testing.assert_array_equal(spilled.arrays()[name], array)


def test_a_full_disk_ends_the_recording_and_not_the_run(monkeypatch, tmp_path, capsys):
    sim = cast()
    results = Results(Wanted(record=str(tmp_path / "run.npz"), save=str(tmp_path / "s.npz")), sim)

    def full(self, values):
        raise OSError(28, "No space left on device")

    for _ in range(3):
        sim.tick()
    results.follow(sim)
    monkeypatch.setattr(frames.Frames, "add", full)
    for _ in range(3):
        sim.tick()
        results.follow(sim)
    results.end(sim)
    assert times(tmp_path / "run.npz") == [0, 1, 2, 3] and (tmp_path / "s.npz").exists()
    assert len(results.faults) == 1 and capsys.readouterr().err.count("No space left on device") == 1


@pytest.fixture
def gl(picture):
    """Skips where there is no OpenGL."""


def test_a_broken_film_leaves_the_old_one(gl, monkeypatch, tmp_path):
    path = tmp_path / "film.mp4"
    path.write_text("old")
    monkeypatch.setitem(film.KINDS, ".mp4", ("nonsense", ()))
    broken = film.Film(cast(), str(path), (64, 64))
    with pytest.raises(InputError, match="the film could not be made: "):
        broken.close()
    assert path.read_text() == "old" and [one.name for one in tmp_path.iterdir()] == ["film.mp4"]


@pytest.mark.parametrize("ending", film.KINDS)
def test_every_kind_of_film_is_made(gl, ending, tmp_path):
    import imageio_ffmpeg

    sim, path = cast(), tmp_path / f"film{ending}"
    made = film.Film(sim, str(path), (65, 63))
    for _ in range(8):
        sim.tick()
        made.add()
    made.close()
    assert [one.name for one in tmp_path.iterdir()] == [path.name]
    assert imageio_ffmpeg.count_frames_and_secs(path)[0] == 4
