"""The picture of weights: a row for each, with what is drawn of it."""

import numpy as np
import pytest

pytest.importorskip("matplotlib", reason="figures need matplotlib")

from PIL import Image

from sim.reports.flows import Flow
from sim.reports.people import BODIES, STANDING, WAYS, Weighed
from sim.reports.pictures.album import Album
from worlds.world import World


def row(drawn):
    time = np.arange(20) / 10
    place = np.stack([np.stack([s * time + 2, np.full(20, 1.0 + c)], axis=1) for c, s in enumerate((1, -1, 0))], axis=1)
    flow = Flow(time, place, World("w", (5.0, 4.0)), np.zeros((20, 3)), np.full((3, 2), 0.2))
    return Weighed("touch", "swerves wider", [0.0, 0.35, 0.7], [flow] * 3, [1.0] * 3, ["w"] * 3, (0, 5, 0, 4), drawn, 1.0)


def test_an_album_draws_what_weights_do(tmp_path):
    album = Album(tmp_path)
    album.weigh([row(WAYS), row(BODIES), row(STANDING)])
    assert [path.name for path in album.draw()] == ["crowd_weights.png"]
    with Image.open(tmp_path / "crowd_weights.png") as image:
        shown = np.asarray(image.convert("RGB"))
    rows = np.array_split(shown, 3)
    assert all(len(np.unique(part.reshape(-1, 3), axis=0)) > 10 for part in rows)
