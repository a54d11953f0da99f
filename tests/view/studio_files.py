"""Sliders of the studio's panel, its file dialogs, typed and native: driven as a person drives them (test_studio_window)."""

import numpy as np

from sim.files.studio.document import Spot
from tests.view.studio_hand import build


def sliders(hand):
    """Where the sliders of the first stretch lie in the panel (name: (left, right, y)), as they were drawn."""
    from imgui_bundle import imgui

    found, drawn = {}, imgui.slider_float

    def watched(name, *values):
        result = drawn(name, *values)
        low, high = imgui.get_item_rect_min(), imgui.get_item_rect_max()
        found[name] = (low.x, low.x + imgui.calc_item_width(), 0.5 * (low.y + high.y))
        return result

    imgui.slider_float = watched
    try:
        hand.frames(2)
    finally:
        imgui.slider_float = drawn
    return found


def test_sliders_of_a_stretch_are_drawn_and_each_drag_is_one_step(hand):
    build(hand)
    desk = hand.desk
    desk.selection = {Spot(0, 3), Spot(0, 4)}
    hand.key("e")
    desk.selection = set()
    before, done = desk.show.motion.curve.control.copy(), len(desk.history.steps)
    left, right, y = sliders(hand)["gravity"]
    grip = 0.5 * 12 + left + 0.6 / 3.0 * (right - left - 12)  # imgui's handle
    hand.drag((grip, y), (grip - 0.1 * (right - left), y))
    stretch = desk.document.tracks[0].stretch[0]
    assert 0.15 < stretch.gravity < 0.45 and not desk.dragging and not desk.fault
    assert len(desk.history.steps) == done + 1 and desk.history.steps[-1].name == "Change a stretch"
    assert np.abs(desk.show.motion.curve.control[: len(before)] - before[: len(desk.show.motion.curve.control)]).max() > 1e-3
    left, right, y = sliders(hand)["leg"]
    hand.drag((right - 0.17 * (right - left), y), (left + 0.5 * (right - left), y))
    assert 0.6 < desk.document.tracks[0].stretch[0].leg < 0.95
    hand.key("z", hand.pygame.KMOD_LCTRL), hand.key("z", hand.pygame.KMOD_LCTRL)
    assert desk.document.tracks[0].stretch[0].gravity == 0.6
    assert not desk.fault


def write(hand, text):
    """Types into the field that has the keyboard, over what is there."""
    pg = hand.pygame
    hand.studio.handle(pg.event.Event(pg.KEYUP, key=pg.K_LCTRL, mod=0, unicode=""))  # it is let go
    hand.frames(2)
    for letter in text:
        hand.studio.handle(pg.event.Event(pg.TEXTINPUT, text=letter))
    hand.frames(2)
    hand.key("return")
    hand.frames(3)


def test_a_scene_is_saved_and_opened_by_a_typed_name_and_nothing_is_written_over_unasked(hand, tmp_path):
    build(hand)
    ctrl, desk, path = hand.pygame.KMOD_LCTRL, hand.desk, tmp_path / "typed.toml"
    hand.key("s", ctrl), hand.frames(3)
    write(hand, str(path))
    assert path.is_file() and desk.opened.path == path and not desk.unsaved
    document = desk.document
    other = tmp_path / "other.toml"
    other.write_text("format = 1\n")
    hand.key("s", ctrl | hand.pygame.KMOD_LSHIFT), hand.frames(3)
    write(hand, str(other.with_suffix("")))
    assert other.read_text() == "format = 1\n" and "there already" in hand.studio.menus._question
    width, height = hand.studio.screen.size
    hand.click(0.5 * width + 49, 0.5 * height + 10), hand.frames(3)  # no
    assert other.read_text() == "format = 1\n" and desk.opened.path == path
    hand.key("n", ctrl), hand.frames(3)
    assert desk.document is not document
    hand.key("o", ctrl), hand.frames(3)
    write(hand, str(path))
    assert desk.document == document and desk.opened.path == path


class Dialog:
    """A native dialog that has been answered."""

    def __init__(self, answer):
        self.answer = answer

    def ready(self, timeout):
        return True

    def result(self):
        return self.answer


def test_native_dialogs_are_asked_where_there_are_any(hand, tmp_path, monkeypatch):
    from sim.view.studio.bars import menus

    asked, path = [], tmp_path / "native.toml"
    monkeypatch.setattr(menus, "has_dialogs", lambda: True)
    monkeypatch.setattr(menus.dialogs, "save_file", lambda title, place, kinds: asked.append(title) or Dialog(str(path)))
    monkeypatch.setattr(menus.dialogs, "open_file", lambda title, place, kinds: asked.append(title) or Dialog([str(path)]))
    build(hand)
    document = hand.desk.document
    hand.key("s", hand.pygame.KMOD_LCTRL), hand.frames(3)
    assert path.is_file() and not hand.desk.unsaved
    hand.key("n", hand.pygame.KMOD_LCTRL), hand.frames(3)
    hand.key("o", hand.pygame.KMOD_LCTRL), hand.frames(3)
    assert hand.desk.document == document and asked == ["Save the scene", "Open a scene"]


def test_no_time_beyond_the_end_is_shown(hand):
    build(hand)
    hand.desk.playing.time = hand.desk.show.end
    while hand.desk.history.at:
        hand.desk.undo()
    hand.frames(2)
    assert hand.desk.playing.time <= hand.desk.show.end
