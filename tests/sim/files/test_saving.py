"""A run that was saved and restored goes on bit by bit; files of another kind, version or state of health are refused."""

import json
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple
from unittest.mock import Mock

import numpy as np
import pytest

import main
from motion.characters.character import load_character
from planner.modes.custom import Custom
from planner.modes.walk_to import WalkTo
from planner.round.weights import PEOPLE
from sim.files import archive
from sim.files.archive import flat
from sim.files.saving import FORMAT, _digest, restore, save
from sim.stage.commands import SetGoal, apply
from sim.stage.making import make_simulation
from sim.stage.simulation import Simulation
from tests.examples.planner_in_python import in_a_circle
from worlds.errors import InputError
from worlds.world import World

ROOT = Path(main.__file__).parent


def ticked(sim, ticks):
    for _ in range(ticks):
        sim.tick()
    return sim


def rows(table):
    return [] if table is None else list(flat("", table).items())


def same(a, b):
    assert a.ticks == b.ticks and a.footprints.steps == b.footprints.steps
    for left, right in ((a.crowd, b.crowd), (a.plans, b.plans), (a.snapshot(), b.snapshot())):
        for (name, x), y in zip(rows(left), rows(right), strict=True):
            assert x.tobytes() == y[1].tobytes(), name


def walkers(weights=PEOPLE):
    world = World("floor", (20.0, 20.0), start=(10.0, 10.0))
    starts, stops = [(6.0, 10.0, 0.0), (14.0, 10.0, np.pi)], [[(14.0, 10.0), (10.0, 14.0)], [(6.0, 10.0), (10.0, 6.0)]]
    return Simulation(
        world, [load_character("human"), load_character("bird")], WalkTo(starts, stops, again=True), 4, weights=weights
    )


MADE = {
    "crowd": lambda: make_simulation("dense_forest", "bird", 12, 3, False),
    "river": lambda: make_simulation("river_easy", "human", 1, 0, True),
    "walkers": walkers,
    "walkers of another table": lambda: walkers(PEOPLE._replace(around=0.0, side=3.0)),
    "walkers of another model": lambda: walkers(PEOPLE._replace(model="orca")),
}


@pytest.mark.parametrize("kind", MADE)
def test_a_restored_run_goes_on_bit_by_bit(kind, tmp_path):
    whole = ticked(MADE[kind](), 400)
    save(whole, tmp_path / "state.npz")
    restored = restore(tmp_path / "state.npz")
    same(whole, restored)
    same(ticked(whole, 400), ticked(restored, 400))


def test_edits_and_replanning_go_on_too(tmp_path):
    whole = ticked(make_simulation("river_easy", "human", 1, 0, True), 200)
    save(whole, tmp_path / "state.npz")
    restored = restore(tmp_path / "state.npz")
    for sim in (whole, restored):
        apply(sim, SetGoal(3.0, 9.0))
        ticked(sim, 300)
    same(whole, restored)


def test_kept_footprints_are_saved(tmp_path):
    sim = make_simulation("forest", "bird", 2, 1, False)
    sim.keep_footprints()
    save(ticked(sim, 900), tmp_path / "state.npz")
    again = restore(tmp_path / "state.npz")
    for (name, a), b in zip(
        sim.footprints.arrays(sim.crowd).items(), again.footprints.arrays(again.crowd).values(), strict=True
    ):
        np.testing.assert_array_equal(a, b, err_msg=name)


def test_nothing_grows_unless_it_is_kept():
    sim = ticked(make_simulation("forest", "bird", 1, 1, False), 3000)
    assert sim.footprints.kept() == {} and sim.footprints.steps > 50
    assert len(sim.footprints.arrays(sim.crowd)["footprint_side"]) <= sim.crowd.footprints.side.shape[1]


def test_another_process_goes_on_bit_by_bit(tmp_path):
    state, end, other = (str(tmp_path / f"{name}.npz") for name in ("state", "end", "other"))
    run = [sys.executable, "main.py", "wander", "--headless", "--json", "--characters", "5", "--seed", "2"]
    subprocess.run([*run, "--seconds", "12", "--save", state], cwd=ROOT, check=True, capture_output=True)
    told = subprocess.run(
        [*run, "--restore", state, "--seconds", "20", "--save", end], cwd=ROOT, check=True, capture_output=True
    )
    subprocess.run([*run, "--seconds", "20", "--save", other], cwd=ROOT, check=True, capture_output=True)
    same(restore(end), restore(other))
    assert json.loads(told.stdout)["seconds"] == 20.0


def test_bad_states_are_refused(tmp_path, capsys):
    path, state = tmp_path / "bad.npz", tmp_path / "state.npz"
    save(make_simulation("forest", "bird", 1, 1, False), state)
    whole = state.read_bytes()
    with np.load(state) as file:
        arrays = {name: file[name] for name in file.files}
    meta = json.loads(str(arrays["meta"]))

    def stored(changed=None, **new):
        np.savez(path, allow_pickle=False, **(arrays | new | {"meta": np.array(json.dumps(meta | (changed or {})))}))

    spoiled = {
        "no such file": lambda: path.unlink(missing_ok=True),
        "not readable": lambda: path.write_bytes(whole[: len(whole) // 2]),
        "version '0.0.1'": lambda: stored({"version": "0.0.1"}),
        "meta.format": lambda: stored({"format": 99}),
        "contents are not": lambda: stored(**{"crowd.real": arrays["crowd.real"] + 1}),
        "lacks": lambda: np.savez(path, a=np.zeros(3)),
    }
    for said, spoil in spoiled.items():
        spoil()
        with pytest.raises(InputError, match=said):
            restore(path)
        assert main.main(["--headless", "--seconds", "1", "--restore", str(path)]) == 2
        assert "Traceback" not in capsys.readouterr().err
    assert main.main(["--headless", "--seconds", "0.01", "--restore", str(state), "--json"]) in (0, 2)
    assert main.main(["--headless", "--seconds", "1", "--save", str(tmp_path / "no" / "s.npz")]) == 2


def test_weights_are_restored_as_they_were_or_not_at_all(tmp_path):
    """Also where the file is what was written: a weight that is missing would be the usual one."""
    save(walkers(), tmp_path / "state.npz")
    arrays, meta = archive.read(tmp_path / "state.npz", "a state", "--save", (), FORMAT)
    weights = meta["weights"]
    spoiled = {
        "lacks side": {name: weight for name, weight in weights.items() if name != "side"},
        "side, stand: numbers": weights | {"side": "1.5", "stand": ""},
        "side: nan is no weight": weights | {"side": np.nan},
        "stand: -1.0 is no weight": weights | {"stand": -1.0},
        "'herd' is no model": weights | {"model": "herd"},
        "unexpected keyword argument 'up'": weights | {"up": 1.0},
    }
    for said, changed in spoiled.items():
        meta["weights"] = changed
        archive.write(tmp_path / "bad.npz", arrays, meta | {"digest": _digest(arrays, meta)})
        with pytest.raises(InputError, match=said):
            restore(tmp_path / "bad.npz")


def test_states_with_two_in_one_place_are_refused(tmp_path):
    """Also where the file is what was saved: what is in the row of the second is what is in that of the first."""
    sim = make_simulation("forest", "bird", 3, 1, False)
    for _ in range(200):
        sim.tick()
    save(sim, tmp_path / "apart.npz")
    restore(tmp_path / "apart.npz")
    for column in sim.crowd:
        for array in column if isinstance(column, tuple) else (column,):
            array[2] = array[0]
    save(sim, tmp_path / "within.npz")
    with pytest.raises(InputError, match="is damaged: characters 0 and 2 are in one place"):
        restore(tmp_path / "within.npz")


def test_a_planner_of_ones_own_is_given_to_restore(tmp_path):
    world, bird, mine = World("yard", (20.0, 20.0)), load_character("bird"), Custom(in_a_circle, [(10.0, 6.0, 0.0)])
    sim = Simulation(world, [bird], mine, 0)
    for _ in range(200):
        sim.tick()
    save(sim, tmp_path / "s.npz")
    with pytest.raises(InputError, match=r"'Custom' is none of .*restore\(path, planner\)"):
        restore(tmp_path / "s.npz")
    same(restore(tmp_path / "s.npz", mine), sim)


class Same(Custom):
    """A planner of somebody's own."""

    def __init__(self, changed):
        super().__init__(in_a_circle, [(10.0, 6.0, 0.0)])
        for name, value in changed.items():
            setattr(self, name, value)


class Remembers(NamedTuple):
    """Plans whose types nothing tells."""

    steps: np.ndarray


UNSAVED = {
    "has the name of one that ships": {"name": "Wander"},
    "a table of the keyword arguments": {"values": lambda: [1]},
    "not JSON serializable": {"values": lambda: {"a": np.zeros(3)}},
    "nothing tells the types of its plans": {"prepare": lambda situation: Remembers(np.zeros(1))},
    "not mine": {"check_plans": Mock(side_effect=ValueError("not mine"))},
}


@pytest.mark.parametrize("said", UNSAVED)
def test_what_could_not_be_restored_is_not_saved(said, tmp_path):
    sim = Simulation(World("yard", (20.0, 20.0)), [load_character("bird")], Same(UNSAVED[said]), 0)
    with pytest.raises(InputError, match=f"cannot be saved: .*{said}"):
        save(sim, tmp_path / "s.npz")
    assert list(tmp_path.iterdir()) == []


def test_ways_are_measured_from_the_beginning_to_the_bit_whenever_it_was_saved(tmp_path):
    whole, parts = (make_simulation("forest", "bird", 2, 1, False) for _ in range(2))
    for ticks in (7, 23, 130):
        ticked(whole, ticks)
        save(ticked(parts, ticks), tmp_path / "s.npz")
        parts = restore(tmp_path / "s.npz")
        assert (parts.distance == whole.distance).all()
    assert (whole.distance > 0.5).all()


def test_versions_agree():
    import tomllib

    from sim import VERSION

    assert tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"] == VERSION
