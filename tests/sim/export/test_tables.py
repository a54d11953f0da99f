"""Tables, trajectories and footsteps, read back: by pandas' and PedPy's readers where they are, else by what Python has."""

import csv
import sqlite3

import numpy as np
import pytest

from motion.arithmetic.gravity import GRAVITY
from planner.script.scene import load_scene
from sim.export.clip.asked import Asked
from sim.export.tables.contacts import export_array, export_contacts
from sim.export.tables.trajectories import export_footsteps, export_sqlite, export_text
from sim.stage.scripted.performance import Performance
from tests.sim.export.readers import clip, recording
from worlds.errors import InputError


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_contacts_and_forces_of_a_scene(tmp_path):
    run = clip(Performance(load_scene("standing_start")))
    export_contacts(run, str(tmp_path / "a.csv"), Asked())
    rows = rows_of(tmp_path / "a.csv")
    actor = run.actors[0]
    assert len(rows) == actor.pose.contact.sum()
    step = 1 / run.rate
    carried = sum(float(row["force_z"]) for row in rows) * step
    assert carried == pytest.approx(GRAVITY * len(run.time) * step, rel=0.01)
    for row in rows[::97]:
        mark = actor.footprints.position[int(row["footprint"])]
        assert np.linalg.norm(mark - [float(row[axis]) for axis in "xyz"]) < 0.7 * actor.character.biped.foot.length
        assert 0 <= float(row["heel_to_toe"]) <= 1 and row["foot"] in ("left", "right")


def test_parquet_holds_what_csv_holds(tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet", reason="needs pyarrow")
    run = clip(recording("human", 2))
    for name in ("a.csv", "a.parquet"):
        export_contacts(run, str(tmp_path / name), Asked())
    table = parquet.read_table(tmp_path / "a.parquet")
    rows = rows_of(tmp_path / "a.csv")
    assert table.column_names == list(rows[0]) and table.num_rows == len(rows)
    np.testing.assert_array_equal(table["impulse_z"].to_numpy(), [float(row["impulse_z"]) for row in rows])


def test_any_array_of_a_recording(tmp_path):
    run = recording("human", 2)
    export_array(run, str(tmp_path / "toe.csv"), Asked(array="toe", character=1))
    rows = rows_of(tmp_path / "toe.csv")
    found = np.array([[[float(row[f"toe.{side}.{k}"]) for k in range(3)] for side in range(2)] for row in rows])
    np.testing.assert_array_equal(found, run.arrays["toe"][:, 1])
    export_array(run, str(tmp_path / "s.csv"), Asked(array="footprint_stance_time"))
    assert len(rows_of(tmp_path / "s.csv")) == len(run.arrays["footprint_side"])
    with pytest.raises(InputError, match="did you mean toe?"):
        export_array(run, str(tmp_path / "x.csv"), Asked(array="toes"))
    assert not (tmp_path / "x.csv").exists()


def test_trajectories_as_text_and_sqlite(tmp_path):
    run = clip(recording("human", 3), rate=10.0)
    export_text(run, str(tmp_path / "a.txt"), Asked())
    export_sqlite(run, str(tmp_path / "a.sqlite"), Asked())
    text = np.loadtxt(tmp_path / "a.txt")
    file = sqlite3.connect(tmp_path / "a.sqlite")
    table = np.array(file.execute("SELECT id, frame, pos_x, pos_y FROM trajectory_data ORDER BY id, frame").fetchall())
    file.close()
    np.testing.assert_allclose(text[:, :4], table, atol=1e-6)
    np.testing.assert_allclose(table[:, 2:].reshape(3, -1, 2)[1], run.actors[1].pose.com[:, :2])


def test_footsteps_meet_and_are_where_the_body_was(tmp_path):
    run = clip(recording("human", 2))
    export_footsteps(run, str(tmp_path / "a.traj"), Asked())
    steps = np.loadtxt(tmp_path / "a.traj", skiprows=1)
    for actor in run.actors:
        own = steps[steps[:, 0] == actor.index + 1]
        np.testing.assert_allclose(own[1:, [1, 3, 4]], own[:-1, [2, 5, 6]])
        assert own[0, 1] == run.time[0] and own[-1, 2] == run.time[-1]
        contacts = actor.footprints.contact_time
        assert len(own) == ((contacts > run.time[0]) & (contacts < run.time[-1])).sum() + 1
        for k, axis in enumerate((3, 4)):
            np.testing.assert_allclose(own[:, axis], np.interp(own[:, 1], run.time, actor.pose.com[:, k]), atol=1e-5)


def test_pedpy_reads_all_three(tmp_path):
    pedpy = pytest.importorskip("pedpy", reason="needs PedPy")
    run = clip(recording("human", 3), rate=10.0)
    for name, export in (("a.txt", export_text), ("a.sqlite", export_sqlite), ("a.traj", export_footsteps)):
        export(run, str(tmp_path / name), Asked())
    text = pedpy.load_trajectory(trajectory_file=tmp_path / "a.txt")
    tables = pedpy.load_trajectory_from_jupedsim_sqlite(trajectory_file=tmp_path / "a.sqlite")
    steps = pedpy.load_trajectory_from_vadere(trajectory_file=tmp_path / "a.traj", frame_rate=10.0)
    assert text.frame_rate == tables.frame_rate == 10.0
    area = pedpy.load_walkable_area_from_jupedsim_sqlite(trajectory_file=tmp_path / "a.sqlite")
    assert area.polygon.area == pytest.approx(np.prod(run.world.size))
    speeds = [pedpy.compute_individual_speed(traj_data=data, frame_step=5) for data in (text, tables)]
    assert speeds[1].speed.mean() == pytest.approx(speeds[0].speed.mean(), rel=1e-4)
    com = np.stack([actor.pose.com[:, :2] for actor in run.actors])
    own = np.linalg.norm(com[:, 10:] - com[:, :-10], axis=2)
    middle = speeds[0][(speeds[0].frame >= 5) & (speeds[0].frame < len(run.time) - 5)]
    assert middle.speed.mean() == pytest.approx(own.mean(), rel=0.01)
    who = sorted(steps.data.id.unique())  # Vadere counts from 1; between two footsteps PedPy draws a straight line
    for actor, one in zip(run.actors, who, strict=True):
        walked = steps.data[steps.data.id == one]
        places = np.column_stack([np.interp(walked.frame / 10, run.elapsed, actor.pose.com[:, k]) for k in range(2)])
        assert np.linalg.norm(walked[["x", "y"]].to_numpy() - places, axis=1).max() < 0.12
