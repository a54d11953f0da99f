"""Prints in, a scene out: read with their faults, measured by known answers, walked where they are."""

import json
from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest

import main
from planner.script.scene import load_scene
from sim.files.imports.trackways import trackway
from sim.files.imports.trackways.prints import Prints, read_prints
from sim.files.recording import Recorder
from sim.reports.measure import measure
from sim.stage.scripted.performance import Performance
from worlds.errors import InputError

SCALE = 0.005


def course(count=14, pace=0.7, gauge=0.18, first=0):
    """Prints (n, 2) [m] of an even trackway along +y: left ones at -gauge / 2."""
    k = np.arange(count)
    return np.column_stack([0.5 * gauge * np.where((k + first) % 2 == 0, -1.0, 1.0), pace * k])


def tps(*tracks, extra=""):
    """A landmark file of trackways in metres."""
    lines = []
    for k, points in enumerate(tracks):
        words = ["NA NA" if np.isnan(x) else f"{x / SCALE:.5f} {y / SCALE:.5f}" for x, y in points]
        lines += [f"LM={len(points)}", *words, f"IMAGE=Track{k}.png", f"ID={k}", extra, ""]
    return "\n".join(lines)


@pytest.fixture
def written(tmp_path):
    def write(text, name="prints.tps"):
        path = tmp_path / name
        path.write_text(text, "utf-8")
        return str(path)

    return write


def test_landmarks_are_read_with_what_is_missing(written):
    points = course()
    points[5] = np.nan
    found = read_prints(written(tps(points, course(8), extra="SCALE=0.005")))
    assert [one.name for one in found] == ["Track0", "Track1"] and found[0].scale == 0.005
    assert np.isnan(found[0].points[5]).all() and np.isfinite(found[0].points).sum() == 2 * 13
    np.testing.assert_allclose(found[1].points * SCALE, course(8), atol=1e-6)


def test_a_table_is_read(written):
    rows = "\n".join(f"{name},{y},{x}" for name in "ab" for x, y in course(6))
    found = read_prints(written(f"trackway,y,x\n{rows}\na,NA,NA\na,9.0,0\na,9.7,0.1\n", "prints.csv"))
    assert [len(one.points) for one in found] == [9, 6] and np.isnan(found[0].points[6]).all()
    np.testing.assert_allclose(found[1].points, course(6))


@pytest.mark.parametrize(
    "text, said",
    [
        ("", "no trackway in it"),
        ("LM=three\n", "line 1: LM=three"),
        ("LM=99999999\n1 2\n", "line 1: LM=99999999"),
        ("LM=5\n1 2\n3 4\n", "the file ends after 2 of LM=5"),
        ("LM=4\n1 2\n3 x\n5 6\n7 nan 9\n", "line 3: '3 x': x y, or NA NA"),
        ("LM=4\n1 2\n3 1e400\n5 6\n7 9\n", "line 3"),
        ("LM=4\n1 2\n1 2\n5 6\n7 9\n", "trackway 1: prints 1 and 2 are in one place"),
        ("LM=3\n1 2\n3 4\n5 6\n", "trackway 1: 3 prints; 4 at least"),
        ("LM=4\n1 2\n3 4\n5 6\nNA NA\n", "trackway 1: print 4 is missing"),
        ("hello\n", "line 1: 'hello'"),
        ("LM=4\n1 2\n3 4\n5 6\n7 8\nSCALE=-1\n", "SCALE=-1"),
    ],
)
def test_faults_are_named_with_their_lines(written, text, said):
    path = written(text)
    with pytest.raises(InputError) as fault:
        read_prints(path)
    assert said in str(fault.value) and str(fault.value).startswith(path)


def test_what_is_no_text_or_no_file_is_refused(tmp_path):
    binary = tmp_path / "b.tps"
    binary.write_bytes(b"LM=4\n\xff\xfe\x00")
    for path, said in (
        (binary, "is no text"),
        (tmp_path / "prints.xyz", ".tps and .csv"),
        (tmp_path / "n.tps", "cannot be read"),
    ):
        with pytest.raises(InputError, match=said):
            read_prints(path)


def test_figures_of_an_even_trackway():
    way = trackway.completed(Prints("even", course(20, 0.7, 0.2)), 1.0, 1.1, "left")
    figures = trackway.report(way, "ruiz")
    assert figures["stride"]["mean"] == pytest.approx(1.4) and figures["gauge"]["mean"] == pytest.approx(0.2)
    assert figures["pace"]["mean"] == pytest.approx(np.hypot(0.7, 0.2))
    assert figures["pace_angulation_deg"]["mean"] == pytest.approx(180 - 2 * np.degrees(np.arctan2(0.2, 0.7)))
    for law, k in (("alexander", 0.25), ("ruiz", 0.226)):
        assert figures["speed"][law] == pytest.approx(k * sqrt(9.81) * 1.4**1.67 * 1.1**-1.17, rel=1e-3)
    assert figures["walked"] == pytest.approx(figures["speed"]["ruiz"])
    np.testing.assert_allclose(way.headings, pi / 2)


def test_gaits_by_the_relative_stride():
    assert [trackway.gait(x) for x in (1.0, 1.99, 2.5, 2.9, 3.0)] == ["walk", "walk", "trot", "trot", "run"]


def test_a_missing_print_is_where_it_must_have_been():
    """On a bent course as on a straight one, between the same foot's neighbours."""
    turn = np.array([[cos(radians(4 * k)), sin(radians(4 * k))] for k in range(12)]) * 10
    points = turn.copy()
    points[[5, 6]] = np.nan
    way = trackway.completed(Prints("bent", points), 1.0, 1.1, "right")
    assert np.flatnonzero(way.inferred).tolist() == [5, 6]
    np.testing.assert_allclose(way.points[5], 0.5 * (turn[3] + turn[7]))
    assert way.side.tolist()[:3] == [1, 0, 1]


@pytest.fixture
def imported(written, tmp_path, capsys):
    """Two animals of one site, as scenes, and the report."""
    wavy, straight = course(16, 0.8, 0.25), course(10, 0.6, 0.3, first=1) + (3.0, 1.0)
    wavy[:, 0] += 0.4 * np.sin(wavy[:, 1] / 3)
    out = str(tmp_path / "site.toml")
    arguments = ["import-trackway", written(tps(wavy, straight)), "--scale", str(SCALE), "--hip-height", "1.9", "2.4"]
    assert main.main([*arguments, "--first-side", "left", "right", "--out", out, "--json"]) == 0
    figures = json.loads(capsys.readouterr().out)
    return figures, [wavy, straight], [str(tmp_path / f"site.{k}.toml") for k in (1, 2)]


def test_scenes_stand_on_their_prints_at_the_speed_of_the_law(imported):
    figures, tracks, paths = imported
    worlds = set()
    for points, path, one in zip(tracks, paths, figures, strict=True):
        scene = load_scene(path)
        worlds.add(scene.world.size)
        show = Performance(scene)
        recorder = Recorder(show)
        while not show.over:
            recorder.capture()
            show.tick()
        worst = measure(recorder.recording())["worst"]
        assert worst["footprint_error"] < 1e-3 and worst["skate"] < 1e-3
        places = np.array([footprint.position for footprint in scene.track.footprint])
        np.testing.assert_allclose(places - places[0], points - points[0], atol=1e-4)
        walked = show.motion.footprints
        moved = np.flatnonzero(~walked.stands)[1:]
        along = np.hypot(*(walked.position[moved[2:], :2] - walked.position[moved[:-2], :2]).T)
        times = walked.contact_time[moved[2:]] - walked.contact_time[moved[:-2]]
        assert along[1:-1].sum() / times[1:-1].sum() == pytest.approx(one["speed"]["ruiz"], rel=0.01)
        assert show.motion.character.biped.timing.hip_height == pytest.approx(one["hip_height"])
    assert len(worlds) == 1


def test_all_trackways_play_together(imported, tmp_path):
    together, each = load_scene(tmp_path / "site.toml"), [load_scene(tmp_path / f"site.{k}.toml") for k in (1, 2)]
    assert [track.footprint for track in together.tracks] == [scene.track.footprint for scene in each]
    assert [track.character_scale for track in together.tracks] == [scene.track.character_scale for scene in each]
    show = Performance(together)
    assert len(show.characters) == 2 and show.end == pytest.approx(max(Performance(scene).end for scene in each))


def test_options_that_do_not_fit_are_refused(written, tmp_path, capsys):
    path, out = written(tps(course())), str(tmp_path / "o.toml")
    for more, said in (
        (["--hip-height", "1", "2", "3", "--scale", "1"], "one for each of the 1 trackways"),
        (["--hip-height", "1", "--trackway", "3", "--scale", "1"], "--trackway 3"),
        (["--hip-height", "1"], "give --scale"),
        (["--hip-height", "1", "--scale", "900"], "--scale: the prints reach over"),
        (["--hip-height", "0.05", "--scale", str(SCALE)], "leaps"),
    ):
        assert main.main(["import-trackway", path, "--out", out, *more]) == 2
        assert said in capsys.readouterr().err
    assert not (tmp_path / "o.toml").exists()


def test_inferred_prints_are_marked_in_the_scene(written, tmp_path, capsys):
    points = course()
    points[4] = np.nan
    out = str(tmp_path / "s.toml")
    arguments = ["import-trackway", written(tps(points)), "--scale", str(SCALE), "--hip-height", "1.9", "--out", out]
    assert main.main(arguments) == 0
    assert "inferred: print 5" in capsys.readouterr().out
    assert [footprint.inferred for footprint in load_scene(out).track.footprint] == [k == 4 for k in range(14)]
