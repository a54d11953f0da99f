"""Keys for imgui's fields: what is typed, and the keys that move in a text."""

from types import ModuleType
from typing import Any

from imgui_bundle import imgui

NAMES = {
    "backspace": imgui.Key.backspace, "delete": imgui.Key.delete, "return": imgui.Key.enter, "escape": imgui.Key.escape,
    "left": imgui.Key.left_arrow, "right": imgui.Key.right_arrow, "up": imgui.Key.up_arrow, "down": imgui.Key.down_arrow,
    "home": imgui.Key.home, "end": imgui.Key.end, "tab": imgui.Key.tab, "a": imgui.Key.a, "c": imgui.Key.c, "v": imgui.Key.v,
    "x": imgui.Key.x, "z": imgui.Key.z,
}  # fmt: skip


def typed_into(io: imgui.IO, event: Any, pygame: ModuleType) -> None:
    """Hands a key or a text to imgui."""
    if event.type == pygame.TEXTINPUT:
        io.add_input_characters_utf8(event.text)
        return
    down = event.type == pygame.KEYDOWN
    io.add_key_event(imgui.Key.mod_ctrl, bool(event.mod & pygame.KMOD_CTRL))
    io.add_key_event(imgui.Key.mod_shift, bool(event.mod & pygame.KMOD_SHIFT))
    io.add_key_event(imgui.Key.mod_alt, bool(event.mod & pygame.KMOD_ALT))
    key = NAMES.get(pygame.key.name(event.key))
    if key is not None and (io.want_text_input or not down):
        io.add_key_event(key, down)
