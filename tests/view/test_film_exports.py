"""Films and sprites of clips, by the renderer; and what a replay shows."""

import numpy as np
import pytest
from PIL import Image

import main
from sim.export.clip.asked import Asked
from sim.export.films import COLUMNS, export_film, export_sprites, replay_of
from sim.view.graphics.gl import NoGL, offscreen_context
from tests.sim.export.readers import clip, recording
from worlds.errors import InputError


@pytest.fixture(scope="module", autouse=True)
def gl():
    try:
        offscreen_context().release()
    except NoGL as error:
        pytest.skip(str(error))


def test_a_replay_shows_what_was_recorded():
    run = recording("human", 2)
    cast = replay_of(clip(run, begin=1.0))
    for _ in range(7):
        cast.tick()
    frame = int(np.abs(run.arrays["time"] - cast.time).argmin())
    assert run.arrays["time"][frame] == cast.time == pytest.approx(1.0 + 7 / 60)
    np.testing.assert_array_equal(cast.snapshot().toe, run.arrays["toe"][frame])
    np.testing.assert_array_equal(cast.com(), run.arrays["com"][frame])
    np.testing.assert_array_equal(cast.bones(1).root[0], run.arrays["com"][frame, 1])
    assert len(cast.walked().character) == len(run.arrays["footprint_side"]) and not cast.over


@pytest.mark.parametrize("ending", [".mp4", ".gif", ".webm"])
def test_a_film_of_a_clip_has_its_frames(ending, tmp_path):
    imageio_ffmpeg = pytest.importorskip("imageio_ffmpeg", reason="needs imageio-ffmpeg")
    path = str(tmp_path / f"film{ending}")
    export_film(clip(recording("human"), begin=0.5, end=1.5), path, Asked(size=(160, 120)))
    frames = imageio_ffmpeg.read_frames(path)
    told = next(frames)
    pictures = [np.frombuffer(frame, np.uint8).astype(float) for frame in frames]
    assert told["size"] == (160, 120) and len(pictures) == 31 and told["fps"] == pytest.approx(30, rel=0.15)
    assert np.abs(pictures[0] - pictures[20]).mean() > 1.0


def test_sprites_stand_on_nothing(tmp_path):
    path = str(tmp_path / "sprites.png")
    export_sprites(clip(recording("human"), begin=1.0, end=2.0), path, Asked(rate=10.0))
    sheet = np.asarray(Image.open(path))
    assert sheet.shape == (256, 128 * COLUMNS, 4)
    cells = sheet.reshape(2, 128, COLUMNS, 128, 4).swapaxes(1, 2).reshape(-1, 128, 128, 4)
    assert (cells[:11, 0, :, 3] == 0).all() and (cells[:11, :, 0, 3] == 0).all() and not cells[11:].any()
    solid = (cells[:11, :, :, 3] == 255).mean(axis=(1, 2))
    assert (solid > 0.03).all() and (solid < 0.5).all()


def test_more_sprites_than_a_sheet_holds_are_refused(tmp_path):
    with pytest.raises(InputError, match="give --between"):
        export_sprites(clip(recording("human")), str(tmp_path / "s.png"), Asked(rate=60.0))


def test_a_film_has_a_whole_rate(tmp_path):
    with pytest.raises(InputError, match="10 or more"):
        export_film(clip(recording("human"), rate=6.0), str(tmp_path / "a.mp4"), Asked())
    assert list(tmp_path.iterdir()) == []


def test_a_river_that_ends_before_its_goal_says_so(capsys):
    assert main.main(["river", "--headless", "--seconds", "0.5"]) == 0
    assert "ends before the goal" in capsys.readouterr().err
