"""Colours, sizes and letters of the studio: a dark table on which prints, curves and times are what shines."""

from pathlib import Path

import imgui_bundle
from imgui_bundle import imgui

from motion.track.phases import DOUBLE_STANCE, FLIGHT, LEFT_STANCE, RIGHT_STANCE

Colour = tuple[float, float, float]
LETTERS = 15.0
"""Height of letters [pixels at scale 1]."""
TABLE, SHEET, LINE, LINE_STRONG = (0.085, 0.095, 0.11), (0.125, 0.14, 0.16), (0.19, 0.21, 0.24), (0.27, 0.30, 0.34)
TEXT, FAINT, ACCENT, WRONG, PINNED = (
    (0.88, 0.89, 0.90),
    (0.52, 0.56, 0.60),
    (1.0, 0.74, 0.30),
    (0.98, 0.42, 0.36),
    (1.0, 0.85, 0.40),
)
PRESSED = (0.36, 0.40, 0.45)
LEFT, RIGHT = (0.93, 0.38, 0.85), (0.98, 0.33, 0.30)
SIDES = (LEFT, RIGHT)
PHASES = {LEFT_STANCE: LEFT, RIGHT_STANCE: RIGHT, DOUBLE_STANCE: (0.44, 0.52, 0.95), FLIGHT: (0.55, 0.83, 1.0)}
"""The paper's colours, a little lighter, as the table is dark."""
PHYSICS, COMFORT, REACH = (0.98, 0.42, 0.36), (1.0, 0.74, 0.30), (0.70, 0.50, 1.0)
PATH, COM_PULL, KEY = (0.45, 0.85, 0.72), (0.35, 0.90, 0.95), (0.75, 0.95, 0.45)
WATER, TREE, ROCK = (0.16, 0.30, 0.42), (0.15, 0.27, 0.19), (0.30, 0.31, 0.32)


SIZES: dict[str, float | tuple[float, float]] = {
    "window_padding": (10, 8), "frame_padding": (7, 3), "item_spacing": (7, 5), "item_inner_spacing": (5, 4),
    "grab_min_size": 10, "frame_rounding": 4, "popup_rounding": 6, "grab_rounding": 4, "scrollbar_size": 11,
    "indent_spacing": 14,
}  # fmt: skip
"""Of imgui's style, at scale 1 [pixels]."""


def ink(colour: Colour, alpha: float = 1.0) -> int:
    """A colour for draw lists."""
    return imgui.color_convert_float4_to_u32((*colour, alpha))


def load_letters() -> None:
    """Roboto, which comes with imgui-bundle; imgui's own letters where it does not."""
    folder = Path(imgui_bundle.__file__).parent / "assets" / "fonts" / "Roboto"
    file = folder / "Roboto-Regular.ttf"
    if file.is_file():
        imgui.get_io().fonts.add_font_from_file_ttf(str(file), LETTERS)


def dress(scale: float) -> None:
    """Sets imgui's style for a scale: 1 for plain screens, 2 for those of twice the pixels."""
    style = imgui.get_style()
    imgui.style_colors_dark()
    col = imgui.Col_
    plain = {
        TEXT: (col.text,), FAINT: (col.text_disabled,), SHEET: (col.window_bg, col.popup_bg, col.scrollbar_bg),
        TABLE: (col.menu_bar_bg, col.title_bg, col.title_bg_active),
        LINE: (col.border, col.frame_bg, col.button, col.header, col.separator),
        LINE_STRONG: (col.frame_bg_hovered, col.frame_bg_active, col.button_hovered, col.header_hovered, col.header_active),
        ACCENT: (col.slider_grab, col.check_mark), PINNED: (col.slider_grab_active,),
        PRESSED: (col.button_active, col.scrollbar_grab),
    }  # fmt: skip
    for colour, which in plain.items():
        for one in which:
            style.set_color_(one, (*colour, 1.0))
    style.window_rounding = style.window_border_size = 0.0
    for name, size in SIZES.items():
        setattr(style, name, (size[0] * scale, size[1] * scale) if isinstance(size, tuple) else size * scale)
    style.font_scale_main = scale
