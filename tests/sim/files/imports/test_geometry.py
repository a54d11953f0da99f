"""Where people could walk, as a database of JuPedSim tells it: shown as walls around their ways."""

import sqlite3

import numpy as np
import pytest

from motion.characters.character import load_character
from sim.files.imports.trajectories.database import geometry_of
from sim.files.imports.trajectories.people import read_ways
from sim.files.imports.walking.crowding import procession
from worlds.errors import InputError
from worlds.queries import wall_clearance

HALL = "POLYGON ((0 0, 12 0, 12 4, 0 4, 0 0), (5 3, 6 3, 6 3.5, 5 3.5, 5 3))"


def database(path, *geometries):
    file = sqlite3.connect(path)
    file.execute("CREATE TABLE trajectory_data (frame INTEGER, id INTEGER, pos_x REAL, pos_y REAL, ori_x REAL, ori_y REAL)")
    file.execute("CREATE TABLE metadata (key TEXT, value TEXT)")
    file.execute("INSERT INTO metadata VALUES ('fps', '10')")
    file.execute("CREATE TABLE geometry (hash INTEGER, wkt TEXT)")
    file.executemany("INSERT INTO geometry VALUES (1, ?)", ((one,) for one in geometries))
    rows = ((k, 1, 2 + 0.12 * k, 2.0) for k in range(60))
    file.executemany("INSERT INTO trajectory_data VALUES (?, ?, ?, ?, 1, 0)", rows)
    file.commit()
    file.close()
    return path


def test_borders_become_walls_where_they_are(tmp_path):
    path = database(tmp_path / "a.sqlite", HALL)
    borders, ways = geometry_of(path), read_ways(path)
    assert len(borders) == 2
    cast = procession("a", ways, load_character("human"), borders)
    corner = ways[0].place[0] - cast.fitted[0].way.place[0]
    for x, y, away in ((3.0, 1.0, 1.0), (5.5, 2.0, 1.0), (12.0, 2.0, 0.0)):
        assert wall_clearance(cast.world.arrays, x - corner[0], y - corner[1]) == pytest.approx(away - 0.01, abs=1e-6)


def test_a_box_says_no_more_than_the_ways(tmp_path):
    assert geometry_of(database(tmp_path / "a.sqlite", "POLYGON ((0 0, 12 0, 12 4, 0 4, 0 0))")) == ()
    assert geometry_of(database(tmp_path / "b.sqlite")) == ()
    assert geometry_of(__file__) == ()


def test_a_damaged_geometry_is_told(tmp_path):
    with pytest.raises(InputError, match="a.sqlite: geometry: line 1"):
        geometry_of(database(tmp_path / "a.sqlite", "POLYGON ((0 0, 12"))
    assert np.isfinite(geometry_of(database(tmp_path / "c.sqlite", HALL))[0]).all()
