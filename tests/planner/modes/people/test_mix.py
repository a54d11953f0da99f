"""Who comes: speeds, sizes and ages by their laws, and steps that go at these speeds."""

import numpy as np
import pytest

from planner.modes.people.mix import AGES, CUT, Mix, speed_of
from worlds.contents.traffic import Population
from worlds.errors import InputError


def drawn(count=1500, **values):
    mix = Mix([Population(name="some", **values)])
    return [mix.person(7, (0, k), 0) for k in range(count)]


def test_people_prefer_speeds_as_weidmann_measured_them():
    speed = np.array([one.speed for one in drawn()])
    assert speed.mean() == pytest.approx(1.34, abs=0.03) and speed.std() == pytest.approx(0.25, abs=0.02)
    assert speed.min() >= 1.34 - CUT * 0.26 - 0.03 and speed.max() <= 1.34 + CUT * 0.26 + 0.03


def test_whoever_prefers_a_speed_takes_the_steps_for_it():
    people = drawn(60, speed=(1.2, 0.3), size=(1.0, 0.05))
    assert max(abs(speed_of(one.character.biped) - one.speed) for one in people) < 0.02
    order = sorted(people, key=lambda one: one.speed)
    assert order[0].character.biped.gait.preferred_step < 0.75 * order[-1].character.biped.gait.preferred_step


def test_sizes_are_drawn_and_few_kinds_of_bodies_come_of_it():
    people = drawn(600, size=(0.9, 0.05))
    tall = np.array([float(one.character.biped.timing.hip_height) for one in people]) / 0.935
    assert tall.mean() == pytest.approx(0.9, abs=0.01) and 0.03 < tall.std() < 0.06
    assert len({one.character.biped.tobytes() for one in people}) < 220


def test_the_old_are_slower_as_the_table_tells():
    people = drawn(800, ages=[(20.0, 30.0, 1.0), (60.0, 80.0, 3.0)])
    young = np.array([one.speed for one in people if one.age < 40])
    old = np.array([one.speed for one in people if one.age > 40])
    assert len(old) / len(people) == pytest.approx(0.75, abs=0.04)
    assert AGES[0][1][0] - 0.03 <= young.min() and young.max() <= AGES[0][2][1] + 0.03
    assert AGES[2][1][0] - 0.03 <= old.min() and old.max() <= AGES[2][2][1] + 0.03
    assert young.mean() == pytest.approx(1.36, abs=0.05) and old.mean() == pytest.approx(0.935, abs=0.03)


def test_the_same_chance_draws_the_same_people():
    assert [one.speed for one in drawn(20)] == [one.speed for one in drawn(20)]
    mix = Mix([Population(name="a", share=1.0), Population(name="b", share=3.0)])
    chosen = [mix.choose(3, (0, k), []) for k in range(2000)]
    assert np.mean(chosen) == pytest.approx(0.75, abs=0.03)
    assert {mix.choose(3, (0, k), [0]) for k in range(20)} == {0}


def test_groups_come_by_their_shares():
    mix = Mix([Population(name="families", groups=[1.0, 0.0001, 2.0])])
    sizes = np.array([mix.group(1, (0, k), 0) for k in range(1500)])
    assert set(sizes) <= {1, 2, 3} and (sizes == 3).mean() == pytest.approx(2 / 3, abs=0.04)


def test_birds_and_dinosaurs_walk_at_their_own_speed():
    for name in ("bird", "dinosaur"):
        (one,) = drawn(1, character=name)
        assert speed_of(one.character.biped) == pytest.approx(one.speed, abs=0.02) and one.character.name == name


@pytest.mark.parametrize("values", [{"speed": (3.0, 0.2)}, {"character": "humn"}, {"speed": (1.0, 0.4)}, {"size": (0.2, 0.0)}])
def test_who_cannot_walk_so_is_refused(values):
    with pytest.raises(InputError) as told:
        drawn(1, **values)
    assert "some" in str(told.value) or "did you mean human?" in str(told.value)
