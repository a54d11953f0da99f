"""Files are written whole or not at all, into what their names mean, and nothing of others is touched."""

import os
import stat
import threading

import pytest

from sim.files import outputs
from worlds.compiled.leaving import leave_nothing
from worlds.errors import InputError

posix = pytest.mark.skipif(os.name != "posix", reason="devices, pipes and links of POSIX")


def put(path, text="new"):
    with outputs.whole(path) as temporary:
        temporary.write_text(text)


def test_a_file_takes_the_place_of_the_old_one_with_its_rights(tmp_path):
    path = tmp_path / "run.npz"
    path.write_text("old")
    path.chmod(0o640)
    put(path)
    assert path.read_text() == "new" and stat.S_IMODE(path.stat().st_mode) == 0o640
    put(tmp_path / "fresh")
    mask = os.umask(0)
    os.umask(mask)
    assert stat.S_IMODE((tmp_path / "fresh").stat().st_mode) == 0o666 & ~mask
    assert sorted(os.listdir(tmp_path)) == ["fresh", "run.npz"]


@pytest.mark.parametrize("fault", [ZeroDivisionError(), OSError(28, "No space left on device"), KeyboardInterrupt()])
def test_what_fails_leaves_the_old_file_and_nothing_else(fault, tmp_path):
    (tmp_path / "run.npz").write_text("old")
    with pytest.raises(InputError if isinstance(fault, OSError) else type(fault)), outputs.whole(tmp_path / "run.npz") as path:
        path.write_text("half")
        raise fault
    assert (tmp_path / "run.npz").read_text() == "old" and os.listdir(tmp_path) == ["run.npz"]


def test_somebody_elses_part_is_left_alone(tmp_path):
    (tmp_path / "run.npz.part").write_text("mine")
    put(tmp_path / "run.npz")
    assert (tmp_path / "run.npz.part").read_text() == "mine"


def test_an_end_at_once_leaves_nothing_half_made(tmp_path):
    part = outputs.Part(tmp_path / "run.npz")
    assert part.path.exists()
    leave_nothing()
    assert os.listdir(tmp_path) == []


@posix
def test_a_link_is_followed(tmp_path):
    folder = tmp_path / "elsewhere"
    folder.mkdir()
    for name in ("there", "not_yet"):
        (tmp_path / name).symlink_to(folder / name)
    (folder / "there").write_text("old")
    for name in ("there", "not_yet"):
        put(tmp_path / name)
        assert (tmp_path / name).is_symlink() and (folder / name).read_text() == "new"


@posix
def test_pipes_and_devices_are_written_to(tmp_path):
    pipe, read = tmp_path / "pipe", []
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()))
    reader.start()
    put(pipe)
    reader.join()
    assert read == ["new"] and stat.S_ISFIFO(pipe.stat().st_mode)
    assert outputs._as_such("/dev/null") and outputs._as_such("/dev/stdout") and not outputs._as_such(tmp_path / "no")
    outputs.check({"--record": "/dev/null", "--save": "/dev/null"})


def test_every_fault_is_named_before_the_run(tmp_path):
    (tmp_path / "file").write_text("")
    wanted = {
        "--record": str(tmp_path), "--save": str(tmp_path / "no" / "s.npz"), "--video": "", "--screenshot": None,
        "--plot": str(tmp_path / "file" / "p.png"), "--other": str(tmp_path / ("x" * 300)),
    }  # fmt: skip
    with pytest.raises(InputError) as refused:
        outputs.check(wanted)
    lines = str(refused.value).splitlines()
    assert [line.split()[0] for line in lines] == ["--record", "--save", "--video", "--plot", "--other"]
    assert "is a folder" in lines[0] and "does not exist" in lines[1] and "empty name" in lines[2]
    assert sorted(os.listdir(tmp_path)) == ["file"]


def test_two_results_need_two_files(tmp_path):
    with pytest.raises(InputError, match="is the file of --record, too"):
        outputs.check({"--record": str(tmp_path / "a"), "--save": str(tmp_path / "b" / ".." / "a").replace("/b/..", "/.")})


def test_one_that_fails_does_not_keep_the_others():
    done = []

    def bad():
        raise InputError("bad: is full")

    assert outputs.write_all({"a": lambda: done.append("a"), "b": bad, "c": lambda: done.append("c")}) == (
        ["a", "c"],
        ["bad: is full"],
    )
    assert done == ["a", "c"]
