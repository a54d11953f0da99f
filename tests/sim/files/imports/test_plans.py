"""Floor plans: their lines become walls, to the millimetre; what is none is told with its place."""

import numpy as np
import pytest

import main
from sim.files.imports.plans.wkt import plan_of
from worlds.errors import InputError
from worlds.level import load_level
from worlds.queries import wall_clearance

ROOM = "POLYGON ((0 0, 10 0, 10 6, 0 6, 0 0), (4 2, 6 2, 6 4, 4 4, 4 2))"


@pytest.mark.parametrize(
    "text, count",
    [
        (ROOM, 2),
        ("SRID=25832;LINESTRING Z (0 0 1, 1e1 0 1)", 1),
        ("multilinestring ((0 0, 1 0), (0 1, 1 1, 2 1))", 2),
        (f"GEOMETRYCOLLECTION (POINT (1 1), {ROOM}, LINESTRING EMPTY, MULTIPOINT ((1 2), (3 4)))", 2),
        (f"{ROOM}\n{ROOM.replace('0 0,', '0 0, 0 0,')};\n", 4),
        ("MULTIPOLYGON (((0 0, 3 0, 3 3, 0 0)), ((5 5, 8 5, 8 8, 5 5)))", 2),
    ],
)
def test_every_kind_of_geometry_is_read(text, count):
    assert len(plan_of(text, "plan").lines) == count


def test_as_shapely_reads_it():
    shapely = pytest.importorskip("shapely", reason="needs Shapely")
    theirs = shapely.from_wkt(ROOM)
    ours = plan_of(ROOM, "plan")
    np.testing.assert_array_equal(ours.lines[0], np.array(theirs.exterior.coords))
    np.testing.assert_array_equal(ours.lines[1], np.array(theirs.interiors[0].coords))
    assert ours.walkable == (0,)


@pytest.mark.parametrize(
    "text, said",
    [
        ("POLYGN ((0 0, 1 0, 1 1, 0 0))", "did you mean POLYGON?"),
        ("POLYGON ((0 0, 1 0, 1 1, 0 0)", "')' is needed"),
        ("POLYGON ((0 0, 1 0, 1 1, 0 2))", "a ring that ends where it begins"),
        ("LINESTRING (0 0)", "2 points or more"),
        ("LINESTRING (0 0, 1 x)", "a point of 2 to 4 numbers"),
        ("LINESTRING (0 0, 1e300 0)", "up to 1e+07"),
        ("\n\nLINESTRING (0 0, 1 0) what", "line 3"),
        ("POINT (1 1)", "nothing to make walls of"),
        ("GEOMETRYCOLLECTION (" * 30 + "POINT (1 1)" + ")" * 30, "one of"),
    ],
)
def test_what_is_no_plan_is_told(text, said):
    with pytest.raises(InputError) as told:
        plan_of(text, "plan.wkt")
    assert said in str(told.value) and "plan.wkt" in str(told.value)


def made(folder, text, *more, name="plan.wkt"):
    (folder / name).write_text(text)
    return main.main(["import-plan", str(folder / name), "--out", str(folder / "level.toml"), *more])


def test_a_plan_becomes_a_level(tmp_path, capsys):
    assert made(tmp_path, ROOM, "--thickness", "0.2") == 0
    world = load_level(tmp_path / "level.toml")
    assert world.size == (12.0, 8.0) and len(world.walls) == 2
    for x, y, away in ((3.0, 4.0, 1.9), (1.0, 1.0, -0.1), (5.5, 3.0, -0.1)):
        assert wall_clearance(world.arrays, x, y) == pytest.approx(away, abs=1e-3)
    x, y = world.start
    assert 1 < x < 11 and 1 < y < 7 and not (5 < x < 7 and 3 < y < 5) and wall_clearance(world.arrays, x, y) > 1.5
    assert main.main(["check", str(tmp_path / "level.toml")]) == 0
    assert made(tmp_path, ROOM, "--scale", "0.5") == 0 and load_level(tmp_path / "level.toml").size == (7.0, 5.0)


def test_what_cannot_be_made_leaves_nothing(tmp_path, capsys):
    assert made(tmp_path, "LINESTRING (0 0, 90000 90000)") == 2
    assert "is --scale right?" in capsys.readouterr().err and not (tmp_path / "level.toml").exists()
    assert made(tmp_path, ROOM, "--layers", "WALLS") == 2 and "only drawings" in capsys.readouterr().err


def test_a_drawing_becomes_a_level(tmp_path, capsys):
    ezdxf = pytest.importorskip("ezdxf", reason="needs ezdxf")
    drawing = ezdxf.new(units=ezdxf.units.MM)
    space = drawing.modelspace()
    drawing.layers.add("WALLS")
    pillar = drawing.blocks.new("PILLAR")
    pillar.add_circle((0, 0), 300)
    space.add_lwpolyline([(0, 0), (8000, 0), (8000, 5000), (0, 5000)], close=True, dxfattribs={"layer": "WALLS"})
    space.add_blockref("PILLAR", (4000, 2500), dxfattribs={"layer": "WALLS"})
    space.add_line((0, 6000), (8000, 6000), dxfattribs={"layer": "0"})
    space.add_text("nothing to bump into")
    drawing.saveas(tmp_path / "plan.dxf")
    arguments = ["import-plan", str(tmp_path / "plan.dxf"), "--out", str(tmp_path / "level.toml")]
    assert main.main(arguments) == 0
    world = load_level(tmp_path / "level.toml")
    assert world.size == pytest.approx((10.0, 8.0)) and len(world.walls) == 3
    assert wall_clearance(world.arrays, 5.0, 2.5) == pytest.approx(0.7 - 0.05, abs=0.03), "the pillar is round"
    assert main.main([*arguments, "--layers", "WALLS"]) == 0
    assert load_level(tmp_path / "level.toml").size == pytest.approx((10.0, 7.0))
    assert main.main([*arguments, "--layers", "WALS"]) == 2 and "did you mean WALLS?" in capsys.readouterr().err
    (tmp_path / "plan.dxf").write_text("no drawing")
    assert main.main(arguments) == 2 and "is no DXF drawing" in capsys.readouterr().err
