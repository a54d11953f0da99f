"""The command `export`: what is made of what, and what is refused, with nothing left behind."""

import json

import numpy as np
import pytest

import main
from sim.export import formats
from sim.export.endings import FORMATS
from sim.files.saving import save
from sim.stage.making import make_simulation

QUICK = [
    ending for ending, form in FORMATS.items() if form.where.startswith(("tables", "skeletons", "page")) and not form.needs
]


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """A recording of three characters, and a state of the same run."""
    folder = tmp_path_factory.mktemp("run")
    path = folder / "run.npz"
    assert main.main(["wander", "--headless", "--seconds", "1", "--characters", "3", "--record", str(path), "--json"]) == 0
    save(make_simulation("forest", "bird", 3, 0, False), folder / "state.npz")
    return path


@pytest.mark.parametrize("ending", QUICK)
def test_each_format_of_a_recording(ending, run, tmp_path):
    out = tmp_path / f"out{ending}"
    assert main.main(["export", str(run), str(out), "--fps", "20", "--character-index", "1"]) == 0
    assert [path.name for path in tmp_path.iterdir()] == [out.name] and out.stat().st_size > 100


def test_a_format_of_one_character_makes_a_file_for_each(run, tmp_path):
    assert main.main(["export", str(run), str(tmp_path / "out.bvh"), "--between", "0.2", "0.8"]) == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out_0.bvh", "out_1.bvh", "out_2.bvh"]
    assert "Frames: 37\n" in (tmp_path / "out_0.bvh").read_text()


def test_a_state_goes_on_as_the_run_did(run, tmp_path):
    for source, name in ((run, "a.txt"), (run.with_name("state.npz"), "b.txt")):
        assert main.main(["export", str(source), str(tmp_path / name), "--between", "0", "1"]) == 0
    np.testing.assert_array_equal(np.loadtxt(tmp_path / "a.txt"), np.loadtxt(tmp_path / "b.txt"))


REFUSED = {
    "an hour of moments": (["{state}", "{tmp}/out.glb", "--between", "0", "3600", "--fps", "240"], "poses are allowed"),
    "no such ending": (["{run}", "{tmp}/out.glbb"], "did you mean .glb?"),
    "fbx": (["{run}", "{tmp}/out.fbx"], "Blender makes an .fbx"),
    "no ending": (["{run}", "{tmp}/out"], "must end in .csv"),
    "no file": (["{tmp}/none.npz", "{tmp}/out.glb"], "no such file"),
    "no scene": (["sprimt", "{tmp}/out.glb"], "did you mean sprint?"),
    "no folder": (["{run}", "{tmp}/none/out.glb"], "does not exist"),
    "no such character": (["{run}", "{tmp}/out.glb", "--character-index", "3"], "there are 3 characters"),
    "no such moments": (["{run}", "{tmp}/out.glb", "--fps", "50"], "no moment is made up"),
    "too many moments": (["{run}", "{tmp}/out.glb", "--fps", "1e9"], "1 to 240"),
    "not a number": (["{run}", "{tmp}/out.glb", "--fps", "nan"], "1 to 240"),
    "wrong way round": (["{run}", "{tmp}/out.glb", "--between", "2", "1"], "the first the earlier"),
    "after the end": (["{run}", "{tmp}/out.glb", "--between", "50", "60"], "from 0.00 to 1.00 s"),
    "after the script": (["sprint", "{tmp}/out.glb", "--between", "500", "600"], "there are 0.00 to"),
    "array of a scene": (["sprint", "{tmp}/out.csv", "--array", "com"], "of a recording"),
    "array as glb": (["{run}", "{tmp}/out.glb", "--array", "com"], "become .csv"),
    "no such array": (["{run}", "{tmp}/out.csv", "--array", "comm"], "did you mean com?"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_is_refused_and_leaves_nothing(case, run, tmp_path, capsys):
    words, said = REFUSED[case]
    state = run.with_name("state.npz")
    assert main.main(["export", *(word.format(run=run, state=state, tmp=tmp_path) for word in words)]) == 2
    message = capsys.readouterr().err
    assert said in message and "Traceback" not in message and list(tmp_path.iterdir()) == []


def test_damaged_sources_are_refused(run, tmp_path, capsys):
    whole = run.read_bytes()
    for k, data in enumerate(
        (b"", whole[: len(whole) // 2], whole[:100] + bytes(100) + whole[200:], b"PK\x03\x04" + bytes(50))
    ):
        broken = tmp_path / f"{k}.npz"
        broken.write_bytes(data)
        assert main.main(["export", str(broken), str(tmp_path / "out.glb")]) == 2
        assert "Traceback" not in capsys.readouterr().err and not (tmp_path / "out.glb").exists()


def test_what_was_there_stays_where_an_export_fails(run, tmp_path, monkeypatch):
    out = tmp_path / "out.glb"
    out.write_text("mine")
    monkeypatch.setattr("sim.export.skeletons.glb.gltf_of", lambda clip: (_ for _ in ()).throw(MemoryError()))
    assert main.main(["export", str(run), str(out)]) == 2
    assert out.read_text() == "mine" and [path.name for path in tmp_path.iterdir()] == ["out.glb"]


def test_a_missing_library_is_named(run, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(formats, "find_spec", lambda name: None)
    assert main.main(["export", str(run), str(tmp_path / "out.parquet")]) == 2
    assert "pip install pyarrow" in capsys.readouterr().err


def test_recordings_of_older_versions_take_the_looks_that_ship(run, tmp_path):
    with np.load(run) as file:
        arrays = dict(file)
    meta = json.loads(str(arrays["meta"]))
    del meta["looks"]
    old = tmp_path / "old.npz"
    np.savez(old, **(arrays | {"meta": np.array(json.dumps(meta))}))
    for source, name in ((run, "new.glb"), (old, "old.glb")):
        assert main.main(["export", str(source), str(tmp_path / name)]) == 0
    assert (tmp_path / "new.glb").read_bytes() == (tmp_path / "old.glb").read_bytes()
