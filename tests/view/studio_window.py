"""The studio, driven as a person drives it: mouse and keys in the real window, through SDL's offscreen driver.

They run in a process of their own (test_studio_window): a process gets one window with OpenGL, and these share it.
"""

import os
from pathlib import Path

import numpy as np
import pytest

from sim.files.studio.document import Spot, footprint_at, footprints_in
from sim.files.studio.keeping import Opened
from tests.view.studio_hand import FIGURE_1, build


def test_figure_1_is_built_retimed_pinned_bent_keyed_saved_and_opened_again(hand, tmp_path):
    desk = hand.desk
    build(hand)
    retime(hand, desk)
    bend(hand, desk)
    path = tmp_path / "figure_1.toml"
    desk.save(path)
    document, motion = desk.document, desk.show.motion.curve.control.copy()
    done = len(desk.history.steps)
    while desk.history.at:
        desk.undo()
    assert footprints_in(desk.document.tracks[0]) == ()
    for _ in range(done - 1):
        desk.redo()
    assert desk.document is document
    np.testing.assert_array_equal(desk.show.motion.curve.control, motion)
    desk.open(path)
    assert desk.document == document
    np.testing.assert_array_equal(desk.show.motion.curve.control, motion)
    hand.frames(5)


def retime(hand, desk):
    """A bar's end is dragged, and a footprint pinned."""
    places = [one.footprint.position for one in footprints_in(desk.document.tracks[0])]
    np.testing.assert_allclose(places, FIGURE_1, atol=0.02)
    assert [one.footprint.side for one in footprints_in(desk.document.tracks[0])][3:5] == ["right", "right"] and not desk.fault
    t = hand.studio.timeline
    row = desk.act(0).laid.row[5]
    contact = float(desk.act(0).laid.footprints.contact_time[row])
    top, _, high = t.rows()
    hand.drag((t.x(contact), top + 0.5 * high), (t.x(contact + 0.2), top + 0.5 * high))
    assert footprint_at(desk.document, Spot(0, 4)).step_time is not None
    assert float(desk.act(0).laid.footprints.contact_time[row]) == pytest.approx(contact + 0.2, abs=0.02)
    hand.click(*hand.on_plan(*FIGURE_1[6]))
    assert desk.selection == {Spot(0, 6)}
    from sim.files.studio.edits import Set

    desk.do(Set((Spot(0, 6),), "at", 4.0, "Pin to 4.00 s"))
    assert float(desk.act(0).laid.footprints.contact_time[desk.act(0).laid.row[6]]) == pytest.approx(4.0, abs=1e-9)


def bend(hand, desk):
    """A path is drawn and bent, a hand keyed, the hop exaggerated."""
    hand.studio.views.plan.centre, hand.studio.views.plan.zoom = np.array([4.6, 4.2]), 70.0
    hand.key("escape"), hand.key("p")
    for x, y in ((4.2, 4.0), (5.2, 4.3), (5.9, 5.0)):
        hand.click(*hand.on_plan(x, y))
    hand.key("return")
    assert len(desk.document.tracks[0].path) == 1 and not desk.fault
    before = desk.document.tracks[0].path[0].points[1]
    hand.drag(hand.on_plan(*before), hand.on_plan(before[0], before[1] - 0.3))
    assert desk.document.tracks[0].path[0].points[1][1] == pytest.approx(before[1] - 0.3, abs=0.03)
    desk.playing.time = 1.5
    hand.key("b")
    assert desk.document.tracks[0].key[0].bone == "upper_arm_right"
    desk.selection = {Spot(0, 3), Spot(0, 4)}
    hand.key("e")
    assert desk.document.tracks[0].stretch[0].gravity == 0.6
    assert not desk.fault, desk.fault


def test_a_dragged_print_moves_the_motion_around_it_and_nothing_else(hand):
    from sim.files.studio.document import Document

    desk = hand.desk
    track = desk.document.tracks[0]
    from planner.script.footprint import Footprint
    from sim.files.studio.keeping import Opened

    sides = ("left", "right")
    prints = tuple(
        Footprint(side=sides[i % 2], position=(1.5 + 0.6 * max(i - 1, 0), 4.0 + 0.06 * (1 - 2 * (i % 2)))) for i in range(40)
    )
    head = desk.document.head
    head = head.model_copy(update={"world": head.world.model_copy(update={"size": (30.0, 8.0)})})
    desk.take(Opened(Document(head, (track.model_copy(update={"footprint": prints}),)), None))
    hand.frames(2)
    old = desk.show.motion.curve
    hand.studio.views.plan.centre, hand.studio.views.plan.zoom = np.array([13.0, 4.0]), 80.0
    x, y = prints[20].position
    hand.move(*hand.on_plan(x, y)), hand.press()
    hand.move(*hand.on_plan(x + 0.05, y + 0.05)), hand.move(*hand.on_plan(x + 0.1, y + 0.1))
    assert desk.dragging
    new = desk.show.motion.curve
    moved = footprint_at(desk.document, Spot(0, 20)).position
    assert moved == pytest.approx((x + 0.1, y + 0.1), abs=0.03)
    same = (new.control == old.control).all(axis=1)
    assert same[: len(same) // 4].all() and same[-len(same) // 4 :].all() and not same.all()
    hand.key("escape")
    assert footprint_at(desk.document, Spot(0, 20)).position == prints[20].position
    hand.release()
    assert not desk.dragging and len(desk.history.steps) == 1


def test_every_key_does_what_the_help_says_and_none_raises(hand):
    from sim.view.studio.desk.keys import ACTIONS

    build(hand)
    for action in ACTIONS:
        if action.key.lower() not in ("ctrl+o", "ctrl+shift+s", "ctrl+s", "ctrl+q", "ctrl+n"):
            hand.desk.selection = {
                s for s in (Spot(0, 3), Spot(0, 4)) if s.number < len(footprints_in(hand.desk.document.tracks[0]))
            }
            action.does(hand.desk)
            hand.frames()
    assert hand.desk.running


def test_a_cure_takes_what_it_says(hand):
    from sim.files.studio.document import document_of
    from sim.files.studio.keeping import open_scene

    desk = hand.desk
    desk.take(open_scene("fig17_large_leap"))
    assert document_of is not None
    for _ in range(400):
        places = hand.studio.inspector.healing.look(desk)
        if places and all(not place.waiting for place in places) and any(place.cures for place in places):
            break
    cured = next(place for place in places if place.cures)
    assert cured.cures[0].share >= 0.3
    from sim.view.studio.desk.healing import debt_with

    assert debt_with(desk, cured, cured.cures[0].edit) <= 0.7 * cured.debt
    desk.do(cured.cures[0].edit)
    assert not desk.fault


def test_keys_wait_for_the_answer_to_a_question(hand):
    hand.studio.menus._question, tool = "Sure?", hand.desk.tool
    hand.frames(3)
    hand.key("n")
    assert hand.desk.tool == tool
    width, height = hand.studio.screen.size
    hand.click(0.5 * width - 49, 0.5 * height + 10)  # yes
    hand.frames(3)
    hand.key("n")
    assert hand.studio.menus._question == "" and hand.desk.tool != tool


def test_another_document_is_shown_whole_wherever_one_looked_before(hand):
    build(hand)
    hand.studio.views.plan.centre = np.array([50.0, 50.0])
    hand.desk.take(Opened(hand.desk.document, None))
    hand.frames(2)
    assert np.hypot(*(hand.studio.views.plan.centre - np.mean(FIGURE_1, axis=0))) < 1.0


def test_it_draws_at_all_sizes(hand):
    build(hand)
    hand.key("h"), hand.key("o"), hand.key("x")
    hand.studio.screen.draw_unseen()
    for size, scale in (((640, 400), 1.0), ((1920, 1080), 2.0)):
        hand.studio.screen.resize(size)
        hand.studio.screen.set_scale(scale)
        hand.frames(2)
        assert hand.studio.screen.pixels().shape == (size[1], size[0], 3) and hand.studio.screen.pixels().std() > 20
    assert Path(os.environ["FOOTFALL_STATE"]).is_dir()


def test_borders_are_dragged(hand):
    layout = hand.studio.layout
    hand.drag((layout.space.x, 200), (layout.space.x - 90, 200))
    assert hand.studio.layout.space.x == pytest.approx(layout.space.x - 90, abs=15)
    hand.drag((200, layout.play.y), (200, layout.play.y - 40))
    assert hand.studio.layout.play.y == pytest.approx(layout.play.y - 40, abs=8)


def test_the_gizmo_turns_what_it_says():
    from sim.view.studio.table.gizmo import rotation_matrix, rotation_vector

    chance = np.random.default_rng(1)
    for vector in chance.normal(size=(50, 3)):
        vector *= min(1.0, 3.0 / np.linalg.norm(vector))
        matrix = rotation_matrix(vector)
        np.testing.assert_allclose(matrix @ matrix.T, np.eye(3), atol=1e-12)
        np.testing.assert_allclose(rotation_vector(matrix), vector, atol=1e-9)


def test_every_layout_of_a_curve_has_words():
    from motion.com.window import LAYOUTS
    from sim.view.studio.bars.inspector import CURVES

    assert list(CURVES) == list(LAYOUTS)
