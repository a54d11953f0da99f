"""Batches: the same table however they came about."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest

import main
from sim.files.recording import load_recording
from sim.reports.batch import cluster, table
from sim.reports.batch.plan import plan_of
from sim.reports.batch.shards import Shards
from tests.structure import ROOT

SMALL = ["batch", "--level", "forest", "--seeds", "3:6", "--seconds", "1", "--characters", "2", "--jobs", "2"]


@pytest.fixture(autouse=True)
def csv_tables(monkeypatch):
    """Tables as text, whatever is installed here."""
    monkeypatch.setattr(table, "_has_arrow", lambda: False)


def made(folder, *more):
    assert main.main([*SMALL, "--out", str(folder), "--json", *more]) == 0
    return (folder / table.CSV).read_bytes()


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """A batch that nobody has disturbed."""
    folder = tmp_path_factory.mktemp("whole")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(table, "_has_arrow", lambda: False)
        return folder, made(folder)


def test_a_row_for_each_character_of_each_run(whole):
    folder, text = whole
    lines = text.decode().splitlines()
    assert lines[0].startswith("level,seed,character,seconds") and "gait.speed" in lines[0] and len(lines) == 1 + 3 * 2
    assert [line.split(",")[:3] for line in lines[1:4]] == [["forest", "3", "0"], ["forest", "3", "1"], ["forest", "4", "0"]]
    recordings = sorted((folder / "shards").glob("*.npz"))
    assert len(recordings) == 3 and load_recording(recordings[0]).meta["seed"] == 3


def test_what_is_missing_is_made_again_and_nothing_else(whole, tmp_path, capsys):
    folder, text = whole
    times = {path: path.stat().st_mtime_ns for path in (folder / "shards").iterdir()}
    lost = sorted((folder / "shards").glob("*.json"))[1]
    lost.write_text(lost.read_text("utf-8")[:50], "utf-8")
    left = folder / "shards" / ".footfall-1234.part"
    left.write_text("half", "utf-8")
    assert made(folder) == text
    assert "2 of 3 runs are there; going on" in capsys.readouterr().err and not left.exists()
    assert sum(path.stat().st_mtime_ns != at for path, at in times.items()) == 2


def test_killed_it_goes_on(whole, tmp_path):
    """Also while it writes; the table is the one of an undisturbed batch."""
    arguments = [sys.executable, "main.py", *SMALL, "--out", str(tmp_path / "killed")]
    for seconds in (3.0, 4.5):
        process = subprocess.Popen(arguments, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(seconds)
        os.kill(process.pid, signal.SIGKILL) if os.name == "posix" else process.kill()
        process.wait()
    assert made(tmp_path / "killed") == whole[1]


def test_another_batch_does_not_mix_with_it(whole, capsys):
    folder, _ = whole
    assert main.main([*SMALL[:-6], "--seconds", "2", "--out", str(folder)]) == 2
    said = capsys.readouterr().err
    assert "is of another batch" in said and "seconds was 1.0, is 2.0" in said


def test_a_run_that_cannot_be_done_says_so_in_its_row(tmp_path):
    assert main.main(["batch", "--level", "river_impossible", "--seeds", "0:1", "--task", "river", "--out", str(tmp_path)]) == 0
    assert "error" in (tmp_path / table.CSV).read_text("utf-8").splitlines()[0]
    rows = json.loads(next((tmp_path / "shards").glob("*.json")).read_text("utf-8"))["rows"]
    assert len(rows) == 1 and rows[0]["error"]


@pytest.mark.parametrize(
    "typed, said",
    [
        (["--level", "forrest", "--seeds", "0:2"], "did you mean forest"),
        (["--level", "forest", "--seeds", "2:2"], "A:B is allowed"),
        (["--level", "forest", "--seeds", "0:2", "--task", "river"], "has no [goal]"),
        (["--level", "forest", "--seeds", "0:9999999"], "1,000,000 at most"),
    ],
)
def test_what_is_no_batch_is_refused(typed, said, tmp_path, capsys):
    try:
        status = main.main(["batch", *typed, "--out", str(tmp_path / "b")])
    except SystemExit as left:
        status = left.code
    assert status == 2 and said in capsys.readouterr().err


def test_parquet_holds_the_same(whole, tmp_path, monkeypatch):
    parquet = pytest.importorskip("pyarrow.parquet", reason="pyarrow (the extra `batch`) is not installed")
    monkeypatch.undo()
    folder, text = whole
    plan = plan_of(["forest"], (3, 6), "wander", "bird", 2, 1.0)
    rows = [row for job in plan.jobs() for row in Shards(folder).rows(job)]
    path = table.write_table(rows, tmp_path)
    read = parquet.read_table(path)
    assert path.name == table.PARQUET and read.num_rows == 6 and read.column_names == text.decode().splitlines()[0].split(",")
    assert read["seed"].to_pylist() == [3, 3, 4, 4, 5, 5] and read["distance"].to_pylist() == [row["distance"] for row in rows]


def test_ray_makes_the_same(whole, tmp_path):
    pytest.importorskip("ray", reason="Ray (the extra `ray`) is not installed")
    assert made(tmp_path, "--engine", "ray") == whole[1]


def test_without_ray_that_is_said(tmp_path, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "ray", None)
    assert main.main([*SMALL, "--out", str(tmp_path), "--engine", "ray"]) == 2
    assert "needs Ray: pip install ray" in capsys.readouterr().err
    assert cluster.AHEAD > 0
