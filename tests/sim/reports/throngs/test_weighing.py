"""Little scenes of weights: each weight has one, and its figure goes the way that is told."""

import numpy as np
import pytest

from planner.round.weights import NUMBERS, PEOPLE
from sim.reports.throngs import weighing

SOON = ("progress", "turn", "gap", "meet", "touch", "horizon", "near", "distance", "around")
MORE = {"progress": -1, "turn": -1, "gap": 1, "meet": -1, "touch": 1, "horizon": 1, "near": 1, "distance": 1, "around": 1}
"""Whether a figure grows or falls with its weight."""


def test_every_weight_has_a_scene():
    assert tuple(weighing.SCENES) == NUMBERS


@pytest.mark.parametrize("name", SOON)
def test_a_figure_goes_one_way(name):
    scene = weighing.SCENES[name]
    found = [scene.figure(scene.run(PEOPLE.of(name, k * getattr(PEOPLE, name)))) for k in weighing.TIMES]
    assert np.isfinite(found).all() and (MORE[name] * np.diff(found) >= -1e-3).all()
    assert abs(found[2] - found[0]) > 0.02, "it does something"


def test_what_is_weighed_has_a_figure_of_each_value(monkeypatch):
    monkeypatch.setattr(weighing, "SCENES", {"touch": weighing.SCENES["touch"]})
    (row,) = weighing.weighed()
    assert row.values == [0.0, PEOPLE.touch, 2 * PEOPLE.touch] and len(row.flows) == len(row.figures) == 3
    assert row.words[1] == f"two who meet pass {row.figures[1]:.2f} m apart"


def test_who_has_waited_longest_before_a_narrow_door_is_let_through():
    last_through = weighing.SCENES["rank"]
    assert np.isfinite(last_through.figure(last_through.run(PEOPLE)))
    assert not np.isfinite(last_through.figure(last_through.run(PEOPLE.of("rank", 0.0)))), "else two stand before each other"
