"""What killed runs leave half made is removed, and nothing else."""

import os
import signal
import subprocess
import sys

import pytest

from sim.files import leftovers, outputs

posix = pytest.mark.skipif(os.name != "posix", reason="locks of POSIX")
MAKES = """
import sys, time
from sim.files.outputs import Part
part = Part(sys.argv[1])
part.path.write_text("half")
print("made", flush=True)
time.sleep(60)
"""


def started(path):
    process = subprocess.Popen([sys.executable, "-c", MAKES, str(path)], stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"made\n"
    return process


@posix
def test_what_a_killed_run_has_left_goes_with_the_next_file(tmp_path):
    process = started(tmp_path / "run.npz")
    try:
        with outputs.whole(tmp_path / "other") as path:
            path.write_text("new")
        assert len(os.listdir(tmp_path)) == 2, "a file in the making is held"
    finally:
        process.send_signal(signal.SIGKILL)
        process.wait()
    assert len(os.listdir(tmp_path)) == 2
    with outputs.whole(tmp_path / "other") as path:
        path.write_text("newer")
    assert os.listdir(tmp_path) == ["other"] and (tmp_path / "other").read_text() == "newer"


@posix
@pytest.mark.parametrize(
    "name", [".footfall-held-.part", ".footfall-abcd1234.part", ".footfall-held-abcd1234.part.txt", "x.part"]
)
def test_files_of_others_stay(name, tmp_path):
    (tmp_path / name).write_text("mine")
    leftovers.clean(tmp_path)
    assert os.listdir(tmp_path) == [name]


@posix
def test_only_files_are_removed(tmp_path):
    names = [f".footfall-held-abcd123{k}.part" for k in range(3)]
    (tmp_path / names[0]).mkdir()
    (tmp_path / names[1]).symlink_to(tmp_path / "away")
    os.mkfifo(tmp_path / names[2])
    (tmp_path / "away").write_text("mine")
    leftovers.clean(tmp_path)
    assert sorted(os.listdir(tmp_path)) == [*names, "away"]


@posix
def test_where_locks_are_not_to_be_had_nothing_is_removed(tmp_path, monkeypatch):
    left = tmp_path / ".footfall-held-abcd1234.part"
    left.write_text("")

    def none(handle, how):
        raise OSError(37, "No locks available")

    monkeypatch.setattr(leftovers.fcntl, "flock", none)
    with outputs.whole(tmp_path / "run") as path:
        path.write_text("new")
    assert sorted(os.listdir(tmp_path)) == [left.name, "run"]


@posix
def test_one_that_was_taken_for_a_leftover_is_made_once_more(tmp_path, monkeypatch):
    flock, taken = leftovers.fcntl.flock, []

    def quicker(handle, how):
        if not taken:
            taken.extend(tmp_path.iterdir())
            taken[0].unlink()
        flock(handle, how)

    monkeypatch.setattr(leftovers.fcntl, "flock", quicker)
    held = leftovers.Held(tmp_path)
    assert held.path.exists() and held.path != taken[0]
    held.become(tmp_path / "run")
    assert os.listdir(tmp_path) == ["run"]
