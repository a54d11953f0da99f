"""Manners of a stretch: whole within it, blended over the steps beside it, and nothing beyond."""

import numpy as np
import pytest

from motion.arithmetic.rotations import axes_of
from motion.characters.character import load_character
from planner.script import manners
from planner.script.footprint import Footprint
from planner.script.laying import lay
from planner.script.scene import one_track
from planner.script.shaping import Stretch, Style, styled
from sim.stage.scripted.performance import Performance
from worlds.world import World

HUMAN = load_character("human")
PRINTS = tuple(
    Footprint(side=("left", "right")[k % 2], position=(2.0 + 0.7 * max(k - 1, 0), 4.0 + 0.06 * (1 - 2 * (k % 2))))
    for k in range(16)
)
FIRST, LAST = 6, 9


def show(*stretches, **keys):
    scene = one_track("walk", World("flat", (20.0, 8.0)), footprint=PRINTS, stretch=stretches, **keys)
    return Performance(scene)


@pytest.fixture(scope="module")
def plain():
    return show()


def times_of(scene):
    contact = scene.acts[0].laid.footprints.contact_time[scene.acts[0].laid.row]
    return contact[FIRST - 1], contact[FIRST], contact[LAST + 1], contact[LAST + 2]


def test_weights_rise_and_fall_over_the_steps_beside():
    laid = lay(list(PRINTS), HUMAN)
    (spell,) = manners.spells_of(laid, (Stretch(first=FIRST, last=LAST, arms=2.0), Stretch(first=0, last=3)))
    contact = laid.footprints.contact_time[laid.row]
    assert spell.weight(contact[FIRST - 1]) == 0 == spell.weight(contact[LAST + 2])
    assert spell.weight(contact[FIRST]) == 1 == spell.weight(contact[LAST + 1])
    assert np.isclose(spell.weight(0.5 * (contact[FIRST - 1] + contact[FIRST])), 0.5)
    (throughout,) = manners.spells_of(laid, (Stretch(first=0, last=15, arms=2.0),))
    assert all(throughout.weight(t) == 1 for t in np.linspace(0, contact[-1] + 1, 50))


def test_a_stretch_is_posed_as_a_style_is_and_the_rest_as_without(plain):
    lean = {"lean_deg": 20.0, "arms": 2.5, "sway": 2.0, "twist": 0.3}
    part, whole = show(Stretch(first=FIRST, last=LAST, **lean)), show(style=Style(**lean))
    begin, full, last, end = times_of(plain)
    inside, outside = 0.5 * (full + last), (0.5 * begin, end + 0.2)
    assert np.allclose(part.snapshot(inside).elbow, whole.snapshot(inside).elbow, atol=0.02)
    assert np.linalg.norm(part.snapshot(inside).elbow - plain.snapshot(inside).elbow, axis=-1).max() > 0.1
    for t in outside:
        for one, other in zip(part.snapshot(t), plain.snapshot(t), strict=True):
            assert np.array_equal(one, other, equal_nan=True)
    steps = np.arange(begin, end, 1 / 240)
    hands = np.array([part.snapshot(float(t)).hand[0] for t in steps])
    assert np.linalg.norm(np.diff(hands, 2, axis=0), axis=-1).max() < 0.02  # no jump where manners come and go


def test_feet_stay_where_they_stand(plain):
    part = show(Stretch(first=FIRST, last=LAST, sway=3.0, twist=3.0, lean_deg=-20.0, bounce=2.0))
    for t in np.arange(0.0, plain.end, 0.05):
        one, other = part.snapshot(float(t)), plain.snapshot(float(t))
        assert np.array_equal(one.contact, other.contact)
        assert np.allclose(one.ball[one.contact], other.ball[one.contact], atol=2e-3)


def test_two_of_a_kind_keep_their_own_manners():
    scene = one_track("walk", World("flat", (20.0, 8.0)), footprint=PRINTS, stretch=(Stretch(first=0, last=15, lean_deg=30.0),))
    other = scene.track.model_copy(update={"stretch": ()})
    both = Performance(type(scene)(scene.name, scene.world, (scene.track, other)))
    lean = axes_of(both.snapshot(3.0).body_rotation_wxyz)[0][:, 2]
    assert both.kind.tolist() == [0, 0] and lean[0] < lean[1] - 0.1


def test_bounce_gives_the_legs_more_way(plain):
    def height(scene):
        begin, full, last, end = times_of(scene)
        return np.mean([float(scene.com(float(t))[0, 2]) for t in np.arange(full, last, 0.01)])

    lively, still = show(Stretch(first=FIRST, last=LAST, bounce=2.5)), show(Stretch(first=FIRST, last=LAST, bounce=0.0))
    assert height(still) > height(plain) + 0.002 and height(plain) > height(lively) + 0.002
    assert np.isclose(height(lively), height(show(style=Style(bounce=2.5))), atol=0.002)
    assert styled(HUMAN, Style()) is HUMAN
