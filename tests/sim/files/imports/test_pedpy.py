"""PedPy's own measures of people and of the same people walked: what leaves us says what came in."""

import numpy as np
import pytest

from motion.characters.character import load_character
from sim.export.clip.asked import Asked
from sim.export.tables.trajectories import export_text
from sim.files.imports.trajectories.people import read_ways
from sim.files.imports.trajectories.ways import Way
from sim.files.imports.walking.crowding import procession, ticks_of
from sim.files.recording import Recorder
from tests.sim.export.readers import clip
from tests.sim.files.imports.test_procession import ways

RATE = 10
SECOND = RATE // 2
"""Frames before and behind one whose speed is asked for."""


def test_speeds_of_who_walks_are_those_of_the_file(tmp_path):
    pedpy = pytest.importorskip("pedpy", reason="needs PedPy")
    given, walked = tmp_path / "given.txt", tmp_path / "walked.txt"
    going = [way for way in ways() if way.name in ("straight", "bent", "starts", "stops", "runs", "creeps")]
    rows = [(k, round(t * RATE), x, y) for k, way in enumerate(going) for t, (x, y) in zip(way.time, way.place, strict=True)]
    given.write_text(
        f"# framerate: {RATE}\n# id frame x/m y/m\n" + "".join("{} {} {:.6f} {:.6f}\n".format(*row) for row in rows)
    )
    crowd = procession("given", read_ways(given), load_character("human"))
    recorder = Recorder(crowd)
    for k in range(len(going[0].time)):
        recorder.capture(k / RATE)
    export_text(clip(recorder.recording(), rate=float(RATE)), str(walked), Asked())
    means = []
    for path in (given, walked):
        data = pedpy.load_trajectory(trajectory_file=path)
        speed = pedpy.compute_individual_speed(traj_data=data, frame_step=SECOND)
        means.append(speed.groupby("id").speed.mean().to_numpy())
    np.testing.assert_allclose(means[1].mean(), means[0].mean(), rtol=0.005)
    np.testing.assert_allclose(means[1], means[0], rtol=0.01, atol=0.01)


def test_who_weaves_through_others_keeps_its_speed():
    """Bends of half a metre in a step or two: bodies cut corners, and footsteps are moved until they do not."""
    time = np.arange(0, 12, 0.1)
    weaving = Way("weaves", time, np.column_stack([1.2 * time, 0.35 * np.sin(2.2 * time)]), np.zeros(len(time), bool))
    crowd = procession("weaves", [weaving], load_character("human"))
    corner = crowd.fitted[0].way.place[0] - weaving.place[0]
    place = np.array([crowd.com(t)[0, :2] for t in time]) - corner
    off = np.hypot(*(place - weaving.place)[10:-10].T)
    gone = [np.hypot(*(where[10:] - where[:-10]).T).mean() for where in (weaving.place, place)]
    assert np.quantile(off, 0.95) < 0.06 and gone[1] == pytest.approx(gone[0], rel=0.005)


@pytest.mark.parametrize("apart, ticks", [(1 / 25, 50), (1 / 16, 64), (0.1, 60), (0.4, 60), (1 / 29.97, 60), (1 / 100, 100)])
def test_a_recording_has_the_moments_of_its_file(apart, ticks):
    assert ticks_of([Way("a", apart * np.arange(9), np.zeros((9, 2)), np.zeros(9, bool))]) == ticks
