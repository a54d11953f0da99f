"""Compiled kernels that are kept: what comes out is what was put in, from folders that are ours alone."""

import os
import pickle
import stat
import subprocess
import sys
import time

import pytest

from worlds.compiled import cache, telling
from worlds.compiled.jit import jit
from worlds.compiled.kept import Kept

posix = pytest.mark.skipif(os.name != "posix", reason="rights of POSIX")


def twice(x):
    return 2 * x


@pytest.fixture
def kernel(monkeypatch, tmp_path):
    """Makes the kernel anew, as another start would; counts what came from the cache."""
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))

    def made():
        compiled = jit(twice)
        assert compiled(21) == 42 and isinstance(compiled._cache, Kept)
        return sum(compiled.stats.cache_hits.values())

    return made


@pytest.mark.parametrize("ending", [".nbi", ".nbc"])
@pytest.mark.parametrize("damage", ["cut", "empty", "flipped", "other"])
def test_damaged_files_are_made_anew(ending, damage, kernel, tmp_path, capsys):
    assert (kernel(), kernel()) == (0, 1)
    (path,) = tmp_path.rglob(f"*{ending}")
    data = path.read_bytes()
    path.write_bytes({
        "cut": data[: len(data) // 2],
        "empty": b"",
        "flipped": data[:-9] + bytes([data[-9] ^ 4]) + data[-8:],
        "other": pickle.dumps({}),
    }[damage])  # fmt: skip
    capsys.readouterr()
    assert kernel() == 0
    assert capsys.readouterr().err.count(f"{path} was damaged") == 1
    assert kernel() == 1


def test_kernels_are_found_by_their_place_in_the_program(kernel, tmp_path):
    kernel()
    assert {path.parent for path in tmp_path.rglob("*.nb?")} == {tmp_path / "tests" / "worlds" / "compiled"}


def test_a_folder_that_cannot_be_written_compiles_and_says_so(kernel, monkeypatch, capsys):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("worlds.compiled.kept._Files._write", full)
    assert kernel() == 0 and "No space left on device" in capsys.readouterr().err


@posix
def test_the_temporary_folder_is_ours_alone(monkeypatch, tmp_path):
    monkeypatch.setattr(cache.tempfile, "tempdir", str(tmp_path))
    place = cache._temporary("key")
    mine = tmp_path / f"footfall-{os.getuid()}"
    assert place == mine / "key" and stat.S_IMODE(mine.stat().st_mode) == 0o700
    mine.chmod(0o777)
    assert cache._temporary("key") is None
    mine.rename(tmp_path / "elsewhere")
    (tmp_path / "elsewhere").chmod(0o700)
    mine.symlink_to(tmp_path / "elsewhere")
    assert cache._temporary("key") is None


@posix
def test_who_has_no_home_compiles_into_a_temporary_folder(monkeypatch, tmp_path):
    def homeless():
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(cache, "_home", homeless)
    monkeypatch.setattr(cache.tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(cache, "source_key", lambda: "key")
    monkeypatch.setattr(cache, "ROOT", tmp_path / "installed")
    assert cache.folder() == tmp_path / f"footfall-{os.getuid()}" / "key"


@posix
def test_folders_that_others_write_to_are_not_trusted(tmp_path, monkeypatch):
    assert cache._is_trusted(tmp_path)
    tmp_path.chmod(0o777)
    assert not cache._is_trusted(tmp_path)
    tmp_path.chmod(0o755)
    monkeypatch.setattr(cache.os, "getuid", lambda: 4711)
    monkeypatch.setattr(cache, "ROOT", tmp_path)
    assert cache._is_trusted(tmp_path)  # of whoever owns the sources that we run
    (tmp_path / "link").symlink_to(tmp_path)
    assert not cache._is_trusted(tmp_path / "link")


def test_nobody_waits_in_silence(monkeypatch, capsys):
    monkeypatch.setattr(telling, "SILENCE", 0.01)
    said = ""
    with telling.compiling(), telling.compiling():
        while said.count("compiling") < 3:
            time.sleep(0.01)
            said += capsys.readouterr().err
    while telling._Work.watch is not None:
        time.sleep(0.01)
    assert telling._Work.depth == 0


@pytest.mark.parametrize(
    "setting", ["NUMBA_DISABLE_JIT=1", "NUMBA_NUM_THREADS=0", "NUMBA_NUM_THREADS=x", "NUMBA_THREADING_LAYER=no-such"]
)
def test_settings_with_which_nothing_runs_are_named(setting):
    name, _, value = setting.partition("=")
    ran = subprocess.run(
        [sys.executable, "main.py", "--headless", "--seconds", "0.1"],
        cwd=cache.ROOT, capture_output=True, text=True, env=os.environ | {name: value},
    )  # fmt: skip
    assert ran.returncode == 2 and name in ran.stderr and "Traceback" not in ran.stderr
    assert len([line for line in ran.stderr.splitlines() if "compiling" not in line]) == 1
