"""States and recordings that were changed and given a right digest are refused before any kernel reads them."""

import json

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.walk_to import WalkTo
from sim.files import saving
from sim.files.recording import Recorder, load_recording
from sim.files.saving import restore, save
from sim.stage.making import make_simulation
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.world import World


def _store(path, arrays, meta):
    np.savez(path, allow_pickle=False, **arrays, meta=np.array(json.dumps(meta)))


def _load(path):
    with np.load(path) as file:
        arrays = {name: file[name] for name in file.files}
    return arrays, json.loads(str(arrays.pop("meta")))


@pytest.fixture(scope="module")
def state(tmp_path_factory):
    path = tmp_path_factory.mktemp("state") / "s.npz"
    people = [load_character("human"), load_character("bird")]
    stops = [[(14.0, 10.0), (10.0, 14.0)], [(6.0, 10.0), (10.0, 6.0)]]
    sim = Simulation(World("floor", (20.0, 20.0)), people, WalkTo([(6.0, 10.0, 0.0), (14.0, 10.0, 3.0)], stops), 4)
    sim.keep_footprints()
    for _ in range(300):
        sim.tick()
    save(sim, path)
    return _load(path)


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    path = tmp_path_factory.mktemp("run") / "r.npz"
    sim = make_simulation("forest", "bird", 2, 1, False)
    recorder = Recorder(sim)
    for _ in range(60):
        sim.tick()
        recorder.capture()
    recorder.save(path)
    return _load(path)


def put(name, value, at=0):
    def change(arrays, meta):
        arrays[name] = arrays[name].copy()
        arrays[name].flat[at] = value

    return change


def told(**new):
    return lambda arrays, meta: meta.update(new)


def reshaped(name, change):
    return lambda arrays, meta: arrays.update({name: change(arrays[name])})


STATES = {
    "crowd.kind": put("crowd.kind", 7),
    "crowd.real": put("crowd.real", 99),
    "crowd.segments": put("crowd.segments", -3),
    "crowd.points": put("crowd.points", 10**6),
    "committed.support": put("crowd.committed.support", 10**6),
    "window.support": put("crowd.window.support", -2),
    "committed.control: finite": put("crowd.committed.control", np.nan),
    "ascend": put("crowd.committed.time", 1e6),
    "footprints.0: side": put("crowd.footprints.side", 2),
    "footprints.0: position": put("crowd.footprints.position", 1e155),
    "normal": put("crowd.footprints.normal", 1.0),
    "hold": put("crowd.footprints.hold", 0.5),
    "is int32": reshaped("crowd.real", lambda a: a.astype(np.int32)),
    "crowd.footprints.side is": reshaped("crowd.footprints.side", lambda a: a[:, :3]),
    "crowd.committed.time is": reshaped("crowd.committed.time", lambda a: a[:, :, None]),
    "plans": put("plans.reached", -5),
    "stops": put("plans.stops", 3.0),
    "footprint_character": put("footprint_character", 9),
    "footprint_side of": reshaped("footprint_side", lambda a: a.astype(float)),
    "heights": reshaped("heights", lambda a: a * np.nan),
    "meta: ticks": told(ticks=-1),
    "meta: seed": told(seed="1"),
    "meta: tick_rate": told(tick_rate=0),
    "meta: kind": told(kind=[-1, 0]),
    "meta: steps": told(steps=1.5),
    "meta: kinds": told(kinds=[]),
    "meta.recasts": told(recasts=[0]),
    "meta: changes": told(changes=[{"tick": 1}]),
    "is no command": told(changes=[{"tick": 1, "command": {"command": "fly"}}]),
    "meta: moon": told(moon=1),
    "world": told(world={}),
    "near": told(planner={"name": "WalkTo", "values": {"starts": [[1, 1, 1]], "stops": [[[1, 1]]], "near": True}}),
    "takes no arguments": told(planner={"name": "Wander", "values": {"wings": 2}}),
}
RUNS = {
    "com of shape": reshaped("com", lambda a: a[:, :1]),
    "com: finite": put("com", np.inf),
    "phase": put("phase", 7),
    "contact of": reshaped("contact", lambda a: a.astype(float)),
    "time: must ascend": put("time", 1e6),
    "footprint_character": put("footprint_character", -1),
    "footprint_position of shape": reshaped("footprint_position", lambda a: a[:3]),
    "heights": reshaped("heights", lambda a: a[0]),
    "rate": told(rate=0),
    "level": told(level=3),
    "meta.characters.0": told(characters=[{"name": 1}, {"name": "b"}]),
    "world": told(world=[]),
    "changes": told(changes=3),
}


@pytest.mark.parametrize("said", STATES)
def test_a_state_that_cannot_be_is_refused_whatever_its_digest(said, state, tmp_path):
    arrays, meta = dict(state[0]), json.loads(json.dumps(state[1]))
    STATES[said](arrays, meta)
    meta["digest"] = saving._digest(arrays, {k: v for k, v in meta.items() if k != "digest"})
    _store(tmp_path / "s.npz", arrays, meta)
    with pytest.raises(InputError, match=said):
        restore(tmp_path / "s.npz")


@pytest.mark.parametrize("said", RUNS)
def test_a_recording_that_cannot_be_is_refused(said, recording, tmp_path):
    arrays, meta = dict(recording[0]), json.loads(json.dumps(recording[1]))
    RUNS[said](arrays, meta)
    _store(tmp_path / "r.npz", arrays, meta)
    with pytest.raises(InputError, match=said):
        load_recording(tmp_path / "r.npz")


def test_the_digest_tells_shapes_and_types(state):
    arrays, meta = state
    digests = {saving._digest(arrays | {"crowd.real": arrays["crowd.real"].reshape(shape)}, meta) for shape in ((2,), (1, 2))}
    assert len(digests) == 2


def test_heights_are_an_array_of_the_file_and_no_text(tmp_path):
    world = World("map", (20.0, 20.0), "heightmap", (1.0,), np.random.default_rng(1).uniform(0, 0.2, (21, 21)))
    sim = Simulation(world, [load_character("human")], WalkTo([(6.0, 10.0, 0.0)], [[(9.0, 10.0)]]), 4)
    recorder = Recorder(sim)
    recorder.capture()
    save(sim, tmp_path / "s.npz")
    recorder.save(tmp_path / "r.npz")
    for path, again in (("s.npz", restore(tmp_path / "s.npz").world), ("r.npz", load_recording(tmp_path / "r.npz").world)):
        np.testing.assert_array_equal(again.heights, world.heights)
        assert _load(tmp_path / path)[1]["world"]["heights"] is None


def test_a_recording_with_heights_in_its_text_is_read(recording, tmp_path):
    """As versions up to 0.5.0 wrote them."""
    arrays, meta = dict(recording[0]), json.loads(json.dumps(recording[1]))
    del arrays["heights"]
    meta["world"]["heights"] = [[0.0]]
    _store(tmp_path / "r.npz", arrays, meta)
    assert load_recording(tmp_path / "r.npz").world.heights.shape == (1, 1)


def test_an_archive_that_lies_about_its_size_is_refused(tmp_path):
    import zipfile

    path = tmp_path / "r.npz"
    with zipfile.ZipFile(path, "w") as archive:
        head = b"{'descr': '<f8', 'fortran_order': False, 'shape': (1000000000000,), }"
        archive.writestr("time.npy", b"\x93NUMPY\x01\x00" + len(head).to_bytes(2, "little") + head)
    with pytest.raises(InputError, match="tells 8000000000000 bytes"):
        load_recording(path)
