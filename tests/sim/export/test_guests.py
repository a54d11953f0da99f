"""Runs that people come into and go out of, let out: each of them is a character, for as long as it was there."""

import sqlite3
from functools import cache

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.people.visitors import Visiting
from sim.export.clip.asked import Asked
from sim.export.clip.cutting import clip_of
from sim.export.films import replay_of
from sim.export.skeletons.bvh import bvh_of
from sim.export.skeletons.glb import export_glb, gltf_of
from sim.export.tables.contacts import contacts_of
from sim.export.tables.trajectories import export_footsteps, export_sqlite, export_text
from sim.files.recording import Recorder
from sim.stage.simulation import Simulation
from tests.sim.export.readers import node
from worlds.contents.traffic import Exit, Source, Traffic
from worlds.errors import InputError
from worlds.world import World


@cache
def run():
    """Nine rows, through which more people come; some of them are never used."""
    traffic = Traffic(
        source=[Source(area=[(0.5, 1.0), (2.0, 5.0)], rate=0.6)], exit=[Exit(name="out", area=[(7.0, 0.5), (9.0, 5.5)])]
    )
    sim = Simulation(World("yard", (10.0, 6.0)), [load_character("human")] * 9, Visiting(traffic), 2)
    recorder = Recorder(sim)
    while sim.time < 25.0:
        sim.tick()
        if sim.ticks % 6 == 0:
            recorder.capture()
    return recorder.recording()


@cache
def clip():
    return clip_of(run(), Asked())


def test_each_of_them_is_a_character():
    assert len(clip().actors) > 3 and [actor.index for actor in clip().actors] == list(range(len(clip().actors)))
    for actor in clip().actors:
        here = actor.pose.com[actor.there]
        assert not actor.there.all() and not actor.pose.contact[~actor.there].any()
        assert np.linalg.norm(np.diff(here, axis=0), axis=1).max() < 0.5, "nobody jumps"
        assert here[0, 0] < 2.5
    one = clip_of(run(), Asked(character=2)).actors[0]
    np.testing.assert_array_equal(one.pose.com, clip().actors[2].pose.com)
    with pytest.raises(InputError, match="counted from 0"):
        clip_of(run(), Asked(character=99))


def test_trajectories_tell_only_who_is_there(tmp_path):
    export_text(clip(), str(tmp_path / "a.txt"), Asked())
    export_sqlite(clip(), str(tmp_path / "a.sqlite"), Asked())
    export_footsteps(clip(), str(tmp_path / "a.traj"), Asked())
    rows = np.loadtxt(tmp_path / "a.txt")
    assert len(rows) == sum(actor.there.sum() for actor in clip().actors)
    file = sqlite3.connect(tmp_path / "a.sqlite")
    found = np.array(file.execute("SELECT id, frame, pos_x, pos_y FROM trajectory_data ORDER BY id, frame").fetchall())
    file.close()
    np.testing.assert_allclose(found, rows[:, :4], atol=1e-5)
    steps = np.loadtxt(tmp_path / "a.traj", skiprows=1)
    for actor in clip().actors:
        mine = steps[steps[:, 0] == actor.index + 1]
        assert (
            mine[:, 1].min() >= actor.time[actor.there].min() - 1e-5
            and mine[:, 2].max() <= actor.time[actor.there].max() + 1e-5
        )


def test_pedpy_reads_them(tmp_path):
    pedpy = pytest.importorskip("pedpy", reason="needs PedPy")
    export_text(clip(), str(tmp_path / "a.txt"), Asked())
    found = pedpy.load_trajectory_from_txt(trajectory_file=tmp_path / "a.txt")
    assert found.frame_rate == pytest.approx(10.0) and found.data.id.nunique() == len(clip().actors)
    line = pedpy.MeasurementLine([(4.0, 0.0), (4.0, 6.0)])
    count, _ = pedpy.compute_n_t(traj_data=found, measurement_line=line)
    passed = [actor for actor in clip().actors if actor.pose.com[actor.there][-2, 0] > 4.0]  # the last frame has no next one
    assert count.cumulative_pedestrians.max() == len(passed)


def test_who_is_not_there_has_no_size_and_no_contacts(tmp_path):
    export_glb(clip(), str(tmp_path / "a.glb"), Asked())
    assert node("validate.mjs", str(tmp_path / "a.glb")) == [[0, 0, []]]
    for actor in clip().actors:
        table = contacts_of(actor, clip().time)
        assert set(table["time"]) <= set(clip().time[actor.there].tolist())


def test_sizes_are_keyed_where_somebody_comes_or_goes():
    tables = gltf_of(clip()).tables
    for actor, animation in zip(clip().actors, tables["animations"], strict=True):
        (channel,) = [one for one in animation["channels"] if one["target"]["path"] == "scale"]
        sampler = animation["samplers"][channel["sampler"]]
        assert sampler["interpolation"] == "STEP"
        assert tables["accessors"][sampler["input"]]["count"] == np.count_nonzero(np.diff(actor.there)) + 1


def test_a_bvh_is_as_long_as_its_stay():
    for actor in clip().actors[:3]:
        assert f"Frames: {actor.there.sum()}\n" in bvh_of(actor, clip().rate)


def test_films_show_who_is_there():
    cast = replay_of(clip())
    for k in (10, 120, 240):
        there = [actor.there[k] for actor in clip().actors]
        assert cast.present(float(clip().time[k])).tolist() == there
