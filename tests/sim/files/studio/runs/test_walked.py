"""Live and recorded runs opened as scenes: the same world, prints and times, and a motion near the live one."""

import numpy as np
import pytest

from motion.characters.character import load_character
from planner.modes.steer import Steered
from planner.modes.wander import Wander
from planner.river.rock_hop import RockHop
from planner.script.scene import load_scene
from planner.script.shaping import ComPull, Key, Stretch, Style
from planner.script.track import Track
from sim.files.recording import Recorder
from sim.files.studio.keeping import world_for
from sim.files.studio.runs import grounds, walked, walkers
from sim.files.studio.writing import write_scene
from sim.stage.commands import PlantTree, apply, steer
from sim.stage.scripted.performance import Performance
from sim.stage.scripted.rehearsal import Rehearsal
from sim.stage.simulation import Simulation
from worlds.errors import InputError
from worlds.level import load_level
from worlds.world import World

NEAR = 0.03
"""The live solver sees three steps ahead and the scene's all of them: so far their curves may differ [m], in the middle."""


def run(level, planner, kind, seconds, count=1):
    sim = Simulation(load_level(level), [load_character(kind)] * count, planner, seed=3)
    sim.keep_footprints()
    coms = []
    for tick in range(int(60 * seconds)):
        if isinstance(planner, Steered):
            wish = ("walk", "run", "stand", "walk")[tick // 150 % 4]
            steer(sim, 0.3, wish)
        sim.tick()
        coms.append(sim.com())
    return sim, np.array(coms)


@pytest.mark.parametrize(
    "level, planner, kind",
    [("forest", Wander, "human"), ("river_easy", RockHop, "bird"), ("forest", Steered, "human"), ("hills", Wander, "dinosaur")],
)
def test_a_run_becomes_the_same_walk(level, planner, kind, tmp_path):
    sim, coms = run(level, planner(), kind, 14)
    write_scene(walked.document_of_cast(sim), tmp_path / "walk.toml")
    show = Performance(load_scene(tmp_path / "walk.toml"))
    live, played = sim.walked().footprints, show.walked().footprints
    assert (played.side == live.side).all() and len(live.side) > 10
    assert np.array_equal(played.position, live.position) and np.allclose(played.heading, live.heading, atol=1e-12)
    assert np.abs(played.contact_time[1:] - live.contact_time[1:]).max() < 1e-6
    done = slice(1, -3)  # how long the last ones stand, nobody knows yet
    assert np.allclose(played.stance_time[done], live.stance_time[done], atol=1e-6)
    assert np.allclose(played.nominal_length[done], live.nominal_length[done], atol=1e-6)
    times = np.arange(120, 60 * 12)
    away = [np.linalg.norm(show.com((k + 1) / 60)[0] - coms[k, 0]) for k in times]
    assert np.median(away) < NEAR and np.max(away) < 5 * NEAR
    for name in ("trees", "rocks", "size", "terrain_parameters", "goal"):
        assert np.array_equal(getattr(show.scene.world, name), getattr(sim.world, name)), name
    assert show.scene.world.name == sim.world.name


def test_a_recording_is_opened_as_the_run_was(tmp_path):
    sim = Simulation(load_level("forest"), [load_character("human")] * 3, Wander(), seed=1)
    recorder = Recorder(sim)
    for tick in range(400):
        sim.tick()
        recorder.capture()
        if tick == 200:
            apply(sim, PlantTree(3.0, 3.0, 0.4))
    recorder.save(tmp_path / "run.npz")
    document = walked.document_in(tmp_path / "run.npz")
    assert document == walked.document_of_cast(sim)
    assert len(document.tracks) == 3 and len(document.head.tree) == len(sim.world.trees)
    Rehearsal(document.tracks, world_for(document, None))


def test_long_runs_of_many_keep_their_latest_footprints(monkeypatch):
    monkeypatch.setattr(walked, "MOST_FOOTPRINTS", 40)
    monkeypatch.setattr(walked, "MOST_TRACKS", 2)
    sim, _ = run("forest", Wander(), "bird", 12, 4)
    document = walked.document_of_cast(sim, 2)
    nearest = np.linalg.norm(sim.com() - sim.com()[2], axis=1).argsort()[1]
    ends = [track.footprint[-1].position for track in document.tracks]
    newest = sim.feet().position[:, 1, :2]
    assert ends == [tuple(newest[2]), tuple(newest[nearest])]
    assert 20 < sum(len(track.footprint) for track in document.tracks) <= 42
    show = Rehearsal(document.tracks, world_for(document, None))
    live, since = sim.walked(), []
    for c, k in enumerate((2, nearest)):
        mine = show.acts[c].laid.footprints.contact_time[-1]
        since.append(live.footprints.contact_time[live.character == k][-1] - mine)
    assert np.isclose(*since)  # they keep their places in each other's time


def test_what_has_not_begun_is_no_scene():
    sim = Simulation(load_level("forest"), [load_character("bird")], Steered())
    with pytest.raises(InputError, match="let it run"):
        walked.document_of_cast(sim)


def test_a_scene_that_is_played_is_that_scene():
    scene = load_scene("sprint")
    assert walked.document_of_cast(Performance(scene)).tracks == scene.tracks


def test_a_recorded_scene_keeps_how_it_was_carried(tmp_path):
    scene = load_scene("fig01_steps_and_a_hop")
    tracks = [track.model_copy(update={"style": Style(bounce=1.4, lean_deg=8.0, heaviness=0.8)}) for track in scene.tracks]
    show = Rehearsal(tracks, scene.world)
    recorder = Recorder(show)
    for k in range(int(show.end * 60)):
        recorder.capture(k / 60)
    recorder.save(tmp_path / "run.npz")
    found = walked.document_in(tmp_path / "run.npz")
    assert [track.style for track in found.tracks] == [track.style for track in tracks]


def recorded(show, path):
    recorder = Recorder(show)
    for k in range(int(show.end * 60)):
        recorder.capture(k / 60)
    recorder.save(path)
    return walked.document_in(path)


def test_a_recorded_scene_keeps_what_shapes_it(tmp_path):
    """Stretches, pulls, keys, support: they are there again, and the motion is the same."""
    scene = load_scene("fig17_large_leap")
    shapes = {
        "stretch": (Stretch(first=3, last=5, gravity=0.6, leg=0.93, comfort=1.5, arms=1.4),),
        "pull": (ComPull(footprint=4, after=0.1, position=(2.0, 2.0, 1.2), stiffness=80.0),),
        "key": (Key(bone="head", footprint=4, after=0.2, rotation_deg=(0.0, 20.0, 5.0)),),
        "support": "middle",
    }
    show = Rehearsal([track.model_copy(update=shapes) for track in scene.tracks], scene.world)
    found = recorded(show, tmp_path / "run.npz")
    for name, value in shapes.items():
        assert getattr(found.tracks[0], name) == value
    assert [one.crouch for one in found.tracks[0].footprint] == [1.0] * len(found.tracks[0].footprint)
    again = Rehearsal(found.tracks, world_for(found, None))
    for time in np.linspace(0.5, show.end - 1.0, 12):
        np.testing.assert_allclose(again.com(time), show.com(time), atol=2e-3)


def test_what_shapes_a_scene_goes_with_its_footprints_when_the_first_are_gone():
    stretch, pull = Stretch(first=1, last=4, gravity=0.5), ComPull(footprint=3, position=(0.0, 0.0, 1.0))
    key = Key(bone="head", footprint=1, rotation_deg=(0.0, 0.0, 9.0))
    prints = Performance(load_scene("sprint")).walked().footprints
    given = walkers.Walker(load_character("human"), prints, Track(stretch=(stretch,), pull=(pull,), key=(key,)))
    found = walkers.cut(given, float(prints.contact_time[2]))
    assert len(found.footprints.side) == len(prints.side) - 2
    assert (found.shapes.stretch[0].first, found.shapes.stretch[0].last, found.shapes.pull[0].footprint) == (0, 2, 1)
    assert found.shapes.key == ()


def test_a_recording_over_a_heightmap_is_opened(tmp_path, monkeypatch):
    monkeypatch.setenv("FOOTFALL_STATE", str(tmp_path / "state"))
    heights = np.random.default_rng(2).uniform(0, 0.15, (21, 31))
    world = World("bumps", (30.0, 20.0), "heightmap", (1.0,), heights, start=(8.0, 8.0))
    sim = Simulation(world, [load_character("human")], Wander(), seed=1)
    recorder = Recorder(sim)
    for _ in range(600):
        sim.tick()
        recorder.capture()
    recorder.save(tmp_path / "run.npz")
    document = walked.document_in(tmp_path / "run.npz")
    ground = world_for(document, None)
    np.testing.assert_allclose(ground.heights, heights, atol=0.15 / 65535)
    show = Rehearsal(document.tracks, ground)
    np.testing.assert_allclose(show.walked().footprints.position, sim.walked().footprints.position, atol=1e-4)
    assert walked.document_in(tmp_path / "run.npz") == document and len(list((tmp_path / "state" / "grounds").iterdir())) == 1
    write_scene(document, tmp_path / "walk.toml")
    np.testing.assert_array_equal(load_scene(tmp_path / "walk.toml").world.heights, ground.heights)


def test_a_ground_below_nothing_has_no_picture():
    world = World("pit", (30.0, 20.0), "heightmap", (1.0,), np.full((21, 31), -1.0), start=(8.0, 8.0))
    with pytest.raises(InputError, match="below 0"):
        grounds.tables_of(world)
