"""Where things are in the studio's window: two views side by side or one, the panel at the right, the timeline below."""

from dataclasses import dataclass

from sim.view.studio.desk.desk import Shown
from sim.view.studio.table.canvas import Box

PANEL, TIMELINE, STRIP, BAR = 250.0, 112.0, 42.0, 34.0
"""Width of the panel, heights of the timeline, of its strips and of the bar that plays [pixels at scale 1]."""
NARROW = 760.0
"""Below this width the panel is laid over the view, and one view is shown."""


@dataclass
class Splits:
    """What the user has dragged: shares of the views, and sizes [pixels at scale 1]."""

    views: float = 0.5
    panel: float = PANEL
    timeline: float = TIMELINE


@dataclass(frozen=True)
class Layout:
    """The rectangles of a frame."""

    plan: Box | None
    space: Box | None
    panel: Box | None
    play: Box
    timeline: Box
    scale: float


def layout_of(size: tuple[int, int], top: float, scale: float, shown: Shown, splits: Splits) -> Layout:
    """The rectangles for a window of this size [pixels] below a menu of height `top`."""
    width, height = size
    bottom = (splits.timeline + (STRIP if shown.strips else 0)) * scale
    bottom = min(bottom, 0.42 * height)
    bar = BAR * scale
    narrow = width < NARROW * scale
    panel = min(splits.panel * scale, 0.5 * width) if shown.inspector else 0.0
    high = height - top - bottom - bar
    room = width - (0 if narrow else panel)
    plan, space = shown.plan, shown.space
    if narrow and plan and space:
        space = False
    share = splits.views if plan and space else float(plan)
    return Layout(
        Box(0, top, share * room - (1 if space else 0), high) if plan else None,
        Box(share * room, top, (1 - share) * room, high) if space else None,
        Box(width - panel, top, panel, high) if panel else None,
        Box(0, top + high, width, bar),
        Box(0, top + high + bar, width, bottom),
        scale,
    )
