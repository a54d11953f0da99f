"""The ground of the plan: a table with a grid, and what stands and flows on it."""

import numpy as np
from imgui_bundle import imgui

from sim.view import theme
from sim.view.studio.table import marks
from sim.view.studio.table.canvas import Box, Plan
from sim.view.theme import ink
from worlds.world import World

LENGTHS, LEAST_BAR = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1e3), 55.0
"""How long the bar may be that tells how long that is [m]; its least width at scale 1 [pixels]."""


def draw_ground(draw: imgui.ImDrawList, plan: Plan, world: World, scale: float) -> None:
    """The ground of the plan: a grid of metres, water, trees, rocks, and the edge of the world."""
    box = plan.box
    draw.add_rect_filled((box.x, box.y), (box.x + box.width, box.y + box.height), ink(theme.TABLE))
    edge = plan.project(np.array([[0.0, 0.0, 0.0], [*world.size, 0.0]]))
    draw.add_rect_filled(marks.vector(edge.min(axis=0)), marks.vector(edge.max(axis=0)), ink(theme.SHEET))
    _grid(draw, plan, box, scale)
    for river in world.rivers:
        places = plan.project(np.column_stack([river.points, np.zeros(len(river.points))]))
        marks.draw_line(draw, places, theme.WATER, 1.0, river.width * plan.zoom)
    for discs, colour in ((world.trees, theme.TREE), (world.rocks, theme.ROCK)):
        if len(discs):
            places = plan.project(np.column_stack([discs[:, :2], np.zeros(len(discs))]))
            for i in np.flatnonzero(marks.inside(box, places, 200.0)):
                draw.add_circle_filled(marks.vector(places[i]), float(discs[i, 2]) * plan.zoom, ink(colour))
    if world.goal is not None:
        place = marks.vector(plan.project(np.array([[*world.goal, 0.0]]))[0])
        draw.add_circle(place, world.goal_radius * plan.zoom, ink(theme.ACCENT), 0, 2.0 * scale)
        draw.add_circle_filled(place, 3.0 * scale, ink(theme.ACCENT))
    draw.add_rect(marks.vector(edge.min(axis=0)), marks.vector(edge.max(axis=0)), ink(theme.LINE_STRONG), 0.0, 1.5 * scale)
    _measure(draw, plan, box, scale)


def _measure(draw: imgui.ImDrawList, plan: Plan, box: Box, scale: float) -> None:
    """How long a metre is, or more or less of it: a bar in the lower right corner."""
    far = next(far for far in LENGTHS if far * plan.zoom > LEAST_BAR * scale or far == LENGTHS[-1])
    x, y, wide, ink_of = box.x + box.width - 12 * scale, box.y + box.height - 12 * scale, far * plan.zoom, ink(theme.FAINT)
    for begin, end in (((x - wide, y), (x, y)), ((x - wide, y - 5 * scale), (x - wide, y)), ((x, y - 5 * scale), (x, y))):
        draw.add_line(begin, end, ink_of, 1.5 * scale)
    words = f"{far:g} m"
    size = imgui.calc_text_size(words)
    draw.add_text((x - 0.5 * (wide + size.x), y - size.y - 3 * scale), ink_of, words)


def _grid(draw: imgui.ImDrawList, plan: Plan, box: Box, scale: float) -> None:
    """Lines of metres, or of more where those would be too near to each other."""
    step = next(s for s in (0.5, 1.0, 5.0, 10.0, 50.0, 1e3) if s * plan.zoom > 26 * scale or s == 1e3)
    low, high = plan.ground(None, box.x, box.y + box.height), plan.ground(None, box.x + box.width, box.y)  # type: ignore[arg-type]
    assert low is not None and high is not None
    for axis in range(2):
        for k in range(int(np.ceil(low[axis] / step)), int(high[axis] / step) + 1):
            strong = (k * step) % (5 * step if step < 5 else 2 * step) == 0
            shade = ink(theme.LINE_STRONG if strong else theme.LINE, 0.9 if strong else 0.6)
            if axis == 0:
                x = box.x + 0.5 * box.width + plan.zoom * (k * step - plan.centre[0])
                draw.add_line((x, box.y), (x, box.y + box.height), shade, 1.0)
            else:
                y = box.y + 0.5 * box.height - plan.zoom * (k * step - plan.centre[1])
                draw.add_line((box.x, y), (box.x + box.width, y), shade, 1.0)
