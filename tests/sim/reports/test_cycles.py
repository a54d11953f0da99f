"""Gait cycles beside curves of people: the comparison on curves of known difference, and files that are none."""

import json

import numpy as np
import pytest

import main
from sim.reports import literature
from sim.reports.cycles import ANGLES, PERCENT, Cycle, compared, people_of
from worlds.errors import InputError

WAVE = 30 + 20 * np.sin(2 * np.pi * PERCENT / 100)
OURS = Cycle(PERCENT, dict.fromkeys(ANGLES, WAVE), np.ones(len(PERCENT)), np.zeros(len(PERCENT)), 1.3, 0.6)


def test_an_offset_is_no_difference():
    theirs = np.column_stack([PERCENT, WAVE + 7.0])
    assert compared(OURS, "knee_flexion", theirs) == (pytest.approx(0, abs=1e-9), pytest.approx(1))


def test_a_difference_of_shape_is_its_rms():
    theirs = np.column_stack([PERCENT, WAVE + 4 * np.sign(np.sin(6 * np.pi * PERCENT / 100 + 0.1))])
    assert compared(OURS, "knee_flexion", theirs)[0] == pytest.approx(4, rel=0.02)


def test_curves_are_read_and_nonsense_is_told(tmp_path):
    path = tmp_path / "people.csv"
    head, row = "# somebody's\ndataset,gait,speed_mps,quantity,percent,mean\n", "a,walk,1.2,knee_flexion"
    path.write_text(f"{head}{row},50,4\n{row},0,3\n")
    np.testing.assert_array_equal(people_of(path)["walk", "knee_flexion"], [[0, 3], [50, 4]])
    for text, said in (("a,b\n1,2\n", "no table of curves"), ("", "no curves")):
        path.write_text(text)
        with pytest.raises(InputError, match=said):
            people_of(path)
    with pytest.raises(InputError, match="cannot be read"):
        people_of(tmp_path / "none.csv")


def test_the_humans_figures_lie_among_peoples():
    """All but one: the knee stays a little bent in mid-stance."""
    assert [row.what for row in literature.compare() if not row.fits] in ([], ["walk: knee, straightest in stance"])


def test_curves_are_compared_and_drawn_by_command(tmp_path, capsys):
    pytest.importorskip("matplotlib")
    path, head = tmp_path / "people.csv", "dataset,gait,speed_mps,quantity,percent,mean\n"
    path.write_text(head + "".join(f"a,walk,1.2,knee_flexion,{p},{20 + p % 30}\n" for p in range(0, 101, 5)))
    picture = tmp_path / "strides.png"
    assert main.main(["literature", "--curves", str(path), "--plot", str(picture), "--json"]) == 0
    rows = [row["what"] for row in json.loads(capsys.readouterr().out)["rows"]]
    assert "walk: knee flexion, rms difference" in rows and picture.stat().st_size > 10_000
    assert main.main(["literature", "--curves", str(tmp_path / "none.csv")]) == 2
    assert "cannot be read" in capsys.readouterr().err
