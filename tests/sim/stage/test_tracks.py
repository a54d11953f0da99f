"""Scenes of several tracks, paths and pins, as `play` has them; and the rehearsal that the studio changes."""

import numpy as np
import pytest

import main
from planner.script.scene import load_scene
from sim.stage.scripted.performance import Performance
from sim.stage.scripted.rehearsal import Rehearsal
from worlds.errors import InputError

SCENE = """
format = 1
name = "Two"
character = "human"
[world]
size = [12.0, 6.0]
[[path]]
points = [[1.0, 2.0], [4.0, 2.0]]
step_length = 0.6
[[path]]
points = [[4.0, 2.0], [6.0, 2.2], [8.0, 3.0]]
step_length = 0.6
after = 0
[[path.moved]]
step = 4
offset = [0.05, 0.02]
at = 7.5
[[key]]
bone = "head"
footprint = 3
rotation_deg = [0.0, 0.0, 40.0]
[[track]]
character = "bird"
[[track.footprint]]
side = "left"
position = [1.0, 4.1]
[[track.footprint]]
side = "right"
position = [1.0, 3.9]
[[track.footprint]]
side = "left"
position = [1.2, 4.1]
"""


@pytest.fixture
def path(tmp_path):
    path = tmp_path / "two.toml"
    path.write_text(SCENE)
    return path


def test_two_characters_play_and_the_quicker_one_stands(path):
    show = Performance(load_scene(path))
    assert [one.name for one in show.characters] == ["human", "bird"]
    ends = [act.end for act in show.acts]
    assert ends[1] < ends[0] == show.end
    com = np.array([show.com(t) for t in np.linspace(0, show.end, 60)])
    assert com[-1, 0, 0] > 7 and np.abs(com[com.shape[0] // 2 :, 1] - com[-1, 1]).max() < 1e-9
    late = show.snapshot(show.end - 0.01)
    assert late.contact[1].all()


def test_paths_follow_each_other_and_a_pin_is_kept(path):
    show = Performance(load_scene(path))
    act = show.acts[0]
    sides = [one.footprint.side for one in act.placed]
    assert all(a != b for a, b in zip(sides, sides[1:], strict=False))
    pinned = [i for i, one in enumerate(act.placed) if one.footprint.at is not None]
    assert len(pinned) == 1 and act.placed[pinned[0]].source == (1, 4)
    assert act.laid.footprints.contact_time[act.laid.row[pinned[0]]] == pytest.approx(7.5, abs=1e-9)


def test_a_key_is_in_the_bones_that_exporters_ask_for(path):
    scene = load_scene(path)
    with_key, without = Performance(scene), Performance(scene.changed(key=()))
    t = with_key.acts[0].keys[0].time
    k = with_key.skeleton(0).names.index("head")
    assert np.abs(with_key.bones(0, t).rotation_wxyz[0, k] - without.bones(0, t).rotation_wxyz[0, k]).max() > 0.1
    np.testing.assert_array_equal(with_key.bones(0, t + 1).rotation_wxyz, without.bones(0, t + 1).rotation_wxyz)


def test_check_knows_such_scenes(path, capsys):
    assert main.main(["check", str(path)]) == 0
    assert "scene Two" in capsys.readouterr().out
    path.write_text(SCENE.replace('bone = "head"', 'bone = "haed"'))
    assert main.main(["check", str(path)]) == 2
    assert "did you mean head" in capsys.readouterr().err
    path.write_text(SCENE.replace("footprint = 3", "footprint = 300"))
    assert main.main(["check", str(path)]) == 2
    assert "300" in capsys.readouterr().err


def test_a_rehearsal_that_cannot_be_walked_stays_as_it_was(path):
    scene = load_scene(path)
    show = Rehearsal(scene.tracks, scene.world)
    before = show.acts
    first, second = scene.tracks[0].path
    late = second.model_copy(update={"moved": (second.moved[0].model_copy(update={"at": 0.5}),)})
    wrong = scene.tracks[0].model_copy(update={"path": (first, late)})
    with pytest.raises(InputError, match="at"):
        show.change([wrong, scene.tracks[1]], scene.world)
    assert show.acts is before
    show.change(scene.tracks[:1], scene.world)
    assert len(show.characters) == 1 and show.com().shape == (1, 3)


def test_who_has_no_footprints_yet_stands(path):
    scene = load_scene(path)
    for count in range(3):
        track = scene.tracks[1].model_copy(update={"footprint": scene.tracks[1].footprint[:count]})
        show = Rehearsal([track], scene.world)
        assert np.isfinite(show.com()).all() and show.snapshot(0.3).contact.all()


def test_a_dragged_timing_glides_and_is_what_is_solved_once_it_is_released():
    scene = load_scene("one_leg_hops")

    def dragged(stance):
        given = [
            one.model_copy(update={"stance_time": stance} if k == 1 else {}) for k, one in enumerate(scene.track.footprint)
        ]
        return [scene.track.model_copy(update={"footprint": tuple(given)})]

    show, moments = Rehearsal(dragged(0.195), scene.world), np.linspace(0.1, 1.4, 40)
    for stance in (0.19, 0.185):
        before = np.array([show.com(t)[0] for t in moments])
        show.change(dragged(stance), scene.world)
        assert np.abs(np.array([show.com(t)[0] for t in moments]) - before).max() < 0.01
    drawn = np.array([show.com(t)[0] for t in moments])
    show.change(dragged(0.185), scene.world, whole=True, released=True)
    anew = Rehearsal(dragged(0.185), scene.world)
    assert np.array_equal(show.acts[0].motion.curve.control, anew.acts[0].motion.curve.control)
    assert np.abs(np.array([show.com(t)[0] for t in moments]) - drawn).max() < 0.001
    last = np.array([anew.com(t)[0] for t in moments])
    assert np.abs(last - drawn).max() > 0.01
    show.settle(0.1)
    show.settle(2.0)
    assert np.array_equal(np.array([show.com(t)[0] for t in moments]), last)
