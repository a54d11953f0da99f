"""RiMEA tests: their figures of known ways, their rooms, and those of them that are soon done."""

import json

import numpy as np
import pytest

import main
from sim.reports import verify
from sim.reports.flows import PER_SECOND, Flow, trajectories
from sim.reports.people import Row
from sim.reports.rimea import figures, rooms
from worlds.queries import wall_clearance
from worlds.world import World

NAN = np.nan


def flow(*ways):
    """People who are at these x (F,), NaN where they are not there, at y = 1."""
    x = np.array(ways, float).T
    return Flow(np.arange(len(x)) / PER_SECOND, np.stack([x, np.where(np.isnan(x), NAN, 1.0)], axis=2), World("w", (50.0, 5.0)))


def test_when_the_last_is_gone():
    assert figures.all_out(flow([0, 1, NAN, NAN], [0, 1, 2, NAN])) == pytest.approx(3 / PER_SECOND)
    assert figures.all_out(flow([0, 1, 2], [0, 1, NAN])) == np.inf


def test_how_fast_the_first_goes_between_two_places():
    x = 1.2 * np.arange(200) / PER_SECOND
    assert figures.speed_between(flow(x), 5.0, 13.0) == pytest.approx(1.2)
    assert figures.speed_between(flow(24 - x), 5.0, 13.0) == pytest.approx(1.2)
    assert figures.speed_between(flow(0 * x), 5.0, 13.0) == 0


def test_by_which_exit_they_went():
    ways = flow([5, 4, 0, NAN], [5, 9, 22, NAN], [20, 21, NAN, NAN], [20, 10, 1, NAN])
    assert figures.share_beyond(ways, 14.0) == 0.5
    assert figures.wrong_exits(ways, np.array([0.7, 22.2])) == 2


def test_how_many_stand():
    still, walking = np.full(100, 18.0), 16.5 + np.arange(100) / 12
    assert figures.standing_within(flow(still, still, walking), 16.0, 26.0) == 2
    assert figures.standing_within(flow(still, walking), 20.0, 26.0) == 0


def test_trajectories_leave_out_who_is_not_there():
    rows = np.loadtxt(trajectories(flow([0, 1, NAN], [NAN, 1, 2])).splitlines())
    assert rows[:, :3].tolist() == [[1, 0, 0], [1, 1, 1], [2, 1, 1], [2, 2, 2]]


def test_rooms_have_walls_but_for_their_doors():
    world = World("w", (12.0, 8.0), walls=rooms.room((1.0, 1.0, 9.0, 6.0), [("east", 3.0, 4.0), ("north", 1.0, 2.0)]))
    for x, y, free in ((9.0, 3.5, True), (9.0, 2.5, False), (1.5, 6.0, True), (5.0, 6.0, False), (5.0, 1.0, False)):
        assert (wall_clearance(world.arrays, x, y) > 0.2) == free


def test_everyone_is_there_at_first():
    for place in (rooms.reacting(), rooms.cabins(), rooms.before_stairs(20)):
        sim = rooms.visited(*place, verify.PEOPLE)
        assert sim.present().all() and sim.planner.counts(sim.plans)["outside"] == 0


def test_thirteen_of_the_guideline_and_more():
    assert set(range(1, 8)) | {9, 10, 11, 12, 13, 15, 16} == set(verify.numbers())


@pytest.mark.parametrize("number", [2, 3, 5, 10])
def test_those_that_are_soon_done_fit(number, capsys):
    assert main.main(["verify", "--case", str(number), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert len(told["cases"]) == told["fits"] == 1


def test_a_case_that_there_is_not_is_told(capsys):
    assert main.main(["verify", "--case", "8"]) == 2 and "1, 2, 3" in capsys.readouterr().err


def test_why_is_said_where_a_figure_does_not_fit():
    assert "slow" in verify.in_words(Row("a", "s", 3.0, 0.0, 1.0, "slow"))
    assert "slow" not in verify.in_words(Row("a", "s", 0.5, 0.0, 1.0, "slow"))
