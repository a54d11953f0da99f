"""The timing diagram (paper, Fig. 1b): when each foot stands, in seconds, with the phases named.

Bars are dragged by their ends. The left one is the contact: the step before takes more or less time, or, with Alt held, it is
pinned there. The right one is when the foot leaves. Below, strips show where the motion borrows.
"""

from dataclasses import dataclass

import numpy as np
from imgui_bundle import imgui

from sim.files.studio.document import Spot, footprints_in
from sim.files.studio.edits import Edit, Set
from sim.view import theme
from sim.view.studio.desk import debts
from sim.view.studio.desk.debts import Debts
from sim.view.studio.desk.desk import Desk
from sim.view.studio.table.canvas import Box
from sim.view.studio.table.layout import Layout
from sim.view.studio.table.motions import Span
from sim.view.theme import ink

LEFT_MARGIN, RULER = 26.0, 18.0
EDGE = 6.0
"""Pixels at scale 1 within which the end of a bar is taken."""
SHORT = ("L", "R", "double", "flight")
LEAST = 0.02


@dataclass
class View:
    """What of time is shown."""

    begin: float = -0.2
    pixels: float = 120.0  # per second
    follow: bool = True


@dataclass(frozen=True)
class Held:
    """What is dragged: the play head, the ruler's time, or an end of a bar."""

    what: str  # head, contact, leave, pan
    spot: Spot | None = None
    offset: float = 0.0  # [s] between the mouse and what is held


class Timeline:
    """Draws the diagram and takes the mouse in it."""

    def __init__(self) -> None:
        self.view, self.box, self.scale = View(), Box(), 1.0
        self.held: Held | None = None

    def x(self, t: float) -> float:
        """Where a time [s] is on the screen."""
        return self.box.x + LEFT_MARGIN * self.scale + (t - self.view.begin) * self.view.pixels * self.scale

    def time(self, x: float) -> float:
        """The time [s] at a place of the screen."""
        return (x - self.box.x - LEFT_MARGIN * self.scale) / (self.view.pixels * self.scale) + self.view.begin

    def rows(self) -> tuple[float, float, float]:
        """Tops of the two rows and their height."""
        high = min((self.box.height - RULER * self.scale) * 0.3, 26 * self.scale)
        top = self.box.y + RULER * self.scale + 2 * self.scale
        return top, top + high + 4 * self.scale, high

    def draw(self, draw: imgui.ImDrawList, desk: Desk, spans: list[Span], owed: Debts, layout: Layout) -> None:
        """One frame."""
        box, scale = layout.timeline, layout.scale
        self.box, self.scale = box, scale
        self._keep_in_view(desk)
        draw.push_clip_rect((box.x, box.y), (box.x + box.width, box.y + box.height), True)
        draw.add_rect_filled((box.x, box.y), (box.x + box.width, box.y + box.height), ink(theme.SHEET))
        self._ruler(draw, desk)
        self._bars(draw, desk)
        self._phases(draw, spans)
        if desk.shown.strips:
            self._strips(draw, owed)
        draw.add_rect_filled((box.x, box.y), (box.x + LEFT_MARGIN * scale - 3, box.y + box.height), ink(theme.SHEET))
        for label, top, colour in zip("LR", self.rows()[:2], theme.SIDES, strict=True):
            draw.add_text((box.x + 8 * scale, top + 0.5 * self.rows()[2] - 8 * scale), ink(colour), label)
        if desk.playing.loop:
            a, b = (self.x(t) for t in desk.playing.loop)
            draw.add_rect_filled((a, box.y), (b, box.y + RULER * scale), ink(theme.ACCENT, 0.22))
        head = self.x(desk.playing.time)
        draw.add_line((head, box.y), (head, box.y + box.height), ink(theme.ACCENT), 1.6 * scale)
        r = 5 * scale
        draw.add_triangle_filled((head - r, box.y), (head + r, box.y), (head, box.y + 1.6 * r), ink(theme.ACCENT))
        draw.pop_clip_rect()

    def _keep_in_view(self, desk: Desk) -> None:
        """The play head stays in view while it runs."""
        last = self.time(self.box.x + self.box.width)
        if desk.playing.on and not self.held and (desk.playing.time > last - 0.3 or desk.playing.time < self.view.begin):
            self.view.begin = desk.playing.time - 0.3

    def _ruler(self, draw: imgui.ImDrawList, desk: Desk) -> None:
        box, scale = self.box, self.scale
        step = next(s for s in (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0) if s * self.view.pixels > 46 or s == 60.0)
        last = self.time(box.x + box.width)
        for k in range(int(np.ceil(self.view.begin / step)), int(last / step) + 1):
            if k < 0:
                continue
            x = self.x(k * step)
            draw.add_line((x, box.y + RULER * scale), (x, box.y + box.height), ink(theme.LINE), 1.0)
            draw.add_text((x + 3 * scale, box.y + 1), ink(theme.FAINT), f"{k * step:g} s")
        end = self.x(desk.act(desk.track).end)
        draw.add_rect_filled((end, box.y), (box.x + box.width, box.y + box.height), ink(theme.TABLE, 0.7))

    def _bars(self, draw: imgui.ImDrawList, desk: Desk) -> None:
        """Who stands when."""
        act, tops, scale = desk.act(desk.track), self.rows(), self.scale
        contact = act.laid.footprints.contact_time
        leave = np.minimum(contact + act.laid.footprints.stance_time, act.end)
        numbers = {int(row): i for i, row in enumerate(act.laid.row)}
        order = footprints_in(desk.document.tracks[desk.track])
        shown = (leave >= self.time(self.box.x)) & (contact <= self.time(self.box.x + self.box.width))
        for row in np.flatnonzero(shown).tolist():
            a, b = self.x(float(contact[row])), self.x(float(leave[row]))
            side, i = int(act.laid.footprints.side[row]), numbers.get(row)
            chosen = i is not None and Spot(desk.track, i) in desk.selection
            top = tops[side]
            draw.add_rect_filled((a, top), (b, top + tops[2]), ink(theme.SIDES[side], 0.9 if chosen else 0.55), 3 * scale)
            if chosen:
                draw.add_rect((a, top), (b, top + tops[2]), ink(theme.ACCENT), 3 * scale, 1.6 * scale)
            if i is not None and b - a > 18 * scale:
                draw.add_text((a + 5 * scale, top + 0.5 * tops[2] - 8 * scale), ink((1, 1, 1), 0.9), str(i))
            if i is not None and i < len(order) and order[i].footprint.at is not None:
                draw.add_circle_filled((a, top + 0.5 * tops[2]), 4.5 * scale, ink(theme.PINNED))

    def _phases(self, draw: imgui.ImDrawList, spans: list[Span]) -> None:
        """The phases, in their colours, named where there is room."""
        top, scale = self.rows()[1] + self.rows()[2] + 4 * self.scale, self.scale
        first, last = self.time(self.box.x), self.time(self.box.x + self.box.width)
        for span in spans:
            if span.end < first or span.begin > last:
                continue
            a, b = self.x(span.begin), self.x(span.end)
            draw.add_rect_filled((a, top), (b - 1, top + 15 * scale), ink(theme.PHASES[span.phase], 0.8), 2 * scale)
            name = SHORT[span.phase]
            if b - a > 7.5 * len(name) * scale:
                draw.add_text((a + 4 * scale, top - 1 * scale), ink(theme.TABLE), name)

    def _strips(self, draw: imgui.ImDrawList, owed: Debts) -> None:
        """Where the motion borrows from physics, from comfort, and where legs are out of reach."""
        top = self.rows()[1] + self.rows()[2] + 23 * self.scale
        high = (self.box.y + self.box.height - top) / 3 - 2 * self.scale
        if high < 3 * self.scale:
            return
        first = max(int(self.view.begin / debts.STEP), 0)
        last = min(int(self.time(self.box.x + self.box.width) / debts.STEP) + 1, owed.values.shape[1])
        for kind, colour in enumerate((theme.PHYSICS, theme.COMFORT, theme.REACH)):
            base = top + (kind + 1) * (high + 2 * self.scale) - 2 * self.scale
            draw.add_line((self.x(0.0), base), (self.x(owed.values.shape[1] * debts.STEP), base), ink(colour, 0.35), 1.0)
            for k in range(first, last):
                value = owed.values[kind, k]
                if value > 0.02 * debts.FULL[kind]:
                    tall = high * min(float(value) / debts.FULL[kind], 1.0)
                    x = self.x(k * debts.STEP)
                    draw.add_rect_filled(
                        (x, base - tall), (x + debts.STEP * self.view.pixels * self.scale + 0.5, base), ink(colour, 0.9)
                    )

    def press(self, desk: Desk, x: float, y: float, alt: bool) -> None:
        """The mouse button went down."""
        if y < self.box.y + RULER * self.scale:
            self.held = Held("head")
            self.move(desk, x, alt)
            return
        found = self.bar_at(desk, x, y)
        if found is None:
            self.held = Held("head")
            self.move(desk, x, alt)
            return
        what, number, t = found
        spot = Spot(desk.track, number)
        if spot not in desk.selection:
            desk.selection = {spot}
        if what != "bar":
            self.held = Held(what, spot, self.time(x) - t)

    def bar_at(self, desk: Desk, x: float, y: float) -> tuple[str, int, float] | None:
        """(contact, leave or bar, number of the footprint, the time [s] of that end) under the mouse."""
        act, tops = desk.act(desk.track), self.rows()
        for side in range(2):
            if not tops[side] <= y <= tops[side] + tops[2]:
                continue
            for number, row in enumerate(act.laid.row):
                if int(act.laid.footprints.side[row]) != side:
                    continue
                t = float(act.laid.footprints.contact_time[row])
                leave = t + float(act.laid.footprints.stance_time[row])
                near = min(EDGE * self.scale, 0.3 * (self.x(leave) - self.x(t)))
                if abs(x - self.x(t)) <= near and number > 1:
                    return "contact", number, t
                if abs(x - self.x(leave)) <= near:
                    return "leave", number, leave
                if self.x(t) <= x <= self.x(leave):
                    return "bar", number, t
        return None

    def move(self, desk: Desk, x: float, alt: bool) -> None:
        """The mouse moves with its button down."""
        if self.held is None:
            return
        if self.held.what == "head":
            desk.playing.on = False
            desk.playing.time = float(np.clip(self.time(x), 0.0, desk.show.end))
            return
        edit = self.edit(desk, self.time(x) - self.held.offset, alt)
        if edit is not None:
            desk.preview(edit)

    def edit(self, desk: Desk, t: float, alt: bool) -> Edit | None:
        """What dragging an end to a time does."""
        assert self.held is not None and self.held.spot is not None
        spot, laid = self.held.spot, desk.act(desk.track).laid
        row = int(laid.row[spot.number])
        if self.held.what == "leave":
            stance = max(t - float(laid.footprints.contact_time[row]), LEAST)
            return Set((spot,), "stance_time", round(stance, 4), "Change the stance time")
        if alt:
            return Set((spot,), "at", round(max(t, LEAST), 4), f"Pin to {t:.2f} s")
        step = max(t - float(laid.footprints.contact_time[row - 1]), LEAST)
        return Set((Spot(spot.track, spot.number - 1),), "step_time", round(step, 4), "Change the step time")

    def release(self, desk: Desk) -> None:
        """The mouse button went up."""
        self.held = None
        desk.drop()

    def wheel(self, clicks: float, x: float, zoom: bool) -> None:
        """Turns time on, or zooms about the mouse."""
        if zoom:
            t = self.time(x)
            self.view.pixels = float(np.clip(self.view.pixels * 1.15**clicks, 4.0, 1500.0))
            self.view.begin += t - self.time(x)
        else:
            self.view.begin -= 60 * clicks / self.view.pixels
