"""The timing law against the design's table and its own physics."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motion.characters.character import character_names, load_character
from planner.stepping import random, timing

HUMAN = load_character("human").biped


@pytest.mark.parametrize(("length", "speed"), [(0.5, 0.80), (0.6, 1.09), (0.7, 1.40), (0.8, 1.76), (1.04, 2.70)])
def test_speeds_of_dynamic_similarity(length, speed):
    assert timing.speed(length, 0.9) == pytest.approx(speed, abs=0.03)


def test_walks_overlap_and_runs_fly():
    step, stance = timing.step_timing(HUMAN, 0.7, 0.0, 0.0, False)
    assert 0.05 < (stance - step) / (2 * step) < 0.14
    step, stance = timing.step_timing(HUMAN, 1.04, 0.0, 0.0, False)
    assert stance < step


@given(st.floats(0.05, 2.0), st.floats(-0.4, 0.4), st.floats(0, 0.6), st.sampled_from(character_names()))
def test_timings_are_sane(length, rise, turn, name):
    b = load_character(name).biped
    step, stance = timing.step_timing(b, length, rise, turn, False)
    assert 0.1 < step < 4 and 0.05 < stance < 5
    assert stance == step or abs(stance - step) >= timing.SNAP - 1e-12


def test_a_leap_is_ballistic():
    step, stance = timing.step_timing(HUMAN, 1.8, 0.0, 0.0, False)
    flight = step - stance
    distance = 1.8 - 0.5 * HUMAN.reach.leap_length
    assert flight == pytest.approx(np.sqrt(2 * distance * np.tan(HUMAN.timing.takeoff_angle) / 9.81))


def test_who_comes_slowly_pushes_for_longer_and_leaps_more_steeply():
    """Down to a stand, from which one takes off upward as fast as legs can; who comes as fast as the flight leaps as ever."""
    upward = timing.UPWARD * np.sqrt(9.81 * HUMAN.timing.hip_height)
    usual = timing.step_timing(HUMAN, 1.8, 0.0, 0.0, False)
    assert timing.step_timing(HUMAN, 1.8, 0.0, 0.0, False, before=4.0) == usual
    times = np.array([timing.step_timing(HUMAN, 1.8, 0.0, 0.0, False, before=before) for before in (3.0, 2.0, 1.5, 1.0, 0.0)])
    stances, flights = times[:, 1], times[:, 0] - times[:, 1]
    assert np.all(np.diff(stances) >= 0) and stances[-1] > 1.2 * usual[1]
    assert np.all(np.diff(flights) >= 0) and flights[-1] == pytest.approx(2 * upward / 9.81)


def test_climbs_and_turns_take_longer():
    flat = timing.step_timing(HUMAN, 0.7, 0.0, 0.0, False)[0]
    assert timing.step_timing(HUMAN, 0.7, 0.2, 0.0, False)[0] > flat
    assert timing.step_timing(HUMAN, 0.7, 0.0, 0.5, False)[0] > flat


def test_chance_is_counted_and_even():
    draws = np.array([random.uniform(1, c, s, random.DRIFT) for c in range(30) for s in range(100)])
    assert draws.min() >= 0 and draws.max() < 1 and len(set(draws)) == len(draws)
    assert draws.mean() == pytest.approx(0.5, abs=0.02) and draws.var() == pytest.approx(1 / 12, abs=0.01)
    assert random.uniform(1, 2, 3, 0) == random.uniform(1, 2, 3, 0) != random.uniform(2, 2, 3, 0)
