"""Crowds beside people: what is measured of known trajectories, and what the command says."""

import json
from pathlib import Path

import numpy as np
import pytest

import main
from planner.round.weights import NUMBERS, PEOPLE
from sim.reports import flows
from sim.reports.flows import Flow
from sim.reports.people import Row, by_seeds, median_of, worst_of
from worlds.world import World

DOCS = Path(__file__).parents[3] / "docs" / "crowds.md"


def steady(speed, headway, count=50):
    """So many go along x, one after the other, a `headway` [s] apart."""
    time = np.arange(0, 120, 1 / flows.PER_SECOND)
    x = 2.0 + speed * (time[:, None] - headway * np.arange(count))
    return Flow(time, np.stack([x, np.full_like(x, 6.0)], axis=2), World("w", (400.0, 12.0)))


def test_the_flow_of_a_steady_stream_is_known():
    assert flows.specific_flow(steady(1.0, 0.5), 2.0) == pytest.approx(1.0, rel=0.02)
    assert flows.specific_flow(steady(1.0, 0.5)._replace(place=np.zeros((1200, 50, 2))), 2.0) == 0, "nobody comes through"


@pytest.mark.parametrize("sway", [0.0, 0.03])
def test_the_speed_around_a_ring_is_known(sway):
    """Who sways to and fro, here by more than it goes on from one look to the next, is no faster for that."""
    time = np.arange(0, 30, 1 / flows.PER_SECOND)
    angle = time[:, None] * np.array([[0.1, 0.2]]) + sway * (np.arange(len(time))[:, None] % 2)
    place = 10 + np.array([6.0, 8.0])[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=2)
    assert flows.ring_speed(Flow(time, place, World("w", (20.0, 20.0)))) == pytest.approx(1.1, rel=0.01)


def test_a_figure_tells_as_many_digits_as_its_verdict_needs():
    assert Row("x", "m/s", 0.5604, 0.35, 0.56).told == "0.5604 m/s"
    assert Row("x", "m/s", 0.5597, 0.35, 0.56).told == "0.56 m/s"
    assert Row("x", "", float("inf"), 0.0, 1.0).told == "inf"


def test_figures_of_chance_are_of_several_seeds():
    runs = by_seeds(lambda _, seed: seed, lambda _, seed: 10.0 * seed, seeds=(3, 1, 5))
    found = [run(None) for run in runs]
    assert found == [3, 30, 1, 10, 5, 50]
    assert median_of(sum, 2)(found) == 33 and worst_of(sum, 2)(found) == 55 and worst_of(lambda one: one[0])(found) == 50


def test_trajectories_tell_everyone_at_every_look():
    flow = steady(1.0, 0.5, 3)
    rows = np.loadtxt(flows.trajectories(flow).splitlines())
    assert rows.shape == (3 * len(flow.time), 5) and set(rows[:, 0]) == {1, 2, 3}
    second = rows[rows[:, 0] == 2]
    np.testing.assert_allclose(second[:, 2:4], flow.place[:, 1], atol=1e-4)
    assert (np.diff(second[:, 1]) == 1).all()


def test_crowds_begin_as_dense_as_is_asked_for_and_apart():
    sim = flows.ring(1.0)
    place = sim.com()[:, :2]
    area = 2 * np.pi * flows.RING * flows.CORRIDOR
    assert len(place) / area == pytest.approx(1.0, rel=0.01)
    apart = np.linalg.norm(place[:, None] - place[None], axis=2) + np.where(np.eye(len(place)), np.inf, 0)
    assert apart.min() > 0.4


def test_the_table_of_weights_is_that_of_the_docs():
    told = {line.split("`")[1]: line.split("|")[2].split()[0] for line in DOCS.read_text("utf-8").splitlines() if "| `" in line}
    assert {name: float(value) for name, value in told.items()} == pytest.approx(
        {name: getattr(PEOPLE, name) for name in NUMBERS}
    )


def test_a_term_that_there_is_not_is_told(capsys):
    assert main.main(["verify", "--without", "tuoch"]) == 2
    assert "did you mean touch?" in capsys.readouterr().err
    assert main.main(["verify", "--without", "horizon"]) == 2 and "touch" in capsys.readouterr().err
    assert main.main(["verify", "--model", "orac"]) == 2 and "did you mean orca?" in capsys.readouterr().err


def test_the_quick_cases_are_told_with_their_bands(tmp_path, capsys):
    folder = tmp_path / "went"
    assert main.main(["verify", "--quick", "--json", "--trajectories", str(folder)]) == 0
    told = json.loads(capsys.readouterr().out)
    assert len(told["cases"]) == 3 and told["fits"] == sum(one["fits"] for one in told["cases"]) >= 2
    assert sorted(path.name for path in folder.iterdir()) == ["01.txt", "02.txt", "03.txt"]
    walk = np.loadtxt(folder / "01.txt")
    assert walk[0, 2] == pytest.approx(2.0, abs=0.1) and walk[-1, 2] > 42
