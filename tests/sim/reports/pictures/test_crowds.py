"""Pictures of crowds: whole files, and of what was given only."""

import numpy as np
import pytest

pytest.importorskip("matplotlib", reason="figures need matplotlib")

from PIL import Image

from sim.reports.flows import Flow
from sim.reports.people import Case, Row
from sim.reports.pictures.album import Album
from sim.reports.pictures.crowds import weidmann
from worlds.world import Wall, World


def some(name, at=0.0):
    return Case("c", "", 0, 1, [], lambda all: 0.0, shows=name, at=at)


def test_weidmanns_curve_is_his():
    np.testing.assert_allclose(weidmann(np.array([0.5, 1.0, 2.0])), [1.30, 1.06, 0.61], atol=0.01)


def test_an_album_draws_what_it_was_shown(tmp_path):
    time = np.arange(40) / 10
    place = np.stack([np.stack([s * time + 5, np.full(40, 2.0 + c)], axis=1) for c, s in enumerate((1, -1))], axis=1)
    flow = Flow(time, place, World("w", (12.0, 6.0), walls=(Wall(np.array([(0.0, 1.0), (12.0, 1.0)]), 0.2),)))
    album = Album(tmp_path)
    for density in (0.5, 1.0):
        album.take(some("speeds", density), [flow], Row("r", "m/s", 1.2, 0, 1))
    album.take(some("lanes"), [flow], Row("r", "s", 20.0, 0, 30))
    assert sorted(path.name for path in album.draw()) == ["crowd_lanes.png", "crowd_speeds.png"]
    album.take(some("flows", 2.0), [flow], Row("r", "1/(m s)", 1.4, 1.6, 2.1))
    assert sorted(path.name for path in album.draw()) == [
        f"crowd_{name}.png" for name in ("density", "flows", "lanes", "speeds")
    ]
    angle = np.linspace(0, np.pi, 40)
    round = np.stack([6 + s * 2 * np.stack([np.cos(angle), np.sin(angle)], axis=1) for s in (1, -1)], axis=1)
    album.take(some("circle"), [Flow(time, round, World("w", (12.0, 12.0)))], Row("r", "s", 1.0, 0, 6))
    assert tmp_path / "crowd_circle.png" in album.draw()
    for path in tmp_path.iterdir():
        with Image.open(path) as image:
            assert np.asarray(image.convert("L")).std() > 5, "something is drawn"
