"""Trajectories of every format as the same ways, with their faults by line."""

import sqlite3

import numpy as np
import pytest

from sim.files.imports.trajectories.people import read_ways
from sim.files.imports.trajectories.ways import between
from worlds.errors import InputError

FPS = 10
FRAMES = np.arange(30)


def place(person, frame):
    """Where somebody is at a frame [m]."""
    return 0.11 * frame + person, 2.0 * person + 0.5 * np.sin(frame / 10)


ROWS = [(person, frame, *place(person, frame)) for frame in FRAMES for person in (1, 2, 3) if frame >= 4 * person]


def database(path, fps="10", value=None):
    with sqlite3.connect(path) as made:
        made.execute("CREATE TABLE trajectory_data (frame INTEGER, id INTEGER, pos_x REAL, pos_y REAL, ori_x REAL, ori_y REAL)")
        made.execute("CREATE TABLE metadata (key TEXT PRIMARY KEY, value TEXT)")
        made.execute("INSERT INTO metadata VALUES ('fps', ?)", (fps,))
        rows = [(int(f), i, float(x) if value is None else value, float(y), 1, 0) for i, f, x, y in ROWS]
        made.executemany("INSERT INTO trajectory_data VALUES (?, ?, ?, ?, ?, ?)", rows)
    return path


def text(kind):
    if kind == "jupedsim.txt":
        head = "# description: of JuPedSim\n# framerate: 10.00\n# ID\tframe\tx/m\ty/m\tz/m\n"
        return head + "".join(f"{i}\t{f}\t{x:.6f}\t{y:.6f}\t0.0\n" for i, f, x, y in ROWS)
    if kind == "pedpy_cm.txt":
        rows = "".join(f"{i} {f} {100 * x:.4f} {100 * y:.4f}\n" for i, f, x, y in ROWS)
        return "# framerate: 10 fps\n# id frame x/cm y/cm\n" + rows
    if kind == "obsmat.txt":  # of a film at 25 a second, annotated every tenth frame
        return "".join(f"{10 * f + 780:.7e} {i:.7e} {x:.7e} 0 {y:.7e} 0 0 0\n" for i, f, x, y in ROWS)
    if kind == "plain.csv":
        return "y;x;time;id\n" + "".join(f"{y:.6f};{x:.6f};{f / FPS:.3f};{i}\n" for i, f, x, y in ROWS)
    return "".join(f"{i} {f / FPS:.3f} {x:.6f} {y:.6f}\n" for i, f, x, y in ROWS)


def check(ways, rate=FPS):
    assert sorted(way.name for way in ways) == ["1", "2", "3"]
    for way in ways:
        person = int(way.name)
        frames = FRAMES[4 * person :]
        np.testing.assert_allclose(way.time - way.time[0], (frames - frames[0]) / rate, atol=1e-6)
        np.testing.assert_allclose(way.place, np.column_stack(place(person, frames)), atol=1e-5)
        assert not way.landed.any()


@pytest.mark.parametrize("kind", ["jupedsim.txt", "pedpy_cm.txt", "plain.csv", "plain.txt"])
def test_texts_say_the_same(tmp_path, kind):
    path = tmp_path / kind
    path.write_text(text(kind), "utf-8")
    check(read_ways(path))


def test_a_database_says_the_same(tmp_path):
    check(read_ways(database(tmp_path / "t.sqlite")))


def test_an_obsmat_is_of_two_and_a_half_annotations_a_second(tmp_path):
    path = tmp_path / "obsmat.txt"
    path.write_text(text("obsmat.txt"), "utf-8")
    check(read_ways(path), 2.5)
    check(read_ways(path, fps=25), 2.5)


def test_frames_of_forecasters_are_no_plain_table(tmp_path):
    """Rows by frame, or by person: neither is taken for id, t, x, y, and plain tables are not taken for frames."""
    path = tmp_path / "biwi_eth.txt"
    by_frame = "".join(f"{10 * f + 780}.0\t{i}.0\t{x:.6f}\t{y:.6f}\n" for i, f, x, y in ROWS)
    by_person = "".join(f"{6 * f}\t{i}\t{x:.6f}\t{y:.6f}\t1.0\t0.0\n" for i, f, x, y in sorted(ROWS))
    for content in (by_frame, by_person):
        path.write_text(content, "utf-8")
        check(read_ways(path), 2.5)
    for rows in (ROWS, sorted(ROWS)):
        path.write_text("".join(f"{i} {f} {x:.6f} {y:.6f}\n" for i, f, x, y in rows), "utf-8")
        check(read_ways(path), 1.0)


def splines(people, scale=0.02):
    """UCY's file of ways in pixels, as its tool writes it."""
    parts = [f"{len(people)} - the number of splines\n"]
    for rows in people:
        parts.append(f"{len(rows)} - Num of control points\n")
        parts += [f"{x / scale:.6f} {y / scale:.6f} {frame} 90.000000 - (2D point, m_id)\n" for frame, x, y in rows]
    return "".join(parts)


def test_splines_are_metres_by_a_homography(tmp_path):
    path, matrix = tmp_path / "crowds.vsp", tmp_path / "H.txt"
    people = [[(f, x, y) for i, f, x, y in ROWS if i == person] for person in (1, 2, 3)]
    path.write_text(splines(people) + "7 - obstacles, which nobody asks for\n", "utf-8")
    matrix.write_text("0.02 0 0\n0 0.02 0\n0 0 1\n", "utf-8")
    check(read_ways(path, homography=str(matrix)), 25)
    matrix.write_text("0.02, 0, 3, 0, -0.02, 1, 0, 0, 2", "utf-8")
    (first, *_) = read_ways(path, fps=10, homography=str(matrix))
    np.testing.assert_allclose(first.place[0], [(people[0][0][1] + 3) / 2, (1 - people[0][0][2]) / 2], atol=1e-6)


@pytest.mark.parametrize(
    "content, matrix, said",
    [
        ("1 - the number of splines\n", "1 0 0 0 1 0 0 0 1", "ends where a number of control points"),
        ("2 - the number of splines\n1 - Num of control points\n1 2 3 4\n", "1 0 0 0 1 0 0 0 1", "ends where a number"),
        ("x - the number of splines\n", "1 0 0 0 1 0 0 0 1", "line 1: 'x': a number of splines"),
        ("99999999 - the number of splines\n", "1 0 0 0 1 0 0 0 1", "0 to 20,000"),
        ("1 - the number of splines\n3 - Num\n1 2 3 4\n", "1 0 0 0 1 0 0 0 1", "ends amid the control points"),
        ("1 - the number of splines\n1 - Num\n1 nan 3 4\n", "1 0 0 0 1 0 0 0 1", "line 3: '1 nan 3 4': x, y, frame"),
        ("0 - the number of splines\n", "1 0 0 0 1 0 0 0 1", "nobody is in it"),
        ("1 - the number of splines\n1 - Num\n1 2 3 4\n", "1 0 0 0 1 0 0 0", "8 words; a homography is nine numbers"),
        ("1 - the number of splines\n1 - Num\n1 2 3 4\n", "1 0 0 1 0 0 0 0 1", "determinant is 0"),
        ("1 - the number of splines\n1 - Num\n1 2 3 4\n", "1 0 0 0 1 0 1 0 -1", "to infinity"),
        ("1 - the number of splines\n1 - Num\n1 2 3 4\n", None, "give --homography H.txt"),
        ("1 0 0 0\n1 1 1 0\n", "1 0 0 0 1 0 0 0 1", "is for .vsp files"),
    ],
)
def test_faults_of_splines_are_named(tmp_path, content, matrix, said):
    path, other = tmp_path / "people.dat", tmp_path / "H.txt"
    path.write_text(content, "utf-8")
    other.write_text(matrix or "", "utf-8")
    with pytest.raises(InputError, match=said):
        read_ways(path, homography=str(other) if matrix else None)


def test_footsteps_of_vadere_are_kept(tmp_path):
    """Who waits before a step is where it begins until then."""
    path = tmp_path / "postvis.traj"
    path.write_text(
        "#IDXCOL=2,DATACOL=5,SEP=' '\n"
        "pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1 targetId-PID2\n"
        "7 0.0 0.5 1.0 2.0 1.6 2.0 1\n7 0.5 1.0 1.6 2.0 2.2 2.1 1\n7 3.0 3.5 2.2 2.1 2.8 2.1 1\n8 0.0 0.0 5.0 5.0 5.0 5.0 1\n",
        "utf-8",
    )
    one, other = read_ways(path)
    np.testing.assert_allclose(one.time, [0, 0.5, 1.0, 3.0, 3.5])
    np.testing.assert_allclose(one.place, [[1, 2], [1.6, 2], [2.2, 2.1], [2.2, 2.1], [2.8, 2.1]])
    assert one.landed.tolist() == [False, True, True, False, True] and not other.landed.any()


@pytest.mark.parametrize(
    "content, said",
    [
        ("", "has no rows"),
        ("1 0.0 1.0\n", "columns"),
        ("id,t,x\n1,2,3\n", "y missing"),
        ("1 0 0 0\n1 1 x 0\n", "line 2: '1 1 x 0'"),
        ("1 0 0 0\n1 1 inf 0\n", "line 2"),
        ("1 0 0 0\n1 0 1 0\n", "id 1 is in two places at 0 s"),
        ("1 0 0 0\n1 1e6 1 0\n", "spans 1,000,000 s"),
        ("1 0 0 0\n1 1 90000 0\n", "spans 90,000 m"),
        ("# framerate: 0\n# x/m\n1 0 0 0\n", "give --fps"),
        ("pedestrianId simTime startX-PID1\n1 2 3\n", "startY"),
        ("pedestrianId simTime endTime startX startY endX endY\n1 2 1 0 0 1 1\n", "ends before it begins"),
    ],
)
def test_faults_are_named(tmp_path, content, said):
    path = tmp_path / "people.txt"
    path.write_text(content, "utf-8")
    with pytest.raises(InputError) as fault:
        read_ways(path)
    assert said in str(fault.value) and str(fault.value).startswith(str(path))


def test_databases_that_are_none(tmp_path):
    cut = database(tmp_path / "cut.sqlite")
    cut.write_bytes(cut.read_bytes()[:2500])
    other = tmp_path / "other.sqlite"
    sqlite3.connect(other).execute("CREATE VIEW trajectory_data AS SELECT 1 AS frame, 1 AS id, 0 AS pos_x, 0 AS pos_y")
    for path, said in (
        (cut, "damaged"), (other, "no table"), (database(tmp_path / "fps.sqlite", "fast"), "metadata.fps"),
        (database(tmp_path / "text.sqlite", value="here"), "must be numbers"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=said):
            read_ways(path)
    with pytest.raises(InputError, match="is no database"):
        (tmp_path / "t.txt").write_text("1 0 0 0", "utf-8")
        read_ways(tmp_path / "t.txt", "jupedsim")


def test_a_part_of_a_file(tmp_path):
    ways = read_ways(database(tmp_path / "t.sqlite"))
    some = between(ways, (1.0, 2.0))
    assert all(way.begin >= 0 and way.end <= 1.0 + 1e-9 for way in some)
    assert min(way.begin for way in between(ways, None)) == 0
    with pytest.raises(InputError, match="nobody is seen twice between 50 and 60 s; the file is of 0.4 to 2.9 s"):
        between(ways, (50.0, 60.0))


def test_pedpy_reads_the_same(tmp_path):
    pedpy = pytest.importorskip("pedpy", reason="pedpy is not installed")
    path = tmp_path / "people.txt"
    path.write_text(text("pedpy_cm.txt"), "utf-8")
    theirs = pedpy.load_trajectory(trajectory_file=path).data
    for way in read_ways(path):
        rows = theirs[theirs.id == int(way.name)].sort_values("frame")
        np.testing.assert_allclose(way.place, rows[["x", "y"]].to_numpy(), atol=1e-9)
        np.testing.assert_allclose(way.time, rows.frame.to_numpy() / FPS, atol=1e-9)
