"""What lies between and over the views: the bar that plays, notices, and the help."""

import time as clock

from imgui_bundle import imgui

from sim.view import theme
from sim.view.studio.bars.menus import GROUPS
from sim.view.studio.desk import desk as desks
from sim.view.studio.desk.desk import Desk
from sim.view.studio.desk.keys import ACTIONS, BY_KEY
from sim.view.studio.table.layout import Layout
from sim.view.theme import ink

STILL = imgui.WindowFlags_.no_move | imgui.WindowFlags_.no_resize
FIXED = STILL | imgui.WindowFlags_.no_title_bar | imgui.WindowFlags_.no_scrollbar


def play(desk: Desk, layout: Layout) -> None:
    """The bar between the views and the timeline."""
    box, scale = layout.play, layout.scale
    imgui.set_next_window_pos((box.x, box.y))
    imgui.set_next_window_size((box.width, box.height))
    imgui.begin("play", None, FIXED)
    playing = desk.playing
    for label, key in (("|<", "home"), ("<", ","), ("stop" if playing.on else "play", "space"), (">", ".")):
        if imgui.button(label, ((52 if key == "space" else 30) * scale, 0)):
            BY_KEY[key].does(desk)
        imgui.same_line()
    imgui.align_text_to_frame_padding()
    imgui.text(f"{playing.time:5.2f} / {desk.show.end:.2f} s")
    imgui.same_line()
    if imgui.button(f"x{playing.speed:g}", (44 * scale, 0)):
        BY_KEY["s"].does(desk)
    imgui.same_line()
    changed, on = imgui.checkbox("loop", playing.loop is not None)
    if changed:
        playing.loop = (0.0, desk.show.end) if on else None
    if box.width > 640 * scale:
        _tools(desk)
    imgui.end()


def _tools(desk: Desk) -> None:
    """Tools and what is shown, as switches."""
    for label, key, on in (
        ("place", "n", desk.tool == desks.PLACE), ("path", "p", desk.tool == desks.DRAW),
        ("ghosts", "o", desk.shown.ghosts), ("forces", "x", desk.shown.forces),
        ("views", "v", False), ("help", "h", desk.shown.help),
    ):  # fmt: skip
        imgui.same_line()
        if on:
            imgui.push_style_color(imgui.Col_.text, (*theme.ACCENT, 1.0))
        if imgui.button(label):
            BY_KEY[key].does(desk)
        if on:
            imgui.pop_style_color()


def notices(draw: imgui.ImDrawList, desk: Desk, layout: Layout) -> None:
    """Sentences that go by themselves; the fault of the scene stays."""
    words = [(desk.fault, True)] if desk.fault else []
    words += [(one.text, one.wrong) for one in desk.notices if one.until > clock.monotonic()]
    y = layout.play.y - 10 * layout.scale
    wide = min(layout.play.width - 40 * layout.scale, 640 * layout.scale)
    for text, wrong in reversed(words):
        size = imgui.calc_text_size(text[:400], False, wide)
        y -= size.y + 14 * layout.scale
        x = 14 * layout.scale
        corner = (x + size.x + 18 * layout.scale, y + size.y + 10 * layout.scale)
        draw.add_rect_filled((x, y), corner, ink(theme.TABLE, 0.92), 5 * layout.scale)
        draw.add_rect((x, y), corner, ink(theme.WRONG if wrong else theme.LINE_STRONG), 5 * layout.scale)
        place = (x + 9 * layout.scale, y + 5 * layout.scale)
        draw.add_text(imgui.get_font(), imgui.get_font_size(), place, ink(theme.TEXT), text[:400], wide)


def help(desk: Desk, size: tuple[int, int], scale: float) -> None:
    """All keys."""
    if not desk.shown.help:
        return
    imgui.set_next_window_pos((0.5 * size[0], 0.5 * size[1]), 0, (0.5, 0.5))
    imgui.set_next_window_size((min(size[0] - 16, 780 * scale), min(size[1] - 16, 500 * scale)))
    imgui.begin(
        "Keys and mouse", None, imgui.WindowFlags_.no_collapse | imgui.WindowFlags_.no_resize | imgui.WindowFlags_.no_move
    )
    imgui.text_wrapped(
        "Click a footprint, or draw a box; shift adds. Drag it, its yellow handle, or its dagger: the tip is the stance "
        "time, the crossbar the step time. Right button: orbit in space, move the plan. Wheel: nearer. Bars of the "
        "timeline are dragged by their ends; with Alt they are pinned. Enter or a right click ends a path. Shift+F: "
        "all in view."
    )
    imgui.push_style_var(imgui.StyleVar_.item_spacing, (7 * scale, 0.5 * scale))
    if imgui.begin_table("keys", 3 if size[0] > 560 * scale else 2):
        for group in GROUPS:
            imgui.table_next_column()
            imgui.text_colored((*theme.ACCENT, 1.0), group)
            for action in ACTIONS:
                if action.group == group:
                    imgui.text(action.key)
                    imgui.same_line(86 * scale)
                    imgui.text_disabled(action.words)
        imgui.end_table()
    imgui.pop_style_var()
    imgui.end()
